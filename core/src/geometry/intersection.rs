//! Intersection of a ray with a shape of any kind, and the surface at the hit.
//!
//! The inner loops call these functions, so inlining is explicit. A tracer of one or two kinds of shapes
//! inlines their tests at every call. A tracer of more kinds inlines only the test of spheres and calls
//! one function for all others: beside the other tests a call is cheap.

use super::clamp::{clamp_to_box, is_valid_t};
use super::tables::get;
use super::{Geometry, Ray, Shape, ShapeFeatures, ShapeKind, Sphere, SurfaceInteraction, triangle};
use crate::math::{Real, Vec3, vec3};

/// Lists all variants, so that a new one is a compile error here: add it to [`Geometry::intersect_unclamped`]
/// and [`Geometry::static_surface_interaction`]. Both end in `_`, because their arms have guards, and a list
/// of all variants would change their jump tables.
const _: fn(&Shape) = |shape| match shape {
    Shape::Sphere(_) | Shape::Triangle(_) | Shape::SmoothTriangle(_) | Shape::Plane(_) | Shape::Disc(_) => {}
    Shape::Polygon(_) | Shape::Cuboid(_) | Shape::OrientedCuboid(_) | Shape::Cone(_) | Shape::Torus(_) => {}
    Shape::Moving(_) => {}
};

/// The `t` at which the ray hits the triangle with the given vertices, as in [`Geometry::intersect`].
#[inline]
pub(crate) fn intersect_triangle(vertices: [&Vec3; 3], ray: &Ray) -> Option<Real> {
    let t = triangle::intersect(vertices, ray).map(|hit| hit.t).filter(is_valid_t)?;
    clamp_to_box(triangle::bounds(vertices), t, ray.origin, ray.inverse_direction)
}

