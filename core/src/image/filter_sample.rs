//! Importance sampling of reconstruction filters.
//!
//! Film points are drawn with the density of the filter, so that all samples have the same weight and a pixel
//! needs only its own samples.
//!
//! Source: Ernst, Stamminger and Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray
//! Tracing 2006.

use super::filter::Filter;
use crate::math::{Real, sample_tent, sample_truncated_gaussian};

/// Maps a uniform point of the unit square to a point with the density of the filter, relative to the upper
/// left corner of the pixel.
pub(super) fn sample_filter(filter: Filter, [x, y]: [Real; 2]) -> [Real; 2] {
    match filter {
        Filter::Box => [x, y],
        Filter::Tent => [0.5 + sample_tent(x), 0.5 + sample_tent(y)],
        Filter::Gaussian => sample_truncated_gaussian([x, y], 3.0).map(|offset| 0.5 + 0.5 * offset),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::SobolSequence;

    /// Mean and variance of the x coordinates of many points.
    fn moments(filter: Filter) -> (Real, Real) {
        let (mut sum, mut squares) = (0.0, 0.0);
        for index in 0..4096 {
            let [x, y] = sample_filter(
                filter,
                SobolSequence::new(0, 0, index, 0).sample_2d(crate::math::Dimension::PIXEL),
            );
            assert!((-1.0..=2.0).contains(&x) && (-1.0..=2.0).contains(&y));
            sum += x;
            squares += x * x;
        }
        let mean = sum / 4096.0;
        (mean, squares / 4096.0 - mean * mean)
    }

    #[test]
    fn points_have_the_mean_and_the_variance_of_their_filter() {
        // A uniform distribution of length 1, a tent of half-width 1, and a normal distribution of standard
        // deviation 1/2, truncated at three deviations, which reduces the variance by the fraction 4.5 e^-4.5
        // / (1 - e^-4.5).
        for (filter, variance) in [
            (Filter::Box, 1.0 / 12.0),
            (Filter::Tent, 1.0 / 6.0),
            (Filter::Gaussian, 0.25 * (1.0 - 0.050_55)),
        ] {
            let (mean, measured) = moments(filter);
            assert!((mean - 0.5).abs() < 1e-3, "{filter:?}: {mean}");
            assert!((measured - variance).abs() < 2e-3, "{filter:?}: {measured}");
        }
    }
}
