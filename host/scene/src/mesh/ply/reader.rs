//! Reads the numbers of a PLY file in order.

use super::header::{PlyElement, PlyEncoding, PlyHeader, PlyProperty, ScalarType};
use crate::mesh::error::LineError;
use crate::quote::quoted;

/// A cursor in the data of a PLY file.
pub struct PlyReader<'b> {
    encoding: PlyEncoding,
    pub remaining: &'b [u8],
    /// The size of the whole file, in bytes.
    file_size: usize,
    line: usize,
}

impl<'b> PlyReader<'b> {
    /// The data after the header.
    pub fn after(header: &PlyHeader, bytes: &'b [u8]) -> Self {
        let left = &bytes[header.bytes..];
        PlyReader {
            encoding: header.encoding,
            remaining: left,
            file_size: bytes.len(),
            line: header.lines + 1,
        }
    }

    /// The current line; `None` in binary files.
    pub fn line(&self) -> Option<usize> {
        (self.encoding == PlyEncoding::Ascii).then_some(self.line)
    }

    /// The current line, or in binary files the byte position as text.
    pub fn position(&self) -> (Option<usize>, String) {
        match self.line() {
            Some(line) => (Some(line), String::new()),
            None => (None, format!(" before byte {}", self.file_size - self.remaining.len())),
        }
    }

    /// Rejects an element count for which the file has too little data.
    pub fn check_count(&self, element: &PlyElement) -> Result<(), LineError> {
        let bytes = |p: &PlyProperty| match self.encoding {
            // A digit and a space, except for the last.
            PlyEncoding::Ascii => 2,
            _ => p.count_type.unwrap_or(p.scalar_type).size(),
        };
        let each: usize = element.properties.iter().map(bytes).sum();
        let left = self.remaining.len() + usize::from(self.encoding == PlyEncoding::Ascii);
        match element.count.checked_mul(each) {
            Some(needed) if needed <= left => Ok(()),
            _ => element.error(format!(
                "{} elements {} take at least {each} bytes each, but {} bytes are left in the file",
                element.count,
                quoted(&element.name),
                self.remaining.len()
            )),
        }
    }

    /// Reads the next number.
    #[inline]
    pub fn number(&mut self, of: ScalarType) -> Result<f64, String> {
        match self.encoding {
            PlyEncoding::Ascii => self.ascii_number(of),
            PlyEncoding::LittleEndian | PlyEncoding::BigEndian => self.binary_number(of),
        }
    }

    fn binary_number(&mut self, of: ScalarType) -> Result<f64, String> {
        macro_rules! read {
            ($type:ty) => {{
                let Some((bytes, rest)) = self.remaining.split_first_chunk() else {
                    return Err("unexpected end of file".into());
                };
                self.remaining = rest;
                f64::from(match self.encoding {
                    PlyEncoding::BigEndian => <$type>::from_be_bytes(*bytes),
                    _ => <$type>::from_le_bytes(*bytes),
                })
            }};
        }
        Ok(match of {
            ScalarType::I8 => read!(i8),
            ScalarType::U8 => read!(u8),
            ScalarType::I16 => read!(i16),
            ScalarType::U16 => read!(u16),
            ScalarType::I32 => read!(i32),
            ScalarType::U32 => read!(u32),
            ScalarType::F32 => read!(f32),
            ScalarType::F64 => read!(f64),
        })
    }

    fn ascii_number(&mut self, of: ScalarType) -> Result<f64, String> {
        let space = self.remaining.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        let (space, rest) = self.remaining.split_at(space);
        let length = rest.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        let (word, rest) = rest.split_at(length);
        if word.is_empty() {
            return Err("unexpected end of file".into());
        }
        self.line += space.iter().filter(|byte| **byte == b'\n').count();
        self.remaining = rest;
        let text = str::from_utf8(word).unwrap_or_default();
        // Rounded once, to the type that the header names.
        let number = match of {
            ScalarType::F32 => text.parse::<f32>().map(f64::from),
            _ => text.parse::<f64>(),
        };
        number.map_err(|_| format!("{} is not a number", quoted(&String::from_utf8_lossy(word))))
    }
}
