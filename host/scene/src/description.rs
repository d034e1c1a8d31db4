//! A loaded scene in plain numbers, independent of the file format and of the precision of the core.
//!
//! All numbers are rounded to single precision here, so that single and double precision render the same scene.
//! Nothing is derived: directions have any length, angles are in degrees, a cone is given by two circles, a polygon by
//! its vertices.

use std::collections::BTreeMap;

use strahl_core::{Material, Rgb, Vec3, vec3};
use strahl_settings::SettingsOverrides;

/// A point or a direction: x, y and z.
pub type Float3 = [f32; 3];

/// The contents of a scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedScene {
    /// The camera.
    pub camera: CameraDescription,
    /// The line of the camera in the file, counted from 1.
    pub camera_line: usize,
    /// The line that enables colored shadows; `None` if none does.
    pub colored_shadows_line: Option<usize>,
    /// The settings in the file; the command line takes precedence.
    pub settings: SettingsOverrides,
    /// The lines of these settings, by key.
    pub setting_lines: BTreeMap<&'static str, usize>,
    /// The background.
    pub background: BackgroundDescription,
    /// The ambient light.
    pub ambient: Rgb,
    /// The lights.
    pub lights: Vec<Located<LightDescription>>,
    /// The materials. Their textures are indices into `textures`.
    pub materials: Vec<Located<Material>>,
    /// The textures.
    pub textures: Vec<TextureDescription>,
    /// The objects in the order of the file: one entry for each object, also for a mesh. Each triangle of a mesh is an
    /// item of the core with its own `ItemId`; every other object is one item.
    pub objects: Vec<ObjectDescription>,
    /// The vertices of triangles and polygons.
    pub vertices: Vec<Float3>,
    /// Vertex normals, of any length but zero; a normal has the index of its vertex.
    pub normals: Vec<Float3>,
    /// The triangles of meshes, as indices into `vertices`.
    pub triangles: Vec<[u32; 3]>,
    /// The moving objects, in ascending order of their indices.
    pub motions: Vec<LinearMotion>,
    /// The times at which the shutter opens and closes, in ascending order.
    pub shutter: [f32; 2],
    /// Warnings for the user.
    pub warnings: Vec<String>,
}

/// A value with its location in the scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Located<T> {
    /// The value.
    pub value: T,
    /// The line, counted from 1; 0 if the value is not from a file.
    pub line: usize,
    /// The name in the file, if any.
    pub name: Option<String>,
}

/// A camera: its position, its orientation and its projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraDescription {
    /// Its position.
    pub from: Float3,
    /// The point at the center of the picture.
    pub at: Float3,
    /// The up direction, of any length.
    pub up: Float3,
    /// The projection.
    pub projection: ProjectionDescription,
}

/// A projection, as in [`strahl_core::Projection`], with angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProjectionDescription {
    /// Pinhole; the vertical field of view, full angle in degrees.
    Perspective(f32),
    /// Thin lens.
    Lens {
        /// The vertical field of view, full angle in degrees.
        angle: f32,
        /// The lens radius.
        radius: f32,
        /// The focus distance from the lens.
        focus: f32,
    },
    /// Parallel rays; the visible height in scene lengths.
    Orthographic(f32),
}

impl ProjectionDescription {
    /// Whether the camera has a lens.
    pub fn has_lens(&self) -> bool {
        matches!(self, ProjectionDescription::Lens { .. })
    }
}

/// The background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BackgroundDescription {
    /// A single color.
    Color(Rgb),
    /// A gradient over the angle between the ray and the up direction.
    Gradient {
        /// The up direction, of any length.
        up: Float3,
        /// The color straight down.
        below: Rgb,
        /// The color straight up.
        above: Rgb,
    },
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDescription {
    /// Its shape and position.
    pub source: LightSourceDescription,
    /// Its radiance at a surface that faces it, before the falloff.
    pub color: Rgb,
    /// Whether it casts shadows.
    pub shadows: bool,
}

