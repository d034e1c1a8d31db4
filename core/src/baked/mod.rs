//! A baked scene: a scene and its accelerator in bytes, ready to be traced where they lie.
//!
//! A host bakes a scene once ([`Baking`]); a device keeps the bytes in flash and opens them
//! ([`Pack::open`]). Nothing is copied and nothing is built: the tables of the scene are slices
//! of the bytes. Everything that a table says is checked before it is believed, so that no bytes
//! whatever lead to a panic or to a read outside of them.
//!
//! # The format, version 3
//!
//! Little-endian, every part aligned to 4 bytes. First a header: a magic word, the version,
//! the length of the whole, a checksum of what follows it (FNV-1a, 32 bits), then what is there
//! once (size, limits, view, surroundings, the accelerator's own numbers), and for each table
//! where it begins and how many entries it has. Then the tables, whose entries have the layout
//! of the core's own types in `repr(C)`. A baked scene holds single precision.

mod error;
mod header;
mod layout;
mod write;

pub use error::{PackError, PackPart};
pub use write::Baking;

use crate::accel::{BareList, Bvh, BvhParts, Grid, GridParts, Octree, OctreeParts};
use crate::geometry::Geometry;
use crate::math::Real;
use crate::scene::{Camera, CameraDescriptor, CameraError, Resolution, Scene, SceneDescriptor};
use header::{Content, Header};

