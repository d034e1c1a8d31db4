//! A picture that becomes better pass by pass.
//!
//! Each pass makes a whole picture, the very one that a plain render of its settings makes, and continues what the passes
//! before have traced: a pixel of a coarse raster is not traced again by a finer one, and a pixel of many samples
//! continues where it stopped. What comes next, and when it is enough, is decided by a [`Scheduler`].

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use rayon::prelude::*;
use strahl_core::image::{CacheEntry, Pixel, PixelEstimate, StochasticSampler};
use strahl_core::scene::CameraSample;
use strahl_core::tally::Counters;
use strahl_core::trace::{PixelSample, RayTracer};
use strahl_core::{Real, Rgb, Tile};
use strahl_settings::{SamplerSettings, Settings};

use crate::options::RenderOptions;
use crate::progress::{Deadline, Interrupt, Progress};
use crate::ray_tracer::{CountingRayTracer, RayTracerFactory};
use crate::samplers::{AnySampler, CornerSource};
use crate::scheduler::{Outlook, Pass, PassStats, Scheduler};
use crate::tiles::{self, Traced, single_precision};

/// So many rays are sent before the clock is read again.
const RAYS_PER_CHECK: u32 = 16;

/// Traces passes until there is none to come, or the time is over; the last that was completed.
pub fn trace(
    ray_tracers: &dyn RayTracerFactory,
    settings: &Settings,
    options: &RenderOptions<'_>,
    progress: &dyn Progress,
    scheduler: &mut dyn Scheduler,
) -> Result<Traced<Rgb>, Interrupt> {
    let area = settings.region_or_all();
    let centers = Centers::new(area);
    let rays = AtomicU64::new(0);
    let once = PassFactory { ray_tracers, centers: Some(&centers), rays: &rays };
    let counting = PassFactory { ray_tracers, centers: None, rays: &rays };
    let mut estimates: Option<Estimates> = None;
    let mut last = (Vec::new(), Counters::default());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(settings.threads).build();
    loop {
        let outlook = Outlook {
            missing: centers.missing(),
            pixels: area.len() as u64,
            needs: &|tolerance| estimates.as_ref().map_or(0, |estimates| estimates.needs(tolerance)),
        };
        let Some(pass) = scheduler.next(&outlook) else { break };
        let progress = &Deadline::new(progress, pass.until);
        let settings = Settings { sampler: pass.sampler, select: pass.select, ..settings.clone() };
        let clock = Instant::now();
        rays.store(0, Ordering::Relaxed);
        let traced = match (pass.sampler, stochastic(&settings)) {
            (SamplerSettings::Single, _) => tiles::trace(&once, &settings, options, progress),
            (_, Some(rule)) => {
                let estimates =
                    estimates.get_or_insert_with(|| Estimates::new(area, options.tile_side, &pass));
                let mut run = || estimates.improve(&counting, options, &rule, progress);
                match &pool {
                    Ok(pool) => pool.install(run),
                    Err(_) => run(),
                }
            }
            // Every other sampler has nothing to continue.
            _ => tiles::trace(&counting, &settings, options, progress),
        };
        match traced {
            Ok((colors, counters)) => {
                last.1.merge(&counters);
                last.0 = colors;
                let (seconds, rays) = (clock.elapsed().as_secs_f64(), rays.load(Ordering::Relaxed));
                scheduler.done(&pass, PassStats { seconds, rays }, single_precision(last.0.clone()));
            }
            Err(Interrupt::TimeLimit) if !last.0.is_empty() => break,
            Err(interrupt) => return Err(interrupt),
        }
    }
    Ok(last)
}

fn stochastic(settings: &Settings) -> Option<StochasticSampler> {
    match AnySampler::new(settings, CornerSource::Retraced, &mut [CacheEntry::EMPTY; 0]) {
        AnySampler::Stochastic(rule) => Some(rule),
        _ => None,
    }
}

/// The samples through the centers of pixels, as far as they have been traced.
struct Centers {
    area: Tile,
    samples: Vec<OnceLock<PixelSample>>,
}

impl Centers {
    fn new(area: Tile) -> Self {
        Centers { area, samples: std::iter::repeat_with(OnceLock::new).take(area.len()).collect() }
    }

    /// How many have not been traced.
    fn missing(&self) -> u64 {
        self.samples.iter().filter(|sample| sample.get().is_none()).count() as u64
    }

    /// Where a sample is kept, if it goes through the center of a pixel.
    fn slot(&self, sample: &CameraSample) -> Option<&OnceLock<PixelSample>> {
        let (x, y) = (sample.point.x, sample.point.y);
        let pixel = Pixel { x: x as u32, y: y as u32 };
        let is_center = x - pixel.x as Real == 0.5 && y - pixel.y as Real == 0.5;
        self.samples.get(self.area.index_of(pixel).filter(|_| is_center)?)
    }
}

/// Ray tracers that count the rays that they send, and with `centers` send none of these twice.
struct PassFactory<'p> {
    ray_tracers: &'p dyn RayTracerFactory,
    centers: Option<&'p Centers>,
    rays: &'p AtomicU64,
}

impl RayTracerFactory for PassFactory<'_> {
    fn ray_tracer<'t>(&'t self, progress: &'t dyn Progress) -> Box<dyn CountingRayTracer + 't> {
        Box::new(PassRayTracer { ray_tracer: self.ray_tracers.ray_tracer(progress), factory: self, rays: 0 })
    }
}

