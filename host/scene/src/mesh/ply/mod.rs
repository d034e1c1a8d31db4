//! PLY, the polygon files of Stanford: ascii, and binary of either byte order.
//!
//! Of the element `vertex` the properties `x y z` count, of any type, and `nx ny nz` when all
//! three are there; of `face` the list `vertex_indices` or `vertex_index` of integers.
//! Anything else is read over. Ascii numbers may stand in any lines.
//!
//! Read by hand, element by element into the mesh: the usual crate keeps every face as a list
//! of its own first, refuses ascii numbers like `1.`, and cannot say at which byte a file
//! is wrong.

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
    let mut gather = MeshBuilder::default();
    let mut has_vertices = false;
    for element in &header.elements {
        data.check_count(element)?;
        let plan = ElementReader::of(element, has_vertices)?;
        match plan.role {
            ElementRole::Vertices => {
                has_vertices = true;
                gather.reserve(element.count, 0);
            }
            ElementRole::Faces => gather.reserve(0, element.count),
            ElementRole::Strips => gather.warn("triangle strips are left out".into()),
            ElementRole::Other => {}
        }
        if element.has("red") && plan.role != ElementRole::Other {
            gather.warn(format!("the colours of the element {} are left out", quoted(&element.name)));
        }
        // What has no properties has no data, however often.
        let count = if element.properties.is_empty() { 0 } else { element.count };
        for number in 0..count {
            // The place is put together only when something is wrong there.
            plan.read(&mut data, &mut gather).map_err(|reason| {
                let (line, byte) = data.position();
                let name = quoted(&element.name);
                (line, format!("{name} {number} of {count}{byte}: {reason}"))
            })?;
        }
    }
    gather.finish().map_err(|reason| (None, reason))
}

/// What an element is to a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ElementRole {
    Vertices,
    Faces,
    Strips,
    Other,
}

/// What is done with an element.
struct ElementReader<'h> {
    role: ElementRole,
    has_normals: bool,
    /// Each property, and where its number goes.
    properties: Vec<(&'h PlyProperty, Option<usize>)>,
}

/// Where the numbers of a vertex go.
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
                return element.error("the element `face` needs a list `vertex_indices` of integers");
            }
            if !has_vertices && element.count > 0 {
                return element.error("the faces stand before the vertices, or there are none");
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

    /// Reads one element.
    fn read(&self, data: &mut PlyReader<'_>, gather: &mut MeshBuilder) -> Result<(), String> {
        let mut vertex = [0.0; 6];
        let mut face = gather.take_face_buffer();
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
                .ok_or_else(|| format!("a list of {length} numbers"))?;
            for _ in 0..length {
                let number = data.number(property.scalar_type)?;
                if goal.is_some() {
                    let corner =
                        as_integer(number, usize::MAX).filter(|corner| *corner < gather.vertex_count());
                    face.push(corner.ok_or_else(|| format!("there is no vertex {number}"))? as u32);
                }
            }
        }
        match self.role {
            ElementRole::Vertices => {
                let [x, y, z, nx, ny, nz] = vertex;
                let point = [coordinate(x)?, coordinate(y)?, coordinate(z)?];
                gather.add_vertex(point, self.has_normals.then_some([nx, ny, nz]))?;
            }
            ElementRole::Faces => gather.add_polygon(&face, data.line()),
            ElementRole::Strips | ElementRole::Other => {}
        }
        gather.return_face_buffer(face);
        Ok(())
    }
}

/// The integer that `number` is, if it is one and not more than `most`.
fn as_integer(number: f64, most: usize) -> Option<usize> {
    let cast = number as usize;
    (cast as f64 == number && cast <= most).then_some(cast)
}
