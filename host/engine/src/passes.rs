//! Progressive rendering.
//!
//! Each pass produces a complete picture, identical to a plain render with the settings of that pass, and reuses all samples
//! of earlier passes: pixel centers are cached, and stochastic pixels continue their sample sequence. A [`Scheduler`]
//! selects the passes.

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

/// The number of rays of a pixel between two checks for cancellation.
const RAYS_PER_CHECK: u32 = 16;

/// Renders passes until the scheduler ends them or the time limit is exceeded; returns the last completed picture.
pub fn trace(
    ray_tracers: &dyn RayTracerFactory,
    settings: &Settings,
    options: &RenderOptions<'_>,
    progress: &dyn Progress,
    scheduler: &mut dyn Scheduler,
) -> Result<Traced<Rgb>, Interrupt> {
    let area = settings.region_or_all();
    let centers = PixelCenterCache::new(area);
    let rays = AtomicU64::new(0);
    let once = PassFactory { ray_tracers, centers: Some(&centers), rays: &rays };
    let counting = PassFactory { ray_tracers, centers: None, rays: &rays };
    let mut estimates: Option<PixelEstimates> = None;
    let mut last = (Vec::new(), Counters::default());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(settings.threads).build();
    loop {
        let outlook = Outlook {
            untraced_pixels: centers.untraced(),
            pixels: area.len() as u64,
            rays_for_tolerance: &|tolerance| {
                estimates.as_ref().map_or(0, |estimates| estimates.rays_for_tolerance(tolerance))
            },
        };
        let Some(pass) = scheduler.next(&outlook) else { break };
        let progress = &Deadline::new(progress, pass.deadline);
        let settings = Settings { sampler: pass.sampler, select: pass.select, ..settings.clone() };
        let start = Instant::now();
        rays.store(0, Ordering::Relaxed);
        let traced = match (pass.sampler, stochastic(&settings)) {
            (SamplerSettings::Single, _) => tiles::trace(&once, &settings, options, progress),
            (_, Some(rule)) => {
                let estimates =
                    estimates.get_or_insert_with(|| PixelEstimates::new(area, options.tile_side, &pass));
                let mut run = || estimates.refine(&counting, options, &rule, progress);
                match &pool {
                    Ok(pool) => pool.install(run),
                    Err(_) => run(),
                }
            }
            // Other samplers have no samples to reuse.
            _ => tiles::trace(&counting, &settings, options, progress),
        };
        match traced {
            Ok((colors, counters)) => {
                last.1.merge(&counters);
                last.0 = colors;
                let (seconds, rays) = (start.elapsed().as_secs_f64(), rays.load(Ordering::Relaxed));
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

/// Cached samples at pixel centers.
struct PixelCenterCache {
    area: Tile,
    samples: Vec<OnceLock<PixelSample>>,
}

impl PixelCenterCache {
    fn new(area: Tile) -> Self {
        PixelCenterCache { area, samples: std::iter::repeat_with(OnceLock::new).take(area.len()).collect() }
    }

    /// The number of pixel centers that have not been traced.
    fn untraced(&self) -> u64 {
        self.samples.iter().filter(|sample| sample.get().is_none()).count() as u64
    }

    /// The cache entry of a sample; `None` if it is not at a pixel center.
    fn slot(&self, sample: &CameraSample) -> Option<&OnceLock<PixelSample>> {
        let (x, y) = (sample.point.x, sample.point.y);
        let pixel = Pixel { x: x as u32, y: y as u32 };
        let is_center = x - pixel.x as Real == 0.5 && y - pixel.y as Real == 0.5;
        self.samples.get(self.area.index_of(pixel).filter(|_| is_center)?)
    }
}

/// Creates ray tracers that count camera rays, and with `centers` trace each pixel center only once.
struct PassFactory<'p> {
    ray_tracers: &'p dyn RayTracerFactory,
    centers: Option<&'p PixelCenterCache>,
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

/// The approximate number of pixels from which the rays for a tolerance are estimated.
const SAMPLED_PIXELS: usize = 1 << 14;

/// The accumulated samples of all pixels, tile by tile.
struct PixelEstimates {
    area: Tile,
    tiles: Vec<(Tile, Vec<PixelEstimate>)>,
    /// The minimum number of samples of a pixel.
    min_samples: u32,
    /// The number of standard errors in a confidence radius.
    standard_errors: f64,
    /// The number of rays and the confidence radius of the mean, of some pixels.
    confidence_radii: Vec<(u32, f64)>,
}

impl PixelEstimates {
    /// No samples.
    fn new(area: Tile, side: u32, pass: &Pass) -> Self {
        let tiles = area.tiles(side).map(|tile| (tile, vec![PixelEstimate::EMPTY; tile.len()])).collect();
        let (min_samples, standard_errors) = match pass.sampler {
            SamplerSettings::Stochastic { min_samples, confidence, .. } => {
                (min_samples, confidence.standard_errors())
            }
            _ => (1, 1.0),
        };
        PixelEstimates { area, tiles, min_samples, standard_errors, confidence_radii: Vec::new() }
    }

    /// One pixel of this many is used for estimates: an odd number, to avoid alignment with tiles.
    fn stride(&self) -> usize {
        (self.area.len() / SAMPLED_PIXELS) | 1
    }

    /// The estimated number of further rays until the mean of every pixel is within this tolerance, if the variance of its
    /// samples does not change.
    fn rays_for_tolerance(&self, tolerance: f32) -> u64 {
        let more = |(rays, radius): &(u32, f64)| {
            if *rays == 0 || *radius <= f64::from(tolerance) || !radius.is_finite() {
                return 0;
            }
            let (rays, ratio) = (f64::from(*rays), radius / f64::from(tolerance));
            let all = (rays * ratio * ratio).min(f64::from(StochasticSampler::MAX_SAMPLES));
            // In steps of the minimum number of samples.
            ((all - rays) as u64).next_multiple_of(u64::from(self.min_samples))
        };
        self.stride() as u64 * self.confidence_radii.iter().map(more).sum::<u64>()
    }

    #[allow(clippy::unnecessary_cast)] // in double precision
    fn estimate_radii(&self) -> Vec<(u32, f64)> {
        let pixels = self.tiles.iter().flat_map(|(_, pixels)| pixels);
        let radius =
            |pixel: &PixelEstimate| pixel.srgb_confidence_radius(self.standard_errors as Real) as f64;
        pixels.step_by(self.stride()).map(|pixel| (pixel.sample_count(), radius(pixel))).collect()
    }

    /// Continues the samples of all requested pixels until they satisfy the rule.
    fn refine(
        &mut self,
        ray_tracers: &PassFactory<'_>,
        options: &RenderOptions<'_>,
        rule: &StochasticSampler,
        progress: &dyn Progress,
    ) -> Result<Traced<Rgb>, Interrupt> {
        progress.begin(self.area.len());
        let work = |(tile, pixels): &mut (Tile, Vec<PixelEstimate>)| {
            let mut ray_tracer = ray_tracers.ray_tracer(progress);
            // A pixel may take many rays. After cancellation their results do not matter, because the whole pass is
            // discarded.
            let (mut rays, mut is_cancelled) = (0_u32, false);
            let mut trace = |sample: CameraSample| {
                rays = rays.wrapping_add(1);
                is_cancelled = is_cancelled || rays % RAYS_PER_CHECK == 0 && progress.check().is_err();
                if is_cancelled { PixelSample::BLACK } else { ray_tracer.trace(sample) }
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

        self.confidence_radii = self.estimate_radii();
        let mut colors = vec![Rgb::BLACK; self.area.len()];
        for (tile, pixels) in &self.tiles {
            for (pixel, estimate) in tile.pixels().zip(pixels) {
                if let Some(index) = self.area.index_of(pixel) {
                    colors[index] = estimate.to_sample().color;
                }
            }
        }
        Ok((colors, counters))
    }
}
