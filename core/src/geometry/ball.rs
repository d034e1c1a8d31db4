//! Balls round boxes, and the conservative test of a ray against one: yes or no, not where.
//!
//! Round the box of a long item a ball holds much that is not the item; boxes hold less and are
//! hardly dearer. It is here to be compared ("A 3-Dimensional Representation for Fast Rendering
//! of Complex Scenes", Rubin and Whitted, 1980, weigh one against the other).

use super::bounds::Aabb;
use super::ray::Ray;
use crate::math::{Real, Vec3, abs, gamma, length, sqrt};

/// A ball that contains a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    center: Vec3,
    /// Less than zero for the ball of nothing.
    radius: Real,
}

/// What of a ray the balls need.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<'r> {
    ray: &'r Ray,
    /// One over the square of the length of its direction, as scaled, and over that length.
    per_square: Real,
    per_length: Real,
}

impl<'r> Line<'r> {
    pub(crate) fn of(ray: &'r Ray) -> Self {
        Line { ray, per_square: 1.0 / ray.square, per_length: 1.0 / sqrt(ray.square) }
    }
}

impl Ball {
    /// The ball of nothing: no ray meets it.
    pub const EMPTY: Ball = Ball { center: Vec3::ZERO, radius: -1.0 };

    /// The ball round a box, rounded outward.
    pub(crate) fn round(aabb: &Aabb) -> Self {
        if aabb.is_empty() {
            return Ball::EMPTY;
        }
        let center = (aabb.min + aabb.max) * 0.5;
        // To the farthest corner, wherever rounding has put the centre.
        let corner = (aabb.max - center).max(center - aabb.min);
        Ball { center, radius: length(corner) * (1.0 + gamma(8)) }
    }

    /// Whether the ray comes into the ball, at most `reach` lengths of its direction away.
    ///
    /// It says yes wherever [`Aabb::span`] meets the box inside: what that test rounds, and what
    /// this one does, follows the distance of the ball from the start of the ray.
    #[inline]
    pub(crate) fn meets(&self, line: &Line<'_>, reach: Real) -> bool {
        let ray = line.ray;
        let to = self.center - ray.origin;
        let middle = to.dot(ray.along) * line.per_square;
        let beside = to - ray.along * middle;
        let away = abs(to);
        let radius = self.radius + (self.radius + away.x + away.y + away.z) * gamma(32);
        let half = radius * line.per_length;
        // What is no number leaves the ball in question.
        let misses = self.radius < 0.0
            || beside.dot(beside) > radius * radius
            || middle + half < 0.0
            || (middle - half) * ray.scale > reach * (1.0 + gamma(8));
        !misses
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    /// Whether box and ball say that a ray within reach meets the cube from -1 to 1.
    fn meets(from: Vec3, toward: Vec3, reach: Real) -> [bool; 2] {
        let cube = Aabb { min: Vec3::splat(-1.0), max: Vec3::ONE };
        let ray = Ray::new(from, toward);
        let in_box = cube.span(&ray).is_some_and(|span| span.entry <= reach);
        [in_box, Ball::round(&cube).meets(&Line::of(&ray), reach)]
    }

    #[test]
    fn a_ray_that_starts_inside_a_volume_meets_it() {
        assert_eq!(meets(vec3(0.5, 0.0, 0.0), Vec3::X, 100.0), [true; 2]);
        assert_eq!(meets(vec3(0.5, 0.0, 0.0), Vec3::X, 0.1), [true; 2], "though it ends inside, too");
    }

    #[test]
    fn a_ray_that_ends_inside_a_volume_meets_it() {
        assert_eq!(meets(vec3(-5.0, 0.1, 0.2), Vec3::X, 5.0), [true; 2]);
        assert_eq!(meets(vec3(-5.0, 0.1, 0.2), Vec3::X * 1e20, 5e-20), [true; 2], "of any length");
    }

    #[test]
    fn a_ray_that_passes_through_a_volume_meets_it() {
        assert_eq!(meets(vec3(-5.0, 0.1, 0.2), Vec3::X, 100.0), [true; 2]);
        assert_eq!(meets(vec3(-5.0, -5.0, -5.0), Vec3::ONE * 1e-20, Real::MAX), [true; 2], "of any length");
    }

    #[test]
    fn a_ray_that_misses_a_volume_does_not_meet_it() {
        assert_eq!(meets(vec3(-5.0, 2.0, 0.0), Vec3::X, 100.0), [false; 2], "beside");
        assert_eq!(meets(vec3(5.0, 0.0, 0.0), Vec3::X, 100.0), [false; 2], "behind");
        assert_eq!(meets(vec3(-5.0, 0.0, 0.0), Vec3::X, 2.0), [false; 2], "beyond its reach");
        assert_eq!(
            meets(vec3(-5.0, 1.2, 1.2), Vec3::X, 100.0),
            [false, true],
            "only the ball has no corners"
        );
        assert!(!Ball::EMPTY.meets(&Line::of(&Ray::new(Vec3::ZERO, Vec3::X)), 1.0));
    }
}
