//! Tiles and threads.
//!
//! The picture is divided into tiles, which are distributed over threads. Each tile has its own ray tracer and its own
//! memory, so the number of threads changes neither the picture nor the counts. Samples that tiles share (pixel corners,
//! or a coarse grid of pixels) are traced first, also in tiles.

use rayon::prelude::*;

use strahl_core::image::{
    CacheEntry, FramebufferPixel, Pixel, PixelSelection, PixelSelector, PretracedCorners, Sink, Subdivision,
    UpperLeftCornerSampler,
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
use crate::samplers::{AnySampler, CornerSource, selection, subdivision};

/// The maximum number of cached samples of a tile.
const MAX_CACHED: usize = 1 << 14;

/// The records of pixels, row by row, and the counters.
pub type Traced<R> = (Vec<R>, Counters);

/// Traces the requested picture.
pub fn trace(
    ray_tracers: &dyn RayTracerFactory,
    settings: &Settings,
    options: &RenderOptions<'_>,
    progress: &dyn Progress,
) -> Result<Traced<Rgb>, Interrupt> {
    let renderer = TileRenderer { ray_tracers, settings, options, area: settings.region_or_all(), progress };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(settings.threads).build();
    // If no pool can be created, use the global one.
    let run = || match selection(settings) {
        Some(selection) => renderer.selected(selection),
        None => renderer.all(),
    };
    match pool {
        Ok(pool) => pool.install(run),
        Err(_) => run(),
    }
}

/// Converts colors to single precision; in single precision the vector is reused.
pub fn single_precision(colors: Vec<Rgb>) -> Vec<Color> {
    #[allow(clippy::unnecessary_cast)] // in single precision
    let narrow = |c: Rgb| Color::new(c.r as f32, c.g as f32, c.b as f32);
    colors.into_iter().map(narrow).collect()
}

/// Renders a picture tile by tile.
struct TileRenderer<'w> {
    ray_tracers: &'w dyn RayTracerFactory,
    settings: &'w Settings,
    options: &'w RenderOptions<'w>,
    /// The pixels to render.
    area: Tile,
    progress: &'w dyn Progress,
}

/// The samples to trace.
#[derive(Clone, Copy)]
enum Target<'c> {
    /// The upper left corners of pixels.
    Corners(Subdivision),
    /// A coarse grid: the pixel at the corner of each block.
    BlockCorners(PixelSelection),
    /// Pixels, with a source of corner samples.
    Pixels(CornerSource<'c>),
}

