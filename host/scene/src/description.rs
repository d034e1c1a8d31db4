//! A scene in neutral numbers, as loaders give it.
//!
//! All numbers are rounded to single precision here, whatever the core computes with, so that
//! the two precisions see the same scene. Nothing is derived: directions have any length,
//! angles are in degrees, a cone is two circles, a polygon its corners.

use std::collections::BTreeMap;

use strahl_core::{Material, Rgb, Vec3, vec3};
use strahl_settings::PartialSettings;

/// A point or a direction.
pub type Triple = [f32; 3];

/// Everything that a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// How it is looked at.
    pub view: View,
    /// The line that says so, counted from 1.
    pub view_line: usize,
    /// The line that lets light pass through bodies on its way from a light, if one does.
    pub colored_shadows: Option<usize>,
    /// The settings that the file has; the command line wins.
    pub settings: PartialSettings,
    /// The lines of those settings, by their keys.
    pub setting_lines: BTreeMap<&'static str, usize>,
    /// What is behind everything.
    pub background: Background,
    /// Light from everywhere.
    pub ambient: Rgb,
    /// The lights.
    pub lights: Vec<Placed<Light>>,
    /// The materials. Their textures are places in `textures`.
    pub materials: Vec<Placed<Material>>,
    /// The textures.
    pub textures: Vec<Texture>,
    /// The objects in the order of the file. Every triangle of a mesh counts as one.
    pub objects: Vec<Object>,
    /// Corners of triangles and polygons.
    pub points: Vec<Triple>,
    /// Normals of corners, of any length but zero: that of a corner has the corner's place.
    pub normals: Vec<Triple>,
    /// Triangles of meshes: the places of their corners.
    pub triangles: Vec<[u32; 3]>,
    /// What moves, in the order of the objects.
    pub moving: Vec<Motion>,
    /// When the shutter opens and closes, not before.
    pub shutter: [f32; 2],
    /// What a user should know of that is no error.
    pub warnings: Vec<String>,
}

/// Something with its place in the scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed<T> {
    /// The thing.
    pub it: T,
    /// The line, counted from 1.
    pub line: usize,
    /// What the file calls it.
    pub name: Option<String>,
}

/// How the scene is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The eye.
    pub from: Triple,
    /// What is in the middle of the picture.
    pub at: Triple,
    /// What is up.
    pub up: Triple,
    /// How rays run.
    pub projection: Projection,
}

/// How rays run, by the rules of [`strahl_core::Projection`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
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

impl Projection {
    /// Whether rays come from a lens.
    pub fn has_lens(&self) -> bool {
        matches!(self, Projection::Lens { .. })
    }
}

/// What is behind everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// One colour.
    Color(Rgb),
    /// From one colour to another, by the height of the direction.
    Gradient {
        /// What is up, of any length.
        up: Triple,
        /// The colour straight down.
        below: Rgb,
        /// The colour straight up.
        above: Rgb,
    },
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it is and where it shines.
    pub source: Source,
    /// Its radiance at a surface that faces it, before the falloff.
    pub color: Rgb,
    /// Whether things stand in its way.
    pub shadows: bool,
}

/// Where a light is and where it shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// From one place in all directions.
    Point {
        /// The place.
        position: Triple,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Triple,
    },
    /// From infinitely far away.
    Directional {
        /// Towards the light, of any length.
        toward: Triple,
    },
    /// From one place into a cone.
    Spot {
        /// The place.
        position: Triple,
        /// The middle of the cone, away from the light, of any length.
        direction: Triple,
        /// Degrees from the middle up to which it is fully bright.
        bright: f32,
        /// Degrees from the middle beyond which it is dark.
        dark: f32,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Triple,
    },
    /// From a sphere in all directions.
    Sphere {
        /// Its middle.
        position: Triple,
        /// Its radius, at least 0.
        radius: f32,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Triple,
    },
    /// From the front of a rectangle.
    Rectangle {
        /// Its middle.
        position: Triple,
        /// From the middle to the middles of two edges that meet; the front is where their cross
        /// product points to.
        half: [Triple; 2],
        /// Whether its light comes from everywhere in it, or all of it from the middle.
        soft: bool,
        /// Constant, linear and quadratic part of what it is divided by.
        falloff: Triple,
    },
}

/// A colour for each point of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texture {
    /// Two colours in turn, in cells upright on the axes.
    Checker {
        /// The colour of the cell that begins in `origin`.
        even: Rgb,
        /// The colour of its neighbours.
        odd: Rgb,
        /// A corner of cells.
        origin: Triple,
        /// The size of a cell along each axis; zero is one cell without end.
        size: Triple,
    },
    /// From one colour to another, and constant beyond both.
    Gradient {
        /// The colour at `start`.
        from: Rgb,
        /// The colour at `end`.
        to: Rgb,
        /// Where it begins.
        start: Triple,
        /// Where it ends.
        end: Triple,
    },
    /// Spheres round a point, the finer the farther.
    ZonePlate {
        /// The colour in the middle.
        from: Rgb,
        /// The colour halfway to the first return.
        to: Rgb,
        /// The middle.
        origin: Triple,
        /// Returns per square of the distance.
        frequency: f32,
    },
}

