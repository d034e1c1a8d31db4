//! glTF 2.0: `.gltf` with its buffers beside it or inside it, and `.glb`.
//!
//! The meshes of the file's scene, where its nodes put them: places, normals, materials.
//! Lines, points, textures, colours of corners, skins, morphing, cameras and lights are left
//! out. Read by serde and by hand: the usual crate panics on places that do not exist.
//!
//! How a surface of base colour `b`, metallic `m`, roughness `r`, opacity `a` and transmission
//! `t` becomes a material:
//!
//! | part | share |
//! |---|---|
//! | diffuse, ambient | `b (1 - m (1 - r)) (1 - t) a` |
//! | mirror | `b m (1 - r)`: polished metal is a mirror, rough metal is not |
//! | highlight | `(b m + 0.5 (1 - m)) (1 - r)`, exponent `2 / r^4 - 2` up to 10,000 |
//! | transmitted | `b t` with its index of refraction (1.5 unless the file says) and Fresnel's formulas, or `1 - a` straight on |
//!
//! One mesh may stand in many places, so a small file may make a large scene: copies together
//! may have as many corners and triangles as the files have bytes, but always 2^24.

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

/// As many corners and triangles any file may make.
const MIN_LIMIT: usize = 1 << 24;

/// Reads the bytes of the file at `path`; other files may be beside it.
pub fn read(files: &SourceFiles, path: &Path, bytes: Vec<u8>) -> Result<TriangleMesh, LoadError> {
    let wrong = |wrong| invalid(path, wrong);
    let size = bytes.len();
    let (root, binary) = split_container(bytes).map_err(wrong)?;
    if let Some(name) =
        root.extensions_required.iter().find(|name| !SUPPORTED_EXTENSIONS.contains(&name.as_str()))
    {
        return Err(wrong((None, format!("the file requires the extension {}", quoted(name)))));
    }
    Buffers::note_textures(files, path, &root);
    let buffers = Buffers::load(files, path, &root, binary)?;
    let most = size.saturating_add(buffers.bytes());
    let most = if most < MIN_LIMIT { MIN_LIMIT } else { most };
    let mut reader = GltfReader {
        root: &root,
        buffers: &buffers,
        gather: MeshBuilder::default(),
        limit: most,
        primitive_count: 0,
    };
    reader.materials().and_then(|()| reader.nodes()).map_err(|reason| wrong((None, reason)))?;
    reader.gather.finish().map_err(|reason| wrong((None, reason)))
}

/// Extensions that a file may require: without them it looks much the same.
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

/// The description and the binary part of a file of either kind.
fn split_container(bytes: Vec<u8>) -> Result<(GltfDocument, Option<Vec<u8>>), LineError> {
    if !bytes.starts_with(b"glTF") {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
        let root =
            serde_json::from_slice(text).map_err(|error| (Some(error.line().max(1)), error_text(&error)))?;
        return Ok((root, None));
    }
    let wrong = |reason: &str| (None, reason.to_owned());
    let number = |place: usize| bytes.get(place..)?.first_chunk().copied().map(u32::from_le_bytes);
    if number(4) != Some(2) {
        return Err(wrong("not version 2 of glTF"));
    }
    let length = number(8).and_then(|length| usize::try_from(length).ok());
    let whole = length.and_then(|length| bytes.get(..length));
    let whole = whole.ok_or_else(|| wrong("the file is shorter than its length in byte 8 says"))?;
    let chunk = |place: usize| {
        let length = usize::try_from(number(place)?).ok()?;
        let kind = whole.get(place + 4..place + 8)?;
        Some((kind, whole.get(place + 8..(place + 8).checked_add(length)?)?))
    };
    let Some((b"JSON", text)) = chunk(12) else {
        return Err(wrong("the first part, in byte 12, is not whole or not of the kind JSON"));
    };
    let root = serde_json::from_slice(text).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        (None, format!("line {line}, column {column} of the first part: {}", error_text(&error)))
    })?;
    // Parts are padded to multiples of four.
    let next = 20 + text.len().next_multiple_of(4);
    match chunk(next) {
        Some((b"BIN\0", binary)) => Ok((root, Some(binary.to_vec()))),
        None if next < whole.len() => Err((None, format!("the second part, in byte {next}, is not whole"))),
        _ => Ok((root, None)),
    }
}

/// What serde says, without the place, which is told elsewhere.
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

/// The file, and what has been read of it.
struct GltfReader<'r> {
    root: &'r GltfDocument,
    buffers: &'r Buffers,
    gather: MeshBuilder,
    /// How many corners, triangles and parts of copies there may be.
    limit: usize,
    primitive_count: usize,
}

