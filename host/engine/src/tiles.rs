//! Tiles and threads.
//!
//! The picture is cut into tiles, which idle threads take one by one. Each tile is traced by a ray tracer of its own into
//! memory of its own, so the number of threads changes neither the picture nor the counts. What tiles share, the corners of
//! pixels or a coarse raster of pixels, is traced before, in tiles of its own.

use rayon::prelude::*;

use strahl_core::image::{
    CacheEntry, CornerGrid, CornerSampler, FramebufferPixel, Pixel, PixelSelector, Selection, Sink,
    Subdivision,
};
use strahl_core::render::render_selected;
use strahl_core::tally::Counters;
use strahl_core::trace::{HitId, PixelSample};
use strahl_core::{Rgb, Tile, render};
use strahl_settings::Settings;

use crate::options::RenderOptions;
use crate::output::Color;
use crate::progress::{Interrupt, Progress};
use crate::ray_tracer::RayTracerFactory;
use crate::samplers::{AnySampler, CornerSource, parting, selection};

/// The most samples that are cached for one tile.
const MOST_CACHED: usize = 1 << 14;

/// Records of pixels, row by row, and the work.
pub type Traced<R> = (Vec<R>, Counters);

/// Traces the picture that is requested.
pub fn trace(
    ray_tracers: &dyn RayTracerFactory,
    settings: &Settings,
    options: &RenderOptions<'_>,
    progress: &dyn Progress,
) -> Result<Traced<Rgb>, Interrupt> {
    let renderer = TileRenderer { ray_tracers, settings, options, area: settings.region_or_all(), progress };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(settings.threads).build();
    // Without a pool of its own the work is done by the pool of the process.
    let run = || match selection(settings) {
        Some(selection) => renderer.selected(selection),
        None => renderer.all(),
    };
    match pool {
        Ok(pool) => pool.install(run),
        Err(_) => run(),
    }
}

/// Colours in single precision; those of single precision stay where they are.
pub fn single_precision(colors: Vec<Rgb>) -> Vec<Color> {
    #[allow(clippy::unnecessary_cast)] // in single precision
    let narrow = |c: Rgb| Color::new(c.r as f32, c.g as f32, c.b as f32);
    colors.into_iter().map(narrow).collect()
}

/// A picture that is traced tile by tile.
struct TileRenderer<'w> {
    ray_tracers: &'w dyn RayTracerFactory,
    settings: &'w Settings,
    options: &'w RenderOptions<'w>,
    /// The pixels of the picture.
    area: Tile,
    progress: &'w dyn Progress,
}

/// What rays are traced for.
#[derive(Clone, Copy)]
enum Target<'c> {
    /// The upper left corners of pixels, which neighbours share.
    Corners(Subdivision),
    /// A raster of pixels, each at the corner of a block.
    Raster(Selection),
    /// Pixels, whose corners may be known.
    Pixels(CornerSource<'c>),
}

