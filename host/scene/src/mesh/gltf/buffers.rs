//! Where the numbers of a glTF file are, and whether they are all there.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use base64::Engine;

use super::json::{GltfAccessor, GltfDocument};
use crate::error::LoadError;
use crate::quote::quoted;
use crate::source_files::SourceFiles;

/// What an accessor may hold: the number of its type, how it is called, its bytes.
pub struct AccessorType {
    pub components: &'static [u32],
    pub name: &'static str,
    pub components_per_element: usize,
}

/// Three single-precision numbers.
pub const VEC3_F32: AccessorType =
    AccessorType { components: &[FLOAT], name: "VEC3", components_per_element: 3 };

/// One integer.
pub const SCALAR_UINT: AccessorType =
    AccessorType { components: &[BYTE, SHORT, INT], name: "SCALAR", components_per_element: 1 };

const BYTE: u32 = 5121;
const SHORT: u32 = 5123;
const INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// The bytes of all buffers.
pub struct Buffers {
    loaded: Vec<Rc<Vec<u8>>>,
}

impl Buffers {
    /// Loads the buffers of the file at `path`; `binary` is the second part of a `.glb`.
    pub fn load(
        files: &SourceFiles,
        path: &Path,
        root: &GltfDocument,
        mut binary: Option<Vec<u8>>,
    ) -> Result<Self, LoadError> {
        let wrong = |number: usize, reason: &str| LoadError::Invalid {
            path: path.to_owned(),
            line: None,
            reason: format!("buffers[{number}]: {reason}"),
        };
        let mut read: HashMap<PathBuf, Rc<Vec<u8>>> = HashMap::new();
        let mut loaded = Vec::new();
        for (number, buffer) in root.buffers.iter().enumerate() {
            let bytes = match &buffer.uri {
                None => match binary.take() {
                    Some(binary) if number == 0 => Rc::new(binary),
                    _ => return Err(wrong(number, "has no `uri`, and there is no binary part for it")),
                },
                Some(uri) if uri.starts_with("data:") => {
                    Rc::new(decode_data_uri(uri).map_err(|reason| wrong(number, &reason))?)
                }
                Some(uri) if uri.contains("://") => {
                    return Err(wrong(number, "is not beside the file; nothing is fetched from elsewhere"));
                }
                Some(uri) => {
                    let name =
                        percent_decoded(uri).ok_or_else(|| wrong(number, "the name in `uri` is no text"))?;
                    let place = path.parent().unwrap_or(Path::new("")).join(name);
                    match read.get(&place) {
                        Some(known) => Rc::clone(known),
                        None => {
                            let bytes = files.read_referenced(&place).map(Rc::new);
                            let unreadable = |error| LoadError::Unreadable { path: place.clone(), error };
                            let bytes = bytes.map_err(unreadable)?;
                            read.insert(place, Rc::clone(&bytes));
                            bytes
                        }
                    }
                }
            };
            if (bytes.len() as u64) < buffer.byte_length {
                let (needed, there) = (buffer.byte_length, bytes.len());
                return Err(wrong(number, &format!("has {there} bytes; `byteLength` says {needed}")));
            }
            loaded.push(bytes);
        }
        Ok(Buffers { loaded })
    }

    /// Names the files of textures, which are not read.
    pub fn note_textures(files: &SourceFiles, path: &Path, root: &GltfDocument) {
        let beside = |uri: &&str| !uri.starts_with("data:") && !uri.contains("://");
        let uris = root.images.iter().filter_map(|image| image.uri.as_deref()).filter(beside);
        for name in uris.filter_map(percent_decoded) {
            files.note_path(path.parent().unwrap_or(Path::new("")).join(name));
        }
    }

    /// How many bytes there are.
    pub fn bytes(&self) -> usize {
        self.loaded.iter().map(|bytes| bytes.len()).sum()
    }

