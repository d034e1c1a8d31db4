//! Why bytes are not a valid baked scene.

use core::fmt;

use crate::scene::SceneError;

/// Why bytes are not a valid baked scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BakedSceneError {
    /// The address of the first byte is not a multiple of 4.
    Misaligned,
    /// There are too few bytes.
    TooShort {
        /// Number of bytes that are needed.
        needed: usize,
        /// Number of bytes that are provided.
        provided: usize,
    },
    /// The magic number is wrong, or the machine is not little-endian.
    BadMagic,
    /// The format has another version.
    Version {
        /// The version of the bytes; [`BakedScene::VERSION`](super::BakedScene::VERSION) is supported.
        found: u32,
    },
    /// The checksum is wrong: bytes have changed since they were written.
    Checksum,
    /// A section is out of range or missing.
    Section(BakedSection),
    /// The scene is not valid.
    Scene(SceneError),
}

/// A section of a baked scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BakedSection {
    /// The header.
    Header,
    /// The resolution.
    Resolution,
    /// A table of the scene, by its index in the format.
    Table(u8),
    /// The accelerator.
    Accelerator,
}

impl fmt::Display for BakedSceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BakedSceneError::Misaligned => f.write_str("the bytes are not aligned to 4"),
            BakedSceneError::TooShort { needed, provided } => {
                write!(f, "baked scene: {needed} bytes needed, {provided} provided")
            }
            BakedSceneError::BadMagic => f.write_str("not a baked scene (wrong magic number)"),
            BakedSceneError::Version { found } => {
                write!(f, "version {found} of the format is not supported")
            }
            BakedSceneError::Checksum => f.write_str("the bytes have changed since they were written"),
            BakedSceneError::Section(BakedSection::Header) => f.write_str("the header is out of range"),
            BakedSceneError::Section(BakedSection::Resolution) => {
                f.write_str("the resolution is out of range")
            }
            BakedSceneError::Section(BakedSection::Table(number)) => {
                write!(f, "table {number} is out of range")
            }
            BakedSceneError::Section(BakedSection::Accelerator) => {
                f.write_str("the accelerator is out of range, or of another kind")
            }
            BakedSceneError::Scene(error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for BakedSceneError {}
