//! Structural similarity (SSIM): luminance, contrast and structure of two pictures, compared in small windows. It is
//! closer to perception than differences of single pixels.
//!
//! 1 is identical, 0 uncorrelated, less than 0 inverted.
//!
//! Source: Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
//! Similarity", IEEE Transactions on Image Processing 13(4), 2004, with its constants: a Gaussian window of 11 x 11 pixels
//! with a deviation of 1.5, K1 = 0.01, K2 = 0.03.
//! Difference: red, green and blue are measured separately and averaged, so that a change of hue counts; at the border
//! the window is clipped and its weights are normalized, so that every pixel counts and any size of picture works.
//!
//! Implemented here because available crates divide by the wrong number of pixels (`image-compare`), use fused
//! operations, need a C++ compiler, or have an incompatible license.

use std::ops::Range;

use rayon::prelude::*;

use super::measure::Channel;

/// The radius of the window, in pixels.
const WINDOW_RADIUS: usize = 5;
const DEVIATION: f64 = 1.5;
/// (K1 L)^2 and (K2 L)^2, where L, the largest value, is 1.
const C1: f64 = 0.01 * 0.01;
const C2: f64 = 0.03 * 0.03;

/// The mean structural similarity of two pictures.
///
/// A row of windows needs only the rows that it covers, so no buffer of the size of the pictures is allocated. Rows are
/// summed in order, so that the result does not depend on the number of threads.
pub(super) fn ssim<C: Channel>(a: &[[C; 3]], b: &[[C; 3]], width: usize, height: usize) -> f64 {
    let across: Vec<Window> = (0..width).map(|x| Window::at(x, width)).collect();
    let rows = (0..height).into_par_iter().map(|y| row(a, b, width, &Window::at(y, height), &across));
    let rows: Vec<f64> = rows.collect();
    rows.iter().sum::<f64>() / (3.0 * width as f64 * height as f64)
}

/// A window in one dimension: the Gaussian, clipped at the border of the picture.
struct Window {
    covers: Range<usize>,
    /// The weights of the pixels that it covers; their sum is 1.
    weights: [f64; 2 * WINDOW_RADIUS + 1],
}

impl Window {
    fn at(center: usize, length: usize) -> Self {
        let covers = center.saturating_sub(WINDOW_RADIUS)..length.min(center + WINDOW_RADIUS + 1);
        let mut weights = [0.0; 2 * WINDOW_RADIUS + 1];
        let mut sum = 0.0;
        for (weight, place) in weights.iter_mut().zip(covers.clone()) {
            let distance = place.abs_diff(center) as f64 / DEVIATION;
            *weight = libm::exp(-0.5 * distance * distance);
            sum += *weight;
        }
        Window { covers, weights: weights.map(|weight| weight / sum) }
    }

    fn weighted(&self) -> impl Iterator<Item = (usize, f64)> {
        self.covers.clone().zip(self.weights)
    }
}

/// The means of both values, of their squares and of their product.
type Moments = [f64; 5];

fn add(sum: &mut Moments, weight: f64, term: Moments) {
    for (sum, term) in sum.iter_mut().zip(term) {
        *sum += weight * term;
    }
}

/// The sum of the similarities of one row of windows.
fn row<C: Channel>(a: &[[C; 3]], b: &[[C; 3]], width: usize, down: &Window, across: &[Window]) -> f64 {
    // First down the columns, then along the row: a Gaussian is separable.
    let mut columns = vec![[[0.0; 5]; 3]; width];
    for (y, weight) in down.weighted() {
        let line = y * width..(y + 1) * width;
        for ((column, a), b) in columns.iter_mut().zip(&a[line.clone()]).zip(&b[line]) {
            for (channel, sum) in column.iter_mut().enumerate() {
                let (a, b) = (a[channel].value(), b[channel].value());
                add(sum, weight, [a, b, a * a, b * b, a * b]);
            }
        }
    }
    let mut total = 0.0;
    for window in across {
        let mut moments = [[0.0; 5]; 3];
        for (x, weight) in window.weighted() {
            for (sum, term) in moments.iter_mut().zip(columns[x]) {
                add(sum, weight, term);
            }
        }
        total += moments.into_iter().map(similarity).sum::<f64>();
    }
    total
}

