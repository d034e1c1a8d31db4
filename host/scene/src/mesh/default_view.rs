//! Default camera and lights for a mesh file.
//!
//! No object is added: the objects are the triangles of the file, in its order. The camera is in front of the model, 35
//! degrees to the right and slightly above, at the smallest distance at which every vertex is in the picture with a
//! small margin. A flat model is viewed from higher up.
//!
//! A warm key light from the upper left casts shadows; a cool fill light from the right and a rim light from behind do
//! not. The lights are relative to the camera, so that every model is lit alike.
//!
//! The front of a model is towards +z if y is up, and towards -y if z is up, by convention.

use strahl_core::{Material, Resolution, Rgb};

use super::groups::TriangleMesh;
use crate::description::{
    BackgroundDescription, CameraDescription, Float3, LightDescription, LightSourceDescription, LoadedScene,
    Located, ObjectDescription, ProjectionDescription, ShapeDescription,
};
use crate::framing::{CameraFrame, Vec3d, cross, larger, sin_cos};

/// The up axis of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// Y up, with the front towards +z.
    Y,
    /// Z up, with the front towards -y.
    Z,
}

/// The azimuth of the camera, from the front to the right, in degrees.
const AZIMUTH: f64 = 35.0;
/// The elevation of the camera above the horizon, in degrees.
const ELEVATION: f64 = 22.0;
/// The elevation for a flat model, in degrees.
const FLAT_ELEVATION: f64 = 42.0;
/// A model is flat if its height is less than this share of its longer side.
const FLAT_RATIO: f64 = 0.2;
/// The vertical field of view, full angle in degrees.
const VIEW_ANGLE: f64 = 30.0;
/// The share of the half picture that the model may fill.
const FILL: f64 = 0.92;

/// The material of triangles without a material in the file.
const DEFAULT_MATERIAL: Material = Material {
    ambient: Rgb::new(0.72, 0.66, 0.6),
    diffuse: Rgb::new(0.72, 0.66, 0.6),
    highlight: Rgb::gray(0.12),
    highlight_exponent: 24.0,
    ..Material::MATTE
};

/// The mesh as a scene, for a picture of `size`.
pub fn with_default_view(mesh: TriangleMesh, up: UpAxis, size: Resolution) -> Result<LoadedScene, String> {
    let vertices = used_vertices(&mesh);
    let bounds = ModelBounds::of(&vertices, up);
    let frame = CameraFrame::new(bounds.to_camera, bounds.up, VIEW_ANGLE, FILL, size);
    let view = bounds.view(&vertices, &frame, size)?;
    let light = |name: &str, to_light: Vec3d, color: Rgb, shadows: bool| {
        let it = LightDescription {
            source: LightSourceDescription::Directional { to_light: to_float3(to_light) },
            color,
            shadows,
        };
        Located { value: it, line: 0, name: Some(name.into()) }
    };
    let [right, above, back] = frame.axes();
    let direction = |r: f64, a: f64, b: f64| [0, 1, 2].map(|i| r * right[i] + a * above[i] + b * back[i]);
    let lights = vec![
        light("key", direction(-0.75, 0.8, 0.42), Rgb::new(1.0, 0.9, 0.76), true),
        light("fill", direction(0.95, 0.15, 0.3), Rgb::new(0.1, 0.14, 0.22), false),
        light("rim", direction(0.4, 0.3, -0.9), Rgb::new(0.3, 0.32, 0.35), false),
    ];

    let mut materials: Vec<_> = mesh
        .materials
        .into_iter()
        .map(|(name, it)| Located { value: it, line: 0, name: Some(name) })
        .collect();
    let has_nameless = mesh.groups.iter().any(|group| group.material.is_none());
    let default_material = u16::try_from(materials.len()).map_err(|_| "too many materials")?;
    if has_nameless {
        materials.push(Located { value: DEFAULT_MATERIAL, line: 0, name: None });
    }
    let smooth = !mesh.normals.is_empty();
    let mut first = 0;
    let objects = mesh.groups.iter().map(|group| {
        let shape = ShapeDescription::Mesh { first, count: group.count, smooth };
        first += group.count;
        ObjectDescription { shape, material: group.material.unwrap_or(default_material), line: 0 }
    });
    Ok(LoadedScene {
        background: BackgroundDescription::Gradient {
            up: to_float3(bounds.up),
            below: Rgb::new(0.03, 0.035, 0.045),
            above: Rgb::new(0.24, 0.3, 0.37),
        },
        ambient: Rgb::new(0.1, 0.11, 0.13),
        lights,
        materials,
        objects: objects.collect(),
        vertices: mesh.vertices,
        normals: mesh.normals,
        triangles: mesh.triangles,
        warnings: mesh.warnings,
        ..LoadedScene::new(view)
    })
}

