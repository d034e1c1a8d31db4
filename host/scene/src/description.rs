//! A scene in neutral numbers, as loaders give it.
//!
//! All numbers are rounded to single precision here, whatever the core computes with, so that
//! the two precisions see the same scene. Nothing is derived: directions have any length,
//! angles are in degrees, a cone is two circles, a polygon its corners.

use std::collections::BTreeMap;

use strahl_core::{Material, Rgb, Vec3, vec3};
use strahl_settings::SettingsOverrides;

/// A point or a direction.
pub type Float3 = [f32; 3];

/// Everything that a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedScene {
    /// How it is looked at.
    pub camera: CameraDescription,
    /// The line that says so, counted from 1.
    pub camera_line: usize,
    /// The line that lets light pass through bodies on its way from a light, if one does.
    pub colored_shadows_line: Option<usize>,
    /// The settings that the file has; the command line wins.
    pub settings: SettingsOverrides,
    /// The lines of those settings, by their keys.
    pub setting_lines: BTreeMap<&'static str, usize>,
    /// What is behind everything.
    pub background: BackgroundDescription,
    /// Light from everywhere.
    pub ambient: Rgb,
    /// The lights.
    pub lights: Vec<Located<LightDescription>>,
    /// The materials. Their textures are places in `textures`.
    pub materials: Vec<Located<Material>>,
    /// The textures.
    pub textures: Vec<TextureDescription>,
    /// The objects in the order of the file. Every triangle of a mesh counts as one.
    pub objects: Vec<ObjectDescription>,
    /// Corners of triangles and polygons.
    pub vertices: Vec<Float3>,
    /// Normals of corners, of any length but zero: that of a corner has the corner's place.
    pub normals: Vec<Float3>,
    /// Triangles of meshes: the places of their corners.
    pub triangles: Vec<[u32; 3]>,
    /// What moves, in the order of the objects.
    pub motions: Vec<LinearMotion>,
    /// When the shutter opens and closes, not before.
    pub shutter: [f32; 2],
    /// What a user should know of that is no error.
    pub warnings: Vec<String>,
}

/// Something with its place in the scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Located<T> {
    /// The thing.
    pub value: T,
    /// The line, counted from 1.
    pub line: usize,
    /// What the file calls it.
    pub name: Option<String>,
}

/// How the scene is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraDescription {
    /// The eye.
    pub from: Float3,
    /// What is in the middle of the picture.
    pub at: Float3,
    /// What is up.
    pub up: Float3,
    /// How rays run.
    pub projection: ProjectionDescription,
}

/// How rays run, by the rules of [`strahl_core::Projection`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProjectionDescription {
    /// From one point, with a full vertical angle of view in degrees.
    Perspective(f32),
    /// From a lens.
    Lens {
        /// As of a perspective.
        angle: f32,
        /// Its radius.
        radius: f32,
        /// How far away from it everything is sharp.
        focus: f32,
    },
    /// In one direction, over a height in scene lengths.
    Orthographic(f32),
}

impl ProjectionDescription {
    /// Whether rays come from a lens.
    pub fn has_lens(&self) -> bool {
        matches!(self, ProjectionDescription::Lens { .. })
    }
}

/// What is behind everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BackgroundDescription {
    /// One colour.
    Color(Rgb),
    /// From one colour to another, by the height of the direction.
    Gradient {
        /// What is up, of any length.
        up: Float3,
        /// The colour straight down.
        below: Rgb,
        /// The colour straight up.
        above: Rgb,
    },
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDescription {
    /// Where it is and where it shines.
    pub source: LightSourceDescription,
    /// Its radiance at a surface that faces it, before the falloff.
    pub color: Rgb,
    /// Whether things stand in its way.
    pub shadows: bool,
}

/// Where a light is and where it shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSourceDescription {
    /// From one place in all directions.
    Point {
        /// The place.
        position: Float3,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Float3,
    },
    /// From infinitely far away.
    Directional {
        /// Towards the light, of any length.
        to_light: Float3,
    },
    /// From one place into a cone.
    Spot {
        /// The place.
        position: Float3,
        /// The middle of the cone, away from the light, of any length.
        direction: Float3,
        /// Degrees from the middle up to which it is fully bright.
        inner_angle: f32,
        /// Degrees from the middle beyond which it is dark.
        outer_angle: f32,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Float3,
    },
    /// From a sphere in all directions.
    Sphere {
        /// Its middle.
        position: Float3,
        /// Its radius, at least 0.
        radius: f32,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Float3,
    },
    /// From the front of a rectangle.
    Rectangle {
        /// Its middle.
        position: Float3,
        /// From the middle to the middles of two edges that meet; the front is where their cross
        /// product points to.
        half_edges: [Float3; 2],
        /// Whether its light comes from everywhere in it, or all of it from the middle.
        is_sampled: bool,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Float3,
    },
}

