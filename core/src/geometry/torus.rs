//! Torus: a tube round a circle.
//!
//! A ray meets it up to four times, and the distances are the roots of a quartic. In single
//! precision that quartic is useless: far away for its coefficients, and for a thin tube because
//! its roots come in pairs that it cannot part. So the origin is first moved along the ray to
//! where it is nearest to the centre, and everything is divided by the torus' size: then all
//! numbers are at most about 1. And the quartic only says where to look: between its turning
//! points, which lie where the ray comes nearest to the tube's middle and are well parted, the
//! ray goes in or out once. Whether it does, and where, is asked of the distance to the tube's
//! middle, which is right to the last digits.
//!
//! Ferrari's formula takes fewer instructions, but in single precision it is wrong for most rays from
//! ten sizes away.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{Aabb, Ray, ShapeFault, Surface, check_point, check_unit, disc::disc_reach, ray::LEAVING};
use crate::math::{
    CubicRoots, FARTHEST, ROUNDOFF, Real, Vec3, abs, cubic_roots, gamma, length, root_between, sqrt, unit,
};

/// A torus; its normal points out of the tube.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Torus {
    /// The middle of the hole.
    pub center: Vec3,
    /// Upright on the circle, of length one.
    pub axis: Vec3,
    /// From the centre to the middle of the tube.
    pub major: Real,
    /// The radius of the tube: more than zero, at most `major`.
    pub minor: Real,
}

/// A little more than the torus' own size, so that rounding shuts out no root.
const ROOM: Real = 1.0 + 1e-4;

impl Torus {
    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_point(self.center)?;
        check_unit(self.axis)?;
        let ok = self.minor > 0.0 && self.minor <= self.major && self.major <= FARTHEST;
        if ok { Ok(()) } else { Err(ShapeFault::Radius) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let reach = disc_reach(self.axis, self.major) + Vec3::splat(self.minor);
        Aabb::round(self.center, reach * (1.0 + gamma(8)))
    }

    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        let size = self.major + self.minor;
        let speed = sqrt(ray.square);
        let d = ray.along / speed;
        let far = (ray.origin - self.center) / size;
        let shift = -far.dot(d);
        let o = far + d * shift;
        // The part of the ray inside the sphere round the torus, which a ray from afar knows only
        // with the rounding of the way.
        let room = ROOM + 32.0 * ROUNDOFF * shift.abs() - o.dot(o);
        if !(room > 0.0) {
            return None;
        }
        let reach = sqrt(room);
        if shift + reach < 0.0 {
            return None;
        }
        let start = if -shift > -reach { -shift } else { -reach };

        let (major, minor) = (self.major / size, self.minor / size);
        let line = Line::new(o, d, self.axis, major);
        let f = |t: Real| {
            let (tube, change) = line.tube(t);
            (tube - minor, change)
        };
        let mut left = start;
        let mut inside = f(left).0 < 0.0;
        let turns = line.turns(minor, start, reach);
        for right in turns.iter().chain([reach]) {
            let right = if minor < THIN * major { line.nearest(right) } else { right };
            let goes_inside = f(right).0 < 0.0;
            if inside != goes_inside {
                let t = shift + root_between(f, left, right, inside);
                if t > 0.0 {
                    return Some(t * size / speed * ray.scale);
                }
            }
            (left, inside) = (right, goes_inside);
        }
        None
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Surface {
        let p = ray.at_from(t, self.center);
        let z = p.dot(self.axis);
        let middle = unit(p - self.axis * z).unwrap_or(self.axis.any_orthonormal_vector()) * self.major;
        let normal = unit(p - middle).unwrap_or(self.axis);
        let point = self.center + (middle + normal * self.minor);
        let error = (abs(self.center) + Vec3::splat(self.major + self.minor)) * gamma(24 + LEAVING);
        Surface::flat(point, error, normal)
    }
}

/// A ray and the circle in the middle of the tube, in the torus' own measure.
struct Line {
    /// The origin along the axis and upright on it, and the direction.
    z: Real,
    dz: Real,
    flat: Vec3,
    flat_d: Vec3,
    /// Origin times origin, and origin times direction, which is nearly zero.
    square: Real,
    beta: Real,
    major: Real,
}

impl Line {
    fn new(o: Vec3, d: Vec3, axis: Vec3, major: Real) -> Self {
        let (z, dz) = (o.dot(axis), d.dot(axis));
        let (flat, flat_d) = (o - axis * z, d - axis * dz);
        Line { z, dz, flat, flat_d, square: o.dot(o), beta: o.dot(d), major }
    }

    /// How far from the axis, beyond the circle, and along the axis the ray is at `t`; and how the
    /// first two change.
    fn at(&self, t: Real) -> (Real, Real, Real, Real) {
        let flat = self.flat + self.flat_d * t;
        let rho = length(flat);
        (rho, rho - self.major, self.z + self.dz * t, flat.dot(self.flat_d) / rho)
    }

    /// How far from the circle the ray is at `t`, and how that changes.
    fn tube(&self, t: Real) -> (Real, Real) {
        let (_, beyond, z, d_rho) = self.at(t);
        let tube = sqrt(beyond * beyond + z * z);
        (tube, (beyond * d_rho + z * self.dz) / tube)
    }

    /// The turning points of `(p.p - (R^2 + r^2))^2 - 4 R^2 (r^2 - z^2)`, where `p = o + d t`.
    fn turns(&self, minor: Real, low: Real, high: Real) -> CubicRoots {
        let (major, beta) = (self.major, self.beta);
        let m = 4.0 * major * major;
        let g = self.square - (major * major + minor * minor);
        let c1 = 4.0 * beta * g + 2.0 * m * self.z * self.dz;
        let c2 = 4.0 * beta * beta + 2.0 * g + m * self.dz * self.dz;
        cubic_roots([c1, 2.0 * c2, 12.0 * beta, 4.0], low, high)
    }

    /// A turning point, moved by Newton's steps to where the distance to the circle turns: beside
    /// a thin tube it must be right to less than the tube.
    fn nearest(&self, mut t: Real) -> Real {
        for _ in 0..2 {
            let (rho, beyond, z, d_rho) = self.at(t);
            let slope = beyond * d_rho + z * self.dz;
            let bend = d_rho * d_rho
                + self.dz * self.dz
                + beyond * (self.flat_d.dot(self.flat_d) - d_rho * d_rho) / rho;
            let step = slope / bend;
            if !(step.abs() <= NEAR) {
                break;
            }
            t -= step;
        }
        t
    }
}

/// A tube of less than this share of the circle is thin.
const THIN: Real = 1.0 / 16.0;

/// How far off a turning point can be by the rounding of the quartic: its root.
const NEAR: Real = 1e-3;
