//! What is behind everything.

use super::builder::SceneBuilder;
use crate::description::BackgroundDescription;
use crate::diagnostics::Diagnostic;
use crate::toml_scene::format;
use crate::toml_scene::table::SingleTable;
use crate::toml_scene::value::Spanned;

impl SceneBuilder<'_> {
    /// What is behind everything.
    pub fn background(&mut self, background: &SingleTable<format::BackgroundTable>) {
        let Some(Spanned { value: it, span }) = &background.0 else { return };
        self.scene.background = match (&it.color, &it.below, &it.above) {
            (Some(color), None, None) => {
                if let Some(up) = &it.up {
                    let fault = Diagnostic::new(up.span.clone(), "a background of one colour has no `up`");
                    return self
                        .reader
                        .diagnostics
                        .push(fault.with_help("`up` goes with `below` and `above`"));
                }
                BackgroundDescription::Color(color.value.0)
            }
            (None, Some(below), Some(above)) => BackgroundDescription::Gradient {
                up: it.up.as_ref().map_or(self.scene.camera.up, |up| up.value.0),
                below: below.value.0,
                above: above.value.0,
            },
            (Some(color), _, _) => {
                let fault = Diagnostic::new(color.span.clone(), "a background has one colour or two");
                return self
                    .reader
                    .diagnostics
                    .push(fault.with_help("write `color`, or `below` and `above`"));
            }
            (None, _, _) => {
                let fault = Diagnostic::new(span.clone(), "the colour of the `background` is missing");
                self.reader.report_missing::<()>(fault.with_help("write `color`, or `below` and `above`"));
                return;
            }
        };
    }
}
