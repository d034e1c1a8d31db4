//! Stochastic supersampling: film points without a regular grid, which turns aliasing into noise.
//!
//! The film points of a pixel are those of a low-discrepancy sequence, scrambled differently for each pixel
//! ([`SobolSequence`](crate::math::SobolSequence)).
//!
//! The other random numbers of a ray (point on a light, point on the lens, time) come from other dimensions
//! of the sequence. Their index is chosen by the film point: rays are numbered in Morton order of the part of
//! the pixel that they pass through. Aligned ranges of indices of the sequence are stratified, so the points
//! on a light are stratified in each part of the pixel, too. This reduces the error of effects that depend on
//! both, such as soft shadows.
//!
//! With a range of sample counts, a pixel is finished when its mean is accurate enough: when the confidence
//! interval, computed from the variance of the samples so far, is at most the tolerance. The variance is that of independent samples, which is larger than that of stratified ones, so the rule errs
//! towards more rays. It uses the same samples as the mean, so details that the first samples miss are lost,
//! and small details become slightly darker the smaller the minimum is (Kirk and Arvo, "Unbiased Sampling
//! Techniques for Image Synthesis", SIGGRAPH 1991).
//!
//! Source: Lee, Redner and Uselton, "Statistically Optimized Sampling for Distributed Ray Tracing", SIGGRAPH
//! 1985.

use super::filter::Filter;
use super::filter_sample::sample_filter;
use super::pixel::Pixel;
use super::pixel_estimate::PixelEstimate;
use super::sampler::{Sampler, film_point, sequence};
use crate::math::{Dimension, Real};
use crate::scene::CameraSample;
use crate::trace::{PixelSample, RayTracer};

/// Stochastic sampler: rays through random film points of a pixel, and their mean.
///
/// ```
/// use strahl_core::image::{Confidence, StochasticSampler};
///
/// let fixed = StochasticSampler::new(64);
/// // 8 to 512 rays, until the 95 % confidence interval is at most 0.01 to both sides.
/// let confidence = Confidence { standard_errors: 1.96, tolerance: 0.01 };
/// let adaptive = StochasticSampler::with_range(8, 512, confidence);
/// assert!(fixed.is_some() && adaptive.is_some());
/// ```
#[derive(Clone, Copy, Debug)]
#[doc(alias = "antialiasing")]
pub struct StochasticSampler {
    min_samples: u32,
    max_samples: u32,
    confidence: Confidence,
    filter: Filter,
    seed: u32,
}

/// Stopping rule of a [`StochasticSampler`]: the confidence interval of the mean at which a pixel is
/// finished.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Confidence {
    /// Half width of the confidence interval in standard errors: the quantile of the normal distribution,
    /// 1.96 for a confidence of 95 %. In `(0, inf)`.
    pub standard_errors: Real,
    /// Largest half width of the confidence interval of a finished pixel (sRGB-encoded, largest channel), in
    /// `0..=1`. With 0, a pixel is finished early only if all samples are equal.
    pub tolerance: Real,
}

impl StochasticSampler {
    /// Largest number of rays per pixel.
    pub const MAX_SAMPLES: u32 = 65_536;

    /// A sampler with `n` rays in each pixel; `None` if `n` is not in
    /// `1..=`[`StochasticSampler::MAX_SAMPLES`].
    pub fn new(n: u32) -> Option<Self> {
        Self::with_range(n, n, Confidence { standard_errors: 1.0, tolerance: 0.0 })
    }

    /// A sampler with `min_samples` to `max_samples` rays in each pixel: it traces `min_samples` at a time
    /// until the stopping rule `confidence` holds or there are `max_samples`.
    ///
    /// `None` unless `1 <= min_samples <= max_samples <= `[`StochasticSampler::MAX_SAMPLES`] and
    /// `confidence` is in range.
    pub fn with_range(min_samples: u32, max_samples: u32, confidence: Confidence) -> Option<Self> {
        let is_range = min_samples >= 1 && min_samples <= max_samples && max_samples <= Self::MAX_SAMPLES;
        let is_valid = confidence.standard_errors > 0.0
            && confidence.standard_errors < Real::INFINITY
            && confidence.tolerance >= 0.0
            && confidence.tolerance <= 1.0;
        (is_range && is_valid).then_some(StochasticSampler {
            min_samples,
            max_samples,
            confidence,
            filter: Filter::Box,
            seed: 0,
        })
    }

    /// The same sampler with this reconstruction filter, [`Filter::Box`] by default. The filter distributes the
    /// rays, which all have equal weight; those of wider filters leave the pixel.
    pub fn with_filter(self, filter: Filter) -> Self {
        StochasticSampler { filter, ..self }
    }