fn similarity([a, b, aa, bb, ab]: Moments) -> f64 {
    let (variance_a, variance_b, covariance) = (aa - a * a, bb - b * b, ab - a * b);
    let light = (2.0 * a * b + C1) / (a * a + b * b + C1);
    let structure = (2.0 * covariance + C2) / (variance_a + variance_b + C2);
    light * structure
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten decimals: sums of some hundred products of numbers below 1.
    fn assert_near(value: f64, expected: f64) {
        assert!((value - expected).abs() <= 1e-10, "{value} is not {expected}");
    }

    /// Pseudo-random numbers from a fixed start state.
    fn noise(first: u32, count: usize) -> Vec<[f32; 3]> {
        let mut state = first;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32
        };
        (0..count).map(|_| [next(), next(), next()]).collect()
    }

    #[test]
    fn uniform_pictures_differ_in_luminance_only() {
        for (width, height) in [(1, 1), (3, 2), (20, 30)] {
            let (a, b) = (vec![[0.25_f32; 3]; width * height], vec![[0.75_f32; 3]; width * height]);
            let light = (2.0 * 0.25 * 0.75 + 1e-4) / (0.25 * 0.25 + 0.75 * 0.75 + 1e-4);
            assert_near(ssim(&a, &b, width, height), light);
        }
    }

    #[test]
    fn two_pixels_and_their_inverse_have_the_analytic_value() {
        // Both windows cover both pixels. The weight of the other pixel is q, so one mean is q and the other 1 - q,
        // each variance is q (1 - q), and the covariance its negative.
        let (a, b) = ([[0.0_f32; 3], [1.0; 3]], [[1.0_f32; 3], [0.0; 3]]);
        let other = libm::exp(-0.5 / (1.5 * 1.5));
        let q = other / (1.0 + other);
        let v = q * (1.0 - q);
        let light = (2.0 * v + 1e-4) / (q * q + (1.0 - q) * (1.0 - q) + 1e-4);
        let structure = (-2.0 * v + 9e-4) / (2.0 * v + 9e-4);
        assert_near(ssim(&a, &b, 2, 1), light * structure);
        assert_near(ssim(&a, &b, 1, 2), light * structure);
    }

    #[test]
    fn a_change_of_one_channel_counts_a_third() {
        let (a, b) = (vec![[0_u8, 0, 0]; 64], vec![[0_u8, 255, 0]; 64]);
        assert_near(ssim(&a, &b, 8, 8), (1.0 + 1e-4 / (1.0 + 1e-4) + 1.0) / 3.0);
    }

    #[test]
    fn identical_pictures_have_exactly_1_and_the_measure_is_symmetric() {
        let (a, b) = (noise(1, 17 * 13), noise(2, 17 * 13));
        assert_eq!(ssim(&a, &a, 17, 13), 1.0);
        assert_eq!(ssim(&a, &b, 17, 13), ssim(&b, &a, 17, 13));
        assert!(ssim(&a, &b, 17, 13).abs() < 0.2);
    }

    #[test]
    fn separable_windows_agree_with_direct_ones() {
        let (width, height) = (19, 14);
        let (a, b) = (noise(3, width * height), noise(4, width * height));
        let mut total = 0.0;
        for place in 0..width * height {
            let (x, y) = ((place % width) as f64, (place / width) as f64);
            let weights: Vec<f64> = (0..width * height)
                .map(|other| {
                    let (dx, dy) = ((other % width) as f64 - x, (other / width) as f64 - y);
                    let inside = dx.abs() <= 5.0 && dy.abs() <= 5.0;
                    if inside { libm::exp(-(dx * dx + dy * dy) / 4.5) } else { 0.0 }
                })
                .collect();
            let all: f64 = weights.iter().sum();
            for channel in 0..3 {
                let mean = |of: &dyn Fn(usize) -> f64| {
                    weights.iter().enumerate().map(|(at, weight)| weight * of(at)).sum::<f64>() / all
                };
                let (va, vb) = (|at: usize| f64::from(a[at][channel]), |at: usize| f64::from(b[at][channel]));
                let (ma, mb) = (mean(&va), mean(&vb));
                total += similarity([
                    ma,
                    mb,
                    mean(&|at| va(at) * va(at)),
                    mean(&|at| vb(at) * vb(at)),
                    mean(&|at| va(at) * vb(at)),
                ]);
            }
        }
        assert_near(ssim(&a, &b, width, height), total / (3 * width * height) as f64);
    }
}
