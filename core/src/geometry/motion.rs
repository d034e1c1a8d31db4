//! Bounds, hits and surfaces of moving shapes.

use super::clamp::clamp_to_box;
use super::ray::OFFSET_ROUNDINGS;
use super::{Aabb, Geometry, Ray, Shape, ShapeFeatures, ShapeKind, SurfaceInteraction};
use crate::math::{Real, Vec3, abs, gamma};

impl Geometry<'_> {
    /// The kind of a shape, or of the shape inside a moving shape. `None` if the index of a moving shape is
    /// out of range.
    #[inline(always)]
    pub fn kind(&self, shape: &Shape) -> Option<ShapeKind> {
        match shape {
            Shape::Moving(index) => self.moving_shape(*index)?.shape.kind(),
            _ => shape.kind(),
        }
    }

    /// Offset of a shape from its position at rest at `time`, as in
    /// [`MovingShape::offset_at`](super::MovingShape::offset_at); zero for a shape that does not move.
    pub fn motion_offset(&self, shape: &Shape, time: Real) -> Vec3 {
        match shape {
            Shape::Moving(index) => {
                self.moving_shape(*index).map_or(Vec3::ZERO, |moving| moving.offset_at(time))
            }
            _ => Vec3::ZERO,
        }
    }

    /// Bounds of the whole motion.
    pub(super) fn moving_bounds<S: ShapeFeatures>(&self, index: u32) -> Option<Aabb> {
        let moving = self.moving_shape(index)?;
        Some(moving.swept_bounds(self.static_bounds::<S>(moving.shape)?))
    }

    /// [`Geometry::intersect`] of a moving shape. `t` is clamped to the bounds of the whole motion, which
    /// accelerators use.
    #[inline(never)]
    pub(super) fn intersect_moving<S: ShapeFeatures>(&self, index: u32, ray: &Ray) -> Option<Real> {
        let moving = self.moving_shape(index)?;
        let t = self.intersect_static::<S>(&moving.shape, &moving.ray_at_rest(ray))?;
        match moving.shape {
            Shape::Plane(_) => Some(t),
            _ => clamp_to_box(self.moving_bounds::<S>(index)?, t, ray.origin, ray.inverse_direction),
        }
    }

    /// [`Geometry::surface_interaction`] of a moving shape.
    #[inline(never)]
    pub(super) fn moving_surface_interaction<S: ShapeFeatures>(
        &self,
        index: u32,
        ray: &Ray,
        t: Real,
    ) -> Option<SurfaceInteraction> {
        let moving = self.moving_shape(index)?;
        let rest =
            self.static_surface_interaction_outlined::<S>(&moving.shape, &moving.ray_at_rest(ray), t)?;
        let point = rest.point + moving.offset_at(ray.time);
        // The sum takes one rounding, and the subtraction for the next ray another.
        let point_error = rest.point_error + (abs(rest.point) + abs(point)) * gamma(3 + OFFSET_ROUNDINGS);
        Some(SurfaceInteraction { point, point_error, ..rest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{ItemId, MovingShape, ShapeError, ShapeKindSet};
    use crate::geometry::{Plane, Sphere};
    use crate::math::vec3;

    struct All;

    impl ShapeFeatures for All {
        const SHAPES: ShapeKindSet = ShapeKindSet::ALL;
        const SMOOTH_SHADING: bool = true;
        const MOTION_BLUR: bool = true;
    }

    const MOVING_SPHERE: MovingShape = MovingShape {
        shape: Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 }),
        offset_at_open: vec3(-2.0, 0.0, 0.0),
        offset_at_close: vec3(6.0, 0.0, 0.0),
    };

    fn ray(x: Real, time: Real) -> Ray {
        Ray::new(vec3(x, 0.0, 0.0), -Vec3::Z).with_time(time)
    }

    #[test]
    fn a_moving_shape_is_hit_at_its_position_at_the_time_of_the_ray() {
        let geometry =
            Geometry { shapes: &[Shape::Moving(0)], moving_shapes: &[MOVING_SPHERE], ..Geometry::EMPTY };
        geometry.validate().unwrap();
        let hit = |x, time| geometry.intersect::<All>(&Shape::Moving(0), &ray(x, time));
        assert_eq!((hit(-2.0, 0.0), hit(2.0, 0.5), hit(6.0, 1.0)), (Some(4.0), Some(4.0), Some(4.0)));
        assert_eq!((hit(-2.0, 0.5), hit(2.0, 0.0), hit(6.0, 0.5)), (None, None, None));
        // Times outside of 0..=1 are clamped; NaN counts as 0.
        assert_eq!((hit(6.0, 3.0), hit(-2.0, -1.0)), (Some(4.0), Some(4.0)));
        assert_eq!(hit(-2.0, Real::NAN), Some(4.0));
        let surface = geometry.surface_interaction::<All>(&Shape::Moving(0), &ray(2.0, 0.5), 4.0).unwrap();
        assert_eq!((surface.point, surface.normal), (vec3(2.0, 0.0, -4.0), Vec3::Z));
        assert_eq!(geometry.kind(&Shape::Moving(0)), Some(ShapeKind::Sphere));
        assert_eq!(geometry.motion_offset(&Shape::Moving(0), 0.25), vec3(0.0, 0.0, 0.0));
    }

    #[test]
    fn the_bounds_contain_the_shape_at_all_times() {
        let geometry =
            Geometry { shapes: &[Shape::Moving(0)], moving_shapes: &[MOVING_SPHERE], ..Geometry::EMPTY };
        let aabb = geometry.bounds(ItemId(0)).unwrap();
        for step in 0..=100 {
            let center = vec3(0.0, 0.0, -5.0) + MOVING_SPHERE.offset_at(step as Real / 100.0);
            let bounds = Sphere { center, radius: 1.0 }.bounds();
            assert_eq!(aabb.union(bounds), aabb, "{step}");
        }
        assert!(aabb.max.x < 7.001 && aabb.min.x > -3.001);
    }

    #[test]
    fn a_tracer_without_motion_blur_never_hits_a_moving_shape() {
        struct Static;
        impl ShapeFeatures for Static {
            const SHAPES: ShapeKindSet = ShapeKindSet::ALL;
            const SMOOTH_SHADING: bool = true;
        }
        let geometry =
            Geometry { shapes: &[Shape::Moving(0)], moving_shapes: &[MOVING_SPHERE], ..Geometry::EMPTY };
        assert_eq!(geometry.intersect::<Static>(&Shape::Moving(0), &ray(-2.0, 0.0)), None);
    }

    #[test]
    fn invalid_moving_shapes_are_errors() {
        let check = |shapes: &[Shape], moving_shapes: &[MovingShape]| {
            Geometry { shapes, moving_shapes, ..Geometry::EMPTY }.validate().map_err(|(_, error)| error)
        };
        let nested = MovingShape { shape: Shape::Moving(0), ..MOVING_SPHERE };
        assert_eq!(check(&[Shape::Moving(0)], &[nested]), Err(ShapeError::NestedMotion));
        assert_eq!(check(&[Shape::Moving(1)], &[MOVING_SPHERE]), Err(ShapeError::IndexOutOfRange));
        let far = MovingShape { offset_at_close: vec3(0.0, 2e15, 0.0), ..MOVING_SPHERE };
        assert_eq!(check(&[Shape::Moving(0)], &[far]), Err(ShapeError::Coordinate));
        let empty =
            MovingShape { shape: Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 0.0 }), ..MOVING_SPHERE };
        assert_eq!(check(&[Shape::Moving(0)], &[empty]), Err(ShapeError::Radius));
    }

    #[test]
    fn a_plane_may_move() {
        let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) }];
        let moving =
            [MovingShape { shape: Shape::Plane(0), offset_at_open: Vec3::ZERO, offset_at_close: -Vec3::Y }];
        let geometry = Geometry {
            shapes: &[Shape::Moving(0)],
            planes: &planes,
            moving_shapes: &moving,
            ..Geometry::EMPTY
        };
        geometry.validate().unwrap();
        assert_eq!(geometry.bounds(ItemId(0)), None);
        let ray = Ray::new(Vec3::Y, -Vec3::Y).with_time(0.5);
        assert_eq!(geometry.intersect::<All>(&Shape::Moving(0), &ray), Some(1.5));
    }
}
