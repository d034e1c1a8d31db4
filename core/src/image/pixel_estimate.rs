//! The mean of a pixel's samples so far, and its confidence interval.

use super::sampler::SampleMean;
use crate::math::{Real, Rgb, sqrt};
use crate::trace::PixelSample;

/// A pixel of a [`StochasticSampler`](super::StochasticSampler) that is not yet finished: the mean of its samples so far, to which
/// more can be added.
#[derive(Clone, Copy, Debug)]
pub struct PixelEstimate {
    pub(super) mean: SampleMean,
    pub(super) variance: RunningVariance,
}

impl PixelEstimate {
    /// An estimate without samples.
    pub const EMPTY: PixelEstimate =
        PixelEstimate { mean: SampleMean::EMPTY, variance: RunningVariance::EMPTY };

    /// The mean of the samples; [`PixelSample::BLACK`] without samples.
    pub fn to_sample(self) -> PixelSample {
        self.mean.sample()
    }

    /// Number of samples so far.
    pub fn sample_count(&self) -> u32 {
        self.mean.count
    }

    /// Half the width of the confidence interval of the mean: `standard_errors` times the standard error of
    /// the mean. In sRGB-encoded units, of the channel where it is largest, at most 0.5.
    ///
    /// Infinite below two samples, and for estimates of samplers with a fixed number of rays, which do not
    /// compute the variance.
    pub fn srgb_confidence_radius(&self, standard_errors: Real) -> Real {
        self.variance.srgb_confidence_radius(standard_errors)
    }
}

/// Running mean and variance of colors.
///
/// Source: Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products", Technometrics
/// 1962.
#[derive(Clone, Copy, Debug)]
pub(super) struct RunningVariance {
    count: u32,
    mean: Rgb,
    sum_of_squares: Rgb,
}

impl RunningVariance {
    const EMPTY: RunningVariance = RunningVariance { count: 0, mean: Rgb::BLACK, sum_of_squares: Rgb::BLACK };

    pub(super) fn add(&mut self, color: Rgb) {
        self.count += 1;
        let weight = 1.0 / self.count as Real;
        let one = |value: Real, mean: &mut Real, sum_of_squares: &mut Real| {
            let difference = value - *mean;
            *mean += difference * weight;
            *sum_of_squares += difference * (value - *mean);
        };
        one(color.r, &mut self.mean.r, &mut self.sum_of_squares.r);
        one(color.g, &mut self.mean.g, &mut self.sum_of_squares.g);
        one(color.b, &mut self.mean.b, &mut self.sum_of_squares.b);
    }

    /// Half width of the confidence interval of this many standard errors to both sides, sRGB-encoded.
    pub(super) fn srgb_confidence_radius(&self, standard_errors: Real) -> Real {
        if self.count < 2 {
            return Real::INFINITY; // one sample has no variance
        }
        let n = self.count as Real;
        let radius = self.sum_of_squares.map(|squares| standard_errors * sqrt(squares / ((n - 1.0) * n)));
        let below = Rgb::new(self.mean.r - radius.r, self.mean.g - radius.g, self.mean.b - radius.b);
        0.5 * Rgb::contrast([below, self.mean + radius])
    }
}
