//! A scene in neutral numbers, as loaders give it.
//!
//! All numbers are rounded to single precision here, whatever the core computes with, so that
//! the two precisions see the same scene. Nothing is derived: directions have any length, a
//! cone is two circles, a polygon its corners.

use strahl_core::{Background, Light, Material, Size};

/// A point or a direction.
pub type Triple = [f32; 3];

/// Everything that a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// How it is looked at.
    pub view: View,
    /// The size of the picture that the file asks for.
    pub size: Option<Size>,
    /// What is behind everything.
    pub background: Background,
    /// Light from everywhere.
    pub ambient: strahl_core::Rgb,
    /// The lights, with the lines they stand in.
    pub lights: Vec<Placed<Light>>,
    /// The materials, with the lines they stand in.
    pub materials: Vec<Placed<Material>>,
    /// The objects, by their number.
    pub objects: Vec<Object>,
    /// Corners of triangles and polygons.
    pub points: Vec<Triple>,
    /// Normals of corners: that of a corner has the corner's place.
    pub normals: Vec<Triple>,
    /// What a user should know of that is no error.
    pub warnings: Vec<String>,
}

/// Something with its line in the scene file, counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed<T> {
    /// The thing.
    pub it: T,
    /// The line.
    pub line: usize,
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
    /// The full angle of view in degrees, by the rule of [`strahl_core::Projection`].
    pub angle: f32,
}

/// One object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its shape.
    pub form: Form,
    /// Its place in the table of materials.
    pub material: u16,
}

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
    /// Something without extent, which keeps its number and is never hit.
    Nothing,
}
