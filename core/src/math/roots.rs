//! Roots of polynomials and other functions, bracketed and polished, so that none is lost to
//! rounding.
//!
//! The roots of a polynomial are parted by those of its derivative: between two neighbouring
//! turning points it rises or falls, and a change of sign holds exactly one root, which
//! bisection finds and Newton's steps make quick. So the quadratic parts the cubic, on a bounded
//! interval, in a bounded number of steps.

use super::{ROUNDOFF, Real, greatest, sqrt};

/// The real roots of a cubic in an interval, in rising order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CubicRoots {
    roots: [Real; 3],
    count: usize,
}

impl CubicRoots {
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

/// The roots in `low..=high` of `c[3] x^3 + c[2] x^2 + c[1] x + c[0]`.
///
/// A double root is found as two or as none, as rounding decides.
pub fn cubic_roots(c: [Real; 4], low: Real, high: Real) -> CubicRoots {
    let [_, c1, c2, c3] = c;
    let slope = [c1, 2.0 * c2, 3.0 * c3];
    let turns = quadratic_roots(slope, low, high);
    let both = |x: Real| (value(&c, x), value(&slope, x));

    let mut found = CubicRoots::default();
    let (mut left, mut at_left) = (low, value(&c, low));
    for right in turns.iter().chain([high]) {
        let at_right = value(&c, right);
        if (at_left < 0.0) != (at_right < 0.0) {
            found.push(root_between(both, left, right, at_left < 0.0));
        }
        (left, at_left) = (right, at_right);
    }
    found
}

/// Horner's rule.
fn value(c: &[Real], x: Real) -> Real {
    c.iter().rev().fold(0.0, |sum, &c| sum * x + c)
}

/// The roots in `low..=high` of `c[2] x^2 + c[1] x + c[0]`, without cancellation.
fn quadratic_roots([c0, c1, c2]: [Real; 3], low: Real, high: Real) -> CubicRoots {
    let mut found = CubicRoots::default();
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

/// Enough halvings to part any two neighbouring numbers of the interval; Newton's steps make
/// it some six as a rule.
const STEPS: u32 = Real::MANTISSA_DIGITS + 8;

/// The one root between `left` and `right` of a function that changes its sign there: from below
/// zero where it is `rising`. The function answers with its value and its slope.
///
/// It is right to a roundoff of the larger end: where Newton's steps become smaller, they follow
/// the rounding of the function and lead nowhere.
pub fn root_between(f: impl Fn(Real) -> (Real, Real), mut left: Real, mut right: Real, rising: bool) -> Real {
    let close = ROUNDOFF * greatest(left.abs(), right.abs());
    let mut x = 0.5 * (left + right);
    for _ in 0..STEPS {
        let (y, slope) = f(x);
        // A zero has no sign: taken for one, it would shut out the root.
        if y == 0.0 {
            break;
        }
        if (y < 0.0) == rising {
            left = x;
        } else {
            right = x;
        }
        let newton = x - y / slope;
        // Outside the bracket (or no number): halve instead.
        let next = if newton > left && newton < right { newton } else { 0.5 * (left + right) };
        let step = (next - x).abs();
        x = next;
        if step <= close {
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
        let want = [-0.75, -0.25, 0.5];
        let found = cubic_roots(c, -1.0, 1.0);
        assert_eq!(found.iter().count(), 3, "{found:?}");
        for (x, w) in found.iter().zip(want) {
            assert!((x - w).abs() <= 16.0 * Real::EPSILON, "{x} is not {w}");
        }
    }

    #[test]
    fn roots_outside_the_interval_and_complex_ones_are_not_reported() {
        // x^3 + x has one; x^3 - 8 has one at 2.
        assert_eq!(cubic_roots([0.0, 1.0, 0.0, 1.0], -3.0, 3.0).iter().count(), 1);
        assert_eq!(cubic_roots([-8.0, 0.0, 0.0, 1.0], -1.0, 1.0).iter().count(), 0);
        assert_eq!(cubic_roots([-8.0, 0.0, 0.0, 1.0], -1.0, 3.0).iter().count(), 1);
    }

    #[test]
    fn a_root_that_is_met_exactly_is_the_answer_from_both_sides() {
        // The second step of Newton's meets it: from there on zero must not pass for a sign.
        for rising in [true, false] {
            let sign = if rising { 1.0 } else { -1.0 };
            let f = |x: Real| (sign * (x * x - 0.25), sign * 2.0 * x);
            assert_eq!(root_between(f, 0.0, 1.0, rising), 0.5);
            let root = root_between(f, 0.1, 1.7, rising);
            assert!((root - 0.5).abs() <= 2.0 * Real::EPSILON, "{root}");
        }
    }

    #[test]
    fn a_root_is_found_where_the_slope_leads_nowhere() {
        // The slope is given as zero, so that only halving is left.
        let root = root_between(|x| (x - 0.3, 0.0), -1.0, 1.0, true);
        assert!((root - 0.3).abs() <= Real::EPSILON);
    }
}
