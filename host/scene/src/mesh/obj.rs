//! OBJ, the object files of Wavefront: `v vn f usemtl mtllib`.
//!
//! The format is a custom more than a rule, so the reader is generous with words that it does
//! not know (they are counted in a warning) and strict with those that it does. Read by hand:
//! the usual crate gives no lines for what is wrong, and loses track of normals in faces where
//! only some corners have one.
//!
//! * Corners are shared where both place and normal are the same, in the order of their first use.
//! * Texture coordinates, colours of corners, weights, groups' names and smoothing groups have
//!   no meaning here.
//! * A material is known after the `mtllib` that has it, wherever the line stands.

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

/// Reads the bytes of the file at `path`; material libraries are beside it.
pub fn read(files: &SourceFiles, path: &Path, bytes: &[u8]) -> Result<TriangleMesh, LoadError> {
    let wrong = |wrong| invalid(path, wrong);
    let text = text_of(bytes).map_err(wrong)?;
    let mut reader = ObjReader::default();
    // Libraries first: some writers name them after the materials' first use.
    for line in lines(&text).filter(|line| line.keyword == "mtllib") {
        reader.library(files, path.parent().unwrap_or(Path::new("")), line)?;
    }
    for line in lines(&text) {
        reader.line(line).map_err(wrong)?;
    }
    reader.gather.finish().map_err(|reason| wrong((None, reason)))
}

/// A corner that has no normal.
const NO_NORMAL: u32 = u32::MAX;

/// What has been read of the file.
#[derive(Default)]
struct ObjReader {
    gather: MeshBuilder,
    points: Vec<Float3>,
    normals: Vec<Float3>,
    /// Where the corner with this point and this normal stands.
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
            "l" | "p" => self.gather.skip("lines and points are left out", Some(line.number)),
            other => {
                let what = format!("words {} are not known and left out", quoted(other));
                self.gather.skip(&what, Some(line.number));
            }
        }
        Ok(())
    }

    fn position(&mut self, line: LogicalLine<'_>) -> Result<(), LineError> {
        let mut point = line.numbers("a corner")?;
        for number in &mut point {
            *number = coordinate(*number).or_else(|reason| line.error(reason))?;
        }
        // A fourth number is a weight, which only curves have a use for.
        if line.words().count() > 4 {
            self.gather.skip("colours of corners are left out", Some(line.number));
        }
        self.points.push(point);
        Ok(())
    }

    fn face(&mut self, line: LogicalLine<'_>) -> Result<(), LineError> {
        let mut face = self.gather.take_face_buffer();
        for word in line.words() {
            face.push(self.vertex(word, line)?);
        }
        self.gather.add_polygon(&face, Some(line.number));
        self.gather.return_face_buffer(face);
        Ok(())
    }

    /// The corner of a word like `1`, `1/2`, `1//3` or `1/2/3`.
    fn vertex(&mut self, word: &str, line: LogicalLine<'_>) -> Result<u32, LineError> {
        let mut parts = word.split('/');
        let point = parts.next().unwrap_or_default();
        let texture = parts.next().unwrap_or_default();
        let normal = parts.next().unwrap_or_default();
        if parts.next().is_some() || (!texture.is_empty() && texture.parse::<i64>().is_err()) {
            return line.error(format!("{} is no corner of a face", quoted(word)));
        }
        let point = resolve_index(point, self.points.len(), "corner", word, line)?;
        let normal = match normal {
            "" => NO_NORMAL,
            _ => resolve_index(normal, self.normals.len(), "normal", word, line)?,
        };
        if let Some(known) = self.vertex_of.get(&(point, normal)) {
            return Ok(*known);
        }
        let direction = self.normals.get(normal as usize).copied();
        let corner = self.gather.add_vertex(self.points[point as usize], direction);
        let corner = corner.or_else(|reason| line.error(reason))?;
        self.vertex_of.insert((point, normal), corner);
        Ok(corner)
    }

    fn material(&mut self, line: LogicalLine<'_>) {
        let material = self.materials.get(line.rest).copied();
        if material.is_none() && !self.materials.is_empty() {
            let what = format!("uses of the material {}, which no library has", quoted(line.rest));
            self.gather.skip(&what, Some(line.number));
        }
        self.gather.set_material(material);
    }

    /// Reads one library whose name may have spaces, or several whose names have none.
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
                        let what = format!("the materials {name} of line {line} cannot be read: {error}");
                        self.gather.warn(what);
                    }
                }
            }
        }
        Ok(())
    }

    fn one_library(&mut self, files: &SourceFiles, path: &Path, bytes: &[u8]) -> Result<(), LoadError> {
        let wrong = |wrong| invalid(path, wrong);
        let mtl::MtlLibrary { materials, textures } = mtl::read(bytes, &mut self.gather).map_err(wrong)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        textures.iter().for_each(|name| files.note_path(folder.join(name)));
        for material in materials {
            let Some(place) = self.gather.add_material(material.name.clone(), material.material) else {
                return Err(wrong((Some(material.line), "more materials than a scene can number".into())));
            };
            // Of two with the same name the first counts.
            self.materials.entry(material.name).or_insert(place);
        }
        Ok(())
    }
}

/// The place that an index names, which counts from 1, or back from the end when negative.
fn resolve_index(
    index: &str,
    count: usize,
    what: &str,
    word: &str,
    line: LogicalLine<'_>,
) -> Result<u32, LineError> {
    let Ok(index) = index.parse::<i64>() else {
        return line.error(format!("{} is no corner of a face", quoted(word)));
    };
    let place = if index < 0 { count as i64 + index } else { index - 1 };
    match u32::try_from(place) {
        Ok(place) if (place as usize) < count => Ok(place),
        _ => line.error(format!("there is no {what} {index}; {count} stand above this line")),
    }
}
