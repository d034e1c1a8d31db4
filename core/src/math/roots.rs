//! Bracketed roots of polynomials and other functions.
//!
//! The roots of the derivative separate the roots of a polynomial: between two neighboring turning
//! points it is monotone, so a change of sign brackets exactly one root. Newton's method with bisection
//! as a fallback finds that root. Here the roots of a quadratic separate those of a cubic, in a bounded
//! interval and with a bounded number of iterations, so that rounding loses no single root.

use super::{ROUNDOFF, Real, max, sqrt};

/// The real roots of a cubic in an interval, in ascending order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CubicRoots {
    roots: [Real; 3],
    count: usize,
}

impl CubicRoots {
    /// The roots in ascending order.
    pub fn iter(&self) -> impl Iterator<Item = Real> + '_ {
        self.roots.iter().copied().take(self.count)
    }

    fn push(&mut self, root: Real) {
        if let Some(entry) = self.roots.get_mut(self.count) {
            *entry = root;
            self.count += 1;
        }
    }
}

/// The roots of `c[3] x^3 + c[2] x^2 + c[1] x + c[0]` in `low..=high`.
///
/// A double root is returned twice or not at all, depending on rounding.
pub fn cubic_roots(c: [Real; 4], low: Real, high: Real) -> CubicRoots {
    let [_, c1, c2, c3] = c;
    let derivative = [c1, 2.0 * c2, 3.0 * c3];
    let turning_points = quadratic_roots(derivative, low, high);
    let value_and_slope = |x: Real| (evaluate_polynomial(&c, x), evaluate_polynomial(&derivative, x));

    let mut roots = CubicRoots::default();
    let (mut left, mut at_left) = (low, evaluate_polynomial(&c, low));
    for right in turning_points.iter().chain([high]) {
        let at_right = evaluate_polynomial(&c, right);
        if (at_left < 0.0) != (at_right < 0.0) {
            roots.push(bracketed_root(value_and_slope, left, right, at_left < 0.0));
        }
        (left, at_left) = (right, at_right);
    }
    roots
}

/// The value at `x` of the polynomial with coefficients `c`, the constant first, by Horner's rule.
fn evaluate_polynomial(c: &[Real], x: Real) -> Real {
    c.iter().rev().fold(0.0, |sum, &c| sum * x + c)
}

/// The roots of `c[2] x^2 + c[1] x + c[0]` between `low` and `high`, computed without cancellation.
fn quadratic_roots([c0, c1, c2]: [Real; 3], low: Real, high: Real) -> CubicRoots {
    let mut roots = CubicRoots::default();
    let b = -0.5 * c1;
    let d = b * b - c2 * c0;
    if d >= 0.0 {
        let root = sqrt(d);
        let q = if b >= 0.0 { b + root } else { b - root };
        let (x, y) = (c0 / q, q / c2);
        let (first, second) = if x < y { (x, y) } else { (y, x) };
        for x in [first, second] {
            if x > low && x < high {
                roots.push(x);
            }
        }
    }
    roots
}

/// Enough bisections to reach neighboring numbers in the interval. With Newton's method about six
/// iterations are typical.
const MAX_ITERATIONS: u32 = Real::MANTISSA_DIGITS + 8;

/// The root between `left` and `right` of a function that changes its sign there exactly once.
///
/// `f` returns the value and the derivative. `is_increasing`: the sign changes from negative to positive.
///
/// The iteration ends when a step is at most one unit roundoff of the larger bound. Smaller steps would
/// follow the rounding errors of `f`.
pub fn bracketed_root(
    f: impl Fn(Real) -> (Real, Real),
    mut left: Real,
    mut right: Real,
    is_increasing: bool,
) -> Real {
    let tolerance = ROUNDOFF * max(left.abs(), right.abs());
    let mut x = 0.5 * (left + right);
    for _ in 0..MAX_ITERATIONS {
        let (y, slope) = f(x);
        // Zero has no sign. Treating it as positive or negative could exclude the root.
        if y == 0.0 {
            break;
        }
        if (y < 0.0) == is_increasing {
            left = x;
        } else {
            right = x;
        }
        let newton = x - y / slope;
        // Bisect if Newton's step leaves the bracket or is NaN.
        let next = if newton > left && newton < right { newton } else { 0.5 * (left + right) };
        let step = (next - x).abs();
        x = next;
        if step <= tolerance {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_known_roots_are_found_in_order() {
        // (x + 0.75)(x + 0.25)(x - 0.5)
        let c = [-0.093_75, -0.312_5, 0.5, 1.0];
        let c = { c.map(|x| x as Real) };
        let expected = [-0.75, -0.25, 0.5];
        let roots = cubic_roots(c, -1.0, 1.0);
        assert_eq!(roots.iter().count(), 3, "{roots:?}");
        for (x, expected) in roots.iter().zip(expected) {
            assert!((x - expected).abs() <= 16.0 * Real::EPSILON, "{x} is not {expected}");
        }
    }

    #[test]
    fn roots_outside_the_interval_and_complex_ones_are_not_reported() {
        // x^3 + x has one real root; x^3 - 8 has one at 2.
        assert_eq!(cubic_roots([0.0, 1.0, 0.0, 1.0], -3.0, 3.0).iter().count(), 1);
        assert_eq!(cubic_roots([-8.0, 0.0, 0.0, 1.0], -1.0, 1.0).iter().count(), 0);
        assert_eq!(cubic_roots([-8.0, 0.0, 0.0, 1.0], -1.0, 3.0).iter().count(), 1);
    }

    #[test]
    fn an_exact_root_is_returned_for_both_directions() {
        // Some iteration evaluates f at the exact root, whose value zero must not count as a sign.
        for is_increasing in [true, false] {
            let sign = if is_increasing { 1.0 } else { -1.0 };
            let f = |x: Real| (sign * (x * x - 0.25), sign * 2.0 * x);
            assert_eq!(bracketed_root(f, 0.0, 1.0, is_increasing), 0.5);
            let root = bracketed_root(f, 0.1, 1.7, is_increasing);
            assert!((root - 0.5).abs() <= 2.0 * Real::EPSILON, "{root}");
        }
    }

    #[test]
    fn a_root_is_found_without_a_useful_derivative() {
        // With a derivative of zero only bisection remains.
        let root = bracketed_root(|x| (x - 0.3, 0.0), -1.0, 1.0, true);
        assert!((root - 0.3).abs() <= Real::EPSILON);
    }
}
