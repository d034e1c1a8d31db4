//! A mesh file as a scene: a camera and lights that show the model well.
//!
//! Nothing is added that a ray could hit: the objects are the triangles of the file, in its
//! order. The eye looks from the front, a third of the way round to the right, from slightly
//! above, and stands as near as the picture allows while every corner is inside it with a
//! small margin. A model that lies flat is looked at from higher up.
//!
//! A warm key light from the upper left casts the shadows; a cool fill from the right and a
//! rim from behind cast none. They are bound to the view, so that every model is lit alike.
//!
//! Where a model has its front is a custom too: towards +z where y is up, towards -y where
//! z is up.

use strahl_core::{Material, Resolution, Rgb};

use super::groups::TriangleMesh;
use crate::description::{
    BackgroundDescription, CameraDescription, Float3, LightDescription, LightSourceDescription, LoadedScene,
    Located, ObjectDescription, ProjectionDescription, ShapeDescription,
};
use crate::framing::{CameraFrame, Vec3d, cross, larger, sin_cos};

/// The axis that stands upright.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// With the front towards +z.
    Y,
    /// With the front towards -y.
    Z,
}

/// From the front to the right, in degrees.
const AZIMUTH: f64 = 35.0;
/// Above the horizon, in degrees.
const ELEVATION: f64 = 22.0;
/// The same for a model that lies flat.
const FLAT_ELEVATION: f64 = 42.0;
/// What lies flat: its height, as a share of its longer side.
const FLAT_RATIO: f64 = 0.2;
/// The full vertical angle of view in degrees.
const VIEW_ANGLE: f64 = 30.0;
/// The share of the picture's half side that the model may take.
const FILL: f64 = 0.92;

/// Made of this is what has no material in the file.
const DEFAULT_MATERIAL: Material = Material {
    ambient: Rgb::new(0.72, 0.66, 0.6),
    diffuse: Rgb::new(0.72, 0.66, 0.6),
    highlight: Rgb::gray(0.12),
    highlight_exponent: 24.0,
    ..Material::MATTE
};

/// The mesh as a scene, for pictures of `size`.
pub fn with_default_view(mesh: TriangleMesh, up: UpAxis, size: Resolution) -> Result<LoadedScene, String> {
    let seen = used_vertices(&mesh);
    let frame = ModelBounds::of(&seen, up);
    let gaze = CameraFrame::new(frame.to_eye, frame.up, VIEW_ANGLE, FILL, size);
    let view = frame.view(&seen, &gaze, size)?;
    let lamp = |name: &str, to_eye: Vec3d, color: Rgb, shadows: bool| {
        let it = LightDescription {
            source: LightSourceDescription::Directional { to_light: to_float3(to_eye) },
            color,
            shadows,
        };
        Located { value: it, line: 0, name: Some(name.into()) }
    };
    let [right, above, back] = gaze.axes();
    let mix = |r: f64, a: f64, b: f64| [0, 1, 2].map(|i| r * right[i] + a * above[i] + b * back[i]);
    let lights = vec![
        lamp("key", mix(-0.75, 0.8, 0.42), Rgb::new(1.0, 0.9, 0.76), true),
        lamp("fill", mix(0.95, 0.15, 0.3), Rgb::new(0.1, 0.14, 0.22), false),
        lamp("rim", mix(0.4, 0.3, -0.9), Rgb::new(0.3, 0.32, 0.35), false),
    ];

    let mut materials: Vec<_> = mesh
        .materials
        .into_iter()
        .map(|(name, it)| Located { value: it, line: 0, name: Some(name) })
        .collect();
    let has_nameless = mesh.groups.iter().any(|group| group.material.is_none());
    let clay = u16::try_from(materials.len()).map_err(|_| "more materials than a scene can number")?;
    if has_nameless {
        materials.push(Located { value: DEFAULT_MATERIAL, line: 0, name: None });
    }
    let smooth = !mesh.normals.is_empty();
    let mut first = 0;
    let objects = mesh.groups.iter().map(|group| {
        let form = ShapeDescription::Mesh { first, count: group.count, smooth };
        first += group.count;
        ObjectDescription { shape: form, material: group.material.unwrap_or(clay), line: 0 }
    });
    Ok(LoadedScene {
        background: BackgroundDescription::Gradient {
            up: to_float3(frame.up),
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

/// The corners of all triangles, each once: a file may have others, which nobody sees.
fn used_vertices(mesh: &TriangleMesh) -> Vec<Vec3d> {
    let mut is_seen = vec![false; mesh.vertices.len()];
    mesh.triangles.as_flattened().iter().for_each(|corner| is_seen[*corner as usize] = true);
    let seen = mesh.vertices.iter().zip(is_seen).filter(|(_, is_seen)| *is_seen);
    seen.map(|(point, _)| point.map(f64::from)).collect()
}

fn to_float3(v: Vec3d) -> Float3 {
    v.map(|x| x as f32)
}

/// Where the model is, and from where it is looked at.
struct ModelBounds {
    up: Vec3d,
    /// From the model to the eye, of length one.
    to_eye: Vec3d,
    center: Vec3d,
    /// Half of the longest side.
    half_extent: f64,
}

impl ModelBounds {
    fn of(seen: &[Vec3d], up: UpAxis) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in seen {
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
        let to_eye = [0, 1, 2].map(|i| cos * level[i] + sin * up[i]);
        let center = [0, 1, 2].map(|i| 0.5 * (low[i] + high[i]));
        ModelBounds { up, to_eye: to_eye, center: center, half_extent: 0.5 * longest(&sides) }
    }

    /// The nearest view that has every corner inside the picture.
    fn view(
        &self,
        seen: &[Vec3d],
        gaze: &CameraFrame,
        size: Resolution,
    ) -> Result<CameraDescription, String> {
        if self.half_extent == 0.0 {
            return Err("all corners are in the same place, so there is nothing to look at".into());
        }
        let demands = gaze.edge_distances(self.center, seen.iter().copied());
        let (distance, [x, y]) = gaze.distance_and_shift(&demands);
        // Never inside the model, however flat it is seen.
        let distance = larger(distance, demands.nearest + 0.2 * self.half_extent);

        let [right, above, back] = gaze.axes();
        let at = [0, 1, 2].map(|i| self.center[i] + x * right[i] + y * above[i]);
        let from = [0, 1, 2].map(|i| at[i] + distance * back[i]);
        // Far from zero the eye and the corners stand on a coarse raster.
        let is_lost = |x: f64| (f64::from(x as f32) - x).abs() > 0.01 * self.half_extent;
        if from.into_iter().chain(at).any(is_lost) {
            return Err("the model is too small for its distance from zero".into());
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
