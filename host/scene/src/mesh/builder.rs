//! What the readers of all formats do with the corners and faces that they find.

use strahl_core::Material;
use strahl_core::math::MAX_COORDINATE;

use super::groups::{MaterialGroup, TriangleMesh};
use super::triangulate::{self, Triangulation};
use crate::description::Float3;
use crate::quantity::{self, quantity};

/// How many kinds of things are named that were left out.
const MAX_WARNINGS: usize = 16;

/// A mesh that grows, and notes about it.
#[derive(Default)]
pub struct MeshBuilder {
    mesh: TriangleMesh,
    material: Option<u16>,
    skipped: Vec<SkippedFeature>,
    /// For cutting polygons, kept from one to the next.
    polygon: Vec<Float3>,
    triangles_of_polygon: Vec<[u32; 3]>,
    face_buffer: Vec<u32>,
}

/// Things of one kind that were left out.
struct SkippedFeature {
    message: String,
    count: usize,
    line: Option<usize>,
}

impl MeshBuilder {
    /// Adds a corner; a normal that has no direction is as good as none.
    pub fn add_vertex(&mut self, point: Float3, normal: Option<Float3>) -> Result<u32, String> {
        let Ok(place) = u32::try_from(self.mesh.vertices.len()) else {
            return Err("more corners than a scene can number".into());
        };
        let TriangleMesh { vertices: points, normals, .. } = &mut self.mesh;
        if let Some(normal) = normal {
            let has_direction = normal.iter().all(|x| x.is_finite()) && normal != NO_NORMAL;
            normals.resize(points.len(), NO_NORMAL);
            normals.push(if has_direction { normal } else { NO_NORMAL });
            if !has_direction {
                self.skip("normals are zero or not finite; those of the triangles take their place", None);
            }
        }
        self.mesh.vertices.push(point);
        Ok(place)
    }

    /// An empty list for the corners of a face, to be given back when it is used.
    pub fn take_face_buffer(&mut self) -> Vec<u32> {
        let mut list = std::mem::take(&mut self.face_buffer);
        list.clear();
        list
    }

    /// Keeps a list for the next face.
    pub fn return_face_buffer(&mut self, list: Vec<u32>) {
        self.face_buffer = list;
    }

    /// Makes room for so many more; the caller has seen data for them.
    pub fn reserve(&mut self, corners: usize, triangles: usize) {
        self.mesh.vertices.reserve(corners);
        self.mesh.triangles.reserve(triangles);
    }

    /// How many corners there are.
    pub fn vertex_count(&self) -> usize {
        self.mesh.vertices.len()
    }

    /// How many triangles there are.
    pub fn triangle_count(&self) -> usize {
        self.mesh.triangles.len()
    }

    /// What follows is of this material.
    pub fn set_material(&mut self, material: Option<u16>) {
        self.material = material;
    }

    /// Adds a material; none when there are more than a scene can number.
    pub fn add_material(&mut self, name: String, material: Material) -> Option<u16> {
        let place = u16::try_from(self.mesh.materials.len()).ok()?;
        self.mesh.materials.push((name, material));
        Some(place)
    }

    /// Adds a triangle of corners that are there.
    pub fn add_triangle(&mut self, corners: [u32; 3]) {
        self.mesh.triangles.push(corners);
        match self.mesh.groups.last_mut() {
            Some(group) if group.material == self.material => group.count += 1,
            _ => self.mesh.groups.push(MaterialGroup { count: 1, material: self.material }),
        }
    }

    /// Adds a polygon of corners that are there; what has fewer than three is left out.
    pub fn add_polygon(&mut self, corners: &[u32], line: Option<usize>) {
        match corners {
            [] | [_] | [_, _] => self.skip("faces have fewer than three corners and are left out", line),
            [a, b, c] => self.add_triangle([*a, *b, *c]),
            _ => {
                self.polygon.clear();
                self.polygon.extend(corners.iter().map(|corner| self.mesh.vertices[*corner as usize]));
                let mut pieces = std::mem::take(&mut self.triangles_of_polygon);
                if triangulate::triangulate(&self.polygon, &mut pieces) == Triangulation::BestEffort {
                    self.skip("polygons cross themselves or have no area; their triangles may overlap", line);
                }
                for piece in pieces.drain(..) {
                    self.add_triangle(piece.map(|place| corners[place as usize]));
                }
                self.triangles_of_polygon = pieces;
            }
        }
    }

