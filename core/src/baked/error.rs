//! Why bytes are no baked scene.

use core::fmt;

use crate::scene::SceneError;

/// Why bytes are no baked scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PackError {
    /// They do not begin at an address that 4 divides.
    Misaligned,
    /// There are too few.
    TooShort {
        /// How many it takes.
        needed: usize,
        /// How many there are.
        given: usize,
    },
    /// They do not begin as a baked scene does (on a little-endian machine).
    NotAPack,
    /// They are of another version.
    Version {
        /// Which.
        found: u32,
    },
    /// They are not what was written.
    Checksum,
    /// A part is out of range, or not there.
    Part(PackPart),
    /// Its parts make no scene.
    Scene(SceneError),
}

/// A part of a baked scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PackPart {
    /// What comes first.
    Header,
    /// The size of the picture.
    Size,
    /// A table of the scene: its number, in the order of the format.
    Table(u8),
    /// The accelerator.
    Finder,
}

impl fmt::Display for PackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PackError::Misaligned => f.write_str("the bytes are not aligned to 4"),
            PackError::TooShort { needed, given } => write!(f, "{needed} bytes needed, {given} given"),
            PackError::NotAPack => f.write_str("this is no baked scene"),
            PackError::Version { found } => write!(f, "version {found} of the format is not known here"),
            PackError::Checksum => f.write_str("the bytes have changed since they were written"),
            PackError::Part(PackPart::Header) => f.write_str("the header is out of range"),
            PackError::Part(PackPart::Size) => f.write_str("the size of the picture is out of range"),
            PackError::Part(PackPart::Table(number)) => write!(f, "table {number} is out of range"),
            PackError::Part(PackPart::Finder) => {
                f.write_str("the accelerator is out of range, or of another kind")
            }
            PackError::Scene(error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for PackError {}
