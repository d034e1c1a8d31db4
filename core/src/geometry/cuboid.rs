//! Solid boxes: axis-aligned and oriented.
//!
//! Source: the slab method of Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986. Difference: the
//! distances of the faces are quotients, not products with the reciprocal direction, because the rounding
//! of the reciprocal would move the faces.

use super::ranges::{validate_direction, validate_point};
use super::ray::OFFSET_ROUNDINGS;
use super::{Aabb, Ray, ShapeError, SurfaceInteraction};
use crate::math::{Axis, Real, Vec3, abs, gamma, try_normalize};

/// An axis-aligned solid box. Its normal points outward.
///
/// Bounding volumes are [`Aabb`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Cuboid {
    /// Corner with the smallest coordinates, world space, in `-1e15..=1e15`.
    pub min: Vec3,
    /// Corner with the largest coordinates, world space, in `-1e15..=1e15`; none is less than that of
    /// `min`.
    pub max: Vec3,
}

/// A solid box with any orientation. Its normal points outward.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct OrientedCuboid {
    /// Center, world space.
    pub center: Vec3,
    /// Half of the edge length along each axis of the box; not negative.
    pub half_extents: Vec3,
    /// Axes of the box, world space: unit vectors, perpendicular to each other.
    pub axes: [Vec3; 3],
}

/// Intersection of a ray with a face of an axis-aligned box.
struct BoxFaceHit {
    t: Real,
    /// The axis that is perpendicular to the face.
    axis: Axis,
    /// `1.0` or `-1.0`: direction of the outward normal along `axis`.
    sign: Real,
}

impl BoxFaceHit {
    /// Outward unit normal of the face.
    fn normal(&self) -> Vec3 {
        self.sign
            * match self.axis {
                Axis::X => Vec3::X,
                Axis::Y => Vec3::Y,
                Axis::Z => Vec3::Z,
            }
    }
}

/// The face through which the ray enters the box, or through which it exits if it starts inside. The `t`
/// of the exit is negative if the box is behind the origin.
///
/// The `t` of a face is NaN if the ray lies in its plane. Comparisons with NaN are false, so such a ray is
/// inside this slab.
fn intersect_box(min: Vec3, max: Vec3, ray: &Ray) -> Option<BoxFaceHit> {
    let t_min_face = (min - ray.origin) / ray.direction;
    let t_max_face = (max - ray.origin) / ray.direction;
    let mut entry = BoxFaceHit { t: Real::NEG_INFINITY, axis: Axis::X, sign: 1.0 };
    let mut exit = BoxFaceHit { t: Real::INFINITY, axis: Axis::X, sign: 1.0 };
    for (axis, inverse, t_min_face, t_max_face) in [
        (Axis::X, ray.inverse_direction.x, t_min_face.x, t_max_face.x),
        (Axis::Y, ray.inverse_direction.y, t_min_face.y, t_max_face.y),
        (Axis::Z, ray.inverse_direction.z, t_min_face.z, t_max_face.z),
    ] {
        let (t_near, t_far, sign) =
            if inverse >= 0.0 { (t_min_face, t_max_face, 1.0) } else { (t_max_face, t_min_face, -1.0) };
        if t_near > entry.t {
            entry = BoxFaceHit { t: t_near, axis, sign: -sign };
        }
        if t_far < exit.t {
            exit = BoxFaceHit { t: t_far, axis, sign };
        }
    }
    if entry.t > exit.t {
        None
    } else if entry.t > 0.0 {
        Some(entry)
    } else {
        Some(exit)
    }
}

impl Cuboid {
    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_point(self.min)?;
        validate_point(self.max)?;
        if self.min.cmple(self.max).all() { Ok(()) } else { Err(ShapeError::Size) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        intersect_box(self.min, self.max, ray).map(|face| face.t)
    }

    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> Option<SurfaceInteraction> {
        let face = intersect_box(self.min, self.max, ray)?;
        let point = ray.at(t);
        let corner = if face.sign > 0.0 { self.max } else { self.min };
        let point = match face.axis {
            Axis::X => Vec3::new(corner.x, point.y, point.z),
            Axis::Y => Vec3::new(point.x, corner.y, point.z),
            Axis::Z => Vec3::new(point.x, point.y, corner.z),
        };
        // The point is exact along the normal. The error covers the rounding of the next ray's test.
        Some(SurfaceInteraction::with_geometric_normal(
            point,
            abs(point) * gamma(4 + OFFSET_ROUNDINGS),
            face.normal(),
        ))
    }
}

impl OrientedCuboid {
    /// The box around `center` with the given half extents along its axes.
    ///
    /// Its z axis is the direction of `z_axis`; its x axis is the direction of the component of `x_axis`
    /// perpendicular to it. `None` if both are parallel, or if one is zero or not finite.
    pub fn new(center: Vec3, half: Vec3, x_axis: Vec3, z_axis: Vec3) -> Option<Self> {
        let z_axis = try_normalize(z_axis)?;
        let x_axis = try_normalize(x_axis)?;
        let y_axis = try_normalize(z_axis.cross(x_axis))?;
        Some(OrientedCuboid { center, half_extents: half, axes: [y_axis.cross(z_axis), y_axis, z_axis] })
    }

    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        validate_point(self.center)?;
        validate_point(self.half_extents)?;
        let [x, y, z] = self.axes;
        for axis in [x, y, z] {
            validate_direction(axis)?;
        }
        if abs(Vec3::new(x.dot(y), y.dot(z), z.dot(x))).max_element() > 1e-5 {
            return Err(ShapeError::NotOrthogonal);
        }
        if self.half_extents.cmpge(Vec3::ZERO).all() { Ok(()) } else { Err(ShapeError::Size) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let [x, y, z] = self.axes;
        let half_extent =
            abs(x) * self.half_extents.x + abs(y) * self.half_extents.y + abs(z) * self.half_extents.z;
        Aabb::from_center(self.center, half_extent * (1.0 + gamma(8)))
    }

    /// The ray in the frame of the box: its axes, its center as origin.
    ///
    /// The center is subtracted first, so that the errors are relative to the distance between ray and box
    /// and not to their coordinates.
    fn ray_in_box_frame(&self, ray: &Ray) -> Ray {
        let [x, y, z] = self.axes;
        let rotate = |v: Vec3| Vec3::new(v.dot(x), v.dot(y), v.dot(z));
        Ray::new(rotate(ray.origin - self.center), rotate(ray.direction))
    }

    pub(super) fn intersect(&self, ray: &Ray) -> Option<Real> {
        intersect_box(-self.half_extents, self.half_extents, &self.ray_in_box_frame(ray)).map(|face| face.t)
    }

    pub(super) fn surface_interaction(&self, ray: &Ray, t: Real) -> Option<SurfaceInteraction> {
        let face = intersect_box(-self.half_extents, self.half_extents, &self.ray_in_box_frame(ray))?;
        let [x, y, z] = self.axes;
        let (axis, half) = match face.axis {
            Axis::X => (x, self.half_extents.x),
            Axis::Y => (y, self.half_extents.y),
            Axis::Z => (z, self.half_extents.z),
        };
        let normal = axis * face.sign;
        let p = ray.at_relative_to(t, self.center);
        let point = self.center + (p - normal * (p.dot(normal) - half));
        let error =
            (abs(self.center) + Vec3::splat(self.half_extents.max_element())) * gamma(16 + OFFSET_ROUNDINGS);
        Some(SurfaceInteraction::with_geometric_normal(point, error, normal))
    }
}