/// A colour for each point of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TextureDescription {
    /// Two colours in turn, in cells upright on the axes.
    Checker {
        /// The colour of the cell that begins in `origin`.
        even: Rgb,
        /// The colour of its neighbours.
        odd: Rgb,
        /// A corner of cells.
        origin: Float3,
        /// The size of a cell along each axis; zero is one cell without end.
        size: Float3,
    },
    /// From one colour to another, and constant beyond both.
    Gradient {
        /// The colour at `start`.
        from: Rgb,
        /// The colour at `end`.
        to: Rgb,
        /// Where it begins.
        start: Float3,
        /// Where it ends.
        end: Float3,
    },
    /// Spheres round a point, the finer the farther.
    ZonePlate {
        /// The colour in the middle.
        from: Rgb,
        /// The colour halfway to the first return.
        to: Rgb,
        /// The middle.
        origin: Float3,
        /// Returns per square of the distance.
        frequency: f32,
    },
}

/// One object, or one mesh of many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectDescription {
    /// Its shape.
    pub shape: ShapeDescription,
    /// Its place in the table of materials.
    pub material: u16,
    /// Its line in the scene file, counted from 1.
    pub line: u32,
}

/// That an object moves evenly, and is in its own place at the time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearMotion {
    /// The object's place in the table of objects.
    pub object: usize,
    /// How far it moves in a time of one.
    pub velocity: Float3,
}

/// The shutter that is open from 0 to 1.
pub const DEFAULT_SHUTTER: [f32; 2] = [0.0, 1.0];

/// The shape of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeDescription {
    /// A sphere.
    Sphere {
        /// The centre.
        center: Float3,
        /// The radius.
        radius: f32,
    },
    /// A plane without end.
    Plane {
        /// A point on it.
        point: Float3,
        /// Upright on it, of any length.
        normal: Float3,
    },
    /// A flat round disc.
    Disc {
        /// The centre.
        center: Float3,
        /// Upright on it, of any length.
        normal: Float3,
        /// The radius.
        radius: f32,
    },
    /// A box upright on the axes.
    Cuboid {
        /// The smallest coordinates.
        min: Float3,
        /// The largest coordinates.
        max: Float3,
    },
    /// A box turned in space.
    OrientedCuboid {
        /// The middle.
        center: Float3,
        /// Half of its length along each of its axes.
        half_size: Float3,
        /// Its first axis, of any length; the part upright on the third counts.
        first: Float3,
        /// Its third axis, of any length.
        third: Float3,
    },
    /// A cone or cylinder between two circles.
    Cone {
        /// The middle of the first circle.
        base: Float3,
        /// The radius of the first circle.
        base_radius: f32,
        /// The middle of the second circle.
        end: Float3,
        /// The radius of the second circle.
        end_radius: f32,
        /// Whether the circles are closed by discs.
        capped: bool,
    },
    /// A torus.
    Torus {
        /// The middle of the hole.
        center: Float3,
        /// Upright on the circle, of any length.
        axis: Float3,
        /// From the centre to the middle of the tube.
        major_radius: f32,
        /// The radius of the tube.
        minor_radius: f32,
    },
    /// A triangle: the places of its corners.
    Triangle {
        /// Places in the table of points, and in that of normals for a smooth one.
        vertices: [u32; 3],
        /// Whether shading normals are interpolated.
        smooth: bool,
    },
    /// A polygon.
    Polygon {
        /// The place of its first corner.
        first: u32,
        /// How many corners.
        count: u32,
        /// Whether shading normals are interpolated.
        smooth: bool,
    },
    /// Triangles that follow each other in the table of triangles: as many objects.
    Mesh {
        /// The place of the first.
        first: u32,
        /// How many.
        count: u32,
        /// Whether shading normals are interpolated.
        smooth: bool,
    },
    /// Something without extent, which keeps its number and is never hit.
    Degenerate,
}

impl LoadedScene {
    /// Nothing, looked at in this way.
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
    /// As the core has it, in single precision.
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

/// A point or a direction, as the core has it in single precision.
pub(crate) fn vec3_of([x, y, z]: Float3) -> Vec3 {
    vec3(x, y, z)
}

impl ShapeDescription {
    /// What a user calls it.
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