/// One object, or one mesh of many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its shape.
    pub form: Form,
    /// Its place in the table of materials.
    pub material: u16,
    /// Its line in the scene file, counted from 1.
    pub line: u32,
}

/// That an object moves evenly, and is in its own place at the time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// The object's place in the table of objects.
    pub object: usize,
    /// How far it moves in a time of one.
    pub velocity: Triple,
}

/// The shutter that is open from 0 to 1.
pub const SHUTTER: [f32; 2] = [0.0, 1.0];

/// The shape of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A sphere.
    Sphere {
        /// The centre.
        center: Triple,
        /// The radius.
        radius: f32,
    },
    /// A plane without end.
    Plane {
        /// A point on it.
        point: Triple,
        /// Upright on it, of any length.
        normal: Triple,
    },
    /// A flat round disc.
    Disc {
        /// The centre.
        center: Triple,
        /// Upright on it, of any length.
        normal: Triple,
        /// The radius.
        radius: f32,
    },
    /// A box upright on the axes.
    Cuboid {
        /// The smallest coordinates.
        min: Triple,
        /// The largest coordinates.
        max: Triple,
    },
    /// A box turned in space.
    OrientedCuboid {
        /// The middle.
        center: Triple,
        /// Half of its length along each of its axes.
        half: Triple,
        /// Its first axis, of any length; the part upright on the third counts.
        first: Triple,
        /// Its third axis, of any length.
        third: Triple,
    },
    /// A cone or cylinder between two circles.
    Cone {
        /// The middle of the first circle.
        base: Triple,
        /// The radius of the first circle.
        base_radius: f32,
        /// The middle of the second circle.
        end: Triple,
        /// The radius of the second circle.
        end_radius: f32,
        /// Whether the circles are closed by discs.
        capped: bool,
    },
    /// A torus.
    Torus {
        /// The middle of the hole.
        center: Triple,
        /// Upright on the circle, of any length.
        axis: Triple,
        /// From the centre to the middle of the tube.
        major: f32,
        /// The radius of the tube.
        minor: f32,
    },
    /// A triangle: the places of its corners.
    Triangle {
        /// Places in the table of points, and in that of normals for a smooth one.
        corners: [u32; 3],
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
    Nothing,
}

impl Description {
    /// Nothing, looked at in this way.
    pub fn new(view: View) -> Self {
        Description {
            view,
            view_line: 1,
            colored_shadows: None,
            settings: PartialSettings::default(),
            setting_lines: BTreeMap::new(),
            background: Background::Color(Rgb::BLACK),
            ambient: Rgb::BLACK,
            lights: Vec::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            objects: Vec::new(),
            points: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
            moving: Vec::new(),
            shutter: SHUTTER,
            warnings: Vec::new(),
        }
    }
}

impl View {
    /// As the core has it, in single precision.
    pub(crate) fn to_core(self) -> strahl_core::View {
        let radians = |degrees: f32| degrees * (strahl_core::math::PI / 180.0);
        let projection = match self.projection {
            Projection::Perspective(angle) => strahl_core::Projection::Perspective { angle: radians(angle) },
            Projection::Lens { angle, radius, focus } => {
                strahl_core::Projection::Lens { angle: radians(angle), radius, focus }
            }
            Projection::Orthographic(height) => strahl_core::Projection::Orthographic { height },
        };
        strahl_core::View { from: vector(self.from), at: vector(self.at), up: vector(self.up), projection }
    }
}

/// A point or a direction, as the core has it in single precision.
pub(crate) fn vector([x, y, z]: Triple) -> Vec3 {
    vec3(x, y, z)
}

impl Form {
    /// What a user calls it.
    pub fn name(&self) -> &'static str {
        match self {
            Form::Sphere { .. } => "sphere",
            Form::Plane { .. } => "plane",
            Form::Disc { .. } => "disc",
            Form::Cuboid { .. } | Form::OrientedCuboid { .. } => "box",
            Form::Cone { base_radius, end_radius, .. } if base_radius == end_radius => "cylinder",
            Form::Cone { .. } => "cone",
            Form::Torus { .. } => "torus",
            Form::Triangle { .. } | Form::Nothing => "triangle",
            Form::Polygon { .. } => "polygon",
            Form::Mesh { .. } => "mesh",
        }
    }
}