struct PassRayTracer<'p> {
    ray_tracer: Box<dyn CountingRayTracer + 'p>,
    factory: &'p PassFactory<'p>,
    rays: u64,
}

impl RayTracer for PassRayTracer<'_> {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        let Some(slot) = self.factory.centers.and_then(|centers| centers.slot(&sample)) else {
            self.rays += 1;
            return self.ray_tracer.trace(sample);
        };
        *slot.get_or_init(|| {
            self.rays += 1;
            self.ray_tracer.trace(sample)
        })
    }
}

impl CountingRayTracer for PassRayTracer<'_> {
    fn take_counters(&mut self) -> Counters {
        self.ray_tracer.take_counters()
    }
}

impl Drop for PassRayTracer<'_> {
    fn drop(&mut self) {
        self.factory.rays.fetch_add(self.rays, Ordering::Relaxed);
    }
}

/// The needs of a tolerance are estimated from about so many pixels, evenly spread: there is little time to plan in.
const PLANNING_PIXELS: usize = 1 << 14;

/// All pixels with the samples that they have had so far, tile by tile.
struct Estimates {
    area: Tile,
    tiles: Vec<(Tile, Vec<PixelEstimate>)>,
    /// The least samples of a pixel.
    least: u32,
    /// Standard errors in the confidence radius of a pixel.
    errors: f64,
    /// Of some pixels, the number of rays and the confidence radius of the mean.
    radii: Vec<(u32, f64)>,
}

impl Estimates {
    /// No sample yet.
    fn new(area: Tile, side: u32, pass: &Pass) -> Self {
        let tiles = area.tiles(side).map(|tile| (tile, vec![PixelEstimate::EMPTY; tile.len()])).collect();
        let (least, errors) = match pass.sampler {
            SamplerSettings::Stochastic { min_samples: least, confidence, .. } => {
                (least, confidence.standard_errors())
            }
            _ => (1, 1.0),
        };
        Estimates { area, tiles, least, errors, radii: Vec::new() }
    }

    /// One pixel of so many stands for the others: an odd number, so that it follows no raster of tiles.
    fn stride(&self) -> usize {
        (self.area.len() / PLANNING_PIXELS) | 1
    }

    /// How many more rays it takes until all pixels are known to this tolerance, if their samples stay as different as
    /// they were.
    fn needs(&self, tolerance: f32) -> u64 {
        let more = |(rays, radius): &(u32, f64)| {
            if *rays == 0 || *radius <= f64::from(tolerance) || !radius.is_finite() {
                return 0;
            }
            let (rays, ratio) = (f64::from(*rays), radius / f64::from(tolerance));
            let all = (rays * ratio * ratio).min(f64::from(StochasticSampler::MAX_SAMPLES));
            // In whole steps.
            ((all - rays) as u64).next_multiple_of(u64::from(self.least))
        };
        self.stride() as u64 * self.radii.iter().map(more).sum::<u64>()
    }

    #[allow(clippy::unnecessary_cast)] // in double precision
    fn radii(&self) -> Vec<(u32, f64)> {
        let pixels = self.tiles.iter().flat_map(|(_, pixels)| pixels);
        let radius = |pixel: &PixelEstimate| pixel.confidence_radius(self.errors as Real) as f64;
        pixels.step_by(self.stride()).map(|pixel| (pixel.sample_count(), radius(pixel))).collect()
    }

    /// Continues every pixel that is requested, until it fulfils the rule.
    fn improve(
        &mut self,
        ray_tracers: &PassFactory<'_>,
        options: &RenderOptions<'_>,
        rule: &StochasticSampler,
        progress: &dyn Progress,
    ) -> Result<Traced<Rgb>, Interrupt> {
        progress.begin(self.area.len());
        let work = |(tile, pixels): &mut (Tile, Vec<PixelEstimate>)| {
            let mut ray_tracer = ray_tracers.ray_tracer(progress);
            // A pixel may take many rays, and the time may be over before the last of them: what they bring then does
            // not matter, for the whole pass is given up.
            let (mut rays, mut is_over) = (0_u32, false);
            let mut trace = |sample: CameraSample| {
                rays = rays.wrapping_add(1);
                is_over = is_over || rays % RAYS_PER_CHECK == 0 && progress.check().is_err();
                if is_over { PixelSample::BLACK } else { ray_tracer.trace(sample) }
            };
            for (pixel, estimate) in tile.pixels().zip(pixels.iter_mut()) {
                if options.is_requested(pixel) {
                    rule.continue_pixel(pixel, estimate, &mut trace);
                }
                progress.check()?;
            }
            progress.done(tile.len());
            Ok(ray_tracer.take_counters())
        };
        let counted: Vec<Counters> = self.tiles.par_iter_mut().map(work).collect::<Result<_, Interrupt>>()?;
        let mut counters = Counters::default();
        counted.iter().for_each(|counted| counters.merge(counted));

        self.radii = self.radii();
        let mut colors = vec![Rgb::BLACK; self.area.len()];
        for (tile, pixels) in &self.tiles {
            for (pixel, estimate) in tile.pixels().zip(pixels) {
                if let Some(place) = self.area.index_of(pixel) {
                    colors[place] = estimate.to_sample().color;
                }
            }
        }
        Ok((colors, counters))
    }
}
