//! Tiles and threads, for either precision.
//!
//! The picture is cut into tiles, which idle threads take one by one. Each tile is traced by a
//! worker of its own into memory of its own, so the threads change neither the picture nor the
//! counts. What tiles share, the corners of pixels or a coarse raster of pixels, is traced
//! before, in tiles of its own.

use rayon::prelude::*;

use super::samplers::{Any, Shared, parting, selection};
use super::strahl::{
    Accelerator, Corner, Counters, Effects, Kept, Lattice, Met, Parting, Pixel, Record, Rgb, Selected,
    Selection, Sight, Sink, Size, Tally, Tile, Tracer, Worker, render, render_selected,
};
use crate::progress::Watch;
use crate::signals::Stop;
use crate::wanted::Wanted;
pub use crate::wanted::{Cut, LEVELS, Sampling};

/// The most places that a sampler keeps in one tile.
const MOST_KEPT: usize = 1 << 14;

/// Somebody who counts in one tile, and whose counts are added up.
pub trait Count: Tally + Default + Send {
    /// Adds another tile's counts.
    fn add(&mut self, other: Self);
}

impl Count for () {
    fn add(&mut self, _: ()) {}
}

impl Count for Counters {
    fn add(&mut self, other: Counters) {
        Counters::add(self, &other);
    }
}

/// Traces the picture that is wanted, of which `size` is the whole.
pub fn trace<A, E, T, const L: usize>(
    tracer: &Tracer<'_, '_, A, E, L>,
    wanted: &Wanted,
    size: Size,
    watch: &Watch,
) -> Result<(Vec<Rgb>, T), Stop>
where
    A: Accelerator + Sync,
    E: Effects + Sync,
    T: Count,
{
    let whole = match wanted.region {
        Some(region) => tile(region).within(Tile::whole(size)),
        None => Tile::whole(size),
    };
    let work = Work { tracer, wanted, whole, watch };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(wanted.cut.threads).build();
    // Without a pool of its own the work is done by the pool of the process.
    let run = || match selection(wanted) {
        Some(selection) => work.selected(selection),
        None => work.all(),
    };
    match pool {
        Ok(pool) => pool.install(run),
        Err(_) => run(),
    }
}

/// The same in this precision's own type.
fn tile(it: strahl_core::Tile) -> Tile {
    Tile { first: Pixel { x: it.first.x, y: it.first.y }, width: it.width, height: it.height }
}

/// What is done, and what is wanted.
struct Work<'w, 't, 's, A, E, const L: usize> {
    tracer: &'w Tracer<'t, 's, A, E, L>,
    wanted: &'w Wanted,
    /// The pixels of the picture.
    whole: Tile,
    watch: &'w Watch,
}

/// What pixels are traced for.
#[derive(Clone, Copy)]
enum Rays<'c> {
    /// For their upper left corners, which more than one of them needs.
    Corners(Parting),
    /// For a raster of pixels, each at the corner of a block.
    Raster(Selection),
    /// For themselves, their corners being known or not.
    Themselves(Shared<'c>),
}

