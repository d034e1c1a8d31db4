//! Buffers, buffer views and accessors of glTF, with bounds checks.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use base64::Engine;

use super::json::{GltfAccessor, GltfDocument};
use crate::error::LoadError;
use crate::quote::quoted;
use crate::source_files::SourceFiles;

/// An accessor type: allowed component types, its name, and its number of components.
pub struct AccessorType {
    pub components: &'static [u32],
    pub name: &'static str,
    pub components_per_element: usize,
}

/// Vectors of three single-precision numbers.
pub const VEC3_F32: AccessorType =
    AccessorType { components: &[FLOAT], name: "VEC3", components_per_element: 3 };

/// Unsigned integers of any size.
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
    /// Loads the buffers of the file at `path`; `binary` is the binary chunk of a `.glb`.
    pub fn load(
        files: &SourceFiles,
        path: &Path,
        root: &GltfDocument,
        mut binary: Option<Vec<u8>>,
    ) -> Result<Self, LoadError> {
        let invalid = |number: usize, reason: &str| LoadError::Invalid {
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
                    _ => return Err(invalid(number, "has no `uri`, and the file has no binary chunk")),
                },
                Some(uri) if uri.starts_with("data:") => {
                    Rc::new(decode_data_uri(uri).map_err(|reason| invalid(number, &reason))?)
                }
                Some(uri) if uri.contains("://") => {
                    return Err(invalid(number, "is a remote URI; only local files are read"));
                }
                Some(uri) => {
                    let name =
                        percent_decoded(uri).ok_or_else(|| invalid(number, "`uri` is not valid UTF-8"))?;
                    let file = path.parent().unwrap_or(Path::new("")).join(name);
                    match read.get(&file) {
                        Some(bytes) => Rc::clone(bytes),
                        None => {
                            let bytes = files.read_referenced(&file).map(Rc::new);
                            let unreadable = |error| LoadError::Unreadable { path: file.clone(), error };
                            let bytes = bytes.map_err(unreadable)?;
                            read.insert(file, Rc::clone(&bytes));
                            bytes
                        }
                    }
                }
            };
            if (bytes.len() as u64) < buffer.byte_length {
                let (needed, there) = (buffer.byte_length, bytes.len());
                return Err(invalid(number, &format!("has {there} bytes; `byteLength` says {needed}")));
            }
            loaded.push(bytes);
        }
        Ok(Buffers { loaded })
    }

    /// Records the paths of textures, which are not read.
    pub fn note_textures(files: &SourceFiles, path: &Path, root: &GltfDocument) {
        let beside = |uri: &&str| !uri.starts_with("data:") && !uri.contains("://");
        let uris = root.images.iter().filter_map(|image| image.uri.as_deref()).filter(beside);
        for name in uris.filter_map(percent_decoded) {
            files.note_path(path.parent().unwrap_or(Path::new("")).join(name));
        }
    }

    /// The total size of all buffers, in bytes.
    pub fn bytes(&self) -> usize {
        self.loaded.iter().map(|bytes| bytes.len()).sum()
    }

    /// The elements of an accessor, which must have this type.
    pub fn accessor<'b>(
        &'b self,
        root: &'b GltfDocument,
        index: usize,
        kind: &AccessorType,
    ) -> Result<AccessorView<'b>, String> {
        let accessor =
            root.accessors.get(index).ok_or_else(|| format!("accessors[{index}] does not exist"))?;
        self.find(root, accessor, kind).map_err(|reason| format!("accessors[{index}]: {reason}"))
    }

    fn find<'b>(
        &'b self,
        root: &'b GltfDocument,
        accessor: &GltfAccessor,
        kind: &AccessorType,
    ) -> Result<AccessorView<'b>, String> {
        if accessor.kind != kind.name || !kind.components.contains(&accessor.component_type) {
            let (is, number) = (quoted(&accessor.kind), accessor.component_type);
            return Err(format!("has type {is} and component type {number}, which is not allowed here"));
        }
        if accessor.sparse.is_some() {
            return Err("sparse accessors are not supported".into());
        }
        let Some(index) = accessor.buffer_view else {
            return Err("has no `bufferView`".into());
        };
        let view =
            root.buffer_views.get(index).ok_or_else(|| format!("bufferViews[{index}] does not exist"))?;
        let missing = || format!("bufferViews[{index}] extends beyond its buffer");
        let buffer = self.loaded.get(view.buffer).ok_or_else(missing)?;
        let buffer = byte_range(buffer, view.byte_offset, view.byte_length).ok_or_else(missing)?;

        let component = match accessor.component_type {
            BYTE => 1,
            SHORT => 2,
            _ => 4,
        };
        let size = component * kind.components_per_element;
        let stride = view.byte_stride.map_or(Some(size), |stride| usize::try_from(stride).ok());
        let too_short = || format!("extends beyond bufferViews[{index}]");
        let stride = stride.filter(|stride| *stride >= size).ok_or_else(too_short)?;
        let offset = usize::try_from(accessor.byte_offset).map_err(|_| too_short())?;
        let bytes = buffer.get(offset..).ok_or_else(too_short)?;
        let count = usize::try_from(accessor.count).map_err(|_| too_short())?;
        // The last element need not fill its stride.
        if count > 0 {
            let end = (count - 1).checked_mul(stride).and_then(|start| start.checked_add(size));
            end.filter(|end| *end <= bytes.len()).ok_or_else(too_short)?;
        }
        Ok(AccessorView { bytes, count, stride, component })
    }
}

fn byte_range(bytes: &[u8], offset: u64, length: u64) -> Option<&[u8]> {
    let end = offset.checked_add(length)?;
    bytes.get(usize::try_from(offset).ok()?..usize::try_from(end).ok()?)
}

/// The elements of an accessor, all within its buffer.
pub struct AccessorView<'b> {
    bytes: &'b [u8],
    pub count: usize,
    stride: usize,
    component: usize,
}

impl AccessorView<'_> {
    /// A vector; `None` beyond the end.
    pub fn vec3(&self, index: usize) -> Option<[f32; 3]> {
        let bytes = self.element(index)?;
        let number = |i: usize| bytes.get(4 * i..)?.first_chunk().copied().map(f32::from_le_bytes);
        Some([number(0)?, number(1)?, number(2)?])
    }

    /// An integer; `None` beyond the end.
    pub fn index(&self, index: usize) -> Option<u32> {
        let bytes = self.element(index)?;
        match self.component {
            1 => bytes.first().copied().map(u32::from),
            2 => bytes.first_chunk().copied().map(u16::from_le_bytes).map(u32::from),
            _ => bytes.first_chunk().copied().map(u32::from_le_bytes),
        }
    }

    fn element(&self, index: usize) -> Option<&[u8]> {
        if index < self.count { self.bytes.get(index * self.stride..) } else { None }
    }
}

/// The bytes of a data URI in base64.
fn decode_data_uri(uri: &str) -> Result<Vec<u8>, String> {
    let Some((kind, text)) = uri.split_once(',') else {
        return Err("the data URI has no comma".into());
    };
    if !kind.ends_with(";base64") {
        return Err("the data URI is not base64".into());
    }
    let decoded = base64::engine::general_purpose::STANDARD.decode(text);
    decoded.map_err(|error| format!("invalid base64 in the data URI: {error}"))
}

/// The URI with percent escapes replaced; `None` if the result is not UTF-8.
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
