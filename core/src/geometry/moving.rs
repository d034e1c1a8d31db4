//! Items that move while the shutter is open.
//!
//! A shape that has moved is met by a ray exactly as the shape at rest is met by the ray moved
//! back. So shapes know nothing of time: an item that moves names its shape and where that is
//! when the shutter opens and closes, and only the ray's origin changes before it is asked
//! ("Distributed Ray Tracing", Cook, Porter, Carpenter, SIGGRAPH 1984, has the idea of a moment
//! for each ray). Accelerators hold the box over all the time.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::meet::clamp_to_box;
use super::ray::LEAVING;
use super::shape::check_point;
use super::{Aabb, Geometry, Ray, Shape, ShapeFault, ShapeKind, Shapes, Surface, of};
use crate::math::{Real, Vec3, abs, gamma, within};

/// A shape that moves evenly along a straight line while the shutter is open.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Moving {
    /// The shape, where its own numbers put it; none that moves itself.
    pub shape: Shape,
    /// How far away from there it is when the shutter opens.
    pub opening: Vec3,
    /// How far away from there it is when the shutter closes.
    pub closing: Vec3,
}

impl Moving {
    /// How far away from its own place it is at `time`, which is 0 when the shutter opens and 1
    /// when it closes; before and after it stands still.
    pub fn offset(&self, time: Real) -> Vec3 {
        self.opening + (self.closing - self.opening) * within(time, 0.0, 1.0)
    }

    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        if let Shape::Moving(_) = self.shape {
            return Err(ShapeFault::Moving);
        }
        check_point(self.opening)?;
        check_point(self.closing)
    }

    /// The ray as the shape at rest meets it.
    fn back(&self, ray: &Ray) -> Ray {
        Ray { origin: ray.origin - self.offset(ray.time), ..*ray }
    }

    /// The box over all the time of a shape whose box at rest this is, rounded outward.
    fn swept(&self, rest: Aabb) -> Aabb {
        let at = |offset: Vec3| {
            // The sum takes one rounding, the offset between both ends three, what is left of
            // them makes up for the margin's own.
            let margin = (abs(rest.min) + abs(rest.max)) * gamma(2)
                + (abs(self.opening) + abs(self.closing)) * gamma(6);
            Aabb { min: rest.min + offset - margin, max: rest.max + offset + margin }
        };
        at(self.opening).union(at(self.closing))
    }
}