impl Geometry<'_> {
    /// The `t` of the first hit of a shape, from either side, in lengths of the ray's direction: positive
    /// and finite.
    ///
    /// `t` is clamped to the interval in which the ray is inside the bounds of the shape; without such an
    /// interval there is no hit. Rounding may have moved `t` slightly out of it, and then an accelerator
    /// that culls by the bounds and one that does not would produce different pictures.
    #[inline(always)]
    pub fn intersect<S: ShapeFeatures>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        // The tests of one or two kinds are inlined at every call.
        if S::SHAPES.len() <= 2 && !S::MOTION_BLUR {
            return self.intersect_static::<S>(shape, ray);
        }
        // The test of a sphere is so cheap that a call would dominate.
        if S::SHAPES.contains(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return self.intersect_sphere::<S>(sphere, shape, ray);
        }
        self.intersect_outlined::<S>(shape, ray)
    }

    /// [`Geometry::intersect`], not inlined.
    #[inline(never)]
    fn intersect_outlined<S: ShapeFeatures>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        if S::MOTION_BLUR
            && let Shape::Moving(index) = shape
        {
            return self.intersect_moving::<S>(*index, ray);
        }
        self.intersect_static::<S>(shape, ray)
    }

    /// [`Geometry::intersect`] of a shape that does not move.
    #[inline(always)]
    pub(super) fn intersect_static<S: ShapeFeatures>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        // The guard of each arm is a constant; one test before the match would not be.
        // Spheres and polygons are not arms of the match because it would then become a jump table.
        let supports = |kind| S::SHAPES.contains(kind);
        if supports(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return self.intersect_sphere::<S>(sphere, shape, ray);
        }
        if supports(ShapeKind::Polygon)
            && let Shape::Polygon(index) = shape
        {
            return get(self.polygons, *index)?.intersect(self.vertices, ray);
        }
        let t = self.intersect_unclamped::<S>(shape, ray).filter(is_valid_t)?;
        match shape {
            Shape::Plane(_) => Some(t),
            _ => self.clamp_to_bounds::<S>(shape, t, ray),
        }
    }

    #[inline(always)]
    fn intersect_sphere<S: ShapeFeatures>(&self, sphere: &Sphere, shape: &Shape, ray: &Ray) -> Option<Real> {
        let t = sphere.intersect(ray).filter(is_valid_t)?;
        if sphere.is_certainly_in_bounds(ray, t) { Some(t) } else { self.clamp_to_bounds::<S>(shape, t, ray) }
    }

    /// `t` clamped to the bounds of the shape, as [`clamp_to_box`].
    fn clamp_to_bounds<S: ShapeFeatures>(&self, shape: &Shape, t: Real, ray: &Ray) -> Option<Real> {
        /// Not inlined because most rays miss most items, and the code for a miss should be short.
        #[inline(never)]
        #[allow(clippy::too_many_arguments)] // in registers: for a reference all of the ray must be in memory
        fn clamp_outlined<S: ShapeFeatures>(
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
            // The reciprocal is computed only here, so rays that hit no bounds do not need it.
            let inverse_direction = 1.0 / vec3(dx, dy, dz);
            clamp_to_box(geometry.static_bounds::<S>(*shape)?, t, vec3(ox, oy, oz), inverse_direction)
        }
        let (o, d) = (ray.origin, ray.direction);
        clamp_outlined::<S>(self, shape, t, o.x, o.y, o.z, d.x, d.y, d.z)
    }

    /// The `t` before it is clamped, for shapes other than spheres and polygons.
    #[inline(always)]
    fn intersect_unclamped<S: ShapeFeatures>(&self, shape: &Shape, ray: &Ray) -> Option<Real> {
        let supports = |kind| S::SHAPES.contains(kind);
        match *shape {
            Shape::Triangle(indices) if supports(ShapeKind::Triangle) => {
                self.intersect_triangle(indices, ray)
            }
            Shape::SmoothTriangle(indices) if supports(ShapeKind::SmoothTriangle) => {
                self.intersect_triangle(indices, ray)
            }
            Shape::Plane(index) if supports(ShapeKind::Plane) => get(self.planes, index)?.intersect(ray),
            Shape::Disc(index) if supports(ShapeKind::Disc) => get(self.discs, index)?.intersect(ray),
            Shape::Cuboid(index) if supports(ShapeKind::Cuboid) => get(self.cuboids, index)?.intersect(ray),
            Shape::OrientedCuboid(index) if supports(ShapeKind::OrientedCuboid) => {
                get(self.oriented_cuboids, index)?.intersect(ray)
            }
            Shape::Cone(index) if supports(ShapeKind::Cone) => get(self.cones, index)?.intersect(ray),
            Shape::Torus(index) if supports(ShapeKind::Torus) => get(self.tori, index)?.intersect(ray),
            _ => None,
        }
    }

    #[inline(always)]
    fn intersect_triangle(&self, indices: [u32; 3], ray: &Ray) -> Option<Real> {
        triangle::intersect(self.vertices(indices)?, ray).map(|hit| hit.t)
    }

    /// The surface of a shape at a hit, whose `t` is the result of [`Geometry::intersect`]; `None` if `S`
    /// does not support the shape or an index of it is out of range.
    #[inline(always)]
    pub fn surface_interaction<S: ShapeFeatures>(
        &self,
        shape: &Shape,
        ray: &Ray,
        t: Real,
    ) -> Option<SurfaceInteraction> {
        // Again a call would dominate. For one or two kinds the match below is inlined anyway.
        if S::SHAPES.len() > 2
            && S::SHAPES.contains(ShapeKind::Sphere)
            && let Shape::Sphere(sphere) = shape
        {
            return Some(sphere.surface_interaction(ray, t));
        }
        if S::MOTION_BLUR
            && let Shape::Moving(index) = shape
        {
            return self.moving_surface_interaction::<S>(*index, ray, t);
        }
        self.static_surface_interaction::<S>(shape, ray, t)
    }

    /// [`Geometry::surface_interaction`] of a shape that does not move, not inlined: for rare calls.
    #[inline(never)]
    pub(super) fn static_surface_interaction_outlined<S: ShapeFeatures>(
        &self,
        shape: &Shape,
        ray: &Ray,
        t: Real,
    ) -> Option<SurfaceInteraction> {
        self.static_surface_interaction::<S>(shape, ray, t)
    }

    #[inline(always)]
    fn static_surface_interaction<S: ShapeFeatures>(
        &self,
        shape: &Shape,
        ray: &Ray,
        t: Real,
    ) -> Option<SurfaceInteraction> {
        let supports = |kind| S::SHAPES.contains(kind);
        match *shape {
            Shape::Sphere(sphere) if supports(ShapeKind::Sphere) => Some(sphere.surface_interaction(ray, t)),
            Shape::Triangle(indices) if supports(ShapeKind::Triangle) => {
                triangle::surface_interaction(self.vertices(indices)?, None, ray)
            }
            Shape::SmoothTriangle(indices) if supports(ShapeKind::SmoothTriangle) => {
                let normals = if S::SMOOTH_SHADING { self.vertex_normals(indices) } else { None };
                triangle::surface_interaction(self.vertices(indices)?, normals, ray)
            }
            Shape::Plane(index) if supports(ShapeKind::Plane) => {
                Some(get(self.planes, index)?.surface_interaction(ray, t))
            }
            Shape::Disc(index) if supports(ShapeKind::Disc) => {
                Some(get(self.discs, index)?.surface_interaction(ray, t))
            }
            Shape::Polygon(index) if supports(ShapeKind::Polygon) => {
                let normals = if S::SMOOTH_SHADING { Some(self.vertex_normals) } else { None };
                Some(get(self.polygons, index)?.surface_interaction(self.vertices, normals, ray, t))
            }
            Shape::Cuboid(index) if supports(ShapeKind::Cuboid) => {
                get(self.cuboids, index)?.surface_interaction(ray, t)
            }
            Shape::OrientedCuboid(index) if supports(ShapeKind::OrientedCuboid) => {
                get(self.oriented_cuboids, index)?.surface_interaction(ray, t)
            }
            Shape::Cone(index) if supports(ShapeKind::Cone) => {
                get(self.cones, index)?.surface_interaction(ray, t)
            }
            Shape::Torus(index) if supports(ShapeKind::Torus) => {
                Some(get(self.tori, index)?.surface_interaction(ray, t))
            }
            _ => None,
        }
    }
}
