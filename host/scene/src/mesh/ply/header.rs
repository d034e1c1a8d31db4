//! What a PLY file promises: its elements, their properties, and how numbers are written.

use crate::mesh::error::Wrong;
use crate::quote::quoted;

/// How a number is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Type {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Type::I8,
            "uchar" | "uint8" => Type::U8,
            "short" | "int16" => Type::I16,
            "ushort" | "uint16" => Type::U16,
            "int" | "int32" => Type::I32,
            "uint" | "uint32" => Type::U32,
            "float" | "float32" => Type::F32,
            "double" | "float64" => Type::F64,
            _ => return None,
        })
    }

    pub fn bytes(self) -> usize {
        match self {
            Type::I8 | Type::U8 => 1,
            Type::I16 | Type::U16 => 2,
            Type::I32 | Type::U32 | Type::F32 => 4,
            Type::F64 => 8,
        }
    }

    pub fn is_whole(self) -> bool {
        !matches!(self, Type::F32 | Type::F64)
    }
}

/// A number of each element, or as many as a number before them says.
pub struct Property {
    pub name: String,
    /// The type of the number that says how many.
    pub list: Option<Type>,
    pub of: Type,
}

/// Things of one kind.
pub struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
    /// Its line in the header.
    line: usize,
}

impl Element {
    pub fn has(&self, property: &str) -> bool {
        self.properties.iter().any(|p| p.name == property)
    }

    pub fn wrong<T>(&self, reason: impl Into<String>) -> Result<T, Wrong> {
        Err((Some(self.line), reason.into()))
    }
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    Ascii,
    Little,
    Big,
}

/// What the file promises.
pub struct Header {
    pub elements: Vec<Element>,
    pub encoding: Encoding,
    /// How many bytes it has.
    pub bytes: usize,
    /// How many lines it has.
    pub lines: usize,
}

impl Header {
    /// The header of a file.
    pub fn read(bytes: &[u8]) -> Result<Self, Wrong> {
        let (mut left, mut line) = (bytes, 0);
        let mut encoding = None;
        let mut header = Header { elements: Vec::new(), encoding: Encoding::Ascii, bytes: 0, lines: 0 };
        loop {
            line += 1;
            let end = left.iter().position(|byte| *byte == b'\n').map_or(left.len(), |place| place + 1);
            let (text, rest) = left.split_at(end);
            left = rest;
            let text = String::from_utf8_lossy(text);
            let mut words = text.split_ascii_whitespace();
            let wrong = |reason: String| Err((Some(line), reason));
            match (words.next(), line) {
                (Some("ply"), 1) => {}
                (_, 1) => return wrong("the file does not begin with `ply`, so it is no PLY file".into()),
                (None, _) if left.is_empty() => return wrong("the file ends inside its header".into()),
                (None | Some("comment" | "obj_info"), _) => {}
                (Some("format"), _) => {
                    encoding = Some(match words.next() {
                        Some("ascii") => Encoding::Ascii,
                        Some("binary_little_endian") => Encoding::Little,
                        Some("binary_big_endian") => Encoding::Big,
                        other => {
                            let other = quoted(other.unwrap_or_default());
                            return wrong(format!(
                                "the format {other} is not ascii, binary_little_endian or binary_big_endian"
                            ));
                        }
                    });
                }
                (Some("element"), _) => header.element(words, line)?,
                (Some("property"), _) => header.property(words, line)?,
                (Some("end_header"), _) => break,
                (Some(other), _) => return wrong(format!("{} does not belong into a header", quoted(other))),
            }
        }
        header.encoding = encoding.ok_or((Some(line), "the header has no `format`".into()))?;
        (header.bytes, header.lines) = (bytes.len() - left.len(), line);
        Ok(header)
    }

    fn element<'w>(&mut self, mut words: impl Iterator<Item = &'w str>, line: usize) -> Result<(), Wrong> {
        let (name, count) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let Ok(count) = count.parse::<usize>() else {
            let reason = format!("{} is no number of elements {}", quoted(count), quoted(name));
            return Err((Some(line), reason));
        };
        if self.elements.iter().any(|element| element.name == name) {
            return Err((Some(line), format!("a second element {}", quoted(name))));
        }
        self.elements.push(Element { name: name.to_owned(), count, properties: Vec::new(), line });
        Ok(())
    }

    fn property<'w>(&mut self, mut words: impl Iterator<Item = &'w str>, line: usize) -> Result<(), Wrong> {
        let wrong = |reason: String| Err((Some(line), reason));
        let Some(element) = self.elements.last_mut() else {
            return wrong("a property before the first element".into());
        };
        let mut next = || words.next().unwrap_or_default();
        let type_of = |name: &str| {
            Type::named(name).ok_or((Some(line), format!("{} is no type of a number", quoted(name))))
        };
        let first = next();
        let (list, of) = match first {
            "list" => (Some(type_of(next())?), type_of(next())?),
            _ => (None, type_of(first)?),
        };
        if list.is_some_and(|list| !list.is_whole()) {
            return wrong("the length of a list must be an integer".into());
        }
        let name = next();
        if name.is_empty() || element.has(name) {
            return wrong(format!("{} is no name for a property, or is there already", quoted(name)));
        }
        element.properties.push(Property { name: name.to_owned(), list, of });
        Ok(())
    }
}
