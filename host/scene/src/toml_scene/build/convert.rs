//! Conversion of a whole file.

use std::ops::Range;

use super::add_to_scene::AddToScene;
use super::builder::SceneBuilder;
use crate::description::LoadedScene;
use crate::quantity::quantity;
use crate::toml_scene::format::SceneFile;
use crate::toml_scene::table::TableArray;
use crate::toml_scene::value::TableReader;

impl<'m> SceneBuilder<'m> {
    /// Converts the file; the reader holds the errors.
    pub fn build(mut self, mut file: SceneFile) -> (LoadedScene, TableReader<'m>) {
        self.settings(std::mem::take(&mut file.render));
        let file = &file;
        self.materials(&file.material);
        self.shutter(&file.camera);
        // Objects are numbered in the order of the file, whatever their kind.
        let mut objects: Vec<(&Range<usize>, &dyn AddToScene)> = scene_objects(file);
        objects.sort_by_key(|(span, _)| span.start);
        for (span, object) in objects {
            object.add(span, &mut self);
        }
        self.add_warnings();
        self.lights(file);
        self.camera(file);
        self.background(&file.background);
        (self.scene, self.reader)
    }

    fn add_warnings(&mut self) {
        let warnings = &mut self.scene.warnings;
        let (count, line) = self.degenerate;
        match count {
            0 => {}
            1 => warnings.push(format!("1 triangle has zero area and is never hit (line {line})")),
            _ => warnings.push(format!(
                "{} have zero area and are never hit (the first in line {line})",
                quantity(count, "triangle")
            )),
        }
        if self.scene.objects.is_empty() {
            warnings.push("the scene has no objects".into());
        }
    }
}

/// All objects of the file, kind by kind.
pub fn scene_objects(file: &SceneFile) -> Vec<(&Range<usize>, &dyn AddToScene)> {
    fn all<T: AddToScene>(many: &TableArray<T>) -> impl Iterator<Item = (&Range<usize>, &dyn AddToScene)> {
        many.0.iter().map(|at| (&at.span, &at.value as &dyn AddToScene))
    }
    let round = all(&file.sphere).chain(all(&file.cylinder)).chain(all(&file.cone)).chain(all(&file.torus));
    let flat = all(&file.plane).chain(all(&file.disc)).chain(all(&file.triangle)).chain(all(&file.polygon));
    round.chain(flat).chain(all(&file.r#box)).chain(all(&file.mesh)).collect()
}