    /// Notes a thing that has no place in a mesh: what happens to how many, and where the first is.
    pub fn skip(&mut self, what: &str, line: Option<usize>) {
        if let Some(kind) = self.skipped.iter_mut().find(|kind| kind.message == what) {
            kind.count += 1;
        } else if self.skipped.len() < MAX_WARNINGS {
            self.skipped.push(SkippedFeature { message: what.to_owned(), count: 1, line });
        } else if let Some(last) = self.skipped.last_mut() {
            *last = SkippedFeature {
                message: "other things are left out".into(),
                count: last.count + 1,
                line: last.line,
            };
        }
    }

    /// Adds a note.
    pub fn warn(&mut self, warning: String) {
        if self.mesh.warnings.len() < MAX_WARNINGS {
            self.mesh.warnings.push(warning);
        }
    }

    /// The mesh.
    pub fn finish(mut self) -> Result<TriangleMesh, String> {
        if self.mesh.triangles.is_empty() {
            return Err("there is no triangle in it".into());
        }
        let flat = self.mesh.triangles.iter().filter(|corners| has_no_area(&self.mesh, corners)).count();
        if flat > 0 {
            let has = if flat == 1 { "has no area and is" } else { "have no area and are" };
            self.warn(format!("{} {has} never hit", quantity(flat, "triangle")));
        }
        complete_normals(&mut self.mesh)?;
        self.mesh.warnings.extend(self.skipped.iter().map(
            |SkippedFeature { message: what, count, line }| match line {
                Some(line) if *count == 1 => format!("{what} (1, in line {line})"),
                Some(line) => {
                    format!("{what} ({}, the first in line {line})", quantity::grouped(*count as u64))
                }
                None => format!("{what} ({})", quantity::grouped(*count as u64)),
            },
        ));
        Ok(self.mesh)
    }
}

/// A number as a coordinate: what is wrong with it, if it is none.
pub fn coordinate(number: f32) -> Result<f32, String> {
    if number >= -MAX_COORDINATE && number <= MAX_COORDINATE {
        Ok(number)
    } else if number.is_finite() {
        Err(format!("a coordinate must be between {} and {MAX_COORDINATE}, not {number}", -MAX_COORDINATE))
    } else {
        Err(format!("a coordinate is not a finite number but {number}"))
    }
}

/// Stands where a corner has no normal.
const NO_NORMAL: Float3 = [0.0; 3];

/// Whether the tracer sees no area; in its own words, so that what is counted is what is missed.
fn has_no_area(mesh: &TriangleMesh, corners: &[u32; 3]) -> bool {
    let [a, b, c] = corners.map(|i| mesh.vertices[i as usize]).map(|[x, y, z]| strahl_core::vec3(x, y, z));
    !strahl_core::geometry::has_area([a, b, c])
}

/// Upright on the triangle; any direction when it has no area.
fn face_normal(mesh: &TriangleMesh, corners: &[u32; 3]) -> Float3 {
    let [a, b, c] = corners.map(|i| mesh.vertices[i as usize].map(f64::from));
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 { cross.map(|x| (x / length) as f32) } else { [0.0, 0.0, 1.0] }
}

/// Gives the corners without a normal that of their triangle. A corner that triangles with
/// different normals share becomes several.
fn complete_normals(mesh: &mut TriangleMesh) -> Result<(), String> {
    mesh.normals.resize(if mesh.normals.is_empty() { 0 } else { mesh.vertices.len() }, NO_NORMAL);
    if mesh.normals.iter().all(|normal| *normal == NO_NORMAL) {
        mesh.normals = Vec::new();
        return Ok(());
    }
    let is_missing: Vec<bool> = mesh.normals.iter().map(|normal| *normal == NO_NORMAL).collect();
    if !is_missing.contains(&true) {
        return Ok(());
    }
    for place in 0..mesh.triangles.len() {
        let corners = mesh.triangles[place];
        if !corners.iter().any(|corner| is_missing[*corner as usize]) {
            continue;
        }
        let normal = face_normal(mesh, &corners);
        for (which, corner) in corners.into_iter().enumerate() {
            let corner = corner as usize;
            if !is_missing[corner] || mesh.normals[corner] == normal {
                continue;
            }
            if mesh.normals[corner] == NO_NORMAL {
                mesh.normals[corner] = normal;
                continue;
            }
            let Ok(copy) = u32::try_from(mesh.vertices.len()) else {
                return Err("more corners than a scene can number".into());
            };
            mesh.vertices.push(mesh.vertices[corner]);
            mesh.normals.push(normal);
            mesh.triangles[place][which] = copy;
        }
    }
    // Corners of no triangle.
    for normal in mesh.normals.iter_mut().filter(|normal| **normal == NO_NORMAL) {
        *normal = [0.0, 0.0, 1.0];
    }
    Ok(())
}
