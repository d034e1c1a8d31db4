//! Samplers: the rays of a pixel and their combination.

use super::pixel::Pixel;
use crate::math::{Real, Rgb, SobolSequence};
use crate::scene::FilmPoint;
use crate::trace::{HitId, PixelSample, RayTracer};

/// Chooses the camera rays of a pixel and combines their samples into its color.
///
/// ```
/// use strahl_core::image::{Pixel, Sampler};
/// use strahl_core::math::SobolSequence;
/// use strahl_core::scene::{CameraSample, FilmPoint};
/// use strahl_core::trace::{PixelSample, RayTracer};
///
/// /// One ray through the upper left corner of each pixel.
/// struct UpperLeft;
///
/// impl Sampler for UpperLeft {
///     fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
///         let point = FilmPoint { x: pixel.x as f32, y: pixel.y as f32 };
///         tracer.trace(CameraSample { point, sequence: SobolSequence::new(pixel.x, pixel.y, 0, 0) })
///     }
/// }
/// ```
pub trait Sampler {
    /// Samples `pixel` with camera rays that `tracer` traces.
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample;

    /// Removes all cached samples, before another picture. By default does nothing.
    fn reset(&mut self) {}
}

/// A borrowed sampler.
impl<S: Sampler> Sampler for &mut S {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        S::sample_pixel(self, pixel, tracer)
    }

    fn reset(&mut self) {
        S::reset(self);
    }
}

/// The point at `(x, y)` of a pixel, relative to its upper left corner.
pub(super) fn film_point(pixel: Pixel, x: Real, y: Real) -> FilmPoint {
    FilmPoint { x: pixel.x as Real + x, y: pixel.y as Real + y }
}

/// Sample sequence of the sample with this index in a pixel.
pub(super) fn sequence(pixel: Pixel, index: u32, seed: u32) -> SobolSequence {
    SobolSequence::new(pixel.x, pixel.y, index, seed)
}

/// Running mean of samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleMean {
    sum: Rgb,
    hit: Option<HitId>,
    pub(super) count: u32,
}

impl SampleMean {
    pub(super) const EMPTY: SampleMean = SampleMean { sum: Rgb::BLACK, hit: None, count: 0 };

    pub(super) fn add(&mut self, sample: PixelSample) {
        self.sum += sample.color;
        self.hit = Some(self.hit.map_or(sample.hit, |hit| hit.same_or_mixed(sample.hit)));
        self.count += 1;
    }

    /// The mean; black without samples.
    pub(super) fn sample(&self) -> PixelSample {
        let scale = if self.count > 0 { 1.0 / self.count as Real } else { 0.0 };
        PixelSample { color: self.sum * scale, hit: self.hit.unwrap_or(HitId::Nothing) }
    }
}