/// What a baked scene is to be walked by.
#[derive(Clone, Copy, Debug)]
pub enum Finder<'s> {
    /// Every item in order.
    Bare(BareList),
    /// A uniform grid.
    Grid(Grid<'s, 0>),
    /// An octree.
    Octree(Octree<'s, 0>),
    /// A hierarchy of boxes.
    Bvh(Bvh<'s, ()>),
}

/// A baked scene that has been checked.
///
/// ```
/// use strahl_core::baked::{Finder, Pack, PackError};
/// use strahl_core::include_pack;
///
/// # fn bytes() -> &'static [u8] { &[] }
/// // In firmware: `let bytes = include_pack!("scene.strahl");`
/// let bytes = bytes();
/// let Err(error) = Pack::open(bytes) else { panic!() };
/// assert_eq!(error, PackError::TooShort { needed: Pack::HEADER, given: 0 });
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pack<'s> {
    header: &'s Header,
    bytes: &'s [u8],
    scene: Scene<'s>,
    size: Resolution,
}

impl<'s> Pack<'s> {
    /// The version of the format that is written and read.
    pub const VERSION: u32 = header::VERSION;

    /// The fewest bytes that a baked scene has.
    pub const HEADER: usize = size_of::<Header>();

    /// The scene in `bytes`, which must be aligned to 4 ([`include_pack!`](crate::include_pack!)).
    ///
    /// One pass over the bytes, no memory of its own. Errors: [`PackError`], for everything that
    /// these bytes are not.
    pub fn open(bytes: &'s [u8]) -> Result<Self, PackError> {
        let header = Header::of(bytes)?;
        let geometry = Geometry {
            shapes: header.table(bytes, Content::Shapes)?,
            vertices: header.table(bytes, Content::Points)?,
            vertex_normals: header.table(bytes, Content::Normals)?,
            planes: header.table(bytes, Content::Planes)?,
            discs: header.table(bytes, Content::Discs)?,
            polygons: header.table(bytes, Content::Polygons)?,
            cuboids: header.table(bytes, Content::Cuboids)?,
            oriented_cuboids: header.table(bytes, Content::TurnedCuboids)?,
            cones: header.table(bytes, Content::Cones)?,
            tori: header.table(bytes, Content::Tori)?,
            moving_shapes: header.table(bytes, Content::Moving)?,
        };
        let parts = SceneDescriptor {
            geometry,
            material_ids: header.table(bytes, Content::MadeOf)?,
            materials: header.table(bytes, Content::Materials)?,
            textures: header.table(bytes, Content::Textures)?,
            lights: header.table(bytes, Content::Lights)?,
            ambient: header.ambient,
            background: header.background,
            colored_shadows: header.colored_shadows != 0,
        };
        let scene = Scene::new(parts).map_err(PackError::Scene)?;
        let [width, height] = header.size;
        let size = Resolution::new(width, height).ok_or(PackError::Part(PackPart::Size))?;
        Ok(Pack { header, bytes, scene, size })
    }

    /// The scene.
    pub const fn scene(&self) -> &Scene<'s> {
        &self.scene
    }

    /// The size of the picture that it was baked for. A device may take another.
    pub const fn size(&self) -> Resolution {
        self.size
    }

    /// The levels of rays that it was baked with.
    pub const fn levels(&self) -> u8 {
        let levels = self.header.levels;
        if levels < 256 { levels as u8 } else { u8::MAX }
    }

    /// The cutoff that it was baked with.
    pub const fn cutoff(&self) -> Real {
        self.header.cutoff
    }

    /// How the scene is looked at.
    pub const fn view(&self) -> &'s CameraDescriptor {
        &self.header.view
    }

    /// The camera of a picture of `size`.
    pub fn camera(&self, size: Resolution) -> Result<Camera, CameraError> {
        Camera::new(self.view(), size)
    }

    /// How many items there are.
    fn count(&self) -> u32 {
        self.scene.descriptor().geometry.shapes.len() as u32
    }

    /// Every item in order: an accelerator that needs nothing.
    pub fn bare(&self) -> BareList {
        BareList(self.count())
    }

    /// The grid, checked here; [`PackPart::Finder`] is in error when there is none.
    pub fn grid<const MAILBOX: usize>(&self) -> Result<Grid<'s, MAILBOX>, PackError> {
        let (header, bytes) = (self.header, self.bytes);
        header.must_have(header::GRID)?;
        let cell_starts = header.table(bytes, Content::Nodes)?;
        let entries = header.table(bytes, Content::Items)?;
        let (bounds, resolution) = (header.bounds, header.cells);
        let parts = GridParts { bounds, resolution, cell_starts, entries };
        Grid::from_parts(parts, self.count()).ok_or(PackError::Part(PackPart::Finder))
    }

    /// The octree, checked here; [`PackPart::Finder`] is in error when there is none.
    pub fn octree<const MAILBOX: usize>(&self) -> Result<Octree<'s, MAILBOX>, PackError> {
        let (header, bytes) = (self.header, self.bytes);
        header.must_have(header::OCTREE)?;
        let nodes = header.table(bytes, Content::Nodes)?;
        let entries = header.table(bytes, Content::Items)?;
        let parts = OctreeParts { bounds: header.bounds, nodes, entries };
        Octree::from_parts(parts, self.count()).ok_or(PackError::Part(PackPart::Finder))
    }

    /// The hierarchy, checked here, for walks whose parts wait in a `W`; [`PackPart::Finder`] is
    /// in error when there is none.
    pub fn bvh<W>(&self) -> Result<Bvh<'s, W>, PackError> {
        let (header, bytes) = (self.header, self.bytes);
        header.must_have(header::BVH)?;
        let nodes = header.table(bytes, Content::Nodes)?;
        let entries = header.table(bytes, Content::Items)?;
        let parts = BvhParts { nodes, entries, depth: header.depth };
        Bvh::from_parts(parts, self.count()).ok_or(PackError::Part(PackPart::Finder))
    }

    /// Whatever it was baked with. A device that knows asks for that, and carries no code for the
    /// others.
    pub fn finder(&self) -> Result<Finder<'s>, PackError> {
        Ok(match self.header.finder {
            header::BARE => Finder::Bare(self.bare()),
            header::GRID => Finder::Grid(self.grid()?),
            header::OCTREE => Finder::Octree(self.octree()?),
            _ => Finder::Bvh(self.bvh()?),
        })
    }
}

/// The bytes of a file, as [`include_bytes!`] has them, aligned for [`Pack::open`].
///
/// ```ignore
/// static SCENE: &[u8] = strahl_core::include_pack!("scene.strahl");
/// ```
#[macro_export]
macro_rules! include_pack {
    ($path:expr $(,)?) => {{
        #[repr(C, align(4))]
        struct Aligned<Bytes: ?Sized>(Bytes);
        static ALIGNED: &Aligned<[u8]> = &Aligned(*include_bytes!($path));
        &ALIGNED.0
    }};
}
