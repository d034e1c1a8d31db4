//! Cone and cylinder: a round side between two circles on one axis, open or with caps.
//!
//! The origin is moved along the ray to where it is nearest to the cone's middle, so that all
//! numbers are about as large as the cone; only then come squares. With `op` and `dp` the
//! parts of origin and direction upright on the axis, `R` the radius level with the origin and
//! `k` its slope, the discriminant of the quadratic is
//!
//! ```text
//! |R dp - k dz op|^2 - (op x dp)^2
//! ```
//!
//! two squares of which the second is the ray's distance from the axis. Nothing cancels there
//! but the question itself, whether the ray comes nearer to the axis than the side, as the
//! textbook's `b^2 - ac` would for a hair-thin cylinder.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::disc::disc_reach;
use super::{Aabb, Ray, ShapeFault, Surface, check_point, check_unit, ray::LEAVING};
use crate::math::{FARTHEST, Real, Vec3, abs, gamma, greatest, largest, length, sqrt, unit};

/// A cone, cut off at both ends; a cylinder when both radii are equal.
///
/// The normal of the side points away from the axis, those of the caps away from the solid.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Cone {
    /// The middle of the first circle.
    pub base: Vec3,
    /// From the first circle to the second, of length one.
    pub axis: Vec3,
    /// From circle to circle, more than zero.
    pub height: Real,
    /// The radius of the first circle; zero is an apex.
    pub base_radius: Real,
    /// The radius of the second circle; zero is an apex. One of both is more than zero.
    pub end_radius: Real,
    /// Whether the circles are closed by discs.
    pub capped: bool,
}

/// Where a ray meets it.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Side,
    Base,
    End,
}

impl Cone {
    /// The cone between the circle of radius `base_radius` round `base` and that of
    /// `end_radius` round `end`. None when both points are the same or not finite.
    pub fn new(base: Vec3, base_radius: Real, end: Vec3, end_radius: Real, capped: bool) -> Option<Self> {
        let axis = unit(end - base)?;
        let height = (end - base).dot(axis);
        Some(Cone { base, axis, height, base_radius, end_radius, capped })
    }

    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_point(self.base)?;
        check_unit(self.axis)?;
        let (r0, r1) = (self.base_radius, self.end_radius);
        let ok = |r: Real| r >= 0.0 && r <= FARTHEST;
        if !(ok(r0) && ok(r1) && (r0 > 0.0 || r1 > 0.0)) {
            return Err(ShapeFault::Radius);
        }
        if self.height > 0.0 && self.height <= FARTHEST { Ok(()) } else { Err(ShapeFault::Size) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let end = self.base + self.axis * self.height;
        let slack = Vec3::splat(gamma(8) * (largest(self.base) + self.height));
        Aabb::round(self.base, disc_reach(self.axis, self.base_radius) + slack)
            .union(Aabb::round(end, disc_reach(self.axis, self.end_radius) + slack))
    }

    /// How the radius grows along the axis.
    fn slope(&self) -> Real {
        (self.end_radius - self.base_radius) / self.height
    }

    /// Whether a line from `far` along `d`, which is about one long, clearly passes its axis
    /// farther away than it is wide: most of those that come here do, and need not know where.
    #[inline(always)]
    fn is_passed(&self, far: Vec3, d: Vec3) -> bool {
        let across = self.axis.cross(d);
        let away = abs(far);
        let apart = far.dot(across).abs() - (away.x + away.y + away.z) * gamma(16);
        let widest = greatest(self.base_radius, self.end_radius);
        apart > 0.0 && apart * apart > across.dot(across) * (widest * widest) * (1.0 + gamma(16))
    }

    /// The nearest part in front of the ray's origin.
    fn nearest(&self, ray: &Ray) -> Option<(Real, Part)> {
        let d = ray.along;
        let far = ray.origin - self.base;
        if self.is_passed(far, d) {
            return None;
        }
        let shift = (self.axis * (0.5 * self.height) - far).dot(d) / ray.square;
        let o = far + d * shift;
        let (oz, dz) = (o.dot(self.axis), d.dot(self.axis));
        let (op, dp) = (o - self.axis * oz, d - self.axis * dz);

        let mut nearest = (Real::INFINITY, Part::Side);
        let mut offer = |t: Real, part: Part| {
            let t = (shift + t) * ray.scale;
            if t > 0.0 && t < nearest.0 {
                nearest = (t, part);
            }
        };

        // The side: a t^2 - 2 b t + c = 0.
        let k = self.slope();
        let radius = self.base_radius + k * oz;
        let a = dp.dot(dp) - k * k * (dz * dz);
        let b = k * dz * radius - op.dot(dp);
        let c = op.dot(op) - radius * radius;
        let (w, x) = (dp * radius - op * (k * dz), op.cross(dp).dot(self.axis));
        let (w, x) = (length(w), x.abs());
        if w >= x {
            let root = sqrt((w - x) * (w + x));
            let q = if b >= 0.0 { b + root } else { b - root };
            // A ray along the side leaves a = 0: one root is then infinite, and no hit.
            for t in [q / a, c / q] {
                let z = oz + dz * t;
                if z >= 0.0 && z <= self.height {
                    offer(t, Part::Side);
                }
            }
        }

        // The caps.
        if self.capped {
            for (z, radius, part) in
                [(0.0, self.base_radius, Part::Base), (self.height, self.end_radius, Part::End)]
            {
                let t = (z - oz) / dz;
                let p = op + dp * t;
                if p.dot(p) <= radius * radius {
                    offer(t, part);
                }
            }
        }
        (nearest.0 < Real::INFINITY).then_some(nearest)
    }

    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        self.nearest(ray).map(|(t, _)| t)
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Option<Surface> {
        let (_, part) = self.nearest(ray)?;
        let p = ray.at_from(t, self.base);
        let size = self.height + self.base_radius + self.end_radius;
        let error = (abs(self.base) + Vec3::splat(size)) * gamma(24 + LEAVING);
        let z = p.dot(self.axis);
        let on_cap = |z_cap: Real, normal: Vec3| {
            Surface::flat(self.base + (p + self.axis * (z_cap - z)), error, normal)
        };
        Some(match part {
            Part::Base => on_cap(0.0, -self.axis),
            Part::End => on_cap(self.height, self.axis),
            Part::Side => {
                let k = self.slope();
                match unit(p - self.axis * z) {
                    Some(out) => {
                        let normal = unit(out - self.axis * k).unwrap_or(out);
                        let on = self.axis * z + out * (self.base_radius + k * z);
                        Surface::flat(self.base + on, error, normal)
                    }
                    // The apex has no normal of its own: it points on along the axis.
                    None => Surface::flat(self.base + p, error, self.axis * if k > 0.0 { -1.0 } else { 1.0 }),
                }
            }
        })
    }
}
