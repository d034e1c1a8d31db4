//! Which rays make a pixel.

use super::pixel::Pixel;
use crate::math::{Real, Rgb, SobolSequence};
use crate::scene::FilmPoint;
use crate::trace::{HitId, PixelSample, RayTracer};

/// Chooses the places of a pixel that rays are sent through, and makes one colour of them.
pub trait Sampler {
    /// Samples `pixel` with camera rays that `tracer` traces.
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample;

    /// A new picture begins: what was kept of another is forgotten.
    fn reset(&mut self) {}
}

/// A sampler that somebody else goes on using.
impl<S: Sampler> Sampler for &mut S {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        S::sample_pixel(self, pixel, tracer)
    }

    fn reset(&mut self) {
        S::reset(self);
    }
}

/// The place `(x, y)` inside a pixel, from its upper left corner; both in `0..=1`.
pub(super) fn film_point(pixel: Pixel, x: Real, y: Real) -> FilmPoint {
    FilmPoint { x: pixel.x as Real + x, y: pixel.y as Real + y }
}

/// The numbers of the sample `index` of a pixel.
pub(super) fn sequence(pixel: Pixel, index: u32, seed: u32) -> SobolSequence {
    SobolSequence::new(pixel.x, pixel.y, index, seed)
}

/// The mean of some samples, as they come.
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
        self.hit = Some(self.hit.map_or(sample.hit, |hit| hit.merged(sample.hit)));
        self.count += 1;
    }

    /// Of nothing: darkness.
    pub(super) fn to_sample(&self) -> PixelSample {
        let share = if self.count > 0 { 1.0 / self.count as Real } else { 0.0 };
        PixelSample { color: self.sum * share, hit: self.hit.unwrap_or(HitId::Nothing) }
    }
}
