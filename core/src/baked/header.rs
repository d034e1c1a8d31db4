//! What a baked scene begins with: where its tables are, and what is there once.

use zerocopy::{ConvertError, Immutable, KnownLayout, TryFromBytes};

use super::error::{PackError, PackPart};
use crate::geometry::Aabb;
use crate::math::{Real, Rgb};
use crate::scene::{Background, CameraDescriptor};

/// The first word: `strl`.
pub(super) const MAGIC: u32 = u32::from_le_bytes(*b"strl");

/// The version of the format that is written and read.
pub(super) const VERSION: u32 = 3;

/// Kinds of accelerators.
pub(super) const BARE: u32 = 0;
pub(super) const GRID: u32 = 1;
pub(super) const OCTREE: u32 = 2;
pub(super) const BVH: u32 = 3;

/// The tables, in the order of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    Shapes,
    Points,
    Normals,
    Planes,
    Discs,
    Polygons,
    Cuboids,
    TurnedCuboids,
    Cones,
    Tori,
    Moving,
    MadeOf,
    Materials,
    Textures,
    Lights,
    /// The cells of a grid, the nodes of an octree or a hierarchy.
    Nodes,
    /// The items that those list.
    Items,
}

/// How many tables there are.
pub(super) const TABLES: usize = Content::Items as usize + 1;

/// Where a table is.
#[derive(Clone, Copy, Debug, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub(super) struct Table {
    /// Its first byte, counted from that of the header.
    pub(super) start: u32,
    /// How many entries it has.
    pub(super) count: u32,
}

/// The beginning of a baked scene.
#[derive(Clone, Copy, Debug, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub(super) struct Header {
    pub(super) magic: u32,
    pub(super) version: u32,
    /// How many bytes there are, the header among them.
    pub(super) bytes: u32,
    /// Of all bytes after it.
    pub(super) checksum: u32,
    pub(super) size: [u32; 2],
    pub(super) levels: u32,
    pub(super) cutoff: Real,
    pub(super) view: CameraDescriptor,
    pub(super) ambient: Rgb,
    pub(super) background: Background,
    /// One when light passes through bodies on its way from a light, else zero.
    pub(super) colored_shadows: u32,
    /// The kind of the accelerator, and its own numbers.
    pub(super) finder: u32,
    pub(super) bounds: Aabb,
    pub(super) cells: [u32; 3],
    pub(super) depth: u32,
    pub(super) tables: [Table; TABLES],
}

/// Bytes before those that the checksum covers.
pub(super) const UNCHECKED: usize = 16;

/// FNV-1a (Fowler, Noll, Vo), 32 bits: against accidents, not against malice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Checksum(pub(super) u32);

impl Checksum {
    pub(super) const EMPTY: Checksum = Checksum(0x811c_9dc5);

    pub(super) fn and(self, bytes: &[u8]) -> Self {
        Checksum(bytes.iter().fold(self.0, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193)))
    }
}

impl Header {
    /// The header of `bytes`, which are all there and as they were written.
    pub(super) fn of(bytes: &[u8]) -> Result<&Self, PackError> {
        let given = bytes.len();
        let words = |place: usize| {
            let word = bytes.get(4 * place..)?.first_chunk::<4>()?;
            Some(u32::from_ne_bytes(*word))
        };
        let too_short = PackError::TooShort { needed: size_of::<Header>(), given };
        if words(0).ok_or(too_short)? != MAGIC {
            return Err(PackError::NotAPack);
        }
        let found = words(1).ok_or(too_short)?;
        if found != VERSION {
            return Err(PackError::Version { found });
        }
        let needed = words(2).ok_or(too_short)? as usize;
        let bytes = bytes.get(..needed).ok_or(PackError::TooShort { needed, given })?;
        let covered = bytes.get(UNCHECKED..).ok_or(too_short)?;
        if words(3) != Some(Checksum::EMPTY.and(covered).0) {
            return Err(PackError::Checksum);
        }
        match Header::try_ref_from_prefix(bytes) {
            Ok((header, _)) => Ok(header),
            Err(ConvertError::Alignment(_)) => Err(PackError::Misaligned),
            Err(ConvertError::Size(_)) => Err(too_short),
            Err(ConvertError::Validity(_)) => Err(PackError::Part(PackPart::Header)),
        }
    }

    /// A table of the scene.
    pub(super) fn table<'s, T>(&self, bytes: &'s [u8], content: Content) -> Result<&'s [T], PackError>
    where
        T: TryFromBytes + KnownLayout + Immutable,
    {
        let wrong = PackError::Part(PackPart::Table(content as u8));
        let Table { start, count } = *self.tables.get(content as usize).ok_or(wrong)?;
        let length = size_of::<T>().checked_mul(count as usize).ok_or(wrong)?;
        let bytes = bytes.get(start as usize..).and_then(|bytes| bytes.get(..length)).ok_or(wrong)?;
        <[T]>::try_ref_from_bytes(bytes).map_err(|error| match error {
            ConvertError::Alignment(_) if start % 4 == 0 => PackError::Misaligned,
            _ => wrong,
        })
    }

    /// Whether the accelerator is of a kind.
    pub(super) fn must_have(&self, finder: u32) -> Result<(), PackError> {
        if self.finder == finder { Ok(()) } else { Err(PackError::Part(PackPart::Finder)) }
    }
}
