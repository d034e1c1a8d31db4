//! A picture that becomes better pass by pass, for either precision.
//!
//! Each pass makes a whole picture, the very one that a plain render of its settings makes, and
//! goes on from what the passes before have traced: a pixel that a coarse raster has seen is not
//! traced again by a finer one, and a pixel of many samples goes on where it stopped. What comes
//! next, and when it is enough, is decided by a [`Scheduler`].

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use rayon::prelude::*;

use super::ray_tracer::{CountingRayTracer, RayTracerFactory};
use super::samplers::{Any, Shared};
use super::strahl::{
    CameraSample, Counters, Gathered, Kept, Pixel, PixelSample, RayTracer, Rgb, Stochastic, Tile,
};
use super::tiles::{self, Traced};
use crate::interrupt::Interrupt;
use crate::progress::{Deadline, Progress};
use crate::render_request::RenderRequest;
use crate::sampling::Sampling;
use crate::scheduler::{Outlook, Pass, PassStats, Scheduler};
use strahl_settings::Settings;

/// So many rays are sent before the clock is asked again.
const BETWEEN: u32 = 16;

/// Traces passes until there is none to come, or the time is over; the last that was completed.
pub fn trace(
    ray_tracers: &dyn RayTracerFactory,
    request: &RenderRequest,
    progress: &dyn Progress,
    scheduler: &mut dyn Scheduler,
) -> Result<Traced<Rgb>, Interrupt> {
    let whole = request.settings.area();
    let known = Known { whole, sights: std::iter::repeat_with(OnceLock::new).take(whole.len()).collect() };
    let rays = AtomicU64::new(0);
    let remembering = Remembering { ray_tracers, known: Some(&known), rays: &rays };
    let counting = Remembering { ray_tracers, known: None, rays: &rays };
    let mut grown: Option<Grown> = None;
    let mut last = (Vec::new(), Counters::default());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(request.settings.threads).build();
    loop {
        let outlook = Outlook {
            missing: known.sights.iter().filter(|sight| sight.get().is_none()).count() as u64,
            pixels: whole.len() as u64,
            needs: &|tolerance| grown.as_ref().map_or(0, |grown| grown.needs(tolerance)),
        };
        let Some(pass) = scheduler.next(&outlook) else { break };
        let progress = &Deadline::new(progress, pass.until);
        let settings =
            Settings { sampler: pass.sampling, select: pass.selecting, ..request.settings.clone() };
        let request = &request.with(settings);
        let clock = Instant::now();
        rays.store(0, Ordering::Relaxed);
        let traced = match (pass.sampling, stochastic(&request.settings)) {
            (Sampling::Single, _) => tiles::trace(&remembering, request, progress),
            (_, Some(rule)) => {
                let grown = grown.get_or_insert_with(|| Grown::new(whole, request.tile, &pass));
                let mut run = || grown.go_on(&counting, request, &rule, progress);
                match &pool {
                    Ok(pool) => pool.install(run),
                    Err(_) => run(),
                }
            }
            // Whatever else has nothing to go on from.
            _ => tiles::trace(&counting, request, progress),
        };
        match traced {
            Ok((colors, counts)) => {
                last.1.add(&counts);
                last.0 = colors;
                let stats =
                    PassStats { seconds: clock.elapsed().as_secs_f64(), rays: rays.load(Ordering::Relaxed) };
                let picture = last.0.iter().map(|c| narrow(*c)).collect();
                scheduler.done(&pass, stats, picture);
            }
            Err(Interrupt::TimeLimit) if !last.0.is_empty() => break,
            Err(stop) => return Err(stop),
        }
    }
    Ok(last)
}

#[allow(clippy::unnecessary_cast)] // in single precision
fn narrow(c: Rgb) -> strahl_core::Rgb {
    strahl_core::Rgb::new(c.r as f32, c.g as f32, c.b as f32)
}

fn stochastic(settings: &Settings) -> Option<Stochastic> {
    match Any::of(settings, Shared::Loose, &mut [Kept::NOTHING; 0]) {
        Any::Stochastic(rule) => Some(rule),
        _ => None,
    }
}

/// What is seen through the middle of pixels.
struct Known {
    whole: Tile,
    sights: Vec<OnceLock<PixelSample>>,
}

impl Known {
    /// Where what is seen along a ray is kept, if that goes through the middle of a pixel.
    fn slot(&self, sample: &CameraSample) -> Option<&OnceLock<PixelSample>> {
        let (x, y) = (sample.point.x, sample.point.y);
        let pixel = Pixel { x: x as u32, y: y as u32 };
        let is_middle =
            x - pixel.x as super::strahl::Real == 0.5 && y - pixel.y as super::strahl::Real == 0.5;
        let place = self.whole.place(pixel).filter(|_| is_middle)?;
        self.sights.get(place)
    }
}

/// Counts the rays that it traces, and where something is known of the middles of pixels, traces
/// none of these twice.
struct Remembering<'e> {
    ray_tracers: &'e dyn RayTracerFactory,
    known: Option<&'e Known>,
    rays: &'e AtomicU64,
}

impl RayTracerFactory for Remembering<'_> {
    fn ray_tracer<'t>(&'t self, progress: &'t dyn Progress) -> Box<dyn CountingRayTracer + 't> {
        Box::new(Minding { ray_tracer: self.ray_tracers.ray_tracer(progress), all: self, rays: 0 })
    }
}