impl<A, E, const L: usize> Work<'_, '_, '_, A, E, L>
where
    A: Accelerator + Sync,
    E: Effects + Sync,
{
    /// Traces every pixel that is wanted.
    fn all<T: Count>(&self) -> Result<(Vec<Rgb>, T), Stop> {
        // All corners first, where all pixels are wanted, so that none is traced twice.
        let (lattice, mut counts): (Vec<Sight>, T) = match parting(self.wanted) {
            Some(parting) if self.wanted.mask.is_none() => {
                self.pixels(Lattice::tile(self.whole), Rays::Corners(parting))?
            }
            _ => Default::default(),
        };
        let corners = Lattice::new(self.whole, &lattice).map_or(Shared::Loose, Shared::Lattice);
        let (colors, counted) = self.pixels(self.whole, Rays::Themselves(corners))?;
        counts.add(counted);
        Ok((colors, counts))
    }

    /// Traces some pixels, and guesses the others that are wanted.
    fn selected<T: Count>(&self, selection: Selection) -> Result<(Vec<Rgb>, T), Stop> {
        let blocks = selection.blocks(self.whole);
        let (raster, mut counts): (Vec<Sight>, T) = match self.wanted.mask {
            None => self.pixels(Lattice::tile(blocks), Rays::Raster(selection))?,
            Some(_) => Default::default(),
        };
        let corners = Lattice::new(blocks, &raster).map_or(Shared::Loose, Shared::Lattice);

        // Blocks share what lies between them within a tile, so tiles are larger.
        let side = (2 * self.wanted.cut.tile / selection.step()).max(1);
        let area = |blocks| selection.area(blocks).within(self.whole);
        let (colors, counted) = self.tiles(blocks, side, area, |blocks, canvas| {
            let (mut lent, mut kept) = (lend(area(blocks)), lend(area(blocks)));
            let mut worker = Worker::new(T::default());
            let sampler = Any::of(self.wanted, Shared::Loose, &mut lent);
            let mut selected = Selected::new(selection, sampler, corners, &mut kept);
            let is_wanted = |block: &Pixel| {
                let block = Tile { first: *block, width: 1, height: 1 };
                self.wanted.mask.is_none() || selection.area(block).pixels().any(|pixel| self.has(pixel))
            };
            let blocks = blocks.pixels().filter(is_wanted);
            render_selected(self.tracer, &mut selected, &mut worker, blocks, canvas)?;
            Ok(worker.into_tally())
        })?;
        counts.add(counted);
        Ok((colors, counts))
    }

    /// Traces the pixels of `area` that are wanted.
    fn pixels<R: Record + Send, T: Count>(&self, area: Tile, rays: Rays<'_>) -> Result<(Vec<R>, T), Stop> {
        self.tiles(
            area,
            self.wanted.cut.tile,
            |tile| tile,
            |tile, canvas| {
                let mut lent = lend(tile);
                let mut worker = Worker::new(T::default());
                let (tracer, all) = (self.tracer, tile.pixels());
                match rays {
                    Rays::Corners(parting) => render(tracer, &mut Corner(parting), &mut worker, all, canvas)?,
                    Rays::Raster(selection) => {
                        let sampler = Any::of(self.wanted, Shared::Loose, &mut lent);
                        render(tracer, &mut selection.raster(sampler), &mut worker, all, canvas)?;
                    }
                    Rays::Themselves(corners) => {
                        let mut sampler = Any::of(self.wanted, corners, &mut lent);
                        let pixels = all.filter(|pixel| self.has(*pixel));
                        render(tracer, &mut sampler, &mut worker, pixels, canvas)?;
                    }
                }
                Ok(worker.into_tally())
            },
        )
    }

    /// Works on `cells`, tile by tile, and puts together what comes of it. `area` says which
    /// part of the picture a rectangle of cells is.
    fn tiles<R: Record + Send, T: Count>(
        &self,
        cells: Tile,
        side: u32,
        area: impl Fn(Tile) -> Tile + Sync,
        work: impl Fn(Tile, &mut Canvas<'_, R>) -> Result<T, Stop> + Sync,
    ) -> Result<(Vec<R>, T), Stop> {
        let whole = area(cells);
        self.watch.begin(whole.len());
        let list: Vec<Tile> = cells.tiles(side).collect();
        let traced: Vec<(Tile, Vec<R>, T)> = list
            .into_par_iter()
            .map(|cells| {
                let tile = area(cells);
                let mut records = vec![R::NONE; tile.len()];
                let (wanted, watch) = (self.wanted, self.watch);
                let counts = work(cells, &mut Canvas { tile, records: &mut records, wanted, watch })?;
                self.watch.done(tile.len());
                Ok((tile, records, counts))
            })
            .collect::<Result<_, Stop>>()?;

        let mut picture = vec![R::NONE; whole.len()];
        let mut counts = T::default();
        for (tile, records, counted) in traced {
            // A tile of cells that lie beyond the picture's edge has no pixel.
            let rows = records.chunks(tile.width.max(1) as usize).zip(tile.first.y..);
            for (row, y) in rows {
                if let Some(start) = whole.place(Pixel { x: tile.first.x, y }) {
                    picture[start..start + row.len()].copy_from_slice(row);
                }
            }
            counts.add(counted);
        }
        Ok((picture, counts))
    }

    /// Whether a pixel is wanted.
    fn has(&self, pixel: Pixel) -> bool {
        is_wanted(self.wanted, pixel)
    }
}

fn is_wanted(wanted: &Wanted, pixel: Pixel) -> bool {
    wanted.mask.as_ref().is_none_or(|mask| mask.has(strahl_core::Pixel { x: pixel.x, y: pixel.y }))
}

/// Memory for the places that a sampler keeps while it works on `tile`.
fn lend(tile: Tile) -> Vec<Kept> {
    vec![Kept::NOTHING; MOST_KEPT.min(16 * tile.len())]
}

/// The pixels of one tile, until a signal comes.
struct Canvas<'m, R> {
    tile: Tile,
    records: &'m mut [R],
    wanted: &'m Wanted,
    watch: &'m Watch,
}

impl<R: Record> Sink for Canvas<'_, R> {
    type Error = Stop;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Stop> {
        self.put_sight(pixel, Sight { color, met: Met::Nothing })
    }

    fn put_sight(&mut self, pixel: Pixel, sight: Sight) -> Result<(), Stop> {
        if let Some(place) = self.tile.place(pixel)
            && is_wanted(self.wanted, pixel)
        {
            self.records[place] = R::of(sight);
        }
        self.watch.check()
    }
}
