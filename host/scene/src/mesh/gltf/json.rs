//! The properties of a glTF file that are used; serde skips all others.

use serde::Deserialize;

/// The whole document.
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

/// A scene: its root nodes.
#[derive(Deserialize)]
pub struct GltfScene {
    #[serde(default)]
    pub nodes: Vec<usize>,
}

/// A node: a transform, a mesh and child nodes.
#[derive(Deserialize)]
pub struct GltfNode {
    #[serde(default)]
    pub children: Vec<usize>,
    pub mesh: Option<usize>,
    pub skin: Option<serde::de::IgnoredAny>,
    /// In column-major order. Boxed, like the next ones, because a node may take as little as two bytes in the file.
    pub matrix: Option<Box<[f64; 16]>>,
    pub translation: Option<Box<[f64; 3]>>,
    pub rotation: Option<Box<[f64; 4]>>,
    pub scale: Option<Box<[f64; 3]>>,
}

/// A mesh.
#[derive(Deserialize)]
pub struct GltfMesh {
    pub primitives: Vec<GltfPrimitive>,
}

/// A primitive: triangles of one material.
#[derive(Deserialize)]
pub struct GltfPrimitive {
    pub attributes: GltfAttributes,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    pub mode: Option<u32>,
    #[serde(default)]
    pub targets: Vec<serde::de::IgnoredAny>,
}

/// The vertex attributes: indices of accessors.
#[derive(Deserialize)]
pub struct GltfAttributes {
    #[serde(rename = "POSITION")]
    pub position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub normal: Option<usize>,
    #[serde(rename = "COLOR_0")]
    pub color: Option<serde::de::IgnoredAny>,
}

/// An accessor: typed elements in a buffer view.
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

/// A byte range of a buffer.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct GltfBufferView {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: u64,
    pub byte_length: u64,
    pub byte_stride: Option<u64>,
}

/// A buffer: in a file, in a data URI, or in the binary chunk of a `.glb`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct GltfBuffer {
    pub byte_length: u64,
    pub uri: Option<String>,
}

/// An image of a texture.
#[derive(Deserialize)]
pub struct GltfImage {
    pub uri: Option<String>,
}

/// A material.
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

/// The metallic-roughness material model.
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

/// Extensions for transparent materials.
#[derive(Default, Deserialize)]
pub struct MaterialExtensions {
    #[serde(rename = "KHR_materials_ior")]
    pub index: Option<KhrIor>,
    #[serde(rename = "KHR_materials_transmission")]
    pub transmission: Option<KhrTransmission>,
}

/// KHR_materials_ior.
#[derive(Deserialize)]
pub struct KhrIor {
    pub ior: Option<f32>,
}

/// KHR_materials_transmission.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct KhrTransmission {
    #[serde(default)]
    pub transmission_factor: f32,
}
