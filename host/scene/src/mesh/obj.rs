//! OBJ, the Wavefront object format: `v vn f usemtl mtllib`.
//!
//! The format has no strict definition, so unknown keywords are ignored with a warning, while known ones are checked.
//! The crate `tobj` is not used: it reports no lines for errors, and mixes up normals in faces in which only some
//! vertices have one.
//!
//! * Vertices with the same position and normal are shared, in the order of their first use.
//! * Texture coordinates, vertex colors, weights, group names and smoothing groups are ignored.
//! * A material can be used before the `mtllib` line of its library.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use super::builder::{MeshBuilder, coordinate};
use super::error::{LineError, invalid};
use super::groups::TriangleMesh;
use super::lines::{LogicalLine, lines, text_of};
use super::mtl;
use crate::description::Float3;
use crate::error::LoadError;
use crate::quote::quoted;
use crate::source_files::SourceFiles;

/// Reads the bytes of the file at `path`; paths of material libraries are relative to it.
pub fn read(files: &SourceFiles, path: &Path, bytes: &[u8]) -> Result<TriangleMesh, LoadError> {
    let in_file = |error| invalid(path, error);
    let text = text_of(bytes).map_err(in_file)?;
    let mut reader = ObjReader::default();
    // Libraries first: some writers name them after the first use of their materials.
    for line in lines(&text).filter(|line| line.keyword == "mtllib") {
        reader.library(files, path.parent().unwrap_or(Path::new("")), line)?;
    }
    for line in lines(&text) {
        reader.line(line).map_err(in_file)?;
    }
    reader.builder.finish().map_err(|reason| in_file((None, reason)))
}

/// The normal index of a vertex without a normal.
const NO_NORMAL: u32 = u32::MAX;

/// The state of reading a file.
#[derive(Default)]
struct ObjReader {
    builder: MeshBuilder,
    points: Vec<Float3>,
    normals: Vec<Float3>,
    /// The vertex with this position index and this normal index.
    vertex_of: HashMap<(u32, u32), u32>,
    materials: HashMap<String, u16>,
    libraries: HashSet<String>,
}

impl ObjReader {
    fn line(&mut self, line: LogicalLine<'_>) -> Result<(), LineError> {
        match line.keyword {
            "v" => self.position(line)?,
            "vn" => {
                let normal = line.numbers("a normal")?;
                self.normals.push(normal);
            }
            "f" | "fo" => self.face(line)?,
            "usemtl" => self.material(line),
            "vt" | "vp" | "o" | "g" | "s" | "mg" | "mtllib" => {}
            "l" | "p" => self.builder.skip("lines and points are skipped", Some(line.number)),
            other => {
                let what = format!("unknown keyword {} is ignored", quoted(other));
                self.builder.skip(&what, Some(line.number));
            }
        }
        Ok(())
    }

    fn position(&mut self, line: LogicalLine<'_>) -> Result<(), LineError> {
        let mut point = line.numbers("a vertex")?;
        for number in &mut point {
            *number = coordinate(*number).or_else(|reason| line.error(reason))?;
        }
        // A fourth number is a weight, which only curves use.
        if line.words().count() > 4 {
            self.builder.skip("vertex colors are ignored", Some(line.number));
        }
        self.points.push(point);
        Ok(())
    }

    fn face(&mut self, line: LogicalLine<'_>) -> Result<(), LineError> {
        let mut face = self.builder.take_face_buffer();
        for word in line.words() {
            face.push(self.vertex(word, line)?);
        }
        self.builder.add_polygon(&face, Some(line.number));
        self.builder.return_face_buffer(face);
        Ok(())
    }

    /// The vertex of a word such as `1`, `1/2`, `1//3` or `1/2/3`.
    fn vertex(&mut self, word: &str, line: LogicalLine<'_>) -> Result<u32, LineError> {
        let mut parts = word.split('/');
        let point = parts.next().unwrap_or_default();
        let texture = parts.next().unwrap_or_default();
        let normal = parts.next().unwrap_or_default();
        if parts.next().is_some() || (!texture.is_empty() && texture.parse::<i64>().is_err()) {
            return line.error(format!("{} is not a face vertex", quoted(word)));
        }
        let point = resolve_index(point, self.points.len(), "vertex", word, line)?;
        let normal = match normal {
            "" => NO_NORMAL,
            _ => resolve_index(normal, self.normals.len(), "normal", word, line)?,
        };
        if let Some(vertex) = self.vertex_of.get(&(point, normal)) {
            return Ok(*vertex);
        }
        let direction = self.normals.get(normal as usize).copied();
        let corner = self.builder.add_vertex(self.points[point as usize], direction);
        let corner = corner.or_else(|reason| line.error(reason))?;
        self.vertex_of.insert((point, normal), corner);
        Ok(corner)
    }

    fn material(&mut self, line: LogicalLine<'_>) {
        let material = self.materials.get(line.rest).copied();
        if material.is_none() && !self.materials.is_empty() {
            let what = format!("material {} is not in any library", quoted(line.rest));
            self.builder.skip(&what, Some(line.number));
        }
        self.builder.set_material(material);
    }

    /// Reads one library, whose name may contain spaces, or several, whose names do not.
    fn library(
        &mut self,
        files: &SourceFiles,
        folder: &Path,
        line: LogicalLine<'_>,
    ) -> Result<(), LoadError> {
        if !self.libraries.insert(line.rest.to_owned()) {
            return Ok(());
        }
        if let Ok(bytes) = files.read_referenced(&folder.join(line.rest)) {
            return self.one_library(files, &folder.join(line.rest), &bytes);
        }
        for name in line.words() {
            if name == line.rest || self.libraries.insert(name.to_owned()) {
                let path = folder.join(name);
                match files.read_referenced(&path) {
                    Ok(bytes) => self.one_library(files, &path, &bytes)?,
                    Err(error) => {
                        let (name, line) = (quoted(name), line.number);
                        let what = format!("cannot read material library {name} (line {line}): {error}");
                        self.builder.warn(what);
                    }
                }
            }
        }
        Ok(())
    }

    fn one_library(&mut self, files: &SourceFiles, path: &Path, bytes: &[u8]) -> Result<(), LoadError> {
        let in_file = |error| invalid(path, error);
        let mtl::MtlLibrary { materials, textures } = mtl::read(bytes, &mut self.builder).map_err(in_file)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        textures.iter().for_each(|name| files.note_path(folder.join(name)));
        for material in materials {
            let Some(index) = self.builder.add_material(material.name.clone(), material.material) else {
                return Err(in_file((Some(material.line), "too many materials".into())));
            };
            // The first of two materials with the same name is used.
            self.materials.entry(material.name).or_insert(index);
        }
        Ok(())
    }
}

/// Resolves an index, which counts from 1, or back from the end if negative.
fn resolve_index(
    index: &str,
    count: usize,
    what: &str,
    word: &str,
    line: LogicalLine<'_>,
) -> Result<u32, LineError> {
    let Ok(index) = index.parse::<i64>() else {
        return line.error(format!("{} is not a face vertex", quoted(word)));
    };
    let position = if index < 0 { count as i64 + index } else { index - 1 };
    match u32::try_from(position) {
        Ok(position) if (position as usize) < count => Ok(position),
        _ => line.error(format!("{what} {index} does not exist; {count} are defined above this line")),
    }
}
