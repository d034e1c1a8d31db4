//! Formatting into a buffer of fixed size.

use core::fmt::{self, Debug, Write};

use crate::any::used;

pub fn displayed(error: impl core::fmt::Display) {
    let mut text_buffer = TextBuffer { text: [0; 16], length: 0 };
    used((write!(text_buffer, "{error}"), text_buffer.text));
}

pub fn debugged(set: &impl Debug) {
    let mut text_buffer = TextBuffer { text: [0; 16], length: 0 };
    used((write!(text_buffer, "{set:?}"), text_buffer.text));
}

/// Text that is truncated to 16 bytes.
struct TextBuffer {
    text: [u8; 16],
    length: usize,
}

impl Write for TextBuffer {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            *self.text.get_mut(self.length).ok_or(fmt::Error)? = byte;
            self.length += 1;
        }
        Ok(())
    }
}
