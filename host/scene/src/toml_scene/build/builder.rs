//! The state of converting a file to a loaded scene.

use std::collections::HashMap;
use std::ops::Range;

use strahl_core::{Material, Resolution};

use super::mesh_files::MeshFiles;
use crate::description::{
    CameraDescription, Float3, LinearMotion, LoadedScene, Located, ObjectDescription, ProjectionDescription,
    ShapeDescription,
};
use crate::diagnostics::{Diagnostic, LineIndex};
use crate::toml_scene::value::TableReader;

/// The default up direction.
pub const DEFAULT_UP: Float3 = [0.0, 1.0, 0.0];
/// The default vertical field of view, full angle in degrees.
pub const DEFAULT_VIEW_ANGLE: f32 = 45.0;

/// The indices of materials that have been added, by name.
#[derive(Default)]
pub struct MaterialIds {
    pub named: HashMap<String, u16>,
    pub default: Option<u16>,
}

/// A loaded scene under construction, with the errors found so far.
pub struct SceneBuilder<'m> {
    pub reader: TableReader<'m>,
    pub lines: &'m LineIndex,
    pub scene: LoadedScene,
    pub material_ids: MaterialIds,
    pub meshes: MeshFiles<'m>,
    /// The resolution for which a camera is chosen, if the file has none.
    pub size: Resolution,
    /// Whether too many materials have been reported.
    pub reported_too_many: bool,
    /// The number of triangles without area, and the line of the first.
    pub degenerate: (usize, usize),
}

impl<'m> SceneBuilder<'m> {
    /// An empty scene, for a picture of `size`.
    pub fn new(
        reader: TableReader<'m>,
        lines: &'m LineIndex,
        meshes: MeshFiles<'m>,
        size: Resolution,
    ) -> Self {
        let from = [0.0, 0.0, 1.0];
        let view = CameraDescription {
            from,
            at: [0.0; 3],
            up: DEFAULT_UP,
            projection: ProjectionDescription::Perspective(DEFAULT_VIEW_ANGLE),
        };
        let description = LoadedScene::new(view);
        SceneBuilder {
            reader,
            lines,
            scene: description,
            material_ids: MaterialIds::default(),
            meshes,
            size,
            reported_too_many: false,
            degenerate: (0, 0),
        }
    }

    /// Adds an object, which moves if the velocity is not zero.
    pub fn add_object(
        &mut self,
        shape: ShapeDescription,
        material: u16,
        velocity: Float3,
        span: &Range<usize>,
    ) {
        let line = u32::try_from(self.lines.line_number(span.start)).unwrap_or(u32::MAX);
        if let ShapeDescription::Degenerate = shape {
            let first = if self.degenerate.0 == 0 { line as usize } else { self.degenerate.1 };
            self.degenerate = (self.degenerate.0 + 1, first);
        }
        if velocity != [0.0; 3] {
            let object = self.scene.objects.len();
            self.scene.motions.push(LinearMotion { object, velocity });
        }
        self.scene.objects.push(ObjectDescription { shape, material, line });
    }

    /// Adds vertices, with normals unless `normals` is empty; returns the index of the first.
    pub fn add_vertices(&mut self, points: impl IntoIterator<Item = Float3>, normals: &[Float3]) -> u32 {
        let it = &mut self.scene;
        let first = it.vertices.len();
        it.vertices.extend(points);
        if !normals.is_empty() {
            // A normal has the index of its vertex; earlier vertices may have no normal.
            it.normals.resize(first, [0.0, 0.0, 1.0]);
            it.normals.extend(normals);
        }
        u32::try_from(first).unwrap_or(u32::MAX)
    }

    /// Adds a material and returns its index; `None` if there are too many.
    pub fn add_material(&mut self, it: Material, name: Option<String>, span: &Range<usize>) -> Option<u16> {
        let materials = &mut self.scene.materials;
        let Ok(place) = u16::try_from(materials.len()) else {
            if !std::mem::replace(&mut self.reported_too_many, true) {
                let message = format!("more than {} materials", materials.len());
                let diagnostic = Diagnostic::new(span.clone(), message);
                self.reader.diagnostics.push(diagnostic.with_help("share equal materials by name"));
            }
            return None;
        };
        materials.push(Located { value: it, line: self.lines.line_number(span.start), name });
        Some(place)
    }
}
