//! glTF 2.0: `.gltf` with external or embedded buffers, and `.glb`.
//!
//! The meshes of the file's scene are read with their node transforms: positions, normals and materials. Lines, points,
//! textures, vertex colors, skins, morph targets, cameras and lights are skipped. The crate `gltf` is not used: it
//! panics on indices that do not exist.
//!
//! A surface of base color `b`, metallic `m`, roughness `r`, opacity `a` and transmission `t` is converted to a
//! material:
//!
//! | component | value |
//! |---|---|
//! | diffuse, ambient | `b (1 - m (1 - r)) (1 - t) a` |
//! | mirror | `b m (1 - r)`: polished metal is a mirror, rough metal is not |
//! | highlight | `(b m + 0.5 (1 - m)) (1 - r)`, exponent `2 / r^4 - 2` up to 10,000 |
//! | transmitted | `b t` with the index of refraction (default 1.5) and the Fresnel equations, or `1 - a` without refraction |
//!
//! A mesh can be instantiated many times, so a small file can make a large scene: all instances together may have as many
//! vertices and triangles as the files have bytes, and at least 2^24.

mod buffers;
mod json;
mod transform;

use std::collections::HashMap;
use std::path::Path;

use strahl_core::scene::FresnelModel;
use strahl_core::{Material, Rgb};

use super::builder::{MeshBuilder, coordinate};
use super::error::{LineError, invalid};
use super::groups::TriangleMesh;
use crate::error::LoadError;
use crate::quote::quoted;
use crate::source_files::SourceFiles;
use buffers::{Buffers, SCALAR_UINT, VEC3_F32};
use json::{GltfDocument, GltfPrimitive};
use transform::AffineTransform;

/// The limit of vertices, triangles and primitives for small files.
const MIN_LIMIT: usize = 1 << 24;

/// Reads the bytes of the file at `path`; paths of buffers are relative to it.
pub fn read(files: &SourceFiles, path: &Path, bytes: Vec<u8>) -> Result<TriangleMesh, LoadError> {
    let in_file = |error| invalid(path, error);
    let size = bytes.len();
    let (root, binary) = split_container(bytes).map_err(in_file)?;
    if let Some(name) =
        root.extensions_required.iter().find(|name| !SUPPORTED_EXTENSIONS.contains(&name.as_str()))
    {
        return Err(in_file((None, format!("the file requires the unsupported extension {}", quoted(name)))));
    }
    Buffers::note_textures(files, path, &root);
    let buffers = Buffers::load(files, path, &root, binary)?;
    let most = size.saturating_add(buffers.bytes());
    let most = if most < MIN_LIMIT { MIN_LIMIT } else { most };
    let mut reader = GltfReader {
        root: &root,
        buffers: &buffers,
        builder: MeshBuilder::default(),
        limit: most,
        primitive_count: 0,
    };
    reader.materials().and_then(|()| reader.nodes()).map_err(|reason| in_file((None, reason)))?;
    reader.builder.finish().map_err(|reason| in_file((None, reason)))
}

/// Extensions that a file may require: they are supported, or ignoring them changes little.
const SUPPORTED_EXTENSIONS: [&str; 8] = [
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_emissive_strength",
    "KHR_materials_specular",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_lights_punctual",
    "KHR_texture_transform",
];

/// The JSON document and the binary chunk of a `.gltf` or `.glb` file.
fn split_container(bytes: Vec<u8>) -> Result<(GltfDocument, Option<Vec<u8>>), LineError> {
    if !bytes.starts_with(b"glTF") {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
        let root =
            serde_json::from_slice(text).map_err(|error| (Some(error.line().max(1)), error_text(&error)))?;
        return Ok((root, None));
    }
    let error = |reason: &str| (None, reason.to_owned());
    let number = |offset: usize| bytes.get(offset..)?.first_chunk().copied().map(u32::from_le_bytes);
    if number(4) != Some(2) {
        return Err(error("not glTF version 2"));
    }
    let length = number(8).and_then(|length| usize::try_from(length).ok());
    let whole = length.and_then(|length| bytes.get(..length));
    let whole = whole.ok_or_else(|| error("the file is shorter than the length in its header"))?;
    let chunk = |offset: usize| {
        let length = usize::try_from(number(offset)?).ok()?;
        let kind = whole.get(offset + 4..offset + 8)?;
        Some((kind, whole.get(offset + 8..(offset + 8).checked_add(length)?)?))
    };
    let Some((b"JSON", text)) = chunk(12) else {
        return Err(error("the first chunk, at byte 12, is incomplete or not JSON"));
    };
    let root = serde_json::from_slice(text).map_err(|e| {
        let (line, column) = (e.line(), e.column());
        (None, format!("line {line}, column {column} of the JSON chunk: {}", error_text(&e)))
    })?;
    // Chunks are padded to multiples of four bytes.
    let next = 20 + text.len().next_multiple_of(4);
    match chunk(next) {
        Some((b"BIN\0", binary)) => Ok((root, Some(binary.to_vec()))),
        None if next < whole.len() => Err((None, format!("the second chunk, at byte {next}, is incomplete"))),
        _ => Ok((root, None)),
    }
}

