//! Reconstruction filters: how much of a pixel's surroundings counts in it.
//!
//! A filter weighs what is seen by where it is seen. Here the places are drawn from the filter
//! itself, so that all samples weigh the same and a pixel needs only its own ("Filter
//! Importance Sampling", Ernst, Stamminger, Greiner, 2006).

use super::filter::Filter;
use crate::math::{Real, sample_tent, sample_truncated_gaussian};

/// Where a point that lies evenly in the unit square comes to lie by a filter, from the pixel's upper
/// left corner.
pub(super) fn filtered(filter: Filter, [x, y]: [Real; 2]) -> [Real; 2] {
    match filter {
        Filter::Box => [x, y],
        Filter::Tent => [0.5 + sample_tent(x), 0.5 + sample_tent(y)],
        Filter::Gaussian => sample_truncated_gaussian([x, y], 3.0).map(|way| 0.5 + 0.5 * way),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::SobolSequence;

    /// Mean and variance along x of many places.
    fn moments(filter: Filter) -> (Real, Real) {
        let (mut sum, mut squares) = (0.0, 0.0);
        for index in 0..4096 {
            let [x, y] =
                filtered(filter, SobolSequence::new(0, 0, index, 0).sample_2d(crate::math::Dimension::PIXEL));
            assert!((-1.0..=2.0).contains(&x) && (-1.0..=2.0).contains(&y));
            sum += x;
            squares += x * x;
        }
        let mean = sum / 4096.0;
        (mean, squares / 4096.0 - mean * mean)
    }

    #[test]
    fn places_have_the_mean_and_the_variance_of_their_filter() {
        // Of an even distribution of length one, of a tent of half-width one, and of a normal
        // distribution of deviation 1/2 that is cut off at three deviations: then the variance
        // is less by 4.5 e^-4.5 / (1 - e^-4.5) of itself.
        for (filter, variance) in [
            (Filter::Box, 1.0 / 12.0),
            (Filter::Tent, 1.0 / 6.0),
            (Filter::Gaussian, 0.25 * (1.0 - 0.050_55)),
        ] {
            let (mean, got) = moments(filter);
            assert!((mean - 0.5).abs() < 1e-3, "{filter:?}: {mean}");
            assert!((got - variance).abs() < 2e-3, "{filter:?}: {got}");
        }
    }
}
