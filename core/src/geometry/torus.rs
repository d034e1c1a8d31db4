//! Torus: a tube around a circle.
//!
//! A ray hits it up to four times, at the roots of a quartic. In single precision the quartic itself is
//! not accurate enough: its coefficients cancel far from the torus, and the roots of a thin tube are
//! nearly double. Therefore:
//!
//! * The origin is moved along the ray to the point closest to the center, and all lengths are divided by
//!   the outer radius. All numbers are then at most about 1.
//! * The quartic only provides its turning points, the roots of a cubic. They are where the ray is closest
//!   to the center circle of the tube, and they are well separated. Between two of them the ray enters or
//!   leaves the tube at most once.
//! * Whether it does, and at which `t`, follows from the distance to the center circle, which is accurate
//!   to the last digits.
//!
//! Ferrari's formula is faster, but in single precision it is wrong for most rays from far away.

use super::disc::disc_half_extent;
use super::ranges::{validate_direction, validate_point};
use super::ray::OFFSET_ROUNDINGS;
use super::{Aabb, Ray, ShapeError, SurfaceInteraction};
use crate::math::{
    CubicRoots, MAX_COORDINATE, ROUNDOFF, Real, Vec3, abs, bracketed_root, cubic_roots, gamma, length, sqrt,
    try_normalize,
};

/// A torus. Its normal points out of the tube.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Torus {
    /// Center, world space, coordinates in `-1e15..=1e15`.
    pub center: Vec3,
    /// Unit vector perpendicular to the center circle.
    pub axis: Vec3,
    /// Radius of the center circle of the tube, in scene lengths, at most 1e15.
    pub major_radius: Real,
    /// Radius of the tube, in scene lengths, in `(0, major_radius]`.
    pub minor_radius: Real,
}

/// Squared radius of the bounding sphere relative to the torus: more than 1, so that rounding excludes no
/// root.
const BOUND_MARGIN: Real = 1.0 + 1e-4;

impl Torus {
    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_point(self.center)?;
        validate_direction(self.axis)?;
        let ok = self.minor_radius > 0.0
            && self.minor_radius <= self.major_radius
            && self.major_radius <= MAX_COORDINATE;
        if ok { Ok(()) } else { Err(ShapeError::Radius) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let half_extent = disc_half_extent(self.axis, self.major_radius) + Vec3::splat(self.minor_radius);
        Aabb::from_center(self.center, half_extent * (1.0 + gamma(8)))
    }

    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        let size = self.major_radius + self.minor_radius;
        let direction_length = sqrt(ray.scaled_length_squared);
        let d = ray.scaled_direction / direction_length;
        let origin = (ray.origin - self.center) / size;
        let t_closest = -origin.dot(d);
        let o = origin + d * t_closest;
        // Clip the ray to the bounding sphere, whose margin grows with the rounding of the moved origin.
        let half_chord_squared = BOUND_MARGIN + 32.0 * ROUNDOFF * t_closest.abs() - o.dot(o);
        if !(half_chord_squared > 0.0) {
            return None;
        }
        let half_chord = sqrt(half_chord_squared);
        if t_closest + half_chord < 0.0 {
            return None;
        }
        let start = if -t_closest > -half_chord { -t_closest } else { -half_chord };

        let (major, minor) = (self.major_radius / size, self.minor_radius / size);
        let local_ray = TorusRay::new(o, d, self.axis, major);
        let f = |t: Real| {
            let (distance, derivative) = local_ray.tube_distance(t);
            (distance - minor, derivative)
        };
        let mut left = start;
        let mut is_inside = f(left).0 < 0.0;
        let turning_points = local_ray.turning_points(minor, start, half_chord);
        for right in turning_points.iter().chain([half_chord]) {
            let right =
                if minor < THIN_TUBE_RATIO * major { local_ray.refine_turning_point(right) } else { right };
            let is_inside_next = f(right).0 < 0.0;
            if is_inside != is_inside_next {
                let t = t_closest + bracketed_root(f, left, right, is_inside);
                if t > 0.0 {
                    return Some(t * size / direction_length * ray.direction_scale);
                }
            }
            (left, is_inside) = (right, is_inside_next);
        }
        None
    }

    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> SurfaceInteraction {
        let p = ray.at_relative_to(t, self.center);
        let z = p.dot(self.axis);
        let on_circle = try_normalize(p - self.axis * z).unwrap_or(self.axis.any_orthonormal_vector())
            * self.major_radius;
        let normal = try_normalize(p - on_circle).unwrap_or(self.axis);
        let point = self.center + (on_circle + normal * self.minor_radius);
        let error = (abs(self.center) + Vec3::splat(self.major_radius + self.minor_radius))
            * gamma(24 + OFFSET_ROUNDINGS);
        SurfaceInteraction::with_geometric_normal(point, error, normal)
    }
}