/// The message of a serde error without its location, which is reported separately.
fn error_text(error: &serde_json::Error) -> String {
    let reason = error.to_string();
    let reason = reason.rsplit_once(" at line ").map_or(reason.as_str(), |(reason, _)| reason);
    let mut text: String =
        reason.chars().take(120).flat_map(|c| if c.is_control() { None } else { Some(c) }).collect();
    if reason.chars().nth(120).is_some() {
        text.push('…');
    }
    text
}

/// The state of reading a file.
struct GltfReader<'r> {
    root: &'r GltfDocument,
    buffers: &'r Buffers,
    builder: MeshBuilder,
    /// The maximum number of vertices, of triangles and of primitives.
    limit: usize,
    primitive_count: usize,
}

impl GltfReader<'_> {
    fn materials(&mut self) -> Result<(), String> {
        for (number, material) in self.root.materials.iter().enumerate() {
            let it = convert_material(material).map_err(|reason| format!("materials[{number}]: {reason}"))?;
            let name = material.name.clone().unwrap_or_else(|| format!("material {number}"));
            if self.builder.add_material(name, it).is_none() {
                return Err("too many materials".into());
            }
            let metallic = &material.pbr_metallic_roughness;
            let has_texture = metallic.base_color_texture.is_some()
                || metallic.metallic_roughness_texture.is_some()
                || material.normal_texture.is_some()
                || material.emissive_texture.is_some();
            if has_texture {
                self.builder.skip("textures are ignored", None);
            }
            if material.emissive_factor.as_deref().is_some_and(|e| *e != [0.0; 3]) {
                self.builder.skip("emission is ignored", None);
            }
        }
        Ok(())
    }

    /// Visits the nodes of the scene, parents first, in the order of the file.
    fn nodes(&mut self) -> Result<(), String> {
        let mut visited = vec![false; self.root.nodes.len()];
        let mut open: Vec<(usize, AffineTransform)> =
            self.root_nodes()?.into_iter().rev().map(|node| (node, AffineTransform::IDENTITY)).collect();
        while let Some((number, outer)) = open.pop() {
            let node =
                self.root.nodes.get(number).ok_or_else(|| format!("nodes[{number}] does not exist"))?;
            // Nodes must form trees; a cycle would not end.
            if std::mem::replace(&mut visited[number], true) {
                return Err(format!("nodes[{number}] has two parents"));
            }
            let own = AffineTransform::of_node(node)
                .ok_or_else(|| format!("nodes[{number}]: the transform is not finite"))?;
            let transform = outer.compose(&own);
            open.extend(node.children.iter().rev().map(|child| (*child, transform)));
            if node.skin.is_some() {
                self.builder.skip("skins are ignored", None);
            }
            if let Some(mesh) = node.mesh {
                let mesh_of = |error: String| format!("nodes[{number}]: {error}");
                self.mesh(mesh, &transform).map_err(mesh_of)?;
            }
        }
        Ok(())
    }

    /// The root nodes of the scene; in a file without scenes, all nodes without a parent.
    fn root_nodes(&self) -> Result<Vec<usize>, String> {
        let number = self.root.scene.unwrap_or(0);
        match self.root.scenes.get(number) {
            Some(scene) => Ok(scene.nodes.clone()),
            None if self.root.scene.is_some() => Err(format!("scenes[{number}] does not exist")),
            None => {
                let mut is_child = vec![false; self.root.nodes.len()];
                for child in self.root.nodes.iter().flat_map(|node| &node.children) {
                    if let Some(is_child) = is_child.get_mut(*child) {
                        *is_child = true;
                    }
                }
                Ok((0..is_child.len()).filter(|node| !is_child[*node]).collect())
            }
        }
    }

    fn check_limit(&self) -> Result<(), String> {
        let (vertices, triangles) = (self.builder.vertex_count(), self.builder.triangle_count());
        if self.primitive_count > self.limit || vertices >= self.limit || triangles >= self.limit {
            return Err(format!("more than {} vertices, triangles or primitives", self.limit));
        }
        Ok(())
    }

    fn mesh(&mut self, number: usize, transform: &AffineTransform) -> Result<(), String> {
        let mesh = self.root.meshes.get(number).ok_or_else(|| format!("meshes[{number}] does not exist"))?;
        for (part, primitive) in mesh.primitives.iter().enumerate() {
            let of_part = |error: String| format!("meshes[{number}].primitives[{part}]: {error}");
            self.primitive(primitive, transform).map_err(of_part)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &GltfPrimitive, transform: &AffineTransform) -> Result<(), String> {
        self.primitive_count += 1;
        self.check_limit()?;
        if !primitive.targets.is_empty() {
            self.builder.skip("morph targets are ignored", None);
        }
        if primitive.attributes.color.is_some() {
            self.builder.skip("vertex colors are ignored", None);
        }
        // Triangles, strips and fans.
        let mode = primitive.mode.unwrap_or(TRIANGLES);
        match mode {
            TRIANGLES | TRIANGLE_STRIP | TRIANGLE_FAN => {}
            0..=3 => {
                self.builder.skip("point and line primitives are skipped", None);
                return Ok(());
            }
            other => return Err(format!("`mode` is {other}")),
        }
        let index = primitive.attributes.position.ok_or("has no POSITION")?;
        let points = self.buffers.accessor(self.root, index, &VEC3_F32)?;
        let normals = primitive.attributes.normal;
        let normals = normals.map(|index| self.buffers.accessor(self.root, index, &VEC3_F32)).transpose()?;
        let indices = primitive.indices;
        let indices =
            indices.map(|index| self.buffers.accessor(self.root, index, &SCALAR_UINT)).transpose()?;

        self.builder.set_material(match primitive.material {
            None => None,
            Some(index) if index < self.root.materials.len() => u16::try_from(index).ok(),
            Some(index) => return Err(format!("materials[{index}] does not exist")),
        });
        let count = indices.as_ref().map_or(points.count, |indices| indices.count);
        let mut vertex_of: HashMap<u32, u32> = HashMap::new();
        let mut vertex = |builder: &mut MeshBuilder, number: usize| -> Result<u32, String> {
            let index = match &indices {
                Some(indices) => indices.index(number).ok_or("an index is out of range")?,
                None => number as u32,
            };
            if let Some(vertex) = vertex_of.get(&index) {
                return Ok(*vertex);
            }
            let out_of_range =
                || format!("index {number} refers to vertex {index}, but there are {}", points.count);
            let point = transform.transform_point(points.vec3(index as usize).ok_or_else(out_of_range)?);
            for number in point {
                coordinate(number).map_err(|reason| format!("vertex {index}: {reason}"))?;
            }
            let normal = match &normals {
                Some(normals) => Some(
                    normals.vec3(index as usize).ok_or_else(|| format!("vertex {index} has no NORMAL"))?,
                ),
                None => None,
            };
            let vertex =
                builder.add_vertex(point, normal.map(|normal| transform.transform_normal(normal)))?;
            vertex_of.insert(index, vertex);
            Ok(vertex)
        };
        let triangles = if mode == TRIANGLES { count / 3 } else { count.saturating_sub(2) };
        if mode == TRIANGLES && count % 3 != 0 {
            return Err(format!("{count} vertices are not a multiple of 3"));
        }
        for number in 0..triangles {
            self.check_limit()?;
            // Every second triangle of a strip is reversed.
            let [a, b, c] = match mode {
                TRIANGLES => [3 * number, 3 * number + 1, 3 * number + 2],
                TRIANGLE_STRIP => [number, number + 1 + number % 2, number + 2 - number % 2],
                _ => [number + 1, number + 2, 0],
            };
            let builder = &mut self.builder;
            let [a, b, c] = [vertex(builder, a)?, vertex(builder, b)?, vertex(builder, c)?];
            builder.add_triangle(if transform.flips_orientation() { [a, c, b] } else { [a, b, c] });
        }
        Ok(())
    }
}

