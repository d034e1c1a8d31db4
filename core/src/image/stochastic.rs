//! Stochastic supersampling: places without a raster turn aliasing into noise.
//!
//! The places of a pixel are those of a scrambled low-discrepancy sequence, another scrambling
//! for each pixel ([`SobolSequence`]). At equal numbers of rays its error is smaller than that of
//! jittered cells (`core/examples/sequence.rs`, `tests/reports/quality.md`).
//!
//! What a ray leaves to chance (the place on a light, on the lens, the moment) comes of sequences of
//! their own. Which of their points goes with which place in the pixel is no matter of chance: rays
//! are numbered by the halves of the pixel that they lie in, and the halves of those (Morton's
//! order). As aligned numbers of a sequence are spread evenly, so are the places on a light that
//! belong to the rays of any such part. Whatever changes with both, as a soft shadow does, has a
//! smaller error for it.
//!
//! Where the number of rays is a range, a pixel ends when its mean is known well enough: when
//! the interval in which the mean lies with a wanted confidence, taken from the variance of the
//! rays so far, is small enough to be seen as one colour ("Statistically Optimized Sampling for
//! Distributed Ray Tracing", Lee, Redner, Uselton, SIGGRAPH 1985). The variance is that of
//! independent samples, which is more than that of evenly placed ones: the rule errs towards
//! more rays. It looks at the very rays that make the mean, so what few rays cannot see is
//! missed, and small things get a little darker the smaller the least number is ("Unbiased
//! Sampling Techniques for Image Synthesis", Kirk, Arvo, SIGGRAPH 1991).
//!
//! [`SobolSequence`]: crate::math::SobolSequence

use super::filter::Filter;
use super::filter_sample::sample_filter;
use super::pixel::Pixel;
use super::sampler::{SampleMean, Sampler, film_point, sequence};
use crate::math::{Dimension, Real, Rgb, sqrt};
use crate::scene::CameraSample;
use crate::trace::{PixelSample, RayTracer};

/// Rays through places that follow no raster; the mean of what they see.
#[derive(Clone, Copy, Debug)]
pub struct StochasticSampler {
    min_samples: u32,
    max_samples: u32,
    confidence: Confidence,
    filter: Filter,
    seed: u32,
}

/// When the mean of a pixel is known well enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Confidence {
    /// How many standard errors the mean may be away: the quantile of the normal distribution
    /// that belongs to the confidence, 1.96 for 95 %. More than 0.
    pub standard_errors: Real,
    /// How far away from the true one the mean may be (sRGB-encoded, the largest channel), in
    /// `0..=1`. With 0 a pixel ends early only where all rays see the same.
    pub tolerance: Real,
}

impl StochasticSampler {
    /// The most rays in a pixel.
    pub const MAX_SAMPLES: u32 = 65_536;

    /// `n` rays in each pixel; none when `n` is 0 or more than [`Stochastic::MOST`].
    pub fn new(n: u32) -> Option<Self> {
        Self::with_range(n, n, Confidence { standard_errors: 1.0, tolerance: 0.0 })
    }

    /// At least `least` rays in each pixel, then as many again, until there is confidence in
    /// their mean or there are `most`. None when `least` is 0 or more than `most`, when that is
    /// more than [`Stochastic::MOST`], or when the confidence is out of range.
    pub fn with_range(least: u32, most: u32, ends: Confidence) -> Option<Self> {
        let is_range = least >= 1 && least <= most && most <= Self::MAX_SAMPLES;
        let is_rule = ends.standard_errors > 0.0
            && ends.standard_errors < Real::INFINITY
            && ends.tolerance >= 0.0
            && ends.tolerance <= 1.0;
        (is_range && is_rule).then_some(StochasticSampler {
            min_samples: least,
            max_samples: most,
            confidence: ends,
            filter: Filter::Box,
            seed: 0,
        })
    }

    /// The same with this filter.
    pub fn with_filter(self, filter: Filter) -> Self {
        StochasticSampler { filter, ..self }
    }

    /// The same in the picture with this seed.
    pub fn with_seed(self, seed: u32) -> Self {
        StochasticSampler { seed, ..self }
    }
}

impl StochasticSampler {
    /// Goes on with a pixel for which some rays have been `gathered`, by this rule or by one of
    /// the same numbers and confidence with a larger tolerance: what is seen then is the same as
    /// if this rule had begun it.
    pub fn continue_pixel(
        &self,
        pixel: Pixel,
        gathered: &mut PixelEstimate,
        tracer: &mut (impl RayTracer + ?Sized),
    ) {
        let PixelEstimate { mean, spread } = gathered;
        let is_ruled = self.min_samples < self.max_samples;
        // Before these, rays have been asked for: they are none, or a multiple of the least number.
        let mut next = mean.count;
        while mean.count < self.max_samples {
            if mean.count == next {
                if is_ruled
                    && spread.confidence_radius(self.confidence.standard_errors) <= self.confidence.tolerance
                {
                    break;
                }
                next += self.min_samples;
            }
            let place = sequence(pixel, mean.count, self.seed).sample_2d(Dimension::PIXEL);
            let stream = sequence(pixel, sequence_index(mean.count, place, self.min_samples), self.seed);
            let [x, y] = sample_filter(self.filter, place);
            let sample = tracer.trace(CameraSample { point: film_point(pixel, x, y), sequence: stream });
            mean.add(sample);
            if is_ruled {
                spread.add(sample.color);
            }
        }
    }
}

