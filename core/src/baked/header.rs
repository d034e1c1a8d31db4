//! What a baked scene begins with: where its tables are, and what is there once.

use zerocopy::{ConvertError, Immutable, KnownLayout, TryFromBytes};

use super::error::{BakedSceneError, BakedSection};
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
pub(super) enum TableId {
    Shapes,
    Vertices,
    VertexNormals,
    Planes,
    Discs,
    Polygons,
    Cuboids,
    OrientedCuboids,
    Cones,
    Tori,
    Moving,
    MaterialIds,
    Materials,
    Textures,
    Lights,
    /// The cells of a grid, the nodes of an octree or a hierarchy.
    Nodes,
    /// The items that those list.
    Entries,
}

/// How many tables there are.
pub(super) const TABLES: usize = TableId::Entries as usize + 1;

/// Where a table is.
#[derive(Clone, Copy, Debug, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub(super) struct TableLocation {
    /// Its first byte, counted from that of the header.
    pub(super) start: u32,
    /// How many entries it has.
    pub(super) count: u32,
}

/// The beginning of a baked scene.
#[derive(Clone, Copy, Debug, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub(super) struct BakedHeader {
    pub(super) magic: u32,
    pub(super) version: u32,
    /// How many bytes there are, the header among them.
    pub(super) bytes: u32,
    /// Of all bytes after it.
    pub(super) checksum: u32,
    pub(super) resolution: [u32; 2],
    pub(super) levels: u32,
    pub(super) cutoff: Real,
    pub(super) camera: CameraDescriptor,
    pub(super) ambient: Rgb,
    pub(super) background: Background,
    /// One when light passes through bodies on its way from a light, else zero.
    pub(super) colored_shadows: u32,
    /// The kind of the accelerator, and its own numbers.
    pub(super) accelerator: u32,
    pub(super) bounds: Aabb,
    pub(super) cells: [u32; 3],
    pub(super) depth: u32,
    pub(super) tables: [TableLocation; TABLES],
}

/// Bytes before those that the checksum covers.
pub(super) const CHECKSUM_BEGIN: usize = 16;

/// FNV-1a (Fowler, Noll, Vo), 32 bits: against accidents, not against malice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fnv1a(pub(super) u32);

impl Fnv1a {
    pub(super) const EMPTY: Fnv1a = Fnv1a(0x811c_9dc5);

    pub(super) fn update(self, bytes: &[u8]) -> Self {
        Fnv1a(bytes.iter().fold(self.0, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193)))
    }
}

impl BakedHeader {
    /// The header of `bytes`, which are all there and as they were written.
    pub(super) fn parse(bytes: &[u8]) -> Result<&Self, BakedSceneError> {
        let given = bytes.len();
        let words = |place: usize| {
            let word = bytes.get(4 * place..)?.first_chunk::<4>()?;
            Some(u32::from_ne_bytes(*word))
        };
        let too_short = BakedSceneError::TooShort { needed: size_of::<BakedHeader>(), provided: given };
        if words(0).ok_or(too_short)? != MAGIC {
            return Err(BakedSceneError::BadMagic);
        }
        let found = words(1).ok_or(too_short)?;
        if found != VERSION {
            return Err(BakedSceneError::Version { found });
        }
        let needed = words(2).ok_or(too_short)? as usize;
        let bytes = bytes.get(..needed).ok_or(BakedSceneError::TooShort { needed, provided: given })?;
        let covered = bytes.get(CHECKSUM_BEGIN..).ok_or(too_short)?;
        if words(3) != Some(Fnv1a::EMPTY.update(covered).0) {
            return Err(BakedSceneError::Checksum);
        }
        match BakedHeader::try_ref_from_prefix(bytes) {
            Ok((header, _)) => Ok(header),
            Err(ConvertError::Alignment(_)) => Err(BakedSceneError::Misaligned),
            Err(ConvertError::Size(_)) => Err(too_short),
            Err(ConvertError::Validity(_)) => Err(BakedSceneError::Section(BakedSection::Header)),
        }
    }

    /// A table of the scene.
    pub(super) fn table<'s, T>(&self, bytes: &'s [u8], content: TableId) -> Result<&'s [T], BakedSceneError>
    where
        T: TryFromBytes + KnownLayout + Immutable,
    {
        let wrong = BakedSceneError::Section(BakedSection::Table(content as u8));
        let TableLocation { start, count } = *self.tables.get(content as usize).ok_or(wrong)?;
        let length = size_of::<T>().checked_mul(count as usize).ok_or(wrong)?;
        let bytes = bytes.get(start as usize..).and_then(|bytes| bytes.get(..length)).ok_or(wrong)?;
        <[T]>::try_ref_from_bytes(bytes).map_err(|error| match error {
            ConvertError::Alignment(_) if start % 4 == 0 => BakedSceneError::Misaligned,
            _ => wrong,
        })
    }

    /// Whether the accelerator is of a kind.
    pub(super) fn expect_accelerator(&self, finder: u32) -> Result<(), BakedSceneError> {
        if self.accelerator == finder {
            Ok(())
        } else {
            Err(BakedSceneError::Section(BakedSection::Accelerator))
        }
    }
}
