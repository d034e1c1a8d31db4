//! The words of a glTF file that a mesh has a use for; serde reads over all others.

use serde::Deserialize;

/// A whole file.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[derive(Default)]
pub struct GltfDocument {
    pub extensions_required: Vec<String>,
    pub scene: Option<usize>,
    pub scenes: Vec<GltfScene>,
    pub nodes: Vec<GltfNode>,
    pub meshes: Vec<GltfMesh>,
    pub materials: Vec<GltfMaterial>,
    pub accessors: Vec<GltfAccessor>,
    pub buffer_views: Vec<GltfBufferView>,
    pub buffers: Vec<GltfBuffer>,
    pub images: Vec<GltfImage>,
}

/// What is shown together.
#[derive(Deserialize)]
pub struct GltfScene {
    #[serde(default)]
    pub nodes: Vec<usize>,
}

/// A thing with its place, and the things that move with it.
#[derive(Deserialize)]
pub struct GltfNode {
    #[serde(default)]
    pub children: Vec<usize>,
    pub mesh: Option<usize>,
    pub skin: Option<serde::de::IgnoredAny>,
    /// Column by column. Boxed, as all of these: in the file a node may be two bytes.
    pub matrix: Option<Box<[f64; 16]>>,
    pub translation: Option<Box<[f64; 3]>>,
    pub rotation: Option<Box<[f64; 4]>>,
    pub scale: Option<Box<[f64; 3]>>,
}

/// Parts that belong together.
#[derive(Deserialize)]
pub struct GltfMesh {
    pub primitives: Vec<GltfPrimitive>,
}

/// Triangles of one material.
#[derive(Deserialize)]
pub struct GltfPrimitive {
    pub attributes: GltfAttributes,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    pub mode: Option<u32>,
    #[serde(default)]
    pub targets: Vec<serde::de::IgnoredAny>,
}

/// What corners have: places of accessors.
#[derive(Deserialize)]
pub struct GltfAttributes {
    #[serde(rename = "POSITION")]
    pub position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub normal: Option<usize>,
    #[serde(rename = "COLOR_0")]
    pub color: Option<serde::de::IgnoredAny>,
}

/// Numbers of one kind, in a view.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct GltfAccessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: u64,
    pub component_type: u32,
    pub count: u64,
    #[serde(rename = "type")]
    pub kind: String,
    pub sparse: Option<serde::de::IgnoredAny>,
}

/// A piece of a buffer.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct GltfBufferView {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: u64,
    pub byte_length: u64,
    pub byte_stride: Option<u64>,
}

/// Bytes: in a file, in the text, or in the second part of a `.glb`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct GltfBuffer {
    pub byte_length: u64,
    pub uri: Option<String>,
}

/// A texture: in a file, in the text, or in a view.
#[derive(Deserialize)]
pub struct GltfImage {
    pub uri: Option<String>,
}

/// How a surface looks.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct GltfMaterial {
    pub name: Option<String>,
    #[serde(default)]
    pub pbr_metallic_roughness: PbrMetallicRoughness,
    pub normal_texture: Option<serde::de::IgnoredAny>,
    pub emissive_texture: Option<serde::de::IgnoredAny>,
    pub emissive_factor: Option<Box<[f32; 3]>>,
    pub alpha_mode: Option<String>,
    #[serde(default)]
    pub extensions: MaterialExtensions,
}

/// The usual model of a surface.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct PbrMetallicRoughness {
    pub base_color_factor: [f32; 4],
    pub metallic_factor: f32,
    pub roughness_factor: f32,
    pub base_color_texture: Option<serde::de::IgnoredAny>,
    pub metallic_roughness_texture: Option<serde::de::IgnoredAny>,
}

impl Default for PbrMetallicRoughness {
    fn default() -> Self {
        PbrMetallicRoughness {
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
pub struct MaterialExtensions {
    #[serde(rename = "KHR_materials_ior")]
    pub index: Option<KhrIor>,
    #[serde(rename = "KHR_materials_transmission")]
    pub transmission: Option<KhrTransmission>,
}

/// Of refraction.
#[derive(Deserialize)]
pub struct KhrIor {
    pub ior: Option<f32>,
}

/// Of light through a surface.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct KhrTransmission {
    #[serde(default)]
    pub transmission_factor: f32,
}
