//! Rays, and the origin of a ray that leaves a surface.

use crate::math::{Axis, Real, Vec3, abs, floor_power_of_two, max_abs_component, vec3};

/// A half-line from `origin` along `direction`, with the values that intersection tests derive from it.
///
/// Parameters along the ray (`t`) are measured in lengths of `direction`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Position, world space.
    pub origin: Vec3,
    /// Direction of any length, world space. A tracer uses directions of about unit length.
    pub direction: Vec3,
    /// Reciprocal of each component of the direction; infinite for zero, with its sign.
    pub inverse_direction: Vec3,
    /// Time in `0..=1` between opening and closing of the shutter. Only moving shapes use it.
    pub time: Real,
    /// Axis of the largest absolute component of the direction.
    pub dominant_axis: Axis,
    /// Reciprocal of the component of the direction along `dominant_axis`.
    pub(super) inverse_dominant: Real,
    /// First row of the matrix that maps the direction to the z axis (Woop et al., JCGT 2013). Its product
    /// with a point relative to `origin` is the x coordinate in the frame of the ray.
    pub(super) shear_x: Vec3,
    /// Second row of that matrix, for the y coordinate.
    pub(super) shear_y: Vec3,
    /// The direction times `direction_scale`. Its length is about one, so its square is in range.
    pub(super) scaled_direction: Vec3,
    /// Squared length of `scaled_direction`; NaN if the ray hits nothing.
    pub(super) scaled_length_squared: Real,
    /// A power of two.
    pub(super) direction_scale: Real,
}

impl Ray {
    /// The ray from `origin` along `direction`, at time 0.
    ///
    /// It hits nothing if the origin or the direction is not finite, or if the direction is zero or so short
    /// that its reciprocal overflows.
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        let ray =
            Self::with_scale(origin, direction, 1.0 / floor_power_of_two(max_abs_component(direction)), 0.0);
        // Zero for a valid ray, NaN for any other.
        let nan_if_invalid = origin.dot(Vec3::ZERO) + ray.inverse_dominant * 0.0;
        Ray { scaled_length_squared: ray.scaled_length_squared + nan_if_invalid, ..ray }
    }

    /// [`Ray::new`] with less work, for a finite origin and a direction with a length between 0.5 and 2.
    pub(crate) fn with_near_unit_direction(origin: Vec3, direction: Vec3, time: Real) -> Self {
        debug_assert!(
            origin.is_finite() && max_abs_component(direction) > 0.25 && max_abs_component(direction) <= 2.0
        );
        Self::with_scale(origin, direction, 1.0, time)
    }

    /// Always inlined, so that fields that no shape of the tracer uses are optimized away.
    #[inline(always)]
    fn with_scale(origin: Vec3, direction: Vec3, direction_scale: Real, time: Real) -> Self {
        let inverse = 1.0 / direction;
        let axis = Axis::dominant(direction);
        let (permuted, inverse_dominant) = (axis.permute_to_z(direction), axis.permute_to_z(inverse).z);
        let scaled_direction = direction * direction_scale;
        Ray {
            origin,
            direction,
            inverse_direction: inverse,
            time,
            dominant_axis: axis,
            inverse_dominant,
            shear_x: axis.permute_from_z(vec3(1.0, 0.0, -(permuted.x * inverse_dominant))),
            shear_y: axis.permute_from_z(vec3(0.0, 1.0, -(permuted.y * inverse_dominant))),
            scaled_direction,
            scaled_length_squared: scaled_direction.dot(scaled_direction),
            direction_scale,
        }
    }

    /// The same ray at another time, in `0..=1` between opening and closing of the shutter.
    #[inline(always)]
    pub fn with_time(self, time: Real) -> Self {
        Ray { time, ..self }
    }

    /// Whether the ray can hit anything: see [`Ray::new`].
    pub(crate) fn is_valid(&self) -> bool {
        self.scaled_length_squared > 0.0
    }

    /// The point at `t`, world space.
    pub fn at(&self, t: Real) -> Vec3 {
        self.origin + self.direction * t
    }

    /// The point at `t`, relative to `center`.
    ///
    /// `center` is subtracted from the origin first, so that the error is relative to the distance between
    /// both and not to their coordinates.
    pub(super) fn at_relative_to(&self, t: Real, center: Vec3) -> Vec3 {
        (self.origin - center) + self.direction * t
    }
}

/// Origin of a ray that leaves a surface: `point` moved along `normal` until it is outside of its error
/// box.
///
/// * `point`: on the surface to within `error`, world space.
/// * `error`: absolute bound for each component, in scene lengths.
/// * `normal`: unit normal of the surface, on the side on which the ray leaves.
///
/// The result is certainly on that side. The step follows from `error` alone; there is no constant that
/// depends on the scale of the scene.
///
/// Source: Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 6.8, `OffsetRayOrigin`.
/// Difference: the result is not rounded away from the surface. This rounding is at most one roundoff per
/// component, and `error` must include two for it, as
/// [`SurfaceInteraction::point_error`](super::SurfaceInteraction::point_error) does.
#[inline(always)]
pub fn offset_origin(point: Vec3, error: Vec3, normal: Vec3) -> Vec3 {
    point + normal * abs(normal).dot(error)
}

/// Number of roundings that the error of a surface includes for [`offset_origin`].
pub(super) const OFFSET_ROUNDINGS: u32 = 2;
