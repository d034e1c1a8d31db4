//! Where a ray meets a shape, and what that is like there: which shape is asked, and how.
//!
//! The inner loops go through here, so it is said what is inlined where. A tracer of few kinds has
//! the tests of all of them at each of the places that ask. One of many has those of spheres, and goes
//! elsewhere for the rest: a call is little beside the other tests.

use super::{Aabb, Geometry, Ray, Shape, ShapeKind, Shapes, Sphere, Surface, of, triangle};
use crate::math::{Real, Vec3, vec3};

/// Whether it may be how far something is: more than zero, and finite.
pub(super) fn is_distance(t: &Real) -> bool {
    *t > 0.0 && *t <= Real::MAX
}

/// How far along the ray a triangle is met, as [`Geometry::distance`] says.
#[inline]
pub(crate) fn triangle_distance(corners: [&Vec3; 3], ray: &Ray) -> Option<Real> {
    let t = triangle::hit(corners, ray).map(|contact| contact.t).filter(is_distance)?;
    moved_into(triangle::bounds(corners), t, ray.origin, ray.inverse)
}

/// The distance nearest to `t` at which the ray is inside a box.
#[inline(always)]
pub(super) fn moved_into(aabb: Aabb, t: Real, origin: Vec3, inverse: Vec3) -> Option<Real> {
    let span = aabb.span_along(origin, inverse)?;
    let t = if t < span.entry { span.entry } else { t };
    let t = if t > span.exit { span.exit } else { t };
    Some(t).filter(is_distance)
}

