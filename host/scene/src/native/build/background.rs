//! What is behind everything.

use super::builder::SceneBuilder;
use crate::description::BackgroundDescription;
use crate::diagnostics::Diagnostic;
use crate::native::format;
use crate::native::table::One;
use crate::native::value::Spanned;

impl SceneBuilder<'_> {
    /// What is behind everything.
    pub fn background(&mut self, background: &One<format::Background>) {
        let Some(Spanned { it, span }) = &background.0 else { return };
        self.description.background = match (&it.color, &it.below, &it.above) {
            (Some(color), None, None) => {
                if let Some(up) = &it.up {
                    let fault = Diagnostic::new(up.span.clone(), "a background of one colour has no `up`");
                    return self.reader.faults.push(fault.with_help("`up` goes with `below` and `above`"));
                }
                BackgroundDescription::Color(color.it.0)
            }
            (None, Some(below), Some(above)) => BackgroundDescription::Gradient {
                up: it.up.as_ref().map_or(self.description.camera.up, |up| up.it.0),
                below: below.it.0,
                above: above.it.0,
            },
            (Some(color), _, _) => {
                let fault = Diagnostic::new(color.span.clone(), "a background has one colour or two");
                return self.reader.faults.push(fault.with_help("write `color`, or `below` and `above`"));
            }
            (None, _, _) => {
                let fault = Diagnostic::new(span.clone(), "the colour of the `background` is missing");
                self.reader.misses::<()>(fault.with_help("write `color`, or `below` and `above`"));
                return;
            }
        };
    }
}
