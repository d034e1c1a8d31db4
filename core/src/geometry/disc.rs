//! Disc: the points of a plane within a radius of the center.
//!
//! The distance from the center is computed relative to the ray's origin. World coordinates of the hit
//! point are too coarse far from the origin.

use super::plane::plane_interaction;
use super::ranges::{validate_direction, validate_radius};
use super::{Aabb, Ray, ShapeError, SurfaceInteraction};
use crate::math::{Real, Vec3, sqrt};

/// A flat disc, hit from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Disc {
    /// Center, world space, coordinates in `-1e15..=1e15`.
    pub center: Vec3,
    /// Unit normal; it points to the front side.
    pub normal: Vec3,
    /// Radius, in scene lengths, in `(0, 1e15]`.
    pub radius: Real,
}

impl Disc {
    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_radius(self.center, self.radius)?;
        validate_direction(self.normal)
    }

    pub(super) fn bounds(&self) -> Aabb {
        Aabb::from_center(self.center, disc_half_extent(self.normal, self.radius))
    }

    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        let o = self.center - ray.origin;
        let t = o.dot(self.normal) / ray.direction.dot(self.normal);
        let p = ray.direction * t - o;
        (p.dot(p) <= self.radius * self.radius).then_some(t)
    }

    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> SurfaceInteraction {
        plane_interaction(ray, t, self.center, self.normal)
    }
}

/// Half extent along each axis of a disc perpendicular to `normal`: `r sqrt(1 - n^2)`.
///
/// `1 - n^2` is computed from the two other components, so that nothing cancels: the box of a disc
/// perpendicular to an axis is exactly flat.
pub(super) fn disc_half_extent(normal: Vec3, radius: Real) -> Vec3 {
    let square = normal * normal;
    let length_squared = normal.dot(normal);
    let half_extent = |others: Real| radius * sqrt(others / length_squared);
    Vec3::new(
        half_extent(square.y + square.z),
        half_extent(square.z + square.x),
        half_extent(square.x + square.y),
    )
}
