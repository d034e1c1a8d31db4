//! Roots of polynomials, bracketed and polished, so that none is lost to rounding.
//!
//! The roots of a polynomial are parted by those of its derivative: between two neighbouring
//! turning points it rises or falls, and a change of sign holds exactly one root, which
//! bisection finds and Newton's steps make quick. So the quadratic parts the cubic, and the
//! cubic parts the quartic, on a bounded interval, in a bounded number of steps.

use super::{Real, sqrt};

/// The real roots of a quartic in an interval, in rising order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QuarticRoots {
    roots: [Real; 4],
    count: usize,
}

impl QuarticRoots {
    /// The roots, the smallest first.
    pub fn iter(&self) -> impl Iterator<Item = Real> + '_ {
        self.roots.iter().copied().take(self.count)
    }

    fn push(&mut self, root: Real) {
        if let Some(slot) = self.roots.get_mut(self.count) {
            *slot = root;
            self.count += 1;
        }
    }
}

/// The roots in `low..=high` of `c[4] x^4 + c[3] x^3 + c[2] x^2 + c[1] x + c[0]`.
///
/// A double root is found as two or as none, as rounding decides.
pub fn quartic_roots(c: [Real; 5], low: Real, high: Real) -> QuarticRoots {
    let [c0, c1, c2, c3, c4] = c;
    // Each derivative, divided by its constant factor.
    let cubic = [c1, 2.0 * c2, 3.0 * c3, 4.0 * c4];
    let quadratic = [2.0 * c2, 6.0 * c3, 12.0 * c4];

    let turns = quadratic_roots(quadratic, low, high);
    let turns = parted(|x| value(&cubic, x), |x| value(&quadratic, x), &turns, low, high);
    parted(|x| value(&[c0, c1, c2, c3, c4], x), |x| value(&cubic, x), &turns, low, high)
}

/// Horner's rule.
fn value(c: &[Real], x: Real) -> Real {
    c.iter().rev().fold(0.0, |sum, &c| sum * x + c)
}

/// The roots in `low..=high` of `c[2] x^2 + c[1] x + c[0]`, without cancellation.
fn quadratic_roots([c0, c1, c2]: [Real; 3], low: Real, high: Real) -> QuarticRoots {
    let mut found = QuarticRoots::default();
    let b = -0.5 * c1;
    let d = b * b - c2 * c0;
    if d >= 0.0 {
        let root = sqrt(d);
        let q = if b >= 0.0 { b + root } else { b - root };
        let (x, y) = (c0 / q, q / c2);
        let (first, second) = if x < y { (x, y) } else { (y, x) };
        for x in [first, second] {
            if x > low && x < high {
                found.push(x);
            }
        }
    }
    found
}

/// The roots of `f` in `low..=high`, which rises or falls between any two of the `turns`.
fn parted(
    f: impl Fn(Real) -> Real,
    slope: impl Fn(Real) -> Real,
    turns: &QuarticRoots,
    low: Real,
    high: Real,
) -> QuarticRoots {
    let mut found = QuarticRoots::default();
    let mut left = low;
    let mut at_left = f(low);
    for right in turns.iter().chain([high]) {
        let at_right = f(right);
        if (at_left < 0.0) != (at_right < 0.0) {
            found.push(between(&f, &slope, left, right, at_left < 0.0));
        }
        (left, at_left) = (right, at_right);
    }
    found
}

/// Enough halvings to part any two neighbouring numbers of the interval; Newton's steps make
/// it some six as a rule.
const STEPS: u32 = Real::MANTISSA_DIGITS + 8;

/// The one root of `f` between `left` and `right`, where it changes its sign.
fn between(
    f: &impl Fn(Real) -> Real,
    slope: &impl Fn(Real) -> Real,
    mut left: Real,
    mut right: Real,
    rising: bool,
) -> Real {
    let mut x = 0.5 * (left + right);
    for _ in 0..STEPS {
        let y = f(x);
        if (y < 0.0) == rising {
            left = x;
        } else {
            right = x;
        }
        let newton = x - y / slope(x);
        // Outside the bracket (or no number): halve instead.
        let next = if newton > left && newton < right { newton } else { 0.5 * (left + right) };
        if next == x {
            break;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_known_roots_are_found_in_order() {
        // (x + 0.75)(x + 0.25)(x - 0.5)(x - 0.875)
        let c = [0.082_031_25, 0.179_687_5, -0.75, -0.375, 1.0];
        let c = { c.map(|x| x as Real) };
        let want = [-0.75, -0.25, 0.5, 0.875];
        let found = quartic_roots(c, -1.0, 1.0);
        assert_eq!(found.iter().count(), 4, "{found:?}");
        for (x, w) in found.iter().zip(want) {
            assert!((x - w).abs() <= 16.0 * Real::EPSILON, "{x} is not {w}");
        }
    }

    #[test]
    fn roots_outside_the_interval_and_complex_ones_are_not_reported() {
        // x^4 + 1 has none; x^4 - 16 has them at 2 and -2.
        assert_eq!(quartic_roots([1.0, 0.0, 0.0, 0.0, 1.0], -3.0, 3.0).iter().count(), 0);
        assert_eq!(quartic_roots([-16.0, 0.0, 0.0, 0.0, 1.0], -1.0, 1.0).iter().count(), 0);
        assert_eq!(quartic_roots([-16.0, 0.0, 0.0, 0.0, 1.0], -3.0, 1.0).iter().count(), 1);
    }
}
