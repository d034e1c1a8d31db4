//! A loaded scene in plain numbers, independent of the file format and of the precision of the core.
//!
//! All numbers are rounded to single precision here, so that single and double precision render the same scene.
//! Nothing is derived: directions have any length, angles are in degrees, a cone is given by two circles, a polygon by
//! its vertices.
//!
//! | module | contents |
//! |---|---|
//! | `camera` | the camera and its projection |
//! | `float3` | points and directions as numbers |
//! | `light` | lights and the background |
//! | `texture` | textures; materials are those of the core |
//! | `object` | objects: shape, material and motion |

mod camera;
mod float3;
mod light;
mod object;
mod texture;

pub use camera::{CameraDescription, ProjectionDescription};
pub use float3::Float3;
pub(crate) use float3::vec3_of;
pub use light::{BackgroundDescription, LightDescription, LightSourceDescription};
pub use object::{LinearMotion, ObjectDescription, ShapeDescription};
pub use texture::TextureDescription;

use std::collections::BTreeMap;

use strahl_core::{Material, Rgb};
use strahl_settings::SettingsOverrides;

/// The default shutter times: open from 0 to 1.
pub const DEFAULT_SHUTTER: [f32; 2] = [0.0, 1.0];

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