impl TileRenderer<'_> {
    /// Traces all requested pixels.
    fn all(&self) -> Result<Traced<Rgb>, Interrupt> {
        // If there is no mask, trace all corners first, so that none is traced twice.
        let (corner_samples, mut counts): Traced<PixelSample> = match subdivision(self.settings) {
            Some(subdivision) if self.options.mask.is_none() => {
                self.pixels(PretracedCorners::corner_tile(self.area), Target::Corners(subdivision))?
            }
            _ => Default::default(),
        };
        let corners = PretracedCorners::new(self.area, &corner_samples)
            .map_or(CornerSource::Retraced, CornerSource::Grid);
        let (colors, counted) = self.pixels(self.area, Target::Pixels(corners))?;
        counts.merge(&counted);
        Ok((colors, counts))
    }

    /// Traces the selected pixels, and interpolates the other requested ones.
    fn selected(&self, selection: PixelSelection) -> Result<Traced<Rgb>, Interrupt> {
        let blocks = selection.block_range(self.area);
        let (block_corners, mut counts): Traced<PixelSample> = match self.options.mask {
            None => self.pixels(PretracedCorners::corner_tile(blocks), Target::BlockCorners(selection))?,
            Some(_) => Default::default(),
        };
        let corners =
            PretracedCorners::new(blocks, &block_corners).map_or(CornerSource::Retraced, CornerSource::Grid);

        // Blocks within a tile share the pixels between them, so tiles are larger.
        let side = (2 * self.options.tile_side / selection.step()).max(1);
        let area = |blocks| selection.pixels_of(blocks).intersection(self.area);
        let (colors, counted) = self.tiles(blocks, side, area, |blocks, sink| {
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
            render_selected(ray_tracer.as_mut(), &mut selected, blocks, sink)?;
            Ok(ray_tracer.take_counters())
        })?;
        counts.merge(&counted);
        Ok((colors, counts))
    }

    /// Traces the requested pixels of `area`.
    fn pixels<R: FramebufferPixel + Send>(
        &self,
        area: Tile,
        target: Target<'_>,
    ) -> Result<Traced<R>, Interrupt> {
        self.tiles(
            area,
            self.options.tile_side,
            |tile| tile,
            |tile, sink| {
                let mut cache = self.sampler_cache(tile);
                let mut ray_tracer = self.ray_tracers.ray_tracer(self.progress);
                let (tracer, all) = (ray_tracer.as_mut(), tile.pixels());
                match target {
                    Target::Corners(subdivision) => {
                        render(tracer, &mut UpperLeftCornerSampler(subdivision), all, sink)?
                    }
                    Target::BlockCorners(selection) => {
                        let sampler = AnySampler::new(self.settings, CornerSource::Retraced, &mut cache);
                        render(tracer, &mut selection.first_pass_sampler(sampler), all, sink)?;
                    }
                    Target::Pixels(corners) => {
                        let mut sampler = AnySampler::new(self.settings, corners, &mut cache);
                        render(
                            tracer,
                            &mut sampler,
                            all.filter(|pixel| self.options.is_requested(*pixel)),
                            sink,
                        )?;
                    }
                }
                Ok(ray_tracer.take_counters())
            },
        )
    }

    /// Processes `cells` tile by tile in parallel, and assembles the results. `area` maps a rectangle of cells to pixels.
    fn tiles<R: FramebufferPixel + Send>(
        &self,
        cells: Tile,
        side: u32,
        area: impl Fn(Tile) -> Tile + Sync,
        work: impl Fn(Tile, &mut TileSink<'_, R>) -> Result<Counters, Interrupt> + Sync,
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
                let counts = work(cells, &mut TileSink { tile, records: &mut records, options, progress })?;
                self.progress.done(tile.len());
                Ok((tile, records, counts))
            })
            .collect::<Result<_, Interrupt>>()?;

        let mut picture = vec![R::EMPTY; whole.len()];
        let mut counts = Counters::default();
        for (tile, records, counted) in traced {
            // A tile of cells outside the picture has no pixels.
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

    /// The cache of the sampler, empty unless it is used: allocating it takes longer than a cheap pixel.
    fn sampler_cache(&self, tile: Tile) -> Vec<CacheEntry> {
        if subdivision(self.settings).is_some() { cache_for(tile) } else { Vec::new() }
    }
}

/// A cache for the samples of a tile.
fn cache_for(tile: Tile) -> Vec<CacheEntry> {
    vec![CacheEntry::EMPTY; MAX_CACHED.min(16 * tile.len())]
}

/// A sink for the pixels of one tile, which fails on cancellation.
struct TileSink<'m, R> {
    tile: Tile,
    records: &'m mut [R],
    options: &'m RenderOptions<'m>,
    progress: &'m dyn Progress,
}

impl<R: FramebufferPixel> Sink for TileSink<'_, R> {
    type Error = Interrupt;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), Interrupt> {
        self.put_sample(pixel, PixelSample { color, hit: HitId::Nothing })
    }

    fn put_sample(&mut self, pixel: Pixel, sample: PixelSample) -> Result<(), Interrupt> {
        if let Some(index) = self.tile.index_of(pixel)
            && self.options.is_requested(pixel)
        {
            self.records[index] = R::from_sample(sample);
        }
        self.progress.check()
    }
}
