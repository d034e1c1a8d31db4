//! Torus: a tube round a circle.
//!
//! A ray meets it up to four times. The quartic for that is useless in single precision at
//! some distance, so the origin is first moved along the ray to where it is nearest to the
//! centre, and everything is divided by the torus' size: then all numbers are at most about 1.
//! The roots are parted by those of the derivatives ([`quartic_roots`]), and each is polished
//! on the distance to the tube's middle, which is exact where the quartic's coefficients have
//! lost digits.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{Aabb, Ray, ShapeFault, Surface, check_point, check_unit, disc::disc_reach};
use crate::math::{FARTHEST, Real, Vec3, abs, gamma, length, quartic_roots, sqrt, unit};

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
        // The part of the ray inside the sphere round the torus.
        let room = ROOM - o.dot(o);
        if !(room > 0.0) {
            return None;
        }
        let reach = sqrt(room);
        if shift + reach < 0.0 {
            return None;
        }

        let (major, minor) = (self.major / size, self.minor / size);
        let (oz, dz) = (o.dot(self.axis), d.dot(self.axis));
        // (p.p - (R^2 + r^2))^2 = 4 R^2 (r^2 - z^2), p = o + d t.
        let m = 4.0 * major * major;
        let beta = o.dot(d);
        let g = o.dot(o) - (major * major + minor * minor);
        let quartic = [
            g * g + m * (oz - minor) * (oz + minor),
            4.0 * beta * g + 2.0 * m * oz * dz,
            4.0 * beta * beta + 2.0 * g + m * dz * dz,
            4.0 * beta,
            1.0,
        ];
        let start = if -shift > -reach { -shift } else { -reach };
        for root in quartic_roots(quartic, start, reach).iter() {
            let t = shift + polished(o, d, self.axis, major, minor, root);
            if t > 0.0 {
                return Some(t * size / speed * ray.scale);
            }
        }
        None
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Surface {
        let p = ray.at(t) - self.center;
        let z = p.dot(self.axis);
        let middle = unit(p - self.axis * z).unwrap_or(self.axis.any_orthonormal_vector()) * self.major;
        let normal = unit(p - middle).unwrap_or(self.axis);
        let point = self.center + (middle + normal * self.minor);
        let error = (abs(self.center) + Vec3::splat(self.major + self.minor)) * gamma(24);
        Surface::flat(point, error, normal)
    }
}

/// Newton's steps on `(rho - R)^2 + z^2 - r^2`, which knows the distance to the tube's middle
/// to the last digits, from a root of the quartic, which does not.
fn polished(o: Vec3, d: Vec3, axis: Vec3, major: Real, minor: Real, root: Real) -> Real {
    let mut t = root;
    for _ in 0..3 {
        let p = o + d * t;
        let (z, dz) = (p.dot(axis), d.dot(axis));
        let (flat, flat_d) = (p - axis * z, d - axis * dz);
        let rho = length(flat);
        let from_middle = rho - major;
        let tube = length(Vec3::new(from_middle, z, 0.0));
        // Per unit of t: how the distance to the tube's middle changes.
        let change = (from_middle * (flat.dot(flat_d) / rho) + z * dz) / tube;
        let step = (tube - minor) / change;
        // Where the ray grazes the tube the steps mean nothing, and the root is kept.
        if !(step.abs() <= 0.25 * minor) {
            break;
        }
        t -= step;
    }
    t
}
