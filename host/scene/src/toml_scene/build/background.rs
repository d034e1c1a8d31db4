//! The background.

use super::builder::SceneBuilder;
use crate::description::BackgroundDescription;
use crate::diagnostics::Diagnostic;
use crate::toml_scene::format;
use crate::toml_scene::table::SingleTable;
use crate::toml_scene::value::Spanned;

impl SceneBuilder<'_> {
    /// Adds the background.
    pub fn background(&mut self, background: &SingleTable<format::BackgroundTable>) {
        let Some(Spanned { value: it, span }) = &background.0 else { return };
        self.scene.background = match (&it.color, &it.below, &it.above) {
            (Some(color), None, None) => {
                if let Some(up) = &it.up {
                    let diagnostic = Diagnostic::new(up.span.clone(), "`up` requires `below` and `above`");
                    return self.reader.diagnostics.push(diagnostic.with_help("`color` has no direction"));
                }
                BackgroundDescription::Color(color.value.0)
            }
            (None, Some(below), Some(above)) => BackgroundDescription::Gradient {
                up: it.up.as_ref().map_or(self.scene.camera.up, |up| up.value.0),
                below: below.value.0,
                above: above.value.0,
            },
            (Some(color), _, _) => {
                let diagnostic = Diagnostic::new(color.span.clone(), "`color` excludes `below` and `above`");
                return self
                    .reader
                    .diagnostics
                    .push(diagnostic.with_help("write `color`, or `below` and `above`"));
            }
            (None, _, _) => {
                let diagnostic = Diagnostic::new(span.clone(), "`background` has no color");
                self.reader
                    .report_missing::<()>(diagnostic.with_help("write `color`, or `below` and `above`"));
                return;
            }
        };
    }
}
