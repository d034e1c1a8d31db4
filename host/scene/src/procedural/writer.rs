//! Interface between procedural scenes and file formats.

use std::io;

use glam::{DVec3, dvec3};

/// Writes a scene in one format, in the order of the calls.
pub trait SceneWriter {
    /// Writes camera, lights and background; called first. A writer of objects only skips them.
    fn header(&mut self, header: &SceneHeader<'_>) -> io::Result<()>;

    /// Sets the material of the objects that follow.
    fn material(&mut self, material: &ProceduralMaterial) -> io::Result<()>;

    /// Writes a sphere.
    fn sphere(&mut self, center: DVec3, radius: f64) -> io::Result<()>;

    /// Writes an open cone between two circles, each given by its center and its radius.
    fn cone(&mut self, base: (DVec3, f64), end: (DVec3, f64)) -> io::Result<()>;

    /// Writes a planar polygon.
    fn polygon(&mut self, corners: &[DVec3]) -> io::Result<()>;

    /// Writes a mesh.
    fn mesh(&mut self, mesh: &dyn ProceduralMesh) -> io::Result<()>;
}

/// Camera and lights of a scene.
pub struct SceneHeader<'h> {
    /// The position of the camera.
    pub from: DVec3,
    /// The point at the center of the picture.
    pub at: DVec3,
    /// The up direction.
    pub up: DVec3,
    /// The positions of the lights; their intensity is [`intensity`](SceneHeader::intensity).
    pub lights: &'h [DVec3],
}

impl SceneHeader<'_> {
    /// The field of view of all scenes of the Standard Procedural Databases, full angle in degrees.
    pub const ANGLE: u32 = 45;
    /// The width and height of all their pictures.
    pub const SIZE: u32 = 512;
    /// The background color of all their pictures.
    pub const BACKGROUND: [f32; 3] = [0.078, 0.361, 0.753];

    /// The intensity of each light, and of the ambient light, by the rule of the databases.
    pub fn intensity(&self) -> f32 {
        let n = self.lights.len().max(1) as f64;
        (n.sqrt() / (2.0 * n)) as f32
    }
}

/// A material with the parameters of NFF.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProceduralMaterial {
    /// Its name, unique within the scene, for formats with names.
    pub name: &'static str,
    /// The color: red, green and blue.
    pub color: [f32; 3],
    /// The diffuse factor.
    pub kd: f32,
    /// The specular factor: mirror reflectance and highlight.
    pub ks: f32,
    /// The Phong exponent.
    pub shine: f32,
    /// The transmission factor and the index of refraction; `None` if opaque.
    pub glass: Option<(f32, f32)>,
}

impl ProceduralMaterial {
    /// A diffuse material.
    pub const fn matte(name: &'static str, color: [f32; 3], kd: f32) -> Self {
        ProceduralMaterial { name, color, kd, ks: 0.0, shine: 0.0, glass: None }
    }
}

/// A mesh whose vertices and triangles are computed on request.
pub trait ProceduralMesh {
    /// The number of vertices.
    fn points(&self) -> u32;

    /// The position of a vertex, and its normal unless the mesh is flat.
    fn point(&self, number: u32) -> (DVec3, Option<DVec3>);

    /// The number of triangles.
    fn triangles(&self) -> u32;

    /// The vertices of a triangle.
    fn triangle(&self, number: u32) -> [u32; 3];
}

/// A point or direction rounded for output: rounding noise becomes zero, and zero is positive.
pub fn to_float3(position: DVec3) -> [f32; 3] {
    position.to_array().map(|x| if x.abs() < 1e-9 { 0.0 } else { x as f32 })
}

/// Rotates `v` by the shortest rotation from z to the unit vector `toward`. If that is -z, the rotation is by 180 degrees
/// about y.
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

/// The point at an angle on the ellipse with these two half axes.
pub fn ellipse_point(angle: f64, first: DVec3, second: DVec3) -> DVec3 {
    first * libm::cos(angle) + second * libm::sin(angle)
}

/// Converts turns to radians.
pub fn turns_to_radians(share: f64) -> f64 {
    2.0 * std::f64::consts::PI * share
}