impl GltfReader<'_> {
    fn materials(&mut self) -> Result<(), String> {
        for (number, material) in self.root.materials.iter().enumerate() {
            let it = convert_material(material).map_err(|reason| format!("materials[{number}]: {reason}"))?;
            let name = material.name.clone().unwrap_or_else(|| format!("material {number}"));
            if self.gather.add_material(name, it).is_none() {
                return Err("more materials than a scene can number".into());
            }
            let metallic = &material.pbr_metallic_roughness;
            let has_texture = metallic.base_color_texture.is_some()
                || metallic.metallic_roughness_texture.is_some()
                || material.normal_texture.is_some()
                || material.emissive_texture.is_some();
            if has_texture {
                self.gather.skip("materials have textures, which are left out", None);
            }
            if material.emissive_factor.as_deref().is_some_and(|e| *e != [0.0; 3]) {
                self.gather.skip("materials glow, which is left out", None);
            }
        }
        Ok(())
    }

    /// Walks the nodes of the scene, parents first, in the order of the file.
    fn nodes(&mut self) -> Result<(), String> {
        let mut seen = vec![false; self.root.nodes.len()];
        let mut open: Vec<(usize, AffineTransform)> =
            self.root_nodes()?.into_iter().rev().map(|node| (node, AffineTransform::IDENTITY)).collect();
        while let Some((number, outer)) = open.pop() {
            let node = self.root.nodes.get(number).ok_or_else(|| format!("there is no nodes[{number}]"))?;
            // Nodes are trees; a node met again could be met without end.
            if std::mem::replace(&mut seen[number], true) {
                return Err(format!("nodes[{number}]: is reached twice"));
            }
            let own = AffineTransform::of_node(node)
                .ok_or_else(|| format!("nodes[{number}]: moves by no finite numbers"))?;
            let motion = outer.compose(&own);
            open.extend(node.children.iter().rev().map(|child| (*child, motion)));
            if node.skin.is_some() {
                self.gather.skip("nodes have skins, which are left out", None);
            }
            if let Some(mesh) = node.mesh {
                let mesh_of = |error: String| format!("nodes[{number}]: {error}");
                self.mesh(mesh, &motion).map_err(mesh_of)?;
            }
        }
        Ok(())
    }

    /// The nodes that the scene begins with; of a file without scenes those without a parent.
    fn root_nodes(&self) -> Result<Vec<usize>, String> {
        let number = self.root.scene.unwrap_or(0);
        match self.root.scenes.get(number) {
            Some(scene) => Ok(scene.nodes.clone()),
            None if self.root.scene.is_some() => Err(format!("there is no scenes[{number}]")),
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
        let (corners, triangles) = (self.gather.vertex_count(), self.gather.triangle_count());
        if self.primitive_count > self.limit || corners >= self.limit || triangles >= self.limit {
            return Err(format!("more than {} corners, triangles or copies of parts", self.limit));
        }
        Ok(())
    }

    fn mesh(&mut self, number: usize, motion: &AffineTransform) -> Result<(), String> {
        let mesh = self.root.meshes.get(number).ok_or_else(|| format!("there is no meshes[{number}]"))?;
        for (part, primitive) in mesh.primitives.iter().enumerate() {
            let of_part = |error: String| format!("meshes[{number}].primitives[{part}]: {error}");
            self.primitive(primitive, motion).map_err(of_part)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &GltfPrimitive, motion: &AffineTransform) -> Result<(), String> {
        self.primitive_count += 1;
        self.check_limit()?;
        if !primitive.targets.is_empty() {
            self.gather.skip("primitives have other shapes to morph into, which are left out", None);
        }
        if primitive.attributes.color.is_some() {
            self.gather.skip("primitives have colours of corners, which are left out", None);
        }
        // Whether a triangle begins with every third corner, every one, or the first.
        let mode = primitive.mode.unwrap_or(TRIANGLES);
        match mode {
            TRIANGLES | TRIANGLE_STRIP | TRIANGLE_FAN => {}
            0..=3 => {
                self.gather.skip("primitives are points or lines and are left out", None);
                return Ok(());
            }
            other => return Err(format!("`mode` is {other}")),
        }
        let place = primitive.attributes.position.ok_or("has no POSITION")?;
        let points = self.buffers.accessor(self.root, place, &VEC3_F32)?;
        let normals = primitive.attributes.normal;
        let normals = normals.map(|place| self.buffers.accessor(self.root, place, &VEC3_F32)).transpose()?;
        let indices = primitive.indices;
        let indices =
            indices.map(|place| self.buffers.accessor(self.root, place, &SCALAR_UINT)).transpose()?;

        self.gather.set_material(match primitive.material {
            None => None,
            Some(place) if place < self.root.materials.len() => u16::try_from(place).ok(),
            Some(place) => return Err(format!("there is no materials[{place}]")),
        });
        let count = indices.as_ref().map_or(points.count, |indices| indices.count);
        let mut known: HashMap<u32, u32> = HashMap::new();
        let mut corner = |gather: &mut MeshBuilder, number: usize| -> Result<u32, String> {
            let place = match &indices {
                Some(indices) => indices.index(number).ok_or("an index is missing")?,
                None => number as u32,
            };
            if let Some(known) = known.get(&place) {
                return Ok(*known);
            }
            let no_corner = || format!("index {number} names corner {place} of {}", points.count);
            let point = motion.transform_point(points.vec3(place as usize).ok_or_else(no_corner)?);
            for number in point {
                coordinate(number).map_err(|reason| format!("corner {place}: {reason}"))?;
            }
            let normal = match &normals {
                Some(normals) => Some(
                    normals.vec3(place as usize).ok_or_else(|| format!("corner {place} has no NORMAL"))?,
                ),
                None => None,
            };
            let corner = gather.add_vertex(point, normal.map(|normal| motion.transform_normal(normal)))?;
            known.insert(place, corner);
            Ok(corner)
        };
        let triangles = if mode == TRIANGLES { count / 3 } else { count.saturating_sub(2) };
        if mode == TRIANGLES && count % 3 != 0 {
            return Err(format!("{count} corners are not three for each triangle"));
        }
        for number in 0..triangles {
            self.check_limit()?;
            // Every second triangle of a strip is turned back.
            let [a, b, c] = match mode {
                TRIANGLES => [3 * number, 3 * number + 1, 3 * number + 2],
                TRIANGLE_STRIP => [number, number + 1 + number % 2, number + 2 - number % 2],
                _ => [number + 1, number + 2, 0],
            };
            let gather = &mut self.gather;
            let [a, b, c] = [corner(gather, a)?, corner(gather, b)?, corner(gather, c)?];
            gather.add_triangle(if motion.flips_orientation() { [a, c, b] } else { [a, b, c] });
        }
        Ok(())
    }
}

const TRIANGLES: u32 = 4;
const TRIANGLE_STRIP: u32 = 5;
const TRIANGLE_FAN: u32 = 6;

/// The material that comes closest, by the table above.
fn convert_material(material: &json::GltfMaterial) -> Result<Material, String> {
    let metallic = &material.pbr_metallic_roughness;
    let transmission = material.extensions.transmission.as_ref().map_or(0.0, |t| t.transmission_factor);
    let [r, g, b, alpha] = metallic.base_color_factor;
    let (m, rough) = (metallic.metallic_factor, metallic.roughness_factor);
    if ![r, g, b, alpha, m, rough, transmission].iter().all(|x| *x >= 0.0 && *x <= 1.0) {
        return Err("a factor is not between 0 and 1".into());
    }
    let index = material.extensions.index.as_ref().and_then(|index| index.ior).unwrap_or(1.5);
    // Zero means an index without end, which no light enters.
    let index = if index == 0.0 { 100.0 } else { index };
    if !(index >= 1.0 && index <= 100.0) {
        return Err(format!("`ior` is {index}"));
    }
    let opacity = if material.alpha_mode.as_deref() == Some("BLEND") { alpha } else { 1.0 };
    let base = Rgb::new(r, g, b);
    let polish = 1.0 - rough;
    let kept = base * ((1.0 - m * polish) * (1.0 - transmission) * opacity);
    let is_glass = transmission > 0.0;
    let squared = rough * rough;
    let exponent = if squared > 0.014_14 { 2.0 / (squared * squared) - 2.0 } else { 10_000.0 };
    let transmitted = if is_glass { base * transmission } else { Rgb::gray(1.0 - opacity) };
    Ok(Material {
        ambient: kept,
        diffuse: kept,
        highlight: Rgb::gray(0.5).lerp(base, m) * polish,
        highlight_exponent: if exponent > 1e4 { 1e4 } else { exponent },
        reflection: base * (m * polish),
        transmission: transmitted,
        refractive_index: if is_glass { index } else { 1.0 },
        fresnel: if is_glass { FresnelModel::Dielectric } else { FresnelModel::Constant },
        ..Material::MATTE
    })
}