const TRIANGLES: u32 = 4;
const TRIANGLE_STRIP: u32 = 5;
const TRIANGLE_FAN: u32 = 6;

/// The closest material, by the table above.
fn convert_material(material: &json::GltfMaterial) -> Result<Material, String> {
    let metallic = &material.pbr_metallic_roughness;
    let transmission = material.extensions.transmission.as_ref().map_or(0.0, |t| t.transmission_factor);
    let [r, g, b, alpha] = metallic.base_color_factor;
    let (m, rough) = (metallic.metallic_factor, metallic.roughness_factor);
    if ![r, g, b, alpha, m, rough, transmission].iter().all(|x| *x >= 0.0 && *x <= 1.0) {
        return Err("a factor is outside 0 to 1".into());
    }
    let index = material.extensions.index.as_ref().and_then(|index| index.ior).unwrap_or(1.5);
    // Zero means an infinite index, which light cannot enter.
    let index = if index == 0.0 { 100.0 } else { index };
    if !(index >= 1.0 && index <= 100.0) {
        return Err(format!("`ior` is {index}"));
    }
    let opacity = if material.alpha_mode.as_deref() == Some("BLEND") { alpha } else { 1.0 };
    let base = Rgb::new(r, g, b);
    let polish = 1.0 - rough;
    let diffuse = base * ((1.0 - m * polish) * (1.0 - transmission) * opacity);
    let is_glass = transmission > 0.0;
    let squared = rough * rough;
    let exponent = if squared > 0.014_14 { 2.0 / (squared * squared) - 2.0 } else { 10_000.0 };
    let transmitted = if is_glass { base * transmission } else { Rgb::gray(1.0 - opacity) };
    Ok(Material {
        ambient: diffuse,
        diffuse,
        highlight: Rgb::gray(0.5).lerp(base, m) * polish,
        highlight_exponent: if exponent > 1e4 { 1e4 } else { exponent },
        reflection: base * (m * polish),
        transmission: transmitted,
        refractive_index: if is_glass { index } else { 1.0 },
        fresnel: if is_glass { FresnelModel::Dielectric } else { FresnelModel::None },
        ..Material::MATTE
    })
}
