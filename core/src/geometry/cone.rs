//! Cone and cylinder: a lateral surface between two circles on one axis, open or closed by caps.
//!
//! The ray's origin is first moved along the ray to the point closest to the center of the cone, so that
//! all numbers are about as large as the cone before they are squared. With `op` and `dp` the components of
//! origin and direction perpendicular to the axis, `R` the radius at the height of the origin and `k` the
//! slope of the radius, the discriminant of the quadratic is
//!
//! ```text
//! |R dp - k dz op|^2 - (op x dp)^2
//! ```
//!
//! Both terms are squares, the second is the squared distance of the ray from the axis (times `dp.dp`).
//! They cancel only if the ray nearly touches the surface. The textbook's `b^2 - a c` also cancels for a
//! very thin cylinder.

use super::disc::disc_half_extent;
use super::ranges::{validate_direction, validate_point};
use super::ray::OFFSET_ROUNDINGS;
use super::{Aabb, Ray, ShapeError, SurfaceInteraction};
use crate::math::{
    MAX_COORDINATE, Real, Vec3, abs, gamma, length, max, max_abs_component, sqrt, try_normalize,
};

/// A truncated cone. It is a cylinder if both radii are equal.
///
/// The normal of the lateral surface points away from the axis, the normals of the caps out of the solid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Cone {
    /// Center of the base circle, world space, coordinates in `-1e15..=1e15`.
    pub base: Vec3,
    /// Unit vector from the base circle to the end circle.
    pub axis: Vec3,
    /// Distance between the circles, in scene lengths, in `(0, 1e15]`.
    pub height: Real,
    /// Radius of the base circle, in scene lengths, in `0..=1e15`; zero for an apex.
    pub base_radius: Real,
    /// Radius of the end circle, in scene lengths, in `0..=1e15`; zero for an apex. At least one of the
    /// radii is positive.
    pub end_radius: Real,
    /// Whether discs close both circles. If not, the surface is open and can be seen from inside.
    pub capped: bool,
}

/// A part of the surface.
#[derive(Clone, Copy, PartialEq)]
enum ConePart {
    Side,
    BaseCap,
    EndCap,
}

impl Cone {
    /// The cone between the circle of `base_radius` around `base` and the circle of `end_radius` around
    /// `end`. `None` if the points are equal or not finite. The radii are checked by
    /// [`Scene::new`](crate::Scene::new).
    pub fn new(base: Vec3, base_radius: Real, end: Vec3, end_radius: Real, capped: bool) -> Option<Self> {
        let axis = try_normalize(end - base)?;
        let height = (end - base).dot(axis);
        Some(Cone { base, axis, height, base_radius, end_radius, capped })
    }

    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_point(self.base)?;
        validate_direction(self.axis)?;
        let (r0, r1) = (self.base_radius, self.end_radius);
        let ok = |r: Real| r >= 0.0 && r <= MAX_COORDINATE;
        if !(ok(r0) && ok(r1) && (r0 > 0.0 || r1 > 0.0)) {
            return Err(ShapeError::Radius);
        }
        if self.height > 0.0 && self.height <= MAX_COORDINATE { Ok(()) } else { Err(ShapeError::Size) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let end = self.base + self.axis * self.height;
        let slack = Vec3::splat(gamma(8) * (max_abs_component(self.base) + self.height));
        Aabb::from_center(self.base, disc_half_extent(self.axis, self.base_radius) + slack)
            .union(Aabb::from_center(end, disc_half_extent(self.axis, self.end_radius) + slack))
    }

    /// Change of the radius per length along the axis.
    fn radius_slope(&self) -> Real {
        (self.end_radius - self.base_radius) / self.height
    }

    /// Whether a line certainly passes the axis at more than the largest radius: an early out for most
    /// misses. `origin` is relative to `base`; `direction` has a length of about one.
    #[inline(always)]
    fn is_clear_miss(&self, origin: Vec3, direction: Vec3) -> bool {
        let cross = self.axis.cross(direction);
        let distance = abs(origin);
        let separation = origin.dot(cross).abs() - (distance.x + distance.y + distance.z) * gamma(16);
        let max_radius = max(self.base_radius, self.end_radius);
        separation > 0.0
            && separation * separation > cross.dot(cross) * (max_radius * max_radius) * (1.0 + gamma(16))
    }

