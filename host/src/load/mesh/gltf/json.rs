//! The words of a glTF file that a mesh has a use for; serde reads over all others.

use serde::Deserialize;

/// A whole file.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[derive(Default)]
pub(super) struct Root {
    pub(super) extensions_required: Vec<String>,
    pub(super) scene: Option<usize>,
    pub(super) scenes: Vec<Scene>,
    pub(super) nodes: Vec<Node>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) materials: Vec<Material>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) buffer_views: Vec<View>,
    pub(super) buffers: Vec<Buffer>,
    pub(super) images: Vec<Image>,
}

/// What is shown together.
#[derive(Deserialize)]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<usize>,
}

/// A thing with its place, and the things that move with it.
#[derive(Deserialize)]
pub(super) struct Node {
    #[serde(default)]
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    pub(super) skin: Option<serde::de::IgnoredAny>,
    /// Column by column. Boxed, as all of these: in the file a node may be two bytes.
    pub(super) matrix: Option<Box<[f64; 16]>>,
    pub(super) translation: Option<Box<[f64; 3]>>,
    pub(super) rotation: Option<Box<[f64; 4]>>,
    pub(super) scale: Option<Box<[f64; 3]>>,
}

/// Parts that belong together.
#[derive(Deserialize)]
pub(super) struct Mesh {
    pub(super) primitives: Vec<Primitive>,
}

/// Triangles of one material.
#[derive(Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    pub(super) material: Option<usize>,
    pub(super) mode: Option<u32>,
    #[serde(default)]
    pub(super) targets: Vec<serde::de::IgnoredAny>,
}

/// What corners have: places of accessors.
#[derive(Deserialize)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub(super) normal: Option<usize>,
    #[serde(rename = "COLOR_0")]
    pub(super) color: Option<serde::de::IgnoredAny>,
}

/// Numbers of one kind, in a view.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u32,
    pub(super) count: u64,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) sparse: Option<serde::de::IgnoredAny>,
}

/// A piece of a buffer.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct View {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) byte_length: u64,
    pub(super) byte_stride: Option<u64>,
}

/// Bytes: in a file, in the text, or in the second part of a `.glb`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub(super) byte_length: u64,
    pub(super) uri: Option<String>,
}

/// A texture: in a file, in the text, or in a view.
#[derive(Deserialize)]
pub(super) struct Image {
    pub(super) uri: Option<String>,
}

/// How a surface looks.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Material {
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) pbr_metallic_roughness: Metallic,
    pub(super) normal_texture: Option<serde::de::IgnoredAny>,
    pub(super) emissive_texture: Option<serde::de::IgnoredAny>,
    pub(super) emissive_factor: Option<Box<[f32; 3]>>,
    pub(super) alpha_mode: Option<String>,
    #[serde(default)]
    pub(super) extensions: Extensions,
}

/// The usual model of a surface.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Metallic {
    pub(super) base_color_factor: [f32; 4],
    pub(super) metallic_factor: f32,
    pub(super) roughness_factor: f32,
    pub(super) base_color_texture: Option<serde::de::IgnoredAny>,
    pub(super) metallic_roughness_texture: Option<serde::de::IgnoredAny>,
}

impl Default for Metallic {
    fn default() -> Self {
        Metallic {
            base_color_factor: [1.0; 4],
            metallic_factor: 1.0,
            roughness_factor: 1.0,
            base_color_texture: None,
            metallic_roughness_texture: None,
        }
    }
}

/// Extensions that say something of glass.
#[derive(Default, Deserialize)]
pub(super) struct Extensions {
    #[serde(rename = "KHR_materials_ior")]
    pub(super) index: Option<Index>,
    #[serde(rename = "KHR_materials_transmission")]
    pub(super) transmission: Option<Transmission>,
}

/// Of refraction.
#[derive(Deserialize)]
pub(super) struct Index {
    pub(super) ior: Option<f32>,
}

/// Of light through a surface.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Transmission {
    #[serde(default)]
    pub(super) transmission_factor: f32,
}