/// The vertices of all triangles, each once: a file may have unused vertices.
fn used_vertices(mesh: &TriangleMesh) -> Vec<Vec3d> {
    let mut is_used = vec![false; mesh.vertices.len()];
    mesh.triangles.as_flattened().iter().for_each(|corner| is_used[*corner as usize] = true);
    let vertices = mesh.vertices.iter().zip(is_used).filter(|(_, is_used)| *is_used);
    vertices.map(|(point, _)| point.map(f64::from)).collect()
}

fn to_float3(v: Vec3d) -> Float3 {
    v.map(|x| x as f32)
}

/// The bounding box of a model, and the direction to the camera.
struct ModelBounds {
    up: Vec3d,
    /// The unit vector from the model to the camera.
    to_camera: Vec3d,
    center: Vec3d,
    /// Half the longest side.
    half_extent: f64,
}

impl ModelBounds {
    fn of(vertices: &[Vec3d], up: UpAxis) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in vertices {
            for axis in 0..3 {
                low[axis] = if point[axis] < low[axis] { point[axis] } else { low[axis] };
                high[axis] = if point[axis] > high[axis] { point[axis] } else { high[axis] };
            }
        }
        let sides = [0, 1, 2].map(|i| high[i] - low[i]);
        let longest = |sides: &[f64]| sides.iter().fold(0.0, |most, side| larger(most, *side));
        let (up, front, height, width) = match up {
            UpAxis::Y => ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0], sides[1], longest(&[sides[0], sides[2]])),
            UpAxis::Z => ([0.0, 0.0, 1.0], [0.0, -1.0, 0.0], sides[2], longest(&sides[..2])),
        };
        let elevation = if height < FLAT_RATIO * width { FLAT_ELEVATION } else { ELEVATION };
        let (sin, cos) = sin_cos(AZIMUTH);
        let right = cross(up, front);
        let level = [0, 1, 2].map(|i| cos * front[i] + sin * right[i]);
        let (sin, cos) = sin_cos(elevation);
        let to_camera = [0, 1, 2].map(|i| cos * level[i] + sin * up[i]);
        let center = [0, 1, 2].map(|i| 0.5 * (low[i] + high[i]));
        ModelBounds { up, to_camera, center, half_extent: 0.5 * longest(&sides) }
    }

    /// The camera at the smallest distance at which every vertex is in the picture.
    fn view(
        &self,
        vertices: &[Vec3d],
        frame: &CameraFrame,
        size: Resolution,
    ) -> Result<CameraDescription, String> {
        if self.half_extent == 0.0 {
            return Err("all vertices are the same point".into());
        }
        let distances = frame.edge_distances(self.center, vertices.iter().copied());
        let (distance, [x, y]) = frame.distance_and_shift(&distances);
        // Never inside the model, even if it is viewed edge-on.
        let distance = larger(distance, distances.nearest + 0.2 * self.half_extent);

        let [right, above, back] = frame.axes();
        let at = [0, 1, 2].map(|i| self.center[i] + x * right[i] + y * above[i]);
        let from = [0, 1, 2].map(|i| at[i] + distance * back[i]);
        // Far from the origin, single precision is too coarse for the camera.
        let is_too_coarse = |x: f64| (f64::from(x as f32) - x).abs() > 0.01 * self.half_extent;
        if from.into_iter().chain(at).any(is_too_coarse) {
            return Err("the model is too small compared with its distance from the origin".into());
        }
        let projection = ProjectionDescription::Perspective(VIEW_ANGLE as f32);
        let view = CameraDescription {
            from: to_float3(from),
            at: to_float3(at),
            up: to_float3(self.up),
            projection,
        };
        match strahl_core::Camera::new(&view.to_core(), size) {
            Ok(_) => Ok(view),
            Err(fault) => Err(format!("the model is too large or too far away: {fault}")),
        }
    }
}