impl TileRenderer<'_> {
    /// Traces every pixel that is requested.
    fn all(&self) -> Result<Traced<Rgb>, Interrupt> {
        // All corners first, where all pixels are requested, so that none is traced twice.
        let (lattice, mut counts): Traced<PixelSample> = match parting(self.settings) {
            Some(parting) if self.options.mask.is_none() => {
                self.pixels(CornerGrid::corner_tile(self.area), Target::Corners(parting))?
            }
            _ => Default::default(),
        };
        let corners =
            CornerGrid::new(self.area, &lattice).map_or(CornerSource::Retraced, CornerSource::Lattice);
        let (colors, counted) = self.pixels(self.area, Target::Pixels(corners))?;
        counts.merge(&counted);
        Ok((colors, counts))
    }

    /// Traces some pixels, and interpolates the others that are requested.
    fn selected(&self, selection: Selection) -> Result<Traced<Rgb>, Interrupt> {
        let blocks = selection.blocks(self.area);
        let (raster, mut counts): Traced<PixelSample> = match self.options.mask {
            None => self.pixels(CornerGrid::corner_tile(blocks), Target::Raster(selection))?,
            Some(_) => Default::default(),
        };
        let corners = CornerGrid::new(blocks, &raster).map_or(CornerSource::Retraced, CornerSource::Lattice);

        // Blocks share what lies between them within a tile, so tiles are larger.
        let side = (2 * self.options.tile_side / selection.step()).max(1);
        let area = |blocks| selection.pixels_of(blocks).intersection(self.area);
        let (colors, counted) = self.tiles(blocks, side, area, |blocks, canvas| {
            let (mut cache, mut block_cache) = (self.sampler_cache(area(blocks)), cache_for(area(blocks)));
            let mut ray_tracer = self.ray_tracers.ray_tracer(self.progress);
            let sampler = AnySampler::new(self.settings, CornerSource::Retraced, &mut cache);
            let mut selected = PixelSelector::new(selection, sampler, corners, &mut block_cache);
            let is_requested = |block: &Pixel| {
                let block = Tile { top_left: *block, width: 1, height: 1 };
                self.options.mask.is_none()
                    || selection.pixels_of(block).pixels().any(|pixel| self.options.is_requested(pixel))
            };
            let blocks = blocks.pixels().filter(is_requested);
            render_selected(ray_tracer.as_mut(), &mut selected, blocks, canvas)?;
            Ok(ray_tracer.take_counters())
        })?;
        counts.merge(&counted);
        Ok((colors, counts))
    }

    /// Traces the pixels of `area` that are requested.
    fn pixels<R: FramebufferPixel + Send>(
        &self,
        area: Tile,
        target: Target<'_>,
    ) -> Result<Traced<R>, Interrupt> {
        self.tiles(
            area,
            self.options.tile_side,
            |tile| tile,
            |tile, canvas| {
                let mut cache = self.sampler_cache(tile);
                let mut ray_tracer = self.ray_tracers.ray_tracer(self.progress);
                let (tracer, all) = (ray_tracer.as_mut(), tile.pixels());
                match target {
                    Target::Corners(parting) => render(tracer, &mut CornerSampler(parting), all, canvas)?,
                    Target::Raster(selection) => {
                        let sampler = AnySampler::new(self.settings, CornerSource::Retraced, &mut cache);
                        render(tracer, &mut selection.corner_sampler(sampler), all, canvas)?;
                    }
                    Target::Pixels(corners) => {
                        let mut sampler = AnySampler::new(self.settings, corners, &mut cache);
                        render(
                            tracer,
                            &mut sampler,
                            all.filter(|pixel| self.options.is_requested(*pixel)),
                            canvas,
                        )?;
                    }
                }
                Ok(ray_tracer.take_counters())
            },
        )
    }

    /// Works on `cells`, tile by tile, and puts together what comes of it. `area` says which
    /// part of the picture a rectangle of cells is.
    fn tiles<R: FramebufferPixel + Send>(
        &self,
        cells: Tile,
        side: u32,
        area: impl Fn(Tile) -> Tile + Sync,
        work: impl Fn(Tile, &mut Canvas<'_, R>) -> Result<Counters, Interrupt> + Sync,
    ) -> Result<Traced<R>, Interrupt> {
        let whole = area(cells);
        self.progress.begin(whole.len());
        let list: Vec<Tile> = cells.tiles(side).collect();
        let traced: Vec<(Tile, Vec<R>, Counters)> = list
            .into_par_iter()
            .map(|cells| {
                let tile = area(cells);
                let mut records = vec![R::EMPTY; tile.len()];
                let (options, progress) = (self.options, self.progress);
                let counts = work(cells, &mut Canvas { tile, records: &mut records, options, progress })?;
                self.progress.done(tile.len());
                Ok((tile, records, counts))
            })
            .collect::<Result<_, Interrupt>>()?;

        let mut picture = vec![R::EMPTY; whole.len()];
        let mut counts = Counters::default();
        for (tile, records, counted) in traced {
            // A tile of cells that lie beyond the picture's edge has no pixel.
            let rows = records.chunks(tile.width.max(1) as usize).zip(tile.top_left.y..);
            for (row, y) in rows {
                if let Some(start) = whole.index_of(Pixel { x: tile.top_left.x, y }) {
                    picture[start..start + row.len()].copy_from_slice(row);
                }
            }
            counts.merge(&counted);
        }
        Ok((picture, counts))
    }

    /// The cache of a sampler that has one; making it takes longer than an easy pixel.
    fn sampler_cache(&self, tile: Tile) -> Vec<CacheEntry> {
        if parting(self.settings).is_some() { cache_for(tile) } else { Vec::new() }
    }
}

/// A cache for the samples of a tile.
fn cache_for(tile: Tile) -> Vec<CacheEntry> {
    vec![CacheEntry::EMPTY; MOST_CACHED.min(16 * tile.len())]
}

/// The pixels of one tile, until the work is interrupted.
struct Canvas<'m, R> {
    tile: Tile,
    records: &'m mut [R],
    options: &'m RenderOptions<'m>,
    progress: &'m dyn Progress,
}

impl<R: FramebufferPixel> Sink for Canvas<'_, R> {
    type Error = Interrupt;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Interrupt> {
        self.put_sample(pixel, PixelSample { color, hit: HitId::Nothing })
    }

    fn put_sample(&mut self, pixel: Pixel, sample: PixelSample) -> Result<(), Interrupt> {
        if let Some(place) = self.tile.index_of(pixel)
            && self.options.is_requested(pixel)
        {
            self.records[place] = R::from_sample(sample);
        }
        self.progress.check()
    }
}
