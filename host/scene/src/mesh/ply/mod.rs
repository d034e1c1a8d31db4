//! PLY, the polygon files of Stanford: ascii, and binary of either byte order.
//!
//! Of the element `vertex` the properties `x y z` count, of any type, and `nx ny nz` when all
//! three are there; of `face` the list `vertex_indices` or `vertex_index` of integers.
//! Anything else is read over. Ascii numbers may stand in any lines.
//!
//! Read by hand, element by element into the mesh: the usual crate keeps every face as a list
//! of its own first, refuses ascii numbers like `1.`, and cannot say at which byte a file
//! is wrong.

mod data;
mod header;

use super::error::Wrong;
use super::gather::{Gather, coordinate};
use super::groups::TriangleMesh;
use crate::quote::quoted;
use data::Data;
use header::{Element, Header, Property};

/// Reads the bytes of a file.
pub fn read(bytes: &[u8]) -> Result<TriangleMesh, Wrong> {
    let header = Header::read(bytes)?;
    let mut data = Data::after(&header, bytes);
    let mut gather = Gather::default();
    let mut has_vertices = false;
    for element in &header.elements {
        data.promise(element)?;
        let plan = Plan::of(element, has_vertices)?;
        match plan.kind {
            Kind::Vertices => {
                has_vertices = true;
                gather.expect(element.count, 0);
            }
            Kind::Faces => gather.expect(0, element.count),
            Kind::Strips => gather.warn("triangle strips are left out".into()),
            Kind::Other => {}
        }
        if element.has("red") && plan.kind != Kind::Other {
            gather.warn(format!("the colours of the element {} are left out", quoted(&element.name)));
        }
        // What has no properties has no data, however often.
        let count = if element.properties.is_empty() { 0 } else { element.count };
        for number in 0..count {
            // The place is put together only when something is wrong there.
            plan.read(&mut data, &mut gather).map_err(|reason| {
                let (line, byte) = data.place();
                let name = quoted(&element.name);
                (line, format!("{name} {number} of {count}{byte}: {reason}"))
            })?;
        }
    }
    gather.finish().map_err(|reason| (None, reason))
}

/// What an element is to a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Vertices,
    Faces,
    Strips,
    Other,
}

/// What is done with an element.
struct Plan<'h> {
    kind: Kind,
    has_normals: bool,
    /// Each property, and where its number goes.
    steps: Vec<(&'h Property, Option<usize>)>,
}

/// Where the numbers of a vertex go.
const OF_VERTEX: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

impl<'h> Plan<'h> {
    fn of(element: &'h Element, has_vertices: bool) -> Result<Self, Wrong> {
        let is_number = |name: &&str| element.properties.iter().any(|p| p.name == **name && p.list.is_none());
        let kind = match element.name.as_str() {
            "vertex" => Kind::Vertices,
            "face" => Kind::Faces,
            "tristrips" => Kind::Strips,
            _ => Kind::Other,
        };
        let of_face = if element.has("vertex_indices") { "vertex_indices" } else { "vertex_index" };
        if kind == Kind::Vertices && !OF_VERTEX[..3].iter().all(is_number) {
            return element.wrong("the element `vertex` needs the properties x, y and z");
        }
        if kind == Kind::Faces {
            let list = element.properties.iter().find(|p| p.name == of_face);
            if !list.is_some_and(|p| p.list.is_some() && p.of.is_whole()) {
                return element.wrong("the element `face` needs a list `vertex_indices` of integers");
            }
            if !has_vertices && element.count > 0 {
                return element.wrong("the faces stand before the vertices, or there are none");
            }
        }
        let goal = |property: &Property| match kind {
            Kind::Vertices if property.list.is_none() => OF_VERTEX.iter().position(|n| *n == property.name),
            Kind::Faces => (property.name == of_face).then_some(0),
            _ => None,
        };
        let has_normals = kind == Kind::Vertices && OF_VERTEX[3..].iter().all(is_number);
        Ok(Plan { kind, has_normals, steps: element.properties.iter().map(|p| (p, goal(p))).collect() })
    }

    /// Reads one element.
    fn read(&self, data: &mut Data<'_>, gather: &mut Gather) -> Result<(), String> {
        let mut vertex = [0.0; 6];
        let mut face = gather.take_list();
        for (property, goal) in &self.steps {
            let Some(length) = property.list else {
                let number = data.number(property.of)?;
                if let Some(goal) = goal {
                    vertex[*goal] = number as f32;
                }
                continue;
            };
            let length = data.number(length)?;
            let length =
                whole(length, data.left.len()).ok_or_else(|| format!("a list of {length} numbers"))?;
            for _ in 0..length {
                let number = data.number(property.of)?;
                if goal.is_some() {
                    let corner = whole(number, usize::MAX).filter(|corner| *corner < gather.corners());
                    face.push(corner.ok_or_else(|| format!("there is no vertex {number}"))? as u32);
                }
            }
        }
        match self.kind {
            Kind::Vertices => {
                let [x, y, z, nx, ny, nz] = vertex;
                let point = [coordinate(x)?, coordinate(y)?, coordinate(z)?];
                gather.corner(point, self.has_normals.then_some([nx, ny, nz]))?;
            }
            Kind::Faces => gather.polygon(&face, data.line()),
            Kind::Strips | Kind::Other => {}
        }
        gather.give_list(face);
        Ok(())
    }
}

/// The integer that `number` is, if it is one and not more than `most`.
fn whole(number: f64, most: usize) -> Option<usize> {
    let cast = number as usize;
    (cast as f64 == number && cast <= most).then_some(cast)
}