/// The number of the ray with this index through a `place` in the unit square: rays come in groups
/// of the largest power of two that divides `least`, each group has one ray in each of as many
/// equal parts of the square, and takes its numbers in the order of those.
fn sequence_index(index: u32, place: [Real; 2], least: u32) -> u32 {
    let bits = least.trailing_zeros();
    index >> bits << bits | morton_cell(place, bits)
}

/// In which of `2^count` equal parts of the unit square a point lies: halves by x, halves of
/// them by y, and so on, in Morton's order.
fn morton_cell([x, y]: [Real; 2], count: u32) -> u32 {
    // The 16 bits after the point.
    let bits = |x: Real| (x * 65_536.0) as u32;
    let axes = [bits(x), bits(y)].into_iter().cycle();
    axes.zip(0..count).fold(0, |part, (axis, place)| part << 1 | (axis << (place / 2) & 0x8000) >> 15)
}

impl Sampler for StochasticSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let mut gathered = PixelEstimate::EMPTY;
        self.continue_pixel(pixel, &mut gathered, tracer);
        gathered.to_sample()
    }
}

/// What the rays of a pixel have seen so far, so that others can be added.
#[derive(Clone, Copy, Debug)]
pub struct PixelEstimate {
    mean: SampleMean,
    spread: RunningVariance,
}

impl PixelEstimate {
    /// Nothing yet.
    pub const EMPTY: PixelEstimate = PixelEstimate { mean: SampleMean::EMPTY, spread: RunningVariance::NONE };

    /// The mean of what they have seen.
    pub fn to_sample(&self) -> PixelSample {
        self.mean.to_sample()
    }

    /// How many they are.
    pub fn sample_count(&self) -> u32 {
        self.mean.count
    }

    /// How far away the true mean may be (sRGB-encoded, the largest channel), when it may be this
    /// many standard errors away. Infinite before the second ray, and where the number of rays
    /// follows no rule.
    pub fn confidence_radius(&self, errors: Real) -> Real {
        self.spread.confidence_radius(errors)
    }
}

/// Mean and variance of colours, as they come ("Note on a Method for Calculating Corrected Sums
/// of Squares and Products", Welford 1962).
#[derive(Clone, Copy, Debug)]
struct RunningVariance {
    count: u32,
    mean: Rgb,
    sum_of_squares: Rgb,
}

impl RunningVariance {
    const NONE: RunningVariance = RunningVariance { count: 0, mean: Rgb::BLACK, sum_of_squares: Rgb::BLACK };

    fn add(&mut self, color: Rgb) {
        self.count += 1;
        let part = 1.0 / self.count as Real;
        let one = |value: Real, mean: &mut Real, squares: &mut Real| {
            let before = value - *mean;
            *mean += before * part;
            *squares += before * (value - *mean);
        };
        one(color.r, &mut self.mean.r, &mut self.sum_of_squares.r);
        one(color.g, &mut self.mean.g, &mut self.sum_of_squares.g);
        one(color.b, &mut self.mean.b, &mut self.sum_of_squares.b);
    }

