//! Shapes, their tables, bounds and rays.

use strahl_core::geometry::{
    Aabb, Cone, Cuboid, Disc, ItemId, MovingShape, OrientedCuboid, Polygon, Ray, RayInterval, ShapeError,
    ShapeFeatures, ShapeKind, ShapeKindSet, SurfaceInteraction, Torus, has_area, offset_origin,
};
use strahl_core::{AllEffects, Geometry, Plane, Shape, Sphere, Vec3};

use crate::any::{any, any_item, any_ray, number, slice, used, vector};
use crate::text::displayed;

pub fn entry_points() {
    one_by_one();
    in_tables();
    displayed(any(ShapeError::Radius));
}

fn one_by_one() {
    used(Cone::new(vector(), number(), vector(), number(), any(true)));
    used(OrientedCuboid::new(vector(), vector(), vector(), vector()));
    used(Polygon::new(any(0), slice(&[Vec3::X]), any(true)));
    used((Shape::kind(any(SHAPES[0])), ShapeKind::name(any(ShapeKind::Sphere))));

    let around = Aabb::enclosing(slice(&[Vec3::X]).iter().copied());
    let aabb = Aabb::union(around, Aabb::from_center(vector(), vector()));
    let span: Option<RayInterval> = Aabb::intersect(&aabb, &any_ray());
    used((span, Aabb::is_empty(&aabb), any(Aabb::EMPTY), Aabb::from_points(slice(&[Vec3::X]))));

    used((Ray::at(&any_ray(), number()), offset_origin(vector(), vector(), vector())));
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
    Shape::OrientedCuboid(0),
    Shape::Cone(0),
    Shape::Torus(0),
];

/// Shapes and tables of any length and content, consistent or not.
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
        vertices: slice(&[Vec3::ZERO]),
        vertex_normals: slice(&[Vec3::Y]),
        planes: slice(&[Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(3) }]),
        discs: slice(&[Disc { center: Vec3::ZERO, normal: Vec3::Y, radius: 1.0 }]),
        polygons: slice(&[Polygon {
            first_vertex: 0,
            vertex_count: 3,
            point: Vec3::ZERO,
            normal: Vec3::Y,
            bounds: Aabb::EMPTY,
            smooth: true,
        }]),
        cuboids: slice(&[Cuboid { min: Vec3::ZERO, max: Vec3::ONE }]),
        oriented_cuboids: slice(&[OrientedCuboid {
            center: Vec3::ZERO,
            half_extents: Vec3::ONE,
            axes: [Vec3::X, Vec3::Y, Vec3::Z],
        }]),
        cones: slice(&[CONE]),
        tori: slice(&[Torus { center: Vec3::ZERO, axis: Vec3::Y, major_radius: 1.0, minor_radius: 0.5 }]),
        moving_shapes: slice(&[MovingShape {
            shape: Shape::Triangle([0, 1, 2]),
            offset_at_open: Vec3::ZERO,
            offset_at_close: Vec3::X,
        }]),
    }
}

fn in_tables() {
    /// Shape features of no effect set.
    struct ArbitraryTables;
    impl ShapeFeatures for ArbitraryTables {
        const SHAPES: ShapeKindSet = ShapeKindSet::ALL;
        const SMOOTH_SHADING: bool = false;
        const MOTION_BLUR: bool = true;
    }
    fn intersect_any<S: ShapeFeatures>(geometry: &Geometry<'_>) {
        used((
            Geometry::kind(geometry, &any(SHAPES[0])),
            Geometry::motion_offset(geometry, &any(SHAPES[0]), number()),
        ));
        used(Geometry::intersect::<S>(geometry, any(&SHAPES[0]), &any_ray()));
        let surface: Option<SurfaceInteraction> =
            Geometry::surface_interaction::<S>(geometry, any(&SHAPES[0]), &any_ray(), number());
        used(surface);
    }
    let geometry = any_geometry();
    used((Geometry::validate(&geometry), Geometry::shape(&geometry, any_item())));
    used((Geometry::bounds(&geometry, any_item()), Geometry::size_in_bytes(&geometry)));
    Geometry::all_bounds(&geometry).for_each(used);
    geometry
        .moving_shapes
        .first()
        .map(|moving| MovingShape::offset_at(moving, number()))
        .into_iter()
        .for_each(used);
    intersect_any::<ArbitraryTables>(&geometry);
    intersect_any::<AllEffects>(&geometry);
}