    /// The same sampler with this seed of the random numbers, 0 by default.
    pub fn with_seed(self, seed: u32) -> Self {
        StochasticSampler { seed, ..self }
    }
}

impl StochasticSampler {
    /// Adds samples to `estimate` until the pixel is finished.
    ///
    /// If `estimate` is empty, or comes from this sampler or one that differs only in a larger tolerance,
    /// the result is the same as that of [`Sampler::sample_pixel`] of this sampler.
    pub fn continue_pixel(
        &self,
        pixel: Pixel,
        estimate: &mut PixelEstimate,
        tracer: &mut (impl RayTracer + ?Sized),
    ) {
        let PixelEstimate { mean, variance } = estimate;
        let is_adaptive = self.min_samples < self.max_samples;
        // Before this index, a multiple of `min_samples` rays has been traced, or none.
        let mut next = mean.count;
        while mean.count < self.max_samples {
            if mean.count == next {
                if is_adaptive
                    && variance.srgb_confidence_radius(self.confidence.standard_errors)
                        <= self.confidence.tolerance
                {
                    break;
                }
                next += self.min_samples;
            }
            let point = sequence(pixel, mean.count, self.seed).sample_2d(Dimension::PIXEL);
            let sequence = sequence(pixel, sequence_index(mean.count, point, self.min_samples), self.seed);
            let [x, y] = sample_filter(self.filter, point);
            let sample = tracer.trace(CameraSample { point: film_point(pixel, x, y), sequence });
            mean.add(sample);
            if is_adaptive {
                variance.add(sample.color);
            }
        }
    }
}

/// Index in the sequence for the ray with this index in its pixel, through `point` of the unit square.
///
/// Rays come in groups of the largest power of two that divides `min_samples`. Each group has one ray in each
/// of as many equal cells of the square; the ray's index in the group is that of its cell.
fn sequence_index(index: u32, point: [Real; 2], min_samples: u32) -> u32 {
    let bits = min_samples.trailing_zeros();
    index >> bits << bits | morton_cell(point, bits)
}

/// Index of the cell of a point among `2^count` equal cells of the unit square, halved by x, then y, and so
/// on (Morton order).
fn morton_cell([x, y]: [Real; 2], count: u32) -> u32 {
    // The first 16 fractional bits.
    let bits = |x: Real| (x * 65_536.0) as u32;
    let axes = [bits(x), bits(y)].into_iter().cycle();
    axes.zip(0..count).fold(0, |cell, (axis, bit)| cell << 1 | (axis << (bit / 2) & 0x8000) >> 15)
}