    /// The entries of an accessor, which must be of this kind.
    pub fn accessor<'b>(
        &'b self,
        root: &'b GltfDocument,
        place: usize,
        kind: &AccessorType,
    ) -> Result<AccessorView<'b>, String> {
        let accessor = root.accessors.get(place).ok_or_else(|| format!("there is no accessors[{place}]"))?;
        self.find(root, accessor, kind).map_err(|reason| format!("accessors[{place}]: {reason}"))
    }

    fn find<'b>(
        &'b self,
        root: &'b GltfDocument,
        accessor: &GltfAccessor,
        kind: &AccessorType,
    ) -> Result<AccessorView<'b>, String> {
        if accessor.kind != kind.name || !kind.components.contains(&accessor.component_type) {
            let (is, number) = (quoted(&accessor.kind), accessor.component_type);
            return Err(format!("holds {is} of component type {number}, which cannot stand here"));
        }
        if accessor.sparse.is_some() {
            return Err("sparse accessors are not read".into());
        }
        let Some(place) = accessor.buffer_view else {
            return Err("has no `bufferView`".into());
        };
        let view = root.buffer_views.get(place).ok_or_else(|| format!("there is no bufferViews[{place}]"))?;
        let missing = || format!("bufferViews[{place}] is not inside its buffer");
        let buffer = self.loaded.get(view.buffer).ok_or_else(missing)?;
        let buffer = byte_range(buffer, view.byte_offset, view.byte_length).ok_or_else(missing)?;

        let component = match accessor.component_type {
            BYTE => 1,
            SHORT => 2,
            _ => 4,
        };
        let size = component * kind.components_per_element;
        let stride = view.byte_stride.map_or(Some(size), |stride| usize::try_from(stride).ok());
        let short = || format!("is not inside bufferViews[{place}]");
        let stride = stride.filter(|stride| *stride >= size).ok_or_else(short)?;
        let offset = usize::try_from(accessor.byte_offset).map_err(|_| short())?;
        let bytes = buffer.get(offset..).ok_or_else(short)?;
        let count = usize::try_from(accessor.count).map_err(|_| short())?;
        // The last entry need not fill its stride.
        if count > 0 {
            let end = (count - 1).checked_mul(stride).and_then(|start| start.checked_add(size));
            end.filter(|end| *end <= bytes.len()).ok_or_else(short)?;
        }
        Ok(AccessorView { bytes, count, stride, component })
    }
}

fn byte_range(bytes: &[u8], offset: u64, length: u64) -> Option<&[u8]> {
    let end = offset.checked_add(length)?;
    bytes.get(usize::try_from(offset).ok()?..usize::try_from(end).ok()?)
}

/// Entries that are all there.
pub struct AccessorView<'b> {
    bytes: &'b [u8],
    pub count: usize,
    stride: usize,
    component: usize,
}

impl AccessorView<'_> {
    /// A vector; none beyond the end.
    pub fn vec3(&self, place: usize) -> Option<[f32; 3]> {
        let bytes = self.element(place)?;
        let number = |i: usize| bytes.get(4 * i..)?.first_chunk().copied().map(f32::from_le_bytes);
        Some([number(0)?, number(1)?, number(2)?])
    }

    /// An integer; none beyond the end.
    pub fn index(&self, place: usize) -> Option<u32> {
        let bytes = self.element(place)?;
        match self.component {
            1 => bytes.first().copied().map(u32::from),
            2 => bytes.first_chunk().copied().map(u16::from_le_bytes).map(u32::from),
            _ => bytes.first_chunk().copied().map(u32::from_le_bytes),
        }
    }

    fn element(&self, place: usize) -> Option<&[u8]> {
        if place < self.count { self.bytes.get(place * self.stride..) } else { None }
    }
}

/// The bytes of a `data:` URI.
fn decode_data_uri(uri: &str) -> Result<Vec<u8>, String> {
    let Some((kind, text)) = uri.split_once(',') else {
        return Err("the `data:` in `uri` has no comma".into());
    };
    if !kind.ends_with(";base64") {
        return Err("the `data:` in `uri` is not in base64".into());
    }
    let decoded = base64::engine::general_purpose::STANDARD.decode(text);
    decoded.map_err(|error| format!("the base64 in `uri` is wrong: {error}"))
}

/// The name with its `%20` and the like replaced; none when it is no UTF-8 then.
fn percent_decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, after @ ..] = rest {
        let code = after.get(..2).filter(|_| *first == b'%');
        let code = code.and_then(|hex| u8::from_str_radix(str::from_utf8(hex).ok()?, 16).ok());
        bytes.push(code.unwrap_or(*first));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    String::from_utf8(bytes).ok()
}
