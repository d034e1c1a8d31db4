//! PLY header: elements, properties and encoding.

use crate::mesh::error::LineError;
use crate::quote::quoted;

/// A scalar type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl ScalarType {
    fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => ScalarType::I8,
            "uchar" | "uint8" => ScalarType::U8,
            "short" | "int16" => ScalarType::I16,
            "ushort" | "uint16" => ScalarType::U16,
            "int" | "int32" => ScalarType::I32,
            "uint" | "uint32" => ScalarType::U32,
            "float" | "float32" => ScalarType::F32,
            "double" | "float64" => ScalarType::F64,
            _ => return None,
        })
    }

    pub fn size(self) -> usize {
        match self {
            ScalarType::I8 | ScalarType::U8 => 1,
            ScalarType::I16 | ScalarType::U16 => 2,
            ScalarType::I32 | ScalarType::U32 | ScalarType::F32 => 4,
            ScalarType::F64 => 8,
        }
    }

    pub fn is_integer(self) -> bool {
        !matches!(self, ScalarType::F32 | ScalarType::F64)
    }
}

/// A property of an element: a number, or a list with its length in front.
pub struct PlyProperty {
    pub name: String,
    /// The type of the length of a list; `None` if the property is a single number.
    pub count_type: Option<ScalarType>,
    pub scalar_type: ScalarType,
}

/// An element: a number of records with the same properties.
pub struct PlyElement {
    pub name: String,
    pub count: usize,
    pub properties: Vec<PlyProperty>,
    /// Its line in the header.
    line: usize,
}

impl PlyElement {
    pub fn has(&self, property: &str) -> bool {
        self.properties.iter().any(|p| p.name == property)
    }

    pub fn error<T>(&self, reason: impl Into<String>) -> Result<T, LineError> {
        Err((Some(self.line), reason.into()))
    }
}

/// The encoding of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlyEncoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// The header of a file.
pub struct PlyHeader {
    pub elements: Vec<PlyElement>,
    pub encoding: PlyEncoding,
    /// The size of the header, in bytes.
    pub bytes: usize,
    /// The number of lines of the header.
    pub lines: usize,
}

impl PlyHeader {
    /// Reads the header of a file.
    pub fn read(bytes: &[u8]) -> Result<Self, LineError> {
        let (mut left, mut line) = (bytes, 0);
        let mut encoding = None;
        let mut header = PlyHeader { elements: Vec::new(), encoding: PlyEncoding::Ascii, bytes: 0, lines: 0 };
        loop {
            line += 1;
            let end = left.iter().position(|byte| *byte == b'\n').map_or(left.len(), |position| position + 1);
            let (text, rest) = left.split_at(end);
            left = rest;
            let text = String::from_utf8_lossy(text);
            let mut words = text.split_ascii_whitespace();
            let error_at_line = |reason: String| Err((Some(line), reason));
            match (words.next(), line) {
                (Some("ply"), 1) => {}
                (_, 1) => return error_at_line("not a PLY file: it does not begin with `ply`".into()),
                (None, _) if left.is_empty() => {
                    return error_at_line("the file ends inside its header".into());
                }
                (None | Some("comment" | "obj_info"), _) => {}
                (Some("format"), _) => {
                    encoding = Some(match words.next() {
                        Some("ascii") => PlyEncoding::Ascii,
                        Some("binary_little_endian") => PlyEncoding::LittleEndian,
                        Some("binary_big_endian") => PlyEncoding::BigEndian,
                        other => {
                            let other = quoted(other.unwrap_or_default());
                            return error_at_line(format!(
                                "the format {other} is not ascii, binary_little_endian or binary_big_endian"
                            ));
                        }
                    });
                }
                (Some("element"), _) => header.element(words, line)?,
                (Some("property"), _) => header.property(words, line)?,
                (Some("end_header"), _) => break,
                (Some(other), _) => return error_at_line(format!("unknown header line {}", quoted(other))),
            }
        }
        header.encoding = encoding.ok_or((Some(line), "the header has no `format`".into()))?;
        (header.bytes, header.lines) = (bytes.len() - left.len(), line);
        Ok(header)
    }

    fn element<'w>(
        &mut self,
        mut words: impl Iterator<Item = &'w str>,
        line: usize,
    ) -> Result<(), LineError> {
        let (name, count) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let Ok(count) = count.parse::<usize>() else {
            let reason = format!("invalid count {} of element {}", quoted(count), quoted(name));
            return Err((Some(line), reason));
        };
        if self.elements.iter().any(|element| element.name == name) {
            return Err((Some(line), format!("duplicate element {}", quoted(name))));
        }
        self.elements.push(PlyElement { name: name.to_owned(), count, properties: Vec::new(), line });
        Ok(())
    }

    fn property<'w>(
        &mut self,
        mut words: impl Iterator<Item = &'w str>,
        line: usize,
    ) -> Result<(), LineError> {
        let error_at_line = |reason: String| Err((Some(line), reason));
        let Some(element) = self.elements.last_mut() else {
            return error_at_line("a property before the first element".into());
        };
        let mut next = || words.next().unwrap_or_default();
        let type_of = |name: &str| {
            ScalarType::from_name(name).ok_or((Some(line), format!("unknown type {}", quoted(name))))
        };
        let first = next();
        let (list, of) = match first {
            "list" => (Some(type_of(next())?), type_of(next())?),
            _ => (None, type_of(first)?),
        };
        if list.is_some_and(|list| !list.is_integer()) {
            return error_at_line("the count type of a list must be an integer type".into());
        }
        let name = next();
        if name.is_empty() || element.has(name) {
            return error_at_line(format!("missing or duplicate property name {}", quoted(name)));
        }
        element.properties.push(PlyProperty { name: name.to_owned(), count_type: list, scalar_type: of });
        Ok(())
    }
}
