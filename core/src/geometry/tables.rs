//! The shapes of a scene: their tables, and the bounds of each item.

use super::shape::AllShapes;
use super::{
    Aabb, Cone, Cuboid, Disc, ItemId, MovingShape, OrientedCuboid, Plane, Polygon, Shape, ShapeFeatures,
    ShapeKind, Torus, triangle,
};
use crate::math::Vec3;

/// The shapes of all items of a scene, and the tables that they index.
///
/// The tables are borrowed slices, which may be in flash. [`Geometry::validate`] checks them. An index that
/// is out of range is treated as a miss and never panics.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'s> {
    /// The shape of each item, by [`ItemId`].
    pub shapes: &'s [Shape],
    /// Vertices of triangles and polygons, world space.
    pub vertices: &'s [Vec3],
    /// Unit normals of the vertices of smooth shapes, with the indices of their vertices. The table may end
    /// before that of the vertices if later vertices belong to flat shapes only.
    pub vertex_normals: &'s [Vec3],
    /// Planes, by the index in [`Shape::Plane`].
    pub planes: &'s [Plane],
    /// Discs, by the index in [`Shape::Disc`].
    pub discs: &'s [Disc],
    /// Polygons, by the index in [`Shape::Polygon`].
    pub polygons: &'s [Polygon],
    /// Axis-aligned boxes, by the index in [`Shape::Cuboid`].
    pub cuboids: &'s [Cuboid],
    /// Oriented boxes, by the index in [`Shape::OrientedCuboid`].
    pub oriented_cuboids: &'s [OrientedCuboid],
    /// Cones and cylinders, by the index in [`Shape::Cone`].
    pub cones: &'s [Cone],
    /// Tori, by the index in [`Shape::Torus`].
    pub tori: &'s [Torus],
    /// Shapes that move while the shutter is open, by the index in [`Shape::Moving`].
    pub moving_shapes: &'s [MovingShape],
}

/// The entry of a table at `index`.
pub(super) fn get<T>(table: &[T], index: u32) -> Option<&T> {
    table.get(index as usize)
}

impl<'s> Geometry<'s> {
    /// A geometry without items, for struct update syntax: `Geometry { shapes, ..Geometry::EMPTY }`.
    pub const EMPTY: Geometry<'static> = Geometry {
        shapes: &[],
        vertices: &[],
        vertex_normals: &[],
        planes: &[],
        discs: &[],
        polygons: &[],
        cuboids: &[],
        oriented_cuboids: &[],
        cones: &[],
        tori: &[],
        moving_shapes: &[],
    };

    /// Size of all tables, in bytes.
    pub const fn size_in_bytes(&self) -> usize {
        let Geometry {
            shapes,
            vertices,
            vertex_normals,
            planes,
            discs,
            polygons,
            cuboids,
            oriented_cuboids,
            cones,
            tori,
            moving_shapes,
        } = self;
        size_of_val(*shapes)
            + size_of_val(*vertices)
            + size_of_val(*vertex_normals)
            + size_of_val(*planes)
            + size_of_val(*discs)
            + size_of_val(*polygons)
            + size_of_val(*cuboids)
            + size_of_val(*oriented_cuboids)
            + size_of_val(*cones)
            + size_of_val(*tori)
            + size_of_val(*moving_shapes)
    }

    /// The shape of an item; `None` if there is no such item.
    pub fn shape(&self, item: ItemId) -> Option<&'s Shape> {
        get(self.shapes, item.0)
    }

    /// The entry of the table of moving shapes at `index`.
    pub(super) fn moving_shape(&self, index: u32) -> Option<&'s MovingShape> {
        get(self.moving_shapes, index)
    }

    /// The shape itself, or the shape inside a moving shape.
    pub(crate) fn static_shape(&self, shape: &'s Shape) -> Option<&'s Shape> {
        match shape {
            Shape::Moving(index) => Some(&self.moving_shape(*index)?.shape),
            _ => Some(shape),
        }
    }

    /// The vertices of a triangle.
    pub(crate) fn vertices(&self, [a, b, c]: [u32; 3]) -> Option<[&'s Vec3; 3]> {
        Some([get(self.vertices, a)?, get(self.vertices, b)?, get(self.vertices, c)?])
    }

    /// The vertex normals of a smooth triangle.
    pub(super) fn vertex_normals(&self, [a, b, c]: [u32; 3]) -> Option<[Vec3; 3]> {
        Some([*get(self.vertex_normals, a)?, *get(self.vertex_normals, b)?, *get(self.vertex_normals, c)?])
    }

    /// Bounds of an item, rounded outward; `None` for a plane, which is infinite.
    pub fn bounds(&self, item: ItemId) -> Option<Aabb> {
        self.bounds_of_shape::<AllShapes>(*self.shape(item)?)
    }

    /// Bounds of all items, by [`ItemId`]; [`Aabb::EMPTY`] for planes.
    pub fn all_bounds(&self) -> impl Iterator<Item = Aabb> + '_ {
        let geometry = *self;
        let bounds = move |shape: &Shape| geometry.bounds_of_shape::<AllShapes>(*shape);
        self.shapes.iter().map(move |shape| bounds(shape).unwrap_or(Aabb::EMPTY))
    }

    fn bounds_of_shape<S: ShapeFeatures>(&self, shape: Shape) -> Option<Aabb> {
        if S::MOTION_BLUR
            && let Shape::Moving(index) = shape
        {
            return self.moving_bounds::<S>(index);
        }
        self.static_bounds::<S>(shape)
    }

    /// Bounds of a shape that does not move; `None` for a plane and for a kind that is not in `S::SHAPES`.
    // The kind is compared in every arm so that the code of other kinds is compiled away.
    pub(super) fn static_bounds<S: ShapeFeatures>(&self, shape: Shape) -> Option<Aabb> {
        let supports = |kind| S::SHAPES.contains(kind);
        match shape {
            Shape::Sphere(sphere) if supports(ShapeKind::Sphere) => Some(sphere.bounds()),
            Shape::Triangle(indices) if supports(ShapeKind::Triangle) => {
                self.vertices(indices).map(triangle::bounds)
            }
            Shape::SmoothTriangle(indices) if supports(ShapeKind::SmoothTriangle) => {
                self.vertices(indices).map(triangle::bounds)
            }
            Shape::Disc(index) if supports(ShapeKind::Disc) => get(self.discs, index).map(Disc::bounds),
            Shape::Polygon(index) if supports(ShapeKind::Polygon) => {
                get(self.polygons, index).map(|polygon| polygon.bounds)
            }
            Shape::Cuboid(index) if supports(ShapeKind::Cuboid) => {
                get(self.cuboids, index).map(Cuboid::bounds)
            }
            Shape::OrientedCuboid(index) if supports(ShapeKind::OrientedCuboid) => {
                get(self.oriented_cuboids, index).map(OrientedCuboid::bounds)
            }
            Shape::Cone(index) if supports(ShapeKind::Cone) => get(self.cones, index).map(Cone::bounds),
            Shape::Torus(index) if supports(ShapeKind::Torus) => get(self.tori, index).map(Torus::bounds),
            Shape::Sphere(_)
            | Shape::Triangle(_)
            | Shape::SmoothTriangle(_)
            | Shape::Disc(_)
            | Shape::Polygon(_)
            | Shape::Cuboid(_)
            | Shape::OrientedCuboid(_)
            | Shape::Cone(_)
            | Shape::Torus(_)
            | Shape::Plane(_)
            | Shape::Moving(_) => None,
        }
    }
}