/// The kind, the position and the direction of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSourceDescription {
    /// A point light.
    Point {
        /// The position.
        position: Float3,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
    /// A directional light, infinitely far away.
    Directional {
        /// The direction to the light, of any length.
        to_light: Float3,
    },
    /// A spot light.
    Spot {
        /// The position.
        position: Float3,
        /// The axis of the cone, away from the light, of any length.
        direction: Float3,
        /// The half angle of the fully bright inner cone, in degrees.
        inner_angle: f32,
        /// The half angle of the cone, in degrees; outside it is dark.
        outer_angle: f32,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
    /// A spherical area light.
    Sphere {
        /// The center.
        position: Float3,
        /// The radius, at least 0.
        radius: f32,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
    /// A rectangular area light that emits from its front.
    Rectangle {
        /// The center.
        position: Float3,
        /// The vectors from the center to the midpoints of two adjacent edges; their cross product points to the
        /// front.
        half_edges: [Float3; 2],
        /// Whether light is sampled from the whole rectangle; otherwise it all comes from the center.
        soft_shadows: bool,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
}

/// A texture: a color for each point in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TextureDescription {
    /// A checker of two colors, in axis-aligned cells.
    Checker {
        /// The color of the cell that starts at `origin`.
        even: Rgb,
        /// The color of its neighbors.
        odd: Rgb,
        /// A corner of a cell.
        origin: Float3,
        /// The size of a cell along each axis; 0 means unbounded.
        size: Float3,
    },
    /// A linear gradient between two points, constant outside.
    Gradient {
        /// The color at `start`.
        from: Rgb,
        /// The color at `end`.
        to: Rgb,
        /// The start point.
        start: Float3,
        /// The end point.
        end: Float3,
    },
    /// A zone plate: concentric spheres that become finer with distance.
    ZonePlate {
        /// The color at the center.
        from: Rgb,
        /// The color half a cycle from the center.
        to: Rgb,
        /// The center.
        origin: Float3,
        /// The number of cycles within a distance of 1; it grows with the square of the distance.
        frequency: f32,
    },
}

/// One object, or a mesh, which counts as one object per triangle.
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
    /// The index of the object in [`LoadedScene::objects`].
    pub object: usize,
    /// The displacement per unit of time.
    pub velocity: Float3,
}

/// The default shutter times: open from 0 to 1.
pub const DEFAULT_SHUTTER: [f32; 2] = [0.0, 1.0];

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

impl LoadedScene {
    /// An empty scene with this camera: black, without settings.
    pub fn new(view: CameraDescription) -> Self {
        LoadedScene {
            camera: view,
            camera_line: 1,
            colored_shadows_line: None,
            settings: SettingsOverrides::default(),
            setting_lines: BTreeMap::new(),
            background: BackgroundDescription::Color(Rgb::BLACK),
            ambient: Rgb::BLACK,
            lights: Vec::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            objects: Vec::new(),
            vertices: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
            motions: Vec::new(),
            shutter: DEFAULT_SHUTTER,
            warnings: Vec::new(),
        }
    }
}

impl CameraDescription {
    /// The camera of the core, in single precision.
    pub(crate) fn to_core(self) -> strahl_core::CameraDescriptor {
        let radians = |degrees: f32| degrees * (strahl_core::math::PI / 180.0);
        let projection = match self.projection {
            ProjectionDescription::Perspective(angle) => {
                strahl_core::Projection::Perspective { field_of_view: radians(angle) }
            }
            ProjectionDescription::Lens { angle, radius, focus } => strahl_core::Projection::ThinLens {
                field_of_view: radians(angle),
                lens_radius: radius,
                focus_distance: focus,
            },
            ProjectionDescription::Orthographic(height) => strahl_core::Projection::Orthographic { height },
        };
        strahl_core::CameraDescriptor {
            position: vec3_of(self.from),
            target: vec3_of(self.at),
            up: vec3_of(self.up),
            projection,
        }
    }
}

/// The vector of the core, in single precision.
pub(crate) fn vec3_of([x, y, z]: Float3) -> Vec3 {
    vec3(x, y, z)
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
