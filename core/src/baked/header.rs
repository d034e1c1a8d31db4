//! Header of a baked scene: all data that is not in tables, and the locations of the tables.

use zerocopy::{ConvertError, Immutable, KnownLayout, TryFromBytes};

use super::error::{BakedSceneError, BakedSection};
use crate::geometry::Aabb;
use crate::math::{Real, Rgb};
use crate::scene::{Background, CameraDescriptor};

/// Magic number: `strl`.
pub(super) const MAGIC: u32 = u32::from_le_bytes(*b"strl");

/// Version of the format that is written and read.
pub(super) const VERSION: u32 = 3;

/// Kinds of accelerators.
pub(super) const LIST: u32 = 0;
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
    /// Cells of a grid, nodes of an octree or bounding volume hierarchy.
    Nodes,
    /// Entries that the cells or nodes refer to.
    Entries,
}

/// Number of tables.
pub(super) const TABLES: usize = TableId::Entries as usize + 1;

/// Location of a table.
#[derive(Clone, Copy, Debug, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub(super) struct TableLocation {
    /// Offset of its first byte from the header.
    pub(super) start: u32,
    /// Number of entries.
    pub(super) count: u32,
}

/// Header of a baked scene.
#[derive(Clone, Copy, Debug, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub(super) struct BakedHeader {
    pub(super) magic: u32,
    pub(super) version: u32,
    /// Total number of bytes, including the header.
    pub(super) bytes: u32,
    /// FNV-1a of all bytes after it.
    pub(super) checksum: u32,
    pub(super) resolution: [u32; 2],
    pub(super) levels: u32,
    pub(super) cutoff: Real,
    pub(super) camera: CameraDescriptor,
    pub(super) ambient: Rgb,
    pub(super) background: Background,
    /// [`SceneDescriptor::colored_shadows`](crate::SceneDescriptor::colored_shadows), 1 for true, 0 for false.
    pub(super) colored_shadows: u32,
    /// Kind of the accelerator, followed by its fields.
    pub(super) accelerator: u32,
    pub(super) bounds: Aabb,
    pub(super) cells: [u32; 3],
    pub(super) depth: u32,
    pub(super) tables: [TableLocation; TABLES],
}

/// Offset of the first byte that the checksum covers.
pub(super) const CHECKSUM_BEGIN: usize = 16;

/// Hash FNV-1a (Fowler, Noll, Vo) of 32 bits. Detects accidental changes, not malicious ones.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fnv1a(pub(super) u32);

impl Fnv1a {
    pub(super) const EMPTY: Fnv1a = Fnv1a(0x811c_9dc5);

    pub(super) fn update(self, bytes: &[u8]) -> Self {
        Fnv1a(bytes.iter().fold(self.0, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193)))
    }
}

impl BakedHeader {
    /// The header of `bytes`, after a check of the length and checksum of all bytes.
    pub(super) fn parse(bytes: &[u8]) -> Result<&Self, BakedSceneError> {
        let provided = bytes.len();
        let word_at = |index: usize| {
            let word = bytes.get(4 * index..)?.first_chunk::<4>()?;
            Some(u32::from_ne_bytes(*word))
        };
        let too_short = BakedSceneError::TooShort { needed: size_of::<BakedHeader>(), provided };
        if word_at(0).ok_or(too_short)? != MAGIC {
            return Err(BakedSceneError::BadMagic);
        }
        let found = word_at(1).ok_or(too_short)?;
        if found != VERSION {
            return Err(BakedSceneError::Version { found });
        }
        let needed = word_at(2).ok_or(too_short)? as usize;
        let bytes = bytes.get(..needed).ok_or(BakedSceneError::TooShort { needed, provided })?;
        let covered = bytes.get(CHECKSUM_BEGIN..).ok_or(too_short)?;
        if word_at(3) != Some(Fnv1a::EMPTY.update(covered).0) {
            return Err(BakedSceneError::Checksum);
        }
        match BakedHeader::try_ref_from_prefix(bytes) {
            Ok((header, _)) => Ok(header),
            Err(ConvertError::Alignment(_)) => Err(BakedSceneError::Misaligned),
            Err(ConvertError::Size(_)) => Err(too_short),
            Err(ConvertError::Validity(_)) => Err(BakedSceneError::Section(BakedSection::Header)),
        }
    }

    /// A table of the baked scene.
    pub(super) fn table<'s, T>(&self, bytes: &'s [u8], id: TableId) -> Result<&'s [T], BakedSceneError>
    where
        T: TryFromBytes + KnownLayout + Immutable,
    {
        let error = BakedSceneError::Section(BakedSection::Table(id as u8));
        let TableLocation { start, count } = *self.tables.get(id as usize).ok_or(error)?;
        let length = size_of::<T>().checked_mul(count as usize).ok_or(error)?;
        let bytes = bytes.get(start as usize..).and_then(|bytes| bytes.get(..length)).ok_or(error)?;
        <[T]>::try_ref_from_bytes(bytes).map_err(|cause| match cause {
            ConvertError::Alignment(_) if start % 4 == 0 => BakedSceneError::Misaligned,
            _ => error,
        })
    }

    /// Checks the kind of the accelerator.
    pub(super) fn expect_accelerator(&self, kind: u32) -> Result<(), BakedSceneError> {
        if self.accelerator == kind {
            Ok(())
        } else {
            Err(BakedSceneError::Section(BakedSection::Accelerator))
        }
    }
}
