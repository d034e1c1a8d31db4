//! Tiles and threads, for either precision.
//!
//! The picture is cut into tiles, which idle threads take one by one. Each tile is traced by a
//! worker of its own into memory of its own, so the threads change neither the picture nor the
//! counts.

use rayon::prelude::*;

use super::strahl::{
    Accelerator, Corner, Counters, Effects, Lattice, Pixel, Regular, Rgb, Sampler, Single, Sink, Size, Tally,
    Tile, Tracer, Worker, render,
};
use crate::progress::Watch;
use crate::signals::Stop;
pub use crate::wanted::{Cut, LEVELS, Sampling};

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

/// Traces a whole picture.
pub fn trace<A, E, T, const L: usize>(
    tracer: &Tracer<'_, '_, A, E, L>,
    sampling: Sampling,
    size: Size,
    cut: Cut,
    watch: &Watch,
) -> Result<(Vec<Rgb>, T), Stop>
where
    A: Accelerator + Sync,
    E: Effects + Sync,
    T: Count,
{
    let pool = rayon::ThreadPoolBuilder::new().num_threads(cut.threads).build();
    // Without a pool of its own the work is done by the pool of the process.
    let run = || {
        let whole = Tile::whole(size);
        match sampling {
            Sampling::Single => tiles(tracer, Single, whole, cut.tile, watch),
            Sampling::Regular(n) => {
                let sampler = Regular::new(n).unwrap_or(Regular::ONE);
                tiles(tracer, sampler, whole, cut.tile, watch)
            }
            Sampling::Corners => {
                let (corners, counts) = tiles(tracer, Corner, Lattice::tile(size), cut.tile, watch)?;
                let mut colors = Vec::with_capacity(whole.len());
                if let Some(mut lattice) = Lattice::new(size, &corners) {
                    colors.extend(whole.pixels().map(|pixel| lattice.color(pixel, &mut |_| Rgb::BLACK)));
                }
                Ok((colors, counts))
            }
        }
    };
    match pool {
        Ok(pool) => pool.install(run),
        Err(_) => run(),
    }
}

/// Traces the pixels of `whole`, row by row.
fn tiles<A, E, T, S, const L: usize>(
    tracer: &Tracer<'_, '_, A, E, L>,
    sampler: S,
    whole: Tile,
    side: u32,
    watch: &Watch,
) -> Result<(Vec<Rgb>, T), Stop>
where
    A: Accelerator + Sync,
    E: Effects + Sync,
    T: Count,
    S: Sampler + Clone + Sync + Send,
{
    watch.begin(whole.len());
    let list: Vec<Tile> = whole.tiles(side).collect();
    let traced: Vec<(Tile, Vec<Rgb>, T)> = list
        .into_par_iter()
        .map(|tile| {
            let mut worker = Worker::new(T::default());
            let mut colors = Vec::with_capacity(tile.len());
            let mut sink = Growing { colors: &mut colors, watch };
            render(tracer, &mut sampler.clone(), &mut worker, tile.pixels(), &mut sink)?;
            watch.done(tile.len());
            Ok((tile, colors, worker.into_tally()))
        })
        .collect::<Result<_, Stop>>()?;

    let mut picture = vec![Rgb::BLACK; whole.len()];
    let mut counts = T::default();
    for (tile, colors, counted) in traced {
        let rows = colors.chunks(tile.width as usize).zip(tile.first.y..);
        for (row, y) in rows {
            if let Some(start) = whole.place(Pixel { x: tile.first.x, y }) {
                picture[start..start + row.len()].copy_from_slice(row);
            }
        }
        counts.add(counted);
    }
    Ok((picture, counts))
}

/// The pixels of one tile, until a signal comes.
struct Growing<'m> {
    colors: &'m mut Vec<Rgb>,
    watch: &'m Watch,
}

impl Sink for Growing<'_> {
    type Error = Stop;

    fn put(&mut self, _: Pixel, color: Rgb) -> Result<(), Stop> {
        self.colors.push(color);
        self.watch.check()
    }
}