impl Sampler for StochasticSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let mut estimate = PixelEstimate::EMPTY;
        self.continue_pixel(pixel, &mut estimate, tracer);
        estimate.to_sample()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;
    use crate::trace::HitId;

    const PIXEL: Pixel = Pixel { x: 40, y: 9 };

    fn gray(value: Real) -> PixelSample {
        PixelSample { color: Rgb::gray(value), hit: HitId::Nothing }
    }

    #[test]
    fn film_points_are_in_the_pixel_and_have_the_mean_of_a_gradient() {
        let mut rays = 0;
        let sample = StochasticSampler::new(64).unwrap().sample_pixel(PIXEL, &mut |sample: CameraSample| {
            rays += 1;
            let (x, y) = (sample.point.x - 40.0, sample.point.y - 9.0);
            assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y), "{x} {y}");
            gray(x)
        });
        // One film point in each of 64 columns.
        assert_eq!(rays, 64);
        assert!((sample.color.r - 0.5).abs() < 0.5 / 64.0, "{sample:?}");
    }

    #[test]
    fn more_rays_begin_with_the_film_points_of_fewer() {
        let points = |n, seed| {
            let mut points = [(0.0, 0.0); 16];
            let mut rays = 0;
            StochasticSampler::new(n).unwrap().with_seed(seed).sample_pixel(
                PIXEL,
                &mut |sample: CameraSample| {
                    if let Some(slot) = points.get_mut(rays) {
                        *slot = (sample.point.x, sample.point.y);
                    }
                    rays += 1;
                    PixelSample::BLACK
                },
            );
            points
        };
        assert_eq!(points(16, 1), points(100, 1));
        assert_ne!(points(16, 1), points(16, 2));
    }

    #[test]
    fn a_continued_pixel_equals_one_started_with_the_final_settings() {
        let sample_color = |sample: CameraSample| {
            let [x, y] = sample.sequence.sample_2d(Dimension::light(1, 0));
            PixelSample { color: Rgb::new(x, y, x * y), hit: HitId::Nothing }
        };
        for (min_samples, max_samples) in [(1, 50), (4, 300), (7, 30), (6, 6)] {
            let rule = |tolerance| {
                let confidence = Confidence { standard_errors: 1.5, tolerance };
                StochasticSampler::with_range(min_samples, max_samples, confidence)
                    .unwrap()
                    .with_filter(Filter::Tent)
            };
            let mut estimate = PixelEstimate::EMPTY;
            for tolerance in [1.0, 0.2, 0.1, 0.09, 0.04, 0.0] {
                let before = estimate.sample_count();
                rule(tolerance).continue_pixel(PIXEL, &mut estimate, &mut |sample| sample_color(sample));
                let mut rays = 0;
                let started = rule(tolerance).sample_pixel(PIXEL, &mut |sample: CameraSample| {
                    rays += 1;
                    sample_color(sample)
                });
                assert_eq!(
                    (estimate.to_sample(), estimate.sample_count()),
                    (started, rays),
                    "{min_samples} {tolerance}"
                );
                assert!(rays >= before);
                assert!(rays == max_samples || estimate.srgb_confidence_radius(1.5) <= tolerance);
            }
            assert_eq!(estimate.sample_count(), max_samples);
        }
    }

    #[test]
    fn each_cell_of_the_pixel_has_one_ray_and_each_ray_its_own_index() {
        for n in [1_u32, 2, 8, 16, 48, 64] {
            let mut numbers = [0; 64];
            let mut index = 0;
            StochasticSampler::new(n).unwrap().sample_pixel(PIXEL, &mut |sample: CameraSample| {
                let point = [sample.point.x - 40.0, sample.point.y - 9.0];
                let number = sequence_index(index, point, n);
                assert_eq!(sample.sequence, sequence(PIXEL, number, 0));
                numbers[number as usize] += 1;
                index += 1;
                PixelSample::BLACK
            });
            assert!(numbers.iter().take(n as usize).all(|count| *count == 1), "{n}: {numbers:?}");
        }
        // The right half, its upper half, and the left half of that.
        assert_eq!([1, 2, 3].map(|count| morton_cell([0.6, 0.1], count)), [1, 2, 4]);
        assert_eq!((morton_cell([0.0, 0.0], 16), morton_cell([0.99, 0.99], 4)), (0, 15));
    }

    #[test]
    fn a_pixel_of_one_color_takes_the_fewest_rays_and_a_noisy_one_the_most() {
        let rays = |colors: fn(Real) -> Real, tolerance| {
            let mut rays = 0;
            let confidence = Confidence { standard_errors: 1.96, tolerance };
            StochasticSampler::with_range(8, 100, confidence).unwrap().sample_pixel(
                PIXEL,
                &mut |sample: CameraSample| {
                    rays += 1;
                    gray(colors(sample.point.x - 40.0))
                },
            );
            rays
        };
        assert_eq!(rays(|_| 0.4, 0.0), 8);
        assert_eq!(rays(|x| if x < 0.5 { 0.0 } else { 1.0 }, 0.01), 100);
        let some = rays(|x| 0.4 + 0.15 * x, 0.01);
        assert!(some > 8 && some < 100, "{some}");
    }

    #[test]
    fn clipped_colors_need_no_more_rays() {
        let mut rays = 0;
        let confidence = Confidence { standard_errors: 2.0, tolerance: 0.001 };
        StochasticSampler::with_range(4, 1000, confidence).unwrap().sample_pixel(
            PIXEL,
            &mut |sample: CameraSample| {
                rays += 1;
                gray(50.0 + sample.point.x)
            },
        );
        assert_eq!(rays, 4);
    }

    #[test]
    fn invalid_ranges_are_refused() {
        let confidence = Confidence { standard_errors: 2.0, tolerance: 0.01 };
        assert!(
            StochasticSampler::new(0).is_none()
                && StochasticSampler::new(StochasticSampler::MAX_SAMPLES + 1).is_none()
        );
        assert!(
            StochasticSampler::with_range(0, 4, confidence).is_none()
                && StochasticSampler::with_range(5, 4, confidence).is_none()
        );
        for standard_errors in [0.0, -1.0, Real::NAN, Real::INFINITY] {
            assert!(
                StochasticSampler::with_range(1, 4, Confidence { standard_errors, ..confidence }).is_none()
            );
        }
        for tolerance in [-0.1, 1.1, Real::NAN] {
            assert!(StochasticSampler::with_range(1, 4, Confidence { tolerance, ..confidence }).is_none());
        }
    }
}
