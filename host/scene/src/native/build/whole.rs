//! The scene as a whole, part by part.

use std::ops::Range;

use super::builder::SceneBuilder;
use super::thing::Thing;
use crate::description::LoadedScene;
use crate::native::format::File;
use crate::native::table::Many;
use crate::native::value::Reader;
use crate::quantity::quantity;

impl<'m> SceneBuilder<'m> {
    /// Makes everything, and answers with it and what is wrong.
    pub fn scene(mut self, mut file: File) -> (LoadedScene, Reader<'m>) {
        self.settings(std::mem::take(&mut file.render));
        let file = &file;
        self.materials(&file.material);
        self.shutter(&file.camera);
        // Objects are numbered by their places in the file, whatever they are.
        let mut things: Vec<(&Range<usize>, &dyn Thing)> = things(file);
        things.sort_by_key(|(span, _)| span.start);
        for (span, thing) in things {
            thing.add(span, &mut self);
        }
        self.warn();
        self.lights(file);
        self.view(file);
        self.background(&file.background);
        (self.description, self.reader)
    }

    fn warn(&mut self) {
        let warnings = &mut self.description.warnings;
        let (count, line) = self.flat;
        match count {
            0 => {}
            1 => warnings.push(format!("1 triangle has no area and is never hit (line {line})")),
            _ => warnings.push(format!(
                "{} have no area and are never hit (the first in line {line})",
                quantity(count, "triangle")
            )),
        }
        if self.description.objects.is_empty() {
            warnings.push("there is no object in the scene".into());
        }
    }
}

/// Everything in the file, kind by kind.
pub fn things(file: &File) -> Vec<(&Range<usize>, &dyn Thing)> {
    fn all<T: Thing>(many: &Many<T>) -> impl Iterator<Item = (&Range<usize>, &dyn Thing)> {
        many.0.iter().map(|at| (&at.span, &at.it as &dyn Thing))
    }
    let round = all(&file.sphere).chain(all(&file.cylinder)).chain(all(&file.cone)).chain(all(&file.torus));
    let flat = all(&file.plane).chain(all(&file.disc)).chain(all(&file.triangle)).chain(all(&file.polygon));
    round.chain(flat).chain(all(&file.r#box)).chain(all(&file.mesh)).collect()
}
