//! Mesh files with their transforms.

use std::ops::Range;
use std::path::Path;

use strahl_core::math::MAX_COORDINATE;

use super::add_to_scene::AddToScene;
use super::builder::SceneBuilder;
use super::rotation;
use crate::description::{Float3, ShapeDescription};
use crate::diagnostics::Diagnostic;
use crate::mesh::{self, TriangleMesh};
use crate::toml_scene::format;
use crate::toml_scene::value::Spanned;

/// A transform: scale, rotate, translate.
struct MeshTransform {
    scale: [f64; 3],
    /// The rows of the rotation matrix.
    rotation: [[f64; 3]; 3],
    translate: [f64; 3],
}

impl MeshTransform {
    fn of(mesh: &format::MeshTable) -> Self {
        MeshTransform {
            scale: mesh.scale.map_or([1.0; 3], |scale| scale.0).map(f64::from),
            rotation: rotation::rotation_matrix(mesh.rotate.map_or([0.0; 3], |turn| turn.0)),
            translate: mesh.translate.map_or([0.0; 3], |place| place.0).map(f64::from),
        }
    }

    fn rotate(&self, v: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// Transforms a point.
    fn point(&self, p: Float3) -> Float3 {
        let turned = self.rotate(std::array::from_fn(|axis| f64::from(p[axis]) * self.scale[axis]));
        std::array::from_fn(|axis| (turned[axis] + self.translate[axis]) as f32)
    }

    /// Transforms a normal by the inverse transpose. It is scaled by a power of two so that its largest component is
    /// about 1: it never rounds to zero, and without rotation it keeps its bits.
    fn normal(&self, n: Float3) -> Float3 {
        let turned = self.rotate(std::array::from_fn(|axis| f64::from(n[axis]) / self.scale[axis]));
        let largest = turned.iter().fold(0.0, |most: f64, x| if x.abs() > most { x.abs() } else { most });
        let power = f64::from_bits(largest.to_bits() & f64::INFINITY.to_bits());
        turned.map(|x| (x / power) as f32)
    }

    /// Whether it changes the handedness.
    fn flips_orientation(&self) -> bool {
        self.scale.iter().filter(|factor| **factor < 0.0).count() % 2 == 1
    }
}

impl AddToScene for format::MeshTable {
    fn add(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>) {
        let material = match &self.material {
            Some(_) => match builder.material_id(&self.material, span) {
                Some(place) => Some(place),
                None => return,
            },
            None => None,
        };
        let Some(velocity) = builder.checked_velocity(&self.velocity) else { return };
        let path = builder.meshes.folder.join(&self.file.value);
        if !builder.meshes.read.contains_key(&path) {
            let mesh = read(&path, &self.file, builder);
            builder.meshes.read.insert(path.clone(), mesh);
        }
        // Moved out, because the whole builder is borrowed below.
        let Some(Some(mesh)) = builder.meshes.read.remove(&path) else {
            builder.meshes.read.insert(path, None);
            return;
        };
        self.add_instance(&mesh, material, velocity, span, builder);
        builder.meshes.read.insert(path, Some(mesh));
    }
}

/// Reads a mesh file; errors are reported at its name.
fn read(path: &Path, file: &Spanned<String>, builder: &mut SceneBuilder<'_>) -> Option<TriangleMesh> {
    match mesh::read_referenced(builder.meshes.files, path) {
        Ok(mesh) => {
            let name = path.display();
            builder.scene.warnings.extend(mesh.warnings.iter().map(|warning| format!("{name}: {warning}")));
            Some(mesh)
        }
        Err(failure) => {
            let failure: String = failure.to_string().chars().take(400).flat_map(printable).collect();
            let diagnostic = Diagnostic::new(file.span.clone(), format!("cannot load this mesh: {failure}"));
            builder.reader.report(diagnostic.with_help("the path is relative to the scene file"))
        }
    }
}

fn printable(c: char) -> Vec<char> {
    if c.is_control() { c.escape_debug().collect() } else { vec![c] }
}

impl format::MeshTable {
    /// Adds the mesh, one object for each material group.
    fn add_instance(
        &self,
        mesh: &TriangleMesh,
        material: Option<u16>,
        velocity: Float3,
        span: &Range<usize>,
        builder: &mut SceneBuilder<'_>,
    ) {
        let transform = MeshTransform::of(self);
        let points: Vec<Float3> = mesh.vertices.iter().map(|p| transform.point(*p)).collect();
        let is_near = |x: &f32| x.abs() <= MAX_COORDINATE;
        if !points.iter().flatten().all(is_near) {
            let message = format!("the transform moves vertices beyond {MAX_COORDINATE:e}");
            builder.reader.diagnostics.push(Diagnostic::new(span.clone(), message));
            return;
        }
        let normals: Vec<Float3> = mesh.normals.iter().map(|n| transform.normal(*n)).collect();
        let smooth = !normals.is_empty();
        let corners = builder.add_vertices(points, &normals);
        let mut first = builder.scene.triangles.len() as u32;
        builder.scene.triangles.extend(mesh.triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|corner| corners + corner);
            if transform.flips_orientation() { [a, c, b] } else { [a, b, c] }
        }));

        let mut own = vec![None; mesh.materials.len()];
        for group in &mesh.groups {
            let of_file = group.material.map(usize::from).filter(|place| *place < own.len());
            let material = match (material, of_file) {
                (Some(material), _) => Some(material),
                (None, None) => builder.material_id(&None, span),
                (None, Some(place)) => {
                    if own[place].is_none() {
                        let (name, it) = &mesh.materials[place];
                        own[place] = builder.add_material(*it, Some(name.clone()), span);
                    }
                    own[place]
                }
            };
            let Some(material) = material else { return };
            builder.add_object(
                ShapeDescription::Mesh { first, count: group.count, smooth },
                material,
                velocity,
                span,
            );
            first += group.count;
        }
    }
}
