//! Why bytes are no baked scene.

use core::fmt;

use crate::scene::SceneError;

/// Why bytes are no baked scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BakedSceneError {
    /// They do not begin at an address that 4 divides.
    Misaligned,
    /// There are too few.
    TooShort {
        /// How many it takes.
        needed: usize,
        /// How many there are.
        provided: usize,
    },
    /// They do not begin as a baked scene does (on a little-endian machine).
    BadMagic,
    /// They are of another version.
    Version {
        /// Which.
        found: u32,
    },
    /// They are not what was written.
    Checksum,
    /// A part is out of range, or not there.
    Section(BakedSection),
    /// Its parts make no scene.
    Scene(SceneError),
}

/// A part of a baked scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BakedSection {
    /// What comes first.
    Header,
    /// The size of the picture.
    Resolution,
    /// A table of the scene: its number, in the order of the format.
    Table(u8),
    /// The accelerator.
    Accelerator,
}

impl fmt::Display for BakedSceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BakedSceneError::Misaligned => f.write_str("the bytes are not aligned to 4"),
            BakedSceneError::TooShort { needed, provided: given } => {
                write!(f, "{needed} bytes needed, {given} given")
            }
            BakedSceneError::BadMagic => f.write_str("this is no baked scene"),
            BakedSceneError::Version { found } => {
                write!(f, "version {found} of the format is not known here")
            }
            BakedSceneError::Checksum => f.write_str("the bytes have changed since they were written"),
            BakedSceneError::Section(BakedSection::Header) => f.write_str("the header is out of range"),
            BakedSceneError::Section(BakedSection::Resolution) => {
                f.write_str("the size of the picture is out of range")
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