    /// How far away the mean may be: half of the interval of this many standard errors to both
    /// sides, encoded.
    fn confidence_radius(&self, errors: Real) -> Real {
        if self.count < 2 {
            return Real::INFINITY; // of one ray nothing is known
        }
        let n = self.count as Real;
        let way = self.sum_of_squares.map(|squares| errors * sqrt(squares / ((n - 1.0) * n)));
        let below = Rgb::new(self.mean.r - way.r, self.mean.g - way.g, self.mean.b - way.b);
        0.5 * Rgb::contrast([below, self.mean + way])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::HitId;

    const PIXEL: Pixel = Pixel { x: 40, y: 9 };

    fn gray(value: Real) -> PixelSample {
        PixelSample { color: Rgb::gray(value), hit: HitId::Nothing }
    }

    #[test]
    fn the_places_lie_in_the_pixel_and_have_the_mean_of_a_slope() {
        let mut rays = 0;
        let sample = StochasticSampler::new(64).unwrap().sample_pixel(PIXEL, &mut |sample: CameraSample| {
            rays += 1;
            let (x, y) = (sample.point.x - 40.0, sample.point.y - 9.0);
            assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y), "{x} {y}");
            gray(x)
        });
        // One place in each of 64 columns, somewhere in it.
        assert_eq!(rays, 64);
        assert!((sample.color.r - 0.5).abs() < 0.5 / 64.0, "{sample:?}");
    }

    #[test]
    fn more_rays_begin_with_the_places_of_fewer() {
        let places = |n, seed| {
            let mut places = [(0.0, 0.0); 16];
            let mut rays = 0;
            StochasticSampler::new(n).unwrap().with_seed(seed).sample_pixel(
                PIXEL,
                &mut |sample: CameraSample| {
                    if let Some(slot) = places.get_mut(rays) {
                        *slot = (sample.point.x, sample.point.y);
                    }
                    rays += 1;
                    PixelSample::BLACK
                },
            );
            places
        };
        assert_eq!(places(16, 1), places(100, 1));
        assert_ne!(places(16, 1), places(16, 2));
    }

    #[test]
    fn a_pixel_that_is_gone_on_with_is_the_one_that_was_begun_with_the_last_rule() {
        let see = |sample: CameraSample| {
            let [x, y] = sample.sequence.sample_2d(Dimension::light(1, 0));
            PixelSample { color: Rgb::new(x, y, x * y), hit: HitId::Nothing }
        };
        for (least, most) in [(1, 50), (4, 300), (7, 30), (6, 6)] {
            let rule = |tolerance| {
                let ends = Confidence { standard_errors: 1.5, tolerance };
                StochasticSampler::with_range(least, most, ends).unwrap().with_filter(Filter::Tent)
            };
            let mut gathered = PixelEstimate::EMPTY;
            for tolerance in [1.0, 0.2, 0.1, 0.09, 0.04, 0.0] {
                let before = gathered.sample_count();
                rule(tolerance).continue_pixel(PIXEL, &mut gathered, &mut |sample| see(sample));
                let mut rays = 0;
                let begun = rule(tolerance).sample_pixel(PIXEL, &mut |sample: CameraSample| {
                    rays += 1;
                    see(sample)
                });
                assert_eq!(
                    (gathered.to_sample(), gathered.sample_count()),
                    (begun, rays),
                    "{least} {tolerance}"
                );
                assert!(rays >= before);
                assert!(rays == most || gathered.confidence_radius(1.5) <= tolerance);
            }
            assert_eq!(gathered.sample_count(), most);
        }
    }

    #[test]
    fn each_part_of_the_pixel_has_one_ray_and_each_ray_a_number_of_its_own() {
        for n in [1_u32, 2, 8, 16, 48, 64] {
            let mut numbers = [0; 64];
            let mut index = 0;
            StochasticSampler::new(n).unwrap().sample_pixel(PIXEL, &mut |sample: CameraSample| {
                let place = [sample.point.x - 40.0, sample.point.y - 9.0];
                let number = sequence_index(index, place, n);
                assert_eq!(sample.sequence, sequence(PIXEL, number, 0));
                numbers[number as usize] += 1;
                index += 1;
                PixelSample::BLACK
            });
            assert!(numbers.iter().take(n as usize).all(|count| *count == 1), "{n}: {numbers:?}");
        }
        // Right, then upper, then left again.
        assert_eq!([1, 2, 3].map(|count| morton_cell([0.6, 0.1], count)), [1, 2, 4]);
        assert_eq!((morton_cell([0.0, 0.0], 16), morton_cell([0.99, 0.99], 4)), (0, 15));
    }

    #[test]
    fn a_pixel_of_one_colour_ends_at_the_least_number_and_a_noisy_one_at_the_most() {
        let rays = |colors: fn(Real) -> Real, tolerance| {
            let mut rays = 0;
            let ends = Confidence { standard_errors: 1.96, tolerance };
            StochasticSampler::with_range(8, 100, ends).unwrap().sample_pixel(
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
    fn what_is_brighter_than_the_screen_needs_no_more_rays() {
        let mut rays = 0;
        let ends = Confidence { standard_errors: 2.0, tolerance: 0.001 };
        StochasticSampler::with_range(4, 1000, ends).unwrap().sample_pixel(
            PIXEL,
            &mut |sample: CameraSample| {
                rays += 1;
                gray(50.0 + sample.point.x)
            },
        );
        assert_eq!(rays, 4);
    }

    #[test]
    fn ranges_without_sense_are_refused() {
        let ends = Confidence { standard_errors: 2.0, tolerance: 0.01 };
        assert!(
            StochasticSampler::new(0).is_none()
                && StochasticSampler::new(StochasticSampler::MAX_SAMPLES + 1).is_none()
        );
        assert!(
            StochasticSampler::with_range(0, 4, ends).is_none()
                && StochasticSampler::with_range(5, 4, ends).is_none()
        );
        for standard_errors in [0.0, -1.0, Real::NAN, Real::INFINITY] {
            assert!(StochasticSampler::with_range(1, 4, Confidence { standard_errors, ..ends }).is_none());
        }
        for tolerance in [-0.1, 1.1, Real::NAN] {
            assert!(StochasticSampler::with_range(1, 4, Confidence { tolerance, ..ends }).is_none());
        }
    }
}