impl Geometry<'_> {
    /// How far along the ray a shape is first met, from either side: more than zero and
    /// finite.
    ///
    /// The distance is moved into the interval in which the ray is inside the shape's own box,
    /// and where there is no such interval there is no hit. Rounding may have put it a little
    /// outside, and an accelerator that leaves out the box would then give another picture
    /// than one that does not.
    #[inline(always)]
    pub fn distance<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        // Few kinds are worth a copy at each of the places that ask.
        if S::SHAPES.len() <= 2 && !S::MOTION {
            return self.rest_distance::<S>(shape, ray);
        }
        // Spheres are so cheap that the way there would cost more.
        if S::SHAPES.has(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return self.sphere_distance::<S>(sphere, shape, ray);
        }
        self.distance_there::<S>(shape, ray)
    }

    #[inline(never)]
    fn distance_there<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        if S::MOTION
            && let Shape::Moving(place) = shape
        {
            return self.moving_distance::<S>(*place, ray);
        }
        self.rest_distance::<S>(shape, ray)
    }

    /// As [`Geometry::distance`], of what does not move.
    #[inline(always)]
    pub(super) fn rest_distance<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        // Guards for each arm, and not one test before all of them, are known when compiling.
        // The first two are not arms of the match, where they would become a table of the kinds.
        let can = |kind| S::SHAPES.has(kind);
        if can(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return self.sphere_distance::<S>(sphere, shape, ray);
        }
        if can(ShapeKind::Polygon)
            && let Shape::Polygon(place) = shape
        {
            return of(self.polygons, *place)?.hit(self.points, ray);
        }
        let t = self.raw_distance::<S>(shape, ray).filter(is_distance)?;
        match shape {
            Shape::Plane(_) => Some(t),
            _ => self.within_bounds::<S>(shape, t, ray),
        }
    }

    #[inline(always)]
    fn sphere_distance<S: Shapes>(&self, sphere: &Sphere, shape: &Shape, ray: &Ray) -> Option<Real> {
        let t = sphere.hit(ray).filter(is_distance)?;
        if sphere.is_surely_in_its_box(ray, t) { Some(t) } else { self.within_bounds::<S>(shape, t, ray) }
    }

    /// The distance moved into the shape's own box.
    fn within_bounds<S: Shapes>(&self, shape: &Shape, t: Real, ray: &Ray) -> Option<Real> {
        /// Not inlined, because most rays miss most items, and a miss should be short.
        #[inline(never)]
        #[allow(clippy::too_many_arguments)] // in registers: what lies in memory, all of it must be made for
        fn apart<S: Shapes>(
            geometry: &Geometry<'_>,
            shape: &Shape,
            t: Real,
            ox: Real,
            oy: Real,
            oz: Real,
            dx: Real,
            dy: Real,
            dz: Real,
        ) -> Option<Real> {
            // Rays that meet no box then need no reciprocal.
            let inverse = 1.0 / vec3(dx, dy, dz);
            moved_into(geometry.rest_bounds::<S>(*shape)?, t, vec3(ox, oy, oz), inverse)
        }
        let (o, d) = (ray.origin, ray.direction);
        apart::<S>(self, shape, t, o.x, o.y, o.z, d.x, d.y, d.z)
    }

    /// Of the shapes that [`Geometry::distance`] has not answered for itself, before the distance
    /// is moved.
    #[inline(always)]
    fn raw_distance<S: Shapes>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        let can = |kind| S::SHAPES.has(kind);
        match *shape {
            Shape::Triangle(corners) if can(ShapeKind::Triangle) => self.triangle_distance(corners, ray),
            Shape::SmoothTriangle(corners) if can(ShapeKind::SmoothTriangle) => {
                self.triangle_distance(corners, ray)
            }
            Shape::Plane(place) if can(ShapeKind::Plane) => of(self.planes, place)?.hit(ray),
            Shape::Disc(place) if can(ShapeKind::Disc) => of(self.discs, place)?.hit(ray),
            Shape::Cuboid(place) if can(ShapeKind::Cuboid) => of(self.cuboids, place)?.hit(ray),
            Shape::TurnedCuboid(place) if can(ShapeKind::TurnedCuboid) => {
                of(self.turned_cuboids, place)?.hit(ray)
            }
            Shape::Cone(place) if can(ShapeKind::Cone) => of(self.cones, place)?.hit(ray),
            Shape::Torus(place) if can(ShapeKind::Torus) => of(self.tori, place)?.hit(ray),
            _ => None,
        }
    }

    #[inline(always)]
    fn triangle_distance(&self, corners: [u32; 3], ray: &Ray) -> Option<Real> {
        triangle::hit(self.corners(corners)?, ray).map(|contact| contact.t)
    }

    /// What a shape is like where the ray meets it, `t` away as [`Geometry::distance`] said.
    #[inline(always)]
    pub fn surface<S: Shapes>(&self, shape: &Shape, ray: &Ray, t: Real) -> Option<Surface> {
        // As cheap as the way there, again; of few kinds it is one of few arms anyway.
        if S::SHAPES.len() > 2
            && S::SHAPES.has(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return Some(sphere.surface(ray, t));
        }
        if S::MOTION
            && let Shape::Moving(place) = shape
        {
            return self.moving_surface::<S>(*place, ray, t);
        }
        self.rest_surface::<S>(shape, ray, t)
    }

    /// As [`Geometry::surface`], for whoever asks seldom: not inlined.
    #[inline(never)]
    pub(super) fn surface_there<S: Shapes>(&self, shape: &Shape, ray: &Ray, t: Real) -> Option<Surface> {
        self.rest_surface::<S>(shape, ray, t)
    }

    #[inline(always)]
    fn rest_surface<S: Shapes>(&self, shape: &Shape, ray: &Ray, t: Real) -> Option<Surface> {
        let can = |kind| S::SHAPES.has(kind);
        match *shape {
            Shape::Sphere(sphere) if can(ShapeKind::Sphere) => Some(sphere.surface(ray, t)),
            Shape::Triangle(corners) if can(ShapeKind::Triangle) => {
                triangle::surface(self.corners(corners)?, None, ray)
            }
            Shape::SmoothTriangle(corners) if can(ShapeKind::SmoothTriangle) => {
                let normals = if S::SMOOTH { self.corner_normals(corners) } else { None };
                triangle::surface(self.corners(corners)?, normals, ray)
            }
            Shape::Plane(place) if can(ShapeKind::Plane) => Some(of(self.planes, place)?.surface(ray, t)),
            Shape::Disc(place) if can(ShapeKind::Disc) => Some(of(self.discs, place)?.surface(ray, t)),
            Shape::Polygon(place) if can(ShapeKind::Polygon) => {
                let normals = if S::SMOOTH { Some(self.normals) } else { None };
                Some(of(self.polygons, place)?.surface(self.points, normals, ray, t))
            }
            Shape::Cuboid(place) if can(ShapeKind::Cuboid) => of(self.cuboids, place)?.surface(ray, t),
            Shape::TurnedCuboid(place) if can(ShapeKind::TurnedCuboid) => {
                of(self.turned_cuboids, place)?.surface(ray, t)
            }
            Shape::Cone(place) if can(ShapeKind::Cone) => of(self.cones, place)?.surface(ray, t),
            Shape::Torus(place) if can(ShapeKind::Torus) => Some(of(self.tori, place)?.surface(ray, t)),
            _ => None,
        }
    }
}
