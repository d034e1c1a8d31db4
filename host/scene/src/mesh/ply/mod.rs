//! PLY, the Stanford polygon format: ASCII, and binary in both byte orders.
//!
//! Used are, of the element `vertex`, the properties `x y z` of any type, and `nx ny nz` if all three exist; of `face`
//! the integer list `vertex_indices` or `vertex_index`. Everything else is skipped. ASCII numbers may be split across
//! lines in any way.
//!
//! Elements are read directly into the mesh. The crate `ply-rs` is not used: it allocates a list for every face, rejects
//! ASCII numbers such as `1.`, and does not report the byte position of an error.

mod header;
mod reader;

use super::builder::{MeshBuilder, coordinate};
use super::error::LineError;
use super::groups::TriangleMesh;
use crate::quote::quoted;
use header::{PlyElement, PlyHeader, PlyProperty};
use reader::PlyReader;

/// Reads the bytes of a file.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, LineError> {
    let header = PlyHeader::read(bytes)?;
    let mut data = PlyReader::after(&header, bytes);
    let mut builder = MeshBuilder::default();
    let mut has_vertices = false;
    for element in &header.elements {
        data.check_count(element)?;
        let plan = ElementReader::of(element, has_vertices)?;
        match plan.role {
            ElementRole::Vertices => {
                has_vertices = true;
                builder.reserve(element.count, 0);
            }
            ElementRole::Faces => builder.reserve(0, element.count),
            ElementRole::Strips => builder.warn("triangle strips are skipped".into()),
            ElementRole::Other => {}
        }
        if element.has("red") && plan.role != ElementRole::Other {
            builder.warn(format!("the colors of element {} are ignored", quoted(&element.name)));
        }
        // Elements without properties have no data, whatever their count.
        let count = if element.properties.is_empty() { 0 } else { element.count };
        for number in 0..count {
            // The position is formatted only for an error.
            plan.read(&mut data, &mut builder).map_err(|reason| {
                let (line, byte) = data.position();
                let name = quoted(&element.name);
                (line, format!("{name} {number} of {count}{byte}: {reason}"))
            })?;
        }
    }
    builder.finish().map_err(|reason| (None, reason))
}

/// The role of an element in a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ElementRole {
    Vertices,
    Faces,
    Strips,
    Other,
}

/// Reads the records of one element.
struct ElementReader<'h> {
    role: ElementRole,
    has_normals: bool,
    /// Each property, and the index at which its number is stored, if it is used.
    properties: Vec<(&'h PlyProperty, Option<usize>)>,
}

/// The used properties of a vertex, in the order in which they are stored.
const VERTEX_PROPERTIES: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

impl<'h> ElementReader<'h> {
    fn of(element: &'h PlyElement, has_vertices: bool) -> Result<Self, LineError> {
        let is_number =
            |name: &&str| element.properties.iter().any(|p| p.name == **name && p.count_type.is_none());
        let role = match element.name.as_str() {
            "vertex" => ElementRole::Vertices,
            "face" => ElementRole::Faces,
            "tristrips" => ElementRole::Strips,
            _ => ElementRole::Other,
        };
        let of_face = if element.has("vertex_indices") { "vertex_indices" } else { "vertex_index" };
        if role == ElementRole::Vertices && !VERTEX_PROPERTIES[..3].iter().all(is_number) {
            return element.error("the element `vertex` needs the properties x, y and z");
        }
        if role == ElementRole::Faces {
            let list = element.properties.iter().find(|p| p.name == of_face);
            if !list.is_some_and(|p| p.count_type.is_some() && p.scalar_type.is_integer()) {
                return element.error("the element `face` needs an integer list `vertex_indices`");
            }
            if !has_vertices && element.count > 0 {
                return element.error("faces come before the vertices, or there are no vertices");
            }
        }
        let goal = |property: &PlyProperty| match role {
            ElementRole::Vertices if property.count_type.is_none() => {
                VERTEX_PROPERTIES.iter().position(|n| *n == property.name)
            }
            ElementRole::Faces => (property.name == of_face).then_some(0),
            _ => None,
        };
        let has_normals = role == ElementRole::Vertices && VERTEX_PROPERTIES[3..].iter().all(is_number);
        Ok(ElementReader {
            role,
            has_normals,
            properties: element.properties.iter().map(|p| (p, goal(p))).collect(),
        })
    }

    /// Reads one record.
    fn read(&self, data: &mut PlyReader<'_>, builder: &mut MeshBuilder) -> Result<(), String> {
        let mut vertex = [0.0; 6];
        let mut face = builder.take_face_buffer();
        for (property, goal) in &self.properties {
            let Some(length) = property.count_type else {
                let number = data.number(property.scalar_type)?;
                if let Some(goal) = goal {
                    vertex[*goal] = number as f32;
                }
                continue;
            };
            let length = data.number(length)?;
            let length = as_integer(length, data.remaining.len())
                .ok_or_else(|| format!("invalid list length {length}"))?;
            for _ in 0..length {
                let number = data.number(property.scalar_type)?;
                if goal.is_some() {
                    let corner =
                        as_integer(number, usize::MAX).filter(|corner| *corner < builder.vertex_count());
                    face.push(corner.ok_or_else(|| format!("vertex {number} does not exist"))? as u32);
                }
            }
        }
        match self.role {
            ElementRole::Vertices => {
                let [x, y, z, nx, ny, nz] = vertex;
                let point = [coordinate(x)?, coordinate(y)?, coordinate(z)?];
                builder.add_vertex(point, self.has_normals.then_some([nx, ny, nz]))?;
            }
            ElementRole::Faces => builder.add_polygon(&face, data.line()),
            ElementRole::Strips | ElementRole::Other => {}
        }
        builder.return_face_buffer(face);
        Ok(())
    }
}

/// The number as an integer; `None` if it is not one, is negative, or is more than `most`.
fn as_integer(number: f64, most: usize) -> Option<usize> {
    let cast = number as usize;
    (cast as f64 == number && cast <= most).then_some(cast)
}
