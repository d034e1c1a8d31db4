//! The settings in the table `[render]`.

use std::ops::Range;

use super::builder::SceneBuilder;
use crate::toml_scene::format::RenderTable;
use crate::toml_scene::table::SingleTable;
use crate::toml_scene::value::Spanned;

impl SceneBuilder<'_> {
    /// Adds the settings.
    pub fn settings(&mut self, render: SingleTable<RenderTable>) {
        let Some(Spanned { value: it, .. }) = render.0 else { return };
        it.conflicts().into_iter().for_each(|diagnostic| self.reader.diagnostics.push(diagnostic));
        let line = |place: &Range<usize>| self.lines.line_number(place.start);
        let lines = it.spans.iter().map(|(key, place)| (*key, line(&place.key)));
        self.scene.setting_lines = lines.collect();
        if it.settings.colored_shadows == Some(true) {
            self.scene.colored_shadows_line = it.spans.get("colored_shadows").map(|place| line(&place.value));
        }
        self.scene.settings = it.settings;
    }
}
