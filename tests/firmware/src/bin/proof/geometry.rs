//! Shapes, their tables, boxes and rays.

use strahl_core::*;

use crate::any::{any, any_item, any_ray, number, slice, used, vector};
use crate::text::displayed;

pub fn doors() {
    one_by_one();
    in_tables();
    displayed(any(ShapeFault::Radius));
}

fn one_by_one() {
    used(Cone::new(vector(), number(), vector(), number(), any(true)));
    used(TurnedCuboid::new(vector(), vector(), vector(), vector()));
    used(Polygon::new(any(0), slice(&[Vec3::X]), any(true)));
    used((Shape::kind(any(SHAPES[0])), ShapeKind::name(any(ShapeKind::Sphere))));

    let around = Aabb::around(slice(&[Vec3::X]).iter().copied());
    let aabb = Aabb::union(around, Aabb::round(vector(), vector()));
    let span: Option<Span> = Aabb::span(&aabb, &any_ray());
    used((span, Aabb::is_empty(&aabb), any(Aabb::EMPTY), Aabb::of_points(slice(&[Vec3::X]))));

    used((Ray::at(&any_ray(), number()), leave(vector(), vector(), vector())));
    used(has_area([vector(), vector(), vector()]));
}

/// One of each.
static SHAPES: [Shape; 10] = [
    Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 }),
    Shape::Triangle([0, 1, 2]),
    Shape::SmoothTriangle([0, 1, 2]),
    Shape::Plane(0),
    Shape::Disc(0),
    Shape::Polygon(0),
    Shape::Cuboid(0),
    Shape::TurnedCuboid(0),
    Shape::Cone(0),
    Shape::Torus(0),
];

/// Shapes and tables of any length with anything in them, whether they fit together or not.
pub fn any_geometry() -> Geometry<'static> {
    const CONE: Cone = Cone {
        base: Vec3::ZERO,
        axis: Vec3::Y,
        height: 1.0,
        base_radius: 1.0,
        end_radius: 0.0,
        capped: true,
    };
    Geometry {
        shapes: slice(&SHAPES),
        points: slice(&[Vec3::ZERO]),
        normals: slice(&[Vec3::Y]),
        planes: slice(&[Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(3) }]),
        discs: slice(&[Disc { center: Vec3::ZERO, normal: Vec3::Y, radius: 1.0 }]),
        polygons: slice(&[Polygon {
            first: 0,
            count: 3,
            point: Vec3::ZERO,
            normal: Vec3::Y,
            bounds: Aabb::EMPTY,
            smooth: true,
        }]),
        cuboids: slice(&[Cuboid { min: Vec3::ZERO, max: Vec3::ONE }]),
        turned_cuboids: slice(&[TurnedCuboid {
            center: Vec3::ZERO,
            half: Vec3::ONE,
            axes: [Vec3::X, Vec3::Y, Vec3::Z],
        }]),
        cones: slice(&[CONE]),
        tori: slice(&[Torus { center: Vec3::ZERO, axis: Vec3::Y, major: 1.0, minor: 0.5 }]),
        moving: slice(&[Moving { shape: Shape::Triangle([0, 1, 2]), opening: Vec3::ZERO, closing: Vec3::X }]),
    }
}

fn in_tables() {
    /// Somebody who has shapes, but is no tracer.
    struct Bare;
    impl Shapes for Bare {
        const SHAPES: ShapeSet = ShapeSet::ALL;
        const SMOOTH: bool = false;
        const MOTION: bool = true;
    }
    fn met<S: Shapes>(geometry: &Geometry<'_>) {
        used((
            Geometry::kind(geometry, &any(SHAPES[0])),
            Geometry::offset(geometry, &any(SHAPES[0]), number()),
        ));
        used(Geometry::distance::<S>(geometry, any(&SHAPES[0]), &any_ray()));
        let surface: Option<Surface> =
            Geometry::surface::<S>(geometry, any(&SHAPES[0]), &any_ray(), number());
        used(surface);
    }
    let geometry = any_geometry();
    used((Geometry::check(&geometry), Geometry::shape(&geometry, any_item())));
    used((Geometry::bounds(&geometry, any_item()), Geometry::bytes(&geometry)));
    Geometry::all_bounds(&geometry).for_each(used);
    geometry.moving.first().map(|moving| Moving::offset(moving, number())).into_iter().for_each(used);
    met::<Bare>(&geometry);
    met::<Everything>(&geometry);
}