struct Minding<'m> {
    ray_tracer: Box<dyn CountingRayTracer + 'm>,
    all: &'m Remembering<'m>,
    rays: u64,
}

impl RayTracer for Minding<'_> {
    fn trace(&mut self, sample: CameraSample) -> PixelSample {
        let Some(slot) = self.all.known.and_then(|known| known.slot(&sample)) else {
            self.rays += 1;
            return self.ray_tracer.trace(sample);
        };
        *slot.get_or_init(|| {
            self.rays += 1;
            self.ray_tracer.trace(sample)
        })
    }
}

impl CountingRayTracer for Minding<'_> {
    fn take_counters(&mut self) -> Counters {
        self.ray_tracer.take_counters()
    }
}

impl Drop for Minding<'_> {
    fn drop(&mut self) {
        self.all.rays.fetch_add(self.rays, Ordering::Relaxed);
    }
}

/// Of about so many pixels it is asked how well they are known: the others are as these. There is little
/// time to plan in.
const ASKED: usize = 1 << 14;

/// All pixels with the samples that they have seen so far, tile by tile.
struct Grown {
    whole: Tile,
    tiles: Vec<(Tile, Vec<Gathered>)>,
    least: u32,
    errors: f64,
    /// Of some pixels, how many rays they have seen, and how far their mean may be off.
    doubts: Vec<(u32, f64)>,
}

impl Grown {
    /// None yet.
    fn new(whole: Tile, side: u32, pass: &Pass) -> Self {
        let tiles = whole.tiles(side).map(|tile| (tile, vec![Gathered::NONE; tile.len()])).collect();
        let (least, errors) = match pass.sampling {
            Sampling::Stochastic { least, confidence, .. } => (least, confidence.errors()),
            _ => (1, 1.0),
        };
        Grown { whole, tiles, least, errors, doubts: Vec::new() }
    }

    /// One pixel of so many is asked: an odd number, so that it follows no raster of tiles.
    fn stride(&self) -> usize {
        (self.whole.len() / ASKED) | 1
    }

    /// How many more rays it takes until all pixels are known this well, if their samples stay as
    /// different as they were.
    fn needs(&self, tolerance: f32) -> u64 {
        let more = |(rays, doubt): &(u32, f64)| {
            if *rays == 0 || *doubt <= f64::from(tolerance) || !doubt.is_finite() {
                return 0;
            }
            let (rays, ratio) = (f64::from(*rays), doubt / f64::from(tolerance));
            let all = (rays * ratio * ratio).min(f64::from(Stochastic::MOST));
            // In whole steps.
            ((all - rays) as u64).next_multiple_of(u64::from(self.least))
        };
        self.stride() as u64 * self.doubts.iter().map(more).sum::<u64>()
    }

    /// How well some pixels are known.
    #[allow(clippy::unnecessary_cast)] // in double precision
    fn doubts(&self) -> Vec<(u32, f64)> {
        let pixels = self.tiles.iter().flat_map(|(_, pixels)| pixels);
        let doubt = |pixel: &Gathered| pixel.doubt(self.errors as super::strahl::Real) as f64;
        pixels.step_by(self.stride()).map(|pixel| (pixel.rays(), doubt(pixel))).collect()
    }

    /// Goes on with every pixel that is requested, until it fulfils the rule.
    fn go_on(
        &mut self,
        ray_tracers: &Remembering<'_>,
        request: &RenderRequest,
        rule: &Stochastic,
        progress: &dyn Progress,
    ) -> Result<Traced<Rgb>, Interrupt> {
        progress.begin(self.whole.len());
        let work = |(tile, pixels): &mut (Tile, Vec<Gathered>)| {
            let mut ray_tracer = ray_tracers.ray_tracer(progress);
            // A pixel may take many rays, and the time may be over before the last of them: what is
            // seen then does not matter any more, for the whole pass is given up.
            let (mut rays, mut is_over) = (0_u32, false);
            let mut trace = |sample: CameraSample| {
                rays = rays.wrapping_add(1);
                is_over = is_over || rays % BETWEEN == 0 && progress.check().is_err();
                if is_over { PixelSample::BLACK } else { ray_tracer.trace(sample) }
            };
            for (pixel, gathered) in tile.pixels().zip(pixels.iter_mut()) {
                if tiles::is_wanted(request, pixel) {
                    rule.continue_pixel(pixel, gathered, &mut trace);
                }
                progress.check()?;
            }
            progress.done(tile.len());
            Ok(ray_tracer.take_counters())
        };
        let counted: Vec<Counters> = self.tiles.par_iter_mut().map(work).collect::<Result<_, Interrupt>>()?;
        let mut counts = Counters::default();
        counted.iter().for_each(|counted| counts.add(counted));

        self.doubts = self.doubts();
        let mut colors = vec![Rgb::BLACK; self.whole.len()];
        for (tile, pixels) in &self.tiles {
            for (pixel, gathered) in tile.pixels().zip(pixels) {
                if let Some(place) = self.whole.place(pixel) {
                    colors[place] = gathered.sample().color;
                }
            }
        }
        Ok((colors, counts))
    }
}
