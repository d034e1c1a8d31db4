//! Selection of a sampler.
//!
//! One enum for all samplers, so that the pixel loop is compiled only once: the choice is made once for each pixel.

use strahl_core::Real;
use strahl_core::image::{
    AdaptiveSampler, CacheEntry, CornerCache, Pixel, PixelSelection, PretracedCorners, RegularSampler,
    Sampler, StochasticSampler, Subdivision, UncachedCorners,
};
use strahl_core::trace::{PixelSample, RayTracer};
use strahl_settings::{SamplerSettings, Settings};

/// Any of the samplers.
pub enum AnySampler<'m> {
    /// A regular grid of rays.
    Regular(RegularSampler),
    /// Quasi-random samples.
    Stochastic(StochasticSampler),
    /// Adaptive subdivision of pixels.
    Adaptive(AdaptiveSampler<'m, CornerSource<'m>>),
}

/// The source of samples at pixel corners.
#[derive(Clone, Copy)]
pub enum CornerSource<'m> {
    /// Samples that have been traced before.
    Grid(PretracedCorners<'m>),
    /// Each pixel traces its own corners.
    Retraced,
}

impl CornerCache for CornerSource<'_> {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        match self {
            CornerSource::Grid(grid) => grid.corners(cell, find),
            CornerSource::Retraced => UncachedCorners.corners(cell, find),
        }
    }
}

impl Sampler for AnySampler<'_> {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        match self {
            AnySampler::Regular(it) => it.sample_pixel(pixel, tracer),
            AnySampler::Stochastic(it) => it.sample_pixel(pixel, tracer),
            AnySampler::Adaptive(it) => it.sample_pixel(pixel, tracer),
        }
    }

    fn reset(&mut self) {
        match self {
            AnySampler::Regular(it) => it.reset(),
            AnySampler::Stochastic(it) => it.reset(),
            AnySampler::Adaptive(it) => it.reset(),
        }
    }
}

impl<'m> AnySampler<'m> {
    /// The sampler of the settings. `corners` and `cache` are used by adaptive sampling.
    ///
    /// Settings out of range, which the command line rejects, give one ray per pixel.
    pub fn new(settings: &Settings, corners: CornerSource<'m>, cache: &'m mut [CacheEntry]) -> Self {
        let (filter, seed) = (filter(settings.filter), settings.seed);
        let regular =
            |n| RegularSampler::new(n).unwrap_or(RegularSampler::CENTER).with_filter(filter).with_seed(seed);
        match settings.sampler {
            SamplerSettings::Single => AnySampler::Regular(regular(1)),
            SamplerSettings::Regular(n) => AnySampler::Regular(regular(n)),
            SamplerSettings::Adaptive { .. } => match subdivision(settings) {
                Some(subdivision) => AnySampler::Adaptive(AdaptiveSampler::new(subdivision, corners, cache)),
                None => AnySampler::Regular(regular(1)),
            },
            SamplerSettings::Stochastic { min_samples: least, max_samples: most, confidence } => {
                #[allow(clippy::unnecessary_cast)] // in double precision
                let ends = strahl_core::image::Confidence {
                    standard_errors: confidence.standard_errors() as Real,
                    tolerance: Real::from(confidence.tolerance),
                };
                match StochasticSampler::with_range(least, most, ends) {
                    Some(it) => AnySampler::Stochastic(it.with_filter(filter).with_seed(seed)),
                    None => AnySampler::Regular(regular(1)),
                }
            }
        }
    }
}

/// The subdivision of pixels; `None` if the sampler is not adaptive.
pub fn subdivision(settings: &Settings) -> Option<Subdivision> {
    match settings.sampler {
        SamplerSettings::Adaptive { max_depth: depth, contrast: it } => {
            Some(Subdivision::new(depth, contrast_threshold(it)?)?.with_seed(settings.seed))
        }
        _ => None,
    }
}

/// The selection of pixels that are traced; `None` for all.
pub fn selection(settings: &Settings) -> Option<PixelSelection> {
    let it = settings.select?;
    PixelSelection::new(it.step, contrast_threshold(it.contrast)?)
}

fn contrast_threshold(
    it: strahl_settings::ContrastSettings,
) -> Option<strahl_core::image::ContrastThreshold> {
    let colors = strahl_core::image::ContrastThreshold::new(Real::from(it.threshold))?;
    Some(if it.items { colors.with_items() } else { colors })
}

fn filter(filter: strahl_settings::Filter) -> strahl_core::image::Filter {
    match filter {
        strahl_settings::Filter::Box => strahl_core::image::Filter::Box,
        strahl_settings::Filter::Tent => strahl_core::image::Filter::Tent,
        strahl_settings::Filter::Gaussian => strahl_core::image::Filter::Gaussian,
    }
}