    /// The nearest hit at a positive `t`, and the part that is hit.
    fn nearest_part(&self, ray: &Ray) -> Option<(Real, ConePart)> {
        let d = ray.scaled_direction;
        let origin = ray.origin - self.base;
        if self.is_clear_miss(origin, d) {
            return None;
        }
        let shift = (self.axis * (0.5 * self.height) - origin).dot(d) / ray.scaled_length_squared;
        let o = origin + d * shift;
        let (oz, dz) = (o.dot(self.axis), d.dot(self.axis));
        let (op, dp) = (o - self.axis * oz, d - self.axis * dz);

        let mut nearest = (Real::INFINITY, ConePart::Side);
        let mut accept_if_nearer = |t: Real, part: ConePart| {
            let t = (shift + t) * ray.direction_scale;
            if t > 0.0 && t < nearest.0 {
                nearest = (t, part);
            }
        };

        // The side: a t^2 - 2 b t + c = 0.
        let k = self.radius_slope();
        let radius = self.base_radius + k * oz;
        let a = dp.dot(dp) - k * k * (dz * dz);
        let b = k * dz * radius - op.dot(dp);
        let c = op.dot(op) - radius * radius;
        let (w, x) = (dp * radius - op * (k * dz), op.cross(dp).dot(self.axis));
        let (w, x) = (length(w), x.abs());
        if w >= x {
            let root = sqrt((w - x) * (w + x));
            let q = if b >= 0.0 { b + root } else { b - root };
            // For a ray parallel to the side a = 0: one root is infinite and not a hit.
            for t in [q / a, c / q] {
                let z = oz + dz * t;
                if z >= 0.0 && z <= self.height {
                    accept_if_nearer(t, ConePart::Side);
                }
            }
        }

        // The caps.
        if self.capped {
            for (z, radius, part) in
                [(0.0, self.base_radius, ConePart::BaseCap), (self.height, self.end_radius, ConePart::EndCap)]
            {
                let t = (z - oz) / dz;
                let p = op + dp * t;
                if p.dot(p) <= radius * radius {
                    accept_if_nearer(t, part);
                }
            }
        }
        (nearest.0 < Real::INFINITY).then_some(nearest)
    }

    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        self.nearest_part(ray).map(|(t, _)| t)
    }

    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> Option<SurfaceInteraction> {
        let (_, part) = self.nearest_part(ray)?;
        let p = ray.at_relative_to(t, self.base);
        let size = self.height + self.base_radius + self.end_radius;
        let error = (abs(self.base) + Vec3::splat(size)) * gamma(24 + OFFSET_ROUNDINGS);
        let z = p.dot(self.axis);
        let on_cap = |z_cap: Real, normal: Vec3| {
            SurfaceInteraction::with_geometric_normal(
                self.base + (p + self.axis * (z_cap - z)),
                error,
                normal,
            )
        };
        Some(match part {
            ConePart::BaseCap => on_cap(0.0, -self.axis),
            ConePart::EndCap => on_cap(self.height, self.axis),
            ConePart::Side => {
                let k = self.radius_slope();
                match try_normalize(p - self.axis * z) {
                    Some(radial) => {
                        let normal = try_normalize(radial - self.axis * k).unwrap_or(radial);
                        let on_side = self.axis * z + radial * (self.base_radius + k * z);
                        SurfaceInteraction::with_geometric_normal(self.base + on_side, error, normal)
                    }
                    // The apex has no normal; use the outward direction of the axis.
                    None => SurfaceInteraction::with_geometric_normal(
                        self.base + p,
                        error,
                        self.axis * if k > 0.0 { -1.0 } else { 1.0 },
                    ),
                }
            }
        })
    }
}
