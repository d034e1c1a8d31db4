//! The numbers of a PLY file, one after the other.

use super::header::{Element, Encoding, Header, Property, Type};
use crate::mesh::error::Wrong;
use crate::quote::quoted;

/// The data that are not read yet.
pub struct Data<'b> {
    encoding: Encoding,
    pub left: &'b [u8],
    /// The bytes of the whole file.
    size: usize,
    line: usize,
}

impl<'b> Data<'b> {
    /// What follows the header in the bytes of a file, in a line of its own.
    pub fn after(header: &Header, bytes: &'b [u8]) -> Self {
        let left = &bytes[header.bytes..];
        Data { encoding: header.encoding, left, size: bytes.len(), line: header.lines + 1 }
    }

    /// The line, where there are lines.
    pub fn line(&self) -> Option<usize> {
        (self.encoding == Encoding::Ascii).then_some(self.line)
    }

    /// The line, where there are lines, else the byte in words.
    pub fn place(&self) -> (Option<usize>, String) {
        match self.line() {
            Some(line) => (Some(line), String::new()),
            None => (None, format!(" before byte {}", self.size - self.left.len())),
        }
    }

    /// Refuses a number of elements for which there are not enough data.
    pub fn promise(&self, element: &Element) -> Result<(), Wrong> {
        let bytes = |p: &Property| match self.encoding {
            // A digit and a space, but for the last.
            Encoding::Ascii => 2,
            _ => p.list.unwrap_or(p.of).bytes(),
        };
        let each: usize = element.properties.iter().map(bytes).sum();
        let left = self.left.len() + usize::from(self.encoding == Encoding::Ascii);
        match element.count.checked_mul(each) {
            Some(needed) if needed <= left => Ok(()),
            _ => element.wrong(format!(
                "{} elements {} take at least {each} bytes each, but {} bytes are left in the file",
                element.count,
                quoted(&element.name),
                self.left.len()
            )),
        }
    }

    /// The next number.
    #[inline]
    pub fn number(&mut self, of: Type) -> Result<f64, String> {
        match self.encoding {
            Encoding::Ascii => self.word(of),
            Encoding::Little | Encoding::Big => self.bytes(of),
        }
    }

    fn bytes(&mut self, of: Type) -> Result<f64, String> {
        macro_rules! read {
            ($type:ty) => {{
                let Some((bytes, left)) = self.left.split_first_chunk() else {
                    return Err("the file ends here".into());
                };
                self.left = left;
                f64::from(match self.encoding {
                    Encoding::Big => <$type>::from_be_bytes(*bytes),
                    _ => <$type>::from_le_bytes(*bytes),
                })
            }};
        }
        Ok(match of {
            Type::I8 => read!(i8),
            Type::U8 => read!(u8),
            Type::I16 => read!(i16),
            Type::U16 => read!(u16),
            Type::I32 => read!(i32),
            Type::U32 => read!(u32),
            Type::F32 => read!(f32),
            Type::F64 => read!(f64),
        })
    }

    fn word(&mut self, of: Type) -> Result<f64, String> {
        let space = self.left.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        let (space, left) = self.left.split_at(space);
        let length = left.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        let (word, left) = left.split_at(length);
        if word.is_empty() {
            return Err("the file ends here".into());
        }
        self.line += space.iter().filter(|byte| **byte == b'\n').count();
        self.left = left;
        let text = str::from_utf8(word).unwrap_or_default();
        // Rounded once, to the type that the header names.
        let number = match of {
            Type::F32 => text.parse::<f32>().map(f64::from),
            _ => text.parse::<f64>(),
        };
        number.map_err(|_| format!("{} is no number", quoted(&String::from_utf8_lossy(word))))
    }
}
