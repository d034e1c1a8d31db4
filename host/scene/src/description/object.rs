//! The objects of a loaded scene, their shapes and their motion.

use super::float3::Float3;

/// One object: a shape, or a mesh, which has one item per triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectDescription {
    /// Its shape.
    pub shape: ShapeDescription,
    /// The index of its material.
    pub material: u16,
    /// Its line in the scene file, counted from 1; 0 if it is not from a TOML or NFF file.
    pub line: u32,
}

/// The uniform motion of an object, which is at its given position at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearMotion {
    /// The index of the object in [`LoadedScene::objects`](super::LoadedScene::objects).
    pub object: usize,
    /// The displacement per unit of time.
    pub velocity: Float3,
}

/// The shape of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeDescription {
    /// A sphere.
    Sphere {
        /// The center.
        center: Float3,
        /// The radius.
        radius: f32,
    },
    /// An infinite plane.
    Plane {
        /// A point on it.
        point: Float3,
        /// The normal, of any length.
        normal: Float3,
    },
    /// A disc.
    Disc {
        /// The center.
        center: Float3,
        /// The normal, of any length.
        normal: Float3,
        /// The radius.
        radius: f32,
    },
    /// An axis-aligned box.
    Cuboid {
        /// The minimum coordinates.
        min: Float3,
        /// The maximum coordinates.
        max: Float3,
    },
    /// An oriented box.
    OrientedCuboid {
        /// The center.
        center: Float3,
        /// Half of its size along each of its axes.
        half_size: Float3,
        /// The first axis, of any length; only its component perpendicular to the third counts.
        first: Float3,
        /// The third axis, of any length.
        third: Float3,
    },
    /// A cone, truncated cone or cylinder between two circles.
    Cone {
        /// The center of the first circle.
        base: Float3,
        /// The radius of the first circle.
        base_radius: f32,
        /// The center of the second circle.
        end: Float3,
        /// The radius of the second circle.
        end_radius: f32,
        /// Whether the ends are closed by discs.
        capped: bool,
    },
    /// A torus.
    Torus {
        /// The center.
        center: Float3,
        /// The axis of revolution, of any length.
        axis: Float3,
        /// The distance from the center to the center of the tube.
        major_radius: f32,
        /// The radius of the tube.
        minor_radius: f32,
    },
    /// A triangle.
    Triangle {
        /// Indices of its vertices, and of its normals if it is smooth.
        vertices: [u32; 3],
        /// Whether shading normals are interpolated.
        smooth: bool,
    },
    /// A polygon.
    Polygon {
        /// The index of its first vertex; the others follow.
        first: u32,
        /// The number of vertices.
        count: u32,
        /// Whether shading normals are interpolated.
        smooth: bool,
    },
    /// Consecutive triangles of `triangles`, each of which counts as one object.
    Mesh {
        /// The index of the first triangle.
        first: u32,
        /// The number of triangles.
        count: u32,
        /// Whether shading normals are interpolated.
        smooth: bool,
    },
    /// A shape without area, which keeps its object index and is never hit.
    Degenerate,
}

impl ShapeDescription {
    /// The name of the shape's table in TOML.
    pub fn name(&self) -> &'static str {
        match self {
            ShapeDescription::Sphere { .. } => "sphere",
            ShapeDescription::Plane { .. } => "plane",
            ShapeDescription::Disc { .. } => "disc",
            ShapeDescription::Cuboid { .. } | ShapeDescription::OrientedCuboid { .. } => "box",
            ShapeDescription::Cone { base_radius, end_radius, .. } if base_radius == end_radius => "cylinder",
            ShapeDescription::Cone { .. } => "cone",
            ShapeDescription::Torus { .. } => "torus",
            ShapeDescription::Triangle { .. } | ShapeDescription::Degenerate => "triangle",
            ShapeDescription::Polygon { .. } => "polygon",
            ShapeDescription::Mesh { .. } => "mesh",
        }
    }
}