/// A ray relative to the torus: its center as origin, its outer radius as unit of length.
struct TorusRay {
    /// Components of the origin and of the direction along the axis.
    z: Real,
    dz: Real,
    /// Components of the origin and of the direction perpendicular to the axis.
    radial: Vec3,
    radial_direction: Vec3,
    /// Dot product of the origin with itself.
    oo: Real,
    /// Dot product of origin and direction, nearly zero.
    od: Real,
    /// Radius of the center circle of the tube.
    major: Real,
}

impl TorusRay {
    fn new(o: Vec3, d: Vec3, axis: Vec3, major: Real) -> Self {
        let (z, dz) = (o.dot(axis), d.dot(axis));
        let (radial, radial_direction) = (o - axis * z, d - axis * dz);
        TorusRay { z, dz, radial, radial_direction, oo: o.dot(o), od: o.dot(d), major }
    }

    /// Cylindrical coordinates of the point at `t`: distance `rho` from the axis, `rho - major`, height
    /// along the axis, and the derivative of `rho`.
    fn at(&self, t: Real) -> (Real, Real, Real, Real) {
        let radial = self.radial + self.radial_direction * t;
        let rho = length(radial);
        (rho, rho - self.major, self.z + self.dz * t, radial.dot(self.radial_direction) / rho)
    }

    /// Distance of the point at `t` from the center circle of the tube, and its derivative.
    fn tube_distance(&self, t: Real) -> (Real, Real) {
        let (_, from_circle, z, d_rho) = self.at(t);
        let distance = sqrt(from_circle * from_circle + z * z);
        (distance, (from_circle * d_rho + z * self.dz) / distance)
    }

    /// The turning points of `(p.p - (R^2 + r^2))^2 - 4 R^2 (r^2 - z^2)`, where `p = o + d t`.
    fn turning_points(&self, minor: Real, low: Real, high: Real) -> CubicRoots {
        let (major, od) = (self.major, self.od);
        let m = 4.0 * major * major;
        let g = self.oo - (major * major + minor * minor);
        let c1 = 4.0 * od * g + 2.0 * m * self.z * self.dz;
        let c2 = 4.0 * od * od + 2.0 * g + m * self.dz * self.dz;
        cubic_roots([c1, 2.0 * c2, 12.0 * od, 4.0], low, high)
    }

    /// Refines a turning point by Newton's method on the derivative of the squared distance from the
    /// center circle. For a thin tube its error must be less than the radius of the tube.
    fn refine_turning_point(&self, mut t: Real) -> Real {
        for _ in 0..2 {
            let (rho, from_circle, z, d_rho) = self.at(t);
            let slope = from_circle * d_rho + z * self.dz;
            let curvature = d_rho * d_rho
                + self.dz * self.dz
                + from_circle * (self.radial_direction.dot(self.radial_direction) - d_rho * d_rho) / rho;
            let step = slope / curvature;
            if !(step.abs() <= MAX_NEWTON_STEP) {
                break;
            }
            t -= step;
        }
        t
    }
}

/// Ratio of the radii below which turning points are refined.
const THIN_TUBE_RATIO: Real = 1.0 / 16.0;

/// Largest error of a turning point due to the rounding of the quartic: about the square root of the
/// rounding error.
const MAX_NEWTON_STEP: Real = 1e-3;
