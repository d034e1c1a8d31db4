//! Builds a mesh from the vertices and faces that the readers of all formats find.

use strahl_core::Material;
use strahl_core::math::MAX_COORDINATE;

use super::groups::{MaterialGroup, TriangleMesh};
use super::triangulate::{self, Triangulation};
use crate::description::Float3;
use crate::quantity::{self, quantity};

/// The maximum number of warnings, and of kinds of skipped features.
const MAX_WARNINGS: usize = 16;

/// A mesh under construction, with its warnings.
#[derive(Default)]
pub struct MeshBuilder {
    mesh: TriangleMesh,
    material: Option<u16>,
    skipped: Vec<SkippedFeature>,
    /// Buffers for triangulation, reused from one polygon to the next.
    polygon: Vec<Float3>,
    triangles_of_polygon: Vec<[u32; 3]>,
    face_buffer: Vec<u32>,
}

/// Skipped features of one kind.
struct SkippedFeature {
    message: String,
    count: usize,
    line: Option<usize>,
}

impl MeshBuilder {
    /// Adds a vertex; a zero or non-finite normal counts as missing. Returns its index.
    pub fn add_vertex(&mut self, point: Float3, normal: Option<Float3>) -> Result<u32, String> {
        let Ok(index) = u32::try_from(self.mesh.vertices.len()) else {
            return Err("too many vertices".into());
        };
        let TriangleMesh { vertices: points, normals, .. } = &mut self.mesh;
        if let Some(normal) = normal {
            let has_direction = normal.iter().all(|x| x.is_finite()) && normal != NO_NORMAL;
            normals.resize(points.len(), NO_NORMAL);
            normals.push(if has_direction { normal } else { NO_NORMAL });
            if !has_direction {
                self.skip("zero or non-finite normals are replaced by face normals", None);
            }
        }
        self.mesh.vertices.push(point);
        Ok(index)
    }

    /// An empty buffer for the vertices of a face, to be returned for reuse.
    pub fn take_face_buffer(&mut self) -> Vec<u32> {
        let mut list = std::mem::take(&mut self.face_buffer);
        list.clear();
        list
    }

    /// Takes the buffer back for the next face.
    pub fn return_face_buffer(&mut self, list: Vec<u32>) {
        self.face_buffer = list;
    }

    /// Reserves memory; the caller has seen as much data in the file.
    pub fn reserve(&mut self, corners: usize, triangles: usize) {
        self.mesh.vertices.reserve(corners);
        self.mesh.triangles.reserve(triangles);
    }

    /// The number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.mesh.vertices.len()
    }

    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.mesh.triangles.len()
    }

    /// Sets the material of the faces that follow; `None` is the default material.
    pub fn set_material(&mut self, material: Option<u16>) {
        self.material = material;
    }

    /// Adds a material and returns its index; `None` if there are too many.
    pub fn add_material(&mut self, name: String, material: Material) -> Option<u16> {
        let index = u16::try_from(self.mesh.materials.len()).ok()?;
        self.mesh.materials.push((name, material));
        Some(index)
    }

    /// Adds a triangle of existing vertices.
    pub fn add_triangle(&mut self, corners: [u32; 3]) {
        self.mesh.triangles.push(corners);
        match self.mesh.groups.last_mut() {
            Some(group) if group.material == self.material => group.count += 1,
            _ => self.mesh.groups.push(MaterialGroup { count: 1, material: self.material }),
        }
    }

    /// Adds a polygon of existing vertices; polygons with fewer than three are skipped.
    pub fn add_polygon(&mut self, corners: &[u32], line: Option<usize>) {
        match corners {
            [] | [_] | [_, _] => self.skip("faces with fewer than three vertices are skipped", line),
            [a, b, c] => self.add_triangle([*a, *b, *c]),
            _ => {
                self.polygon.clear();
                self.polygon.extend(corners.iter().map(|corner| self.mesh.vertices[*corner as usize]));
                let mut pieces = std::mem::take(&mut self.triangles_of_polygon);
                if triangulate::triangulate(&self.polygon, &mut pieces) == Triangulation::BestEffort {
                    self.skip("self-intersecting or zero-area polygons; their triangles may overlap", line);
                }
                for piece in pieces.drain(..) {
                    self.add_triangle(piece.map(|index| corners[index as usize]));
                }
                self.triangles_of_polygon = pieces;
            }
        }
    }

    /// Counts a skipped feature for a warning, with the line of the first.
    pub fn skip(&mut self, what: &str, line: Option<usize>) {
        if let Some(kind) = self.skipped.iter_mut().find(|kind| kind.message == what) {
            kind.count += 1;
        } else if self.skipped.len() < MAX_WARNINGS {
            self.skipped.push(SkippedFeature { message: what.to_owned(), count: 1, line });
        } else if let Some(last) = self.skipped.last_mut() {
            *last = SkippedFeature {
                message: "other unsupported features are skipped".into(),
                count: last.count + 1,
                line: last.line,
            };
        }
    }

    /// Adds a warning.
    pub fn warn(&mut self, warning: String) {
        if self.mesh.warnings.len() < MAX_WARNINGS {
            self.mesh.warnings.push(warning);
        }
    }

    /// Finishes the mesh: completes its normals and its warnings.
    pub fn finish(mut self) -> Result<TriangleMesh, String> {
        if self.mesh.triangles.is_empty() {
            return Err("contains no triangles".into());
        }
        let flat = self.mesh.triangles.iter().filter(|corners| has_no_area(&self.mesh, corners)).count();
        if flat > 0 {
            let has = if flat == 1 { "has zero area and is" } else { "have zero area and are" };
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

/// Checks that a number is a valid coordinate.
pub fn coordinate(number: f32) -> Result<f32, String> {
    if number >= -MAX_COORDINATE && number <= MAX_COORDINATE {
        Ok(number)
    } else if number.is_finite() {
        Err(format!("a coordinate must be between {} and {MAX_COORDINATE}, not {number}", -MAX_COORDINATE))
    } else {
        Err(format!("a coordinate must be finite, not {number}"))
    }
}

/// Marks a vertex without a normal.
const NO_NORMAL: Float3 = [0.0; 3];

/// Whether a triangle has no area, by the test of the core, so that the count is that of triangles that are never hit.
fn has_no_area(mesh: &TriangleMesh, corners: &[u32; 3]) -> bool {
    let [a, b, c] = corners.map(|i| mesh.vertices[i as usize]).map(|[x, y, z]| strahl_core::vec3(x, y, z));
    !strahl_core::geometry::has_area([a, b, c])
}

/// The unit normal of a triangle; +z if it has no area.
fn face_normal(mesh: &TriangleMesh, corners: &[u32; 3]) -> Float3 {
    let [a, b, c] = corners.map(|i| mesh.vertices[i as usize].map(f64::from));
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 { cross.map(|x| (x / length) as f32) } else { [0.0, 0.0, 1.0] }
}

/// Gives vertices without a normal that of their triangle. A vertex shared by triangles with different normals is
/// duplicated.
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
    for index in 0..mesh.triangles.len() {
        let corners = mesh.triangles[index];
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
                return Err("too many vertices".into());
            };
            mesh.vertices.push(mesh.vertices[corner]);
            mesh.normals.push(normal);
            mesh.triangles[index][which] = copy;
        }
    }
    // Unused vertices.
    for normal in mesh.normals.iter_mut().filter(|normal| **normal == NO_NORMAL) {
        *normal = [0.0, 0.0, 1.0];
    }
    Ok(())
}
