//! What scenes are made of, and how they reach a format.

use std::io;

use glam::{DVec3, dvec3};

/// Writes a scene in one format, in the order of the calls.
pub trait SceneWriter {
    /// How it is looked at and lit; comes first. A pen for objects only leaves it out.
    fn header(&mut self, head: &SceneHeader<'_>) -> io::Result<()>;

    /// What the objects after it are made of.
    fn material(&mut self, surface: &ProceduralMaterial) -> io::Result<()>;

    /// A sphere.
    fn sphere(&mut self, center: DVec3, radius: f64) -> io::Result<()>;

    /// An open cone between two circles, each with its middle and its radius.
    fn cone(&mut self, base: (DVec3, f64), end: (DVec3, f64)) -> io::Result<()>;

    /// A flat polygon.
    fn polygon(&mut self, corners: &[DVec3]) -> io::Result<()>;

    /// Triangles.
    fn mesh(&mut self, mesh: &dyn ProceduralMesh) -> io::Result<()>;
}

/// How a scene is looked at and lit.
pub struct SceneHeader<'h> {
    /// The eye.
    pub from: DVec3,
    /// The middle of the picture.
    pub at: DVec3,
    /// What is up.
    pub up: DVec3,
    /// The places of its lights. Their brightness, and that of the light from everywhere, follow
    /// the rule of the databases.
    pub lights: &'h [DVec3],
}

impl SceneHeader<'_> {
    /// The angle of view of all scenes of the databases, in degrees.
    pub const ANGLE: u32 = 45;
    /// The size of all their pictures.
    pub const SIZE: u32 = 512;
    /// The blue behind all of them.
    pub const BACKGROUND: [f32; 3] = [0.078, 0.361, 0.753];

    /// The brightness of each light, and of the light from everywhere.
    pub fn intensity(&self) -> f32 {
        let n = self.lights.len().max(1) as f64;
        (n.sqrt() / (2.0 * n)) as f32
    }
}

/// What an object is made of, as NFF has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProceduralMaterial {
    /// Its name where a format has names; no two of a scene are the same.
    pub name: &'static str,
    /// Red, green and blue.
    pub color: [f32; 3],
    /// The share of light that is scattered.
    pub kd: f32,
    /// The share of light that is mirrored, and how bright highlights are.
    pub ks: f32,
    /// How narrow highlights are.
    pub shine: f32,
    /// The share of light that passes, and the index of refraction.
    pub glass: Option<(f32, f32)>,
}

impl ProceduralMaterial {
    /// Scatters light and nothing else.
    pub const fn matte(name: &'static str, color: [f32; 3], kd: f32) -> Self {
        ProceduralMaterial { name, color, kd, ks: 0.0, shine: 0.0, glass: None }
    }
}

/// Triangles that share corners, by a formula and not in memory.
pub trait ProceduralMesh {
    /// How many corners.
    fn points(&self) -> u32;

    /// A corner: its place, and its normal unless the mesh is flat.
    fn point(&self, number: u32) -> (DVec3, Option<DVec3>);

    /// How many triangles.
    fn triangles(&self) -> u32;

    /// The corners of a triangle.
    fn triangle(&self, number: u32) -> [u32; 3];
}

/// The numbers of a place as they are written. What is nothing but rounding becomes zero, and
/// zero has no sign.
pub fn to_float3(place: DVec3) -> [f32; 3] {
    place.to_array().map(|x| if x.abs() < 1e-9 { 0.0 } else { x as f32 })
}

/// Turns directions so that z comes to lie on `toward` (of length one) on the shortest way.
/// Straight down, where every way is as short, it is half a turn about y.
pub fn rotate_from_z(toward: DVec3, v: DVec3) -> DVec3 {
    let axis = dvec3(-toward.y, toward.x, 0.0);
    let (sine, cosine) = (axis.dot(axis).sqrt(), toward.z);
    if sine < 1e-9 {
        return if cosine > 0.0 { v } else { dvec3(-v.x, v.y, -v.z) };
    }
    // Rodrigues' formula.
    let axis = axis / sine;
    v * cosine + axis.cross(v) * sine + axis * (axis.dot(v) * (1.0 - cosine))
}

/// The point at an angle on the circle with these two half axes.
pub fn ellipse_point(angle: f64, first: DVec3, second: DVec3) -> DVec3 {
    first * libm::cos(angle) + second * libm::sin(angle)
}

/// The angle of a share of a full turn, in radians.
pub fn turns_to_radians(share: f64) -> f64 {
    2.0 * std::f64::consts::PI * share
}
