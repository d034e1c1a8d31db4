//! Infinite plane.
//!
//! It has no bounds, so every ray is tested against it. A plane stores a point, not its distance from the
//! world origin, because that distance is too coarse far from the origin.

use super::ranges::{validate_direction, validate_point};
use super::ray::OFFSET_ROUNDINGS;
use super::{ItemId, Ray, ShapeError, SurfaceInteraction};
use crate::math::{Real, Vec3, abs, gamma, max_abs_component};

/// An infinite plane, hit from both sides.
///
/// A scene with a plane has an entry in the table of planes and one in the table of shapes, whose index is
/// the plane's `item`:
///
/// ```
/// use strahl_core::geometry::ItemId;
/// use strahl_core::*;
///
/// let shapes = [Shape::Sphere(Sphere { center: Vec3::Y, radius: 1.0 }), Shape::Plane(0)];
/// let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(1) }];
/// let scene = Scene::new(SceneDescriptor {
///     geometry: Geometry { shapes: &shapes, planes: &planes, ..Geometry::EMPTY },
///     material_ids: &[MaterialId(0); 2],
///     materials: &[Material::MATTE],
///     ..SceneDescriptor::EMPTY
/// })?;
/// # Ok::<(), strahl_core::scene::SceneError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Plane {
    /// A point on the plane, world space, coordinates in `-1e15..=1e15`. Rounding errors grow with the
    /// distance from it.
    pub point: Vec3,
    /// Unit normal; it points to the front side.
    pub normal: Vec3,
    /// Item of the scene that is this plane. A tracer tests the table of planes before all other items.
    pub item: ItemId,
}

impl Plane {
    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_point(self.point)?;
        validate_direction(self.normal)
    }

    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        Some((self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal))
    }

    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> SurfaceInteraction {
        plane_interaction(ray, t, self.point, self.normal)
    }
}

/// The surface at `t` of the plane through `point` with the given unit `normal`. The point of the ray is
/// projected onto the plane.
pub(super) fn plane_interaction(ray: &Ray, t: Real, point: Vec3, normal: Vec3) -> SurfaceInteraction {
    let p = ray.at_relative_to(t, point);
    let projected = point + (p - normal * p.dot(normal));
    let error = (abs(projected) + Vec3::splat(max_abs_component(p))) * gamma(12 + OFFSET_ROUNDINGS);
    SurfaceInteraction::with_geometric_normal(projected, error, normal)
}

/// Offset from a point to the tangent plane of a vertex, along the unit normal of the vertex.
///
/// * `vertex`: relative to the point.
/// * `front_face`: the side of the surface that needs the offset, that of the normals or the other.
///
/// It is zero if the tangent plane is on the other side of the point.
pub(super) fn tangent_plane_offset(vertex: Vec3, normal: Vec3, front_face: bool) -> Vec3 {
    let height = vertex.dot(normal);
    if if front_face { height > 0.0 } else { height < 0.0 } { normal * height } else { Vec3::ZERO }
}
