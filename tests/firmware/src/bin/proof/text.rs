//! What is shown, where nobody can hold text of any length.

use core::fmt::{self, Debug, Write};

use crate::any::used;

pub fn displayed(error: impl core::fmt::Display) {
    let mut line = Line { text: [0; 16], length: 0 };
    used((write!(line, "{error}"), line.text));
}

pub fn debugged(set: &impl Debug) {
    let mut line = Line { text: [0; 16], length: 0 };
    used((write!(line, "{set:?}"), line.text));
}

/// Forgets what does not fit.
struct Line {
    text: [u8; 16],
    length: usize,
}

impl Write for Line {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            *self.text.get_mut(self.length).ok_or(fmt::Error)? = byte;
            self.length += 1;
        }
        Ok(())
    }
}