impl<'s> Geometry<'s> {
    /// What moves at a place of the table.
    pub(super) fn moving(&self, place: u32) -> Option<&'s Moving> {
        of(self.moving, place)
    }

    /// What kind a shape is, or the shape that moves; none where that is not there.
    #[inline(always)]
    pub fn kind(&self, shape: &Shape) -> Option<ShapeKind> {
        match shape {
            Shape::Moving(place) => self.moving(*place)?.shape.kind(),
            _ => shape.kind(),
        }
    }

    /// How far away from its own place an item is at `time`, as [`Moving::offset`] says: zero for
    /// what does not move.
    pub fn offset(&self, shape: &Shape, time: Real) -> Vec3 {
        match shape {
            Shape::Moving(place) => self.moving(*place).map_or(Vec3::ZERO, |moving| moving.offset(time)),
            _ => Vec3::ZERO,
        }
    }

    /// The box over all the time.
    pub(super) fn moving_bounds<S: Shapes>(&self, place: u32) -> Option<Aabb> {
        let moving = self.moving(place)?;
        Some(moving.swept(self.rest_bounds::<S>(moving.shape)?))
    }

    /// As [`Geometry::distance`]: moved into the box over all the time, which is what accelerators
    /// see.
    #[inline(never)]
    pub(super) fn moving_distance<S: Shapes>(&self, place: u32, ray: &Ray) -> Option<Real> {
        let moving = self.moving(place)?;
        let t = self.intersect_static::<S>(&moving.shape, &moving.back(ray))?;
        match moving.shape {
            Shape::Plane(_) => Some(t),
            _ => clamp_to_box(self.moving_bounds::<S>(place)?, t, ray.origin, ray.inverse),
        }
    }

    /// As [`Geometry::surface`].
    #[inline(never)]
    pub(super) fn moving_surface<S: Shapes>(&self, place: u32, ray: &Ray, t: Real) -> Option<Surface> {
        let moving = self.moving(place)?;
        let rest = self.static_surface_outlined::<S>(&moving.shape, &moving.back(ray), t)?;
        let point = rest.point + moving.offset(ray.time);
        // This sum is off by one rounding, and by another the difference when the next ray asks.
        let error = rest.error + (abs(rest.point) + abs(point)) * gamma(3 + LEAVING);
        Some(Surface { point, error, ..rest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{ItemId, ShapeSet};
    use crate::geometry::{Plane, Sphere};
    use crate::math::vec3;

    struct All;

    impl Shapes for All {
        const SHAPES: ShapeSet = ShapeSet::ALL;
        const SMOOTH: bool = true;
        const MOTION: bool = true;
    }

    const BALL: Moving = Moving {
        shape: Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 }),
        opening: vec3(-2.0, 0.0, 0.0),
        closing: vec3(6.0, 0.0, 0.0),
    };

    fn ray(x: Real, time: Real) -> Ray {
        Ray::new(vec3(x, 0.0, 0.0), -Vec3::Z).at_time(time)
    }

    #[test]
    fn a_moving_shape_is_met_where_it_is_at_the_time_of_the_ray() {
        let geometry = Geometry { shapes: &[Shape::Moving(0)], moving: &[BALL], ..Geometry::EMPTY };
        geometry.check().unwrap();
        let met = |x, time| geometry.distance::<All>(&Shape::Moving(0), &ray(x, time));
        assert_eq!((met(-2.0, 0.0), met(2.0, 0.5), met(6.0, 1.0)), (Some(4.0), Some(4.0), Some(4.0)));
        assert_eq!((met(-2.0, 0.5), met(2.0, 0.0), met(6.0, 0.5)), (None, None, None));
        // Beyond its time it stands still, and so it does where there is no time.
        assert_eq!((met(6.0, 3.0), met(-2.0, -1.0)), (Some(4.0), Some(4.0)));
        assert_eq!(met(-2.0, Real::NAN), Some(4.0));
        let surface = geometry.surface::<All>(&Shape::Moving(0), &ray(2.0, 0.5), 4.0).unwrap();
        assert_eq!((surface.point, surface.normal), (vec3(2.0, 0.0, -4.0), Vec3::Z));
        assert_eq!(geometry.kind(&Shape::Moving(0)), Some(ShapeKind::Sphere));
        assert_eq!(geometry.offset(&Shape::Moving(0), 0.25), vec3(0.0, 0.0, 0.0));
    }

    #[test]
    fn the_box_holds_it_at_all_times() {
        let geometry = Geometry { shapes: &[Shape::Moving(0)], moving: &[BALL], ..Geometry::EMPTY };
        let aabb = geometry.bounds(ItemId(0)).unwrap();
        for step in 0..=100 {
            let center = vec3(0.0, 0.0, -5.0) + BALL.offset(step as Real / 100.0);
            let ball = Sphere { center, radius: 1.0 }.bounds();
            assert_eq!(aabb.union(ball), aabb, "{step}");
        }
        assert!(aabb.max.x < 7.001 && aabb.min.x > -3.001);
    }

    #[test]
    fn a_tracer_without_motion_does_not_see_it() {
        struct Still;
        impl Shapes for Still {
            const SHAPES: ShapeSet = ShapeSet::ALL;
            const SMOOTH: bool = true;
        }
        let geometry = Geometry { shapes: &[Shape::Moving(0)], moving: &[BALL], ..Geometry::EMPTY };
        assert_eq!(geometry.distance::<Still>(&Shape::Moving(0), &ray(-2.0, 0.0)), None);
    }

    #[test]
    fn what_moves_twice_or_is_not_there_is_refused() {
        let check = |shapes: &[Shape], moving: &[Moving]| {
            Geometry { shapes, moving, ..Geometry::EMPTY }.check().map_err(|(_, fault)| fault)
        };
        let twice = Moving { shape: Shape::Moving(0), ..BALL };
        assert_eq!(check(&[Shape::Moving(0)], &[twice]), Err(ShapeFault::Moving));
        assert_eq!(check(&[Shape::Moving(1)], &[BALL]), Err(ShapeFault::Missing));
        let far = Moving { closing: vec3(0.0, 2e15, 0.0), ..BALL };
        assert_eq!(check(&[Shape::Moving(0)], &[far]), Err(ShapeFault::Place));
        let flat = Moving { shape: Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 0.0 }), ..BALL };
        assert_eq!(check(&[Shape::Moving(0)], &[flat]), Err(ShapeFault::Radius));
    }

    #[test]
    fn a_plane_may_move() {
        let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) }];
        let moving = [Moving { shape: Shape::Plane(0), opening: Vec3::ZERO, closing: -Vec3::Y }];
        let geometry =
            Geometry { shapes: &[Shape::Moving(0)], planes: &planes, moving: &moving, ..Geometry::EMPTY };
        geometry.check().unwrap();
        assert_eq!(geometry.bounds(ItemId(0)), None);
        let ray = Ray::new(Vec3::Y, -Vec3::Y).at_time(0.5);
        assert_eq!(geometry.distance::<All>(&Shape::Moving(0), &ray), Some(1.5));
    }
}
