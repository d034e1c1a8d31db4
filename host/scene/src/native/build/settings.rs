//! The settings of the file.

use std::ops::Range;

use super::builder::SceneBuilder;
use crate::native::format::Render;
use crate::native::table::One;
use crate::native::value::Spanned;

impl SceneBuilder<'_> {
    /// The settings of the file.
    pub fn settings(&mut self, render: One<Render>) {
        let Some(Spanned { it, .. }) = render.0 else { return };
        it.faults().into_iter().for_each(|fault| self.reader.faults.push(fault));
        let line = |place: &Range<usize>| self.lines.line_number(place.start);
        let lines = it.places.iter().map(|(key, place)| (*key, line(&place.key)));
        self.description.setting_lines = lines.collect();
        if it.settings.colored_shadows == Some(true) {
            self.description.colored_shadows_line =
                it.places.get("colored_shadows").map(|place| line(&place.value));
        }
        self.description.settings = it.settings;
    }
}
