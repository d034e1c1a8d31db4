//! A baked scene: a scene and its accelerator in bytes, ready to be traced where they lie.
//!
//! A host bakes a scene once ([`BakedSceneWriter`]); a device keeps the bytes in flash and opens them
//! ([`BakedScene::open`]). Nothing is copied and nothing is built: the tables of the scene are slices
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

pub use error::{BakedSceneError, BakedSection};
pub use write::BakedSceneWriter;

use crate::accel::{BareList, Bvh, BvhParts, Grid, GridParts, Octree, OctreeParts};
use crate::geometry::Geometry;
use crate::math::Real;
use crate::scene::{Camera, CameraDescriptor, CameraError, Resolution, Scene, SceneDescriptor};
use header::{BakedHeader, TableId};

/// What a baked scene is to be walked by.
#[derive(Clone, Copy, Debug)]
pub enum BakedAccelerator<'s> {
    /// Every item in order.
    BareList(BareList),
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
/// use strahl_core::baked::{BakedScene, BakedSceneError};
/// use strahl_core::include_baked_scene;
///
/// # fn bytes() -> &'static [u8] { &[] }
/// // In firmware: `let bytes = include_baked_scene!("scene.strahl");`
/// let bytes = bytes();
/// let Err(error) = BakedScene::open(bytes) else { panic!() };
/// assert_eq!(error, BakedSceneError::TooShort { needed: BakedScene::MIN_SIZE_IN_BYTES, provided: 0 });
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BakedScene<'s> {
    header: &'s BakedHeader,
    bytes: &'s [u8],
    scene: Scene<'s>,
    resolution: Resolution,
}

impl<'s> BakedScene<'s> {
    /// The version of the format that is written and read.
    pub const VERSION: u32 = header::VERSION;

    /// The fewest bytes that a baked scene has.
    pub const MIN_SIZE_IN_BYTES: usize = size_of::<BakedHeader>();

    /// The scene in `bytes`, which must be aligned to 4 ([`include_baked_scene!`](crate::include_baked_scene!)).
    ///
    /// One pass over the bytes, no memory of its own. Errors: [`BakedSceneError`], for everything that
    /// these bytes are not.
    pub fn open(bytes: &'s [u8]) -> Result<Self, BakedSceneError> {
        let header = BakedHeader::parse(bytes)?;
        let geometry = Geometry {
            shapes: header.table(bytes, TableId::Shapes)?,
            vertices: header.table(bytes, TableId::Vertices)?,
            vertex_normals: header.table(bytes, TableId::VertexNormals)?,
            planes: header.table(bytes, TableId::Planes)?,
            discs: header.table(bytes, TableId::Discs)?,
            polygons: header.table(bytes, TableId::Polygons)?,
            cuboids: header.table(bytes, TableId::Cuboids)?,
            oriented_cuboids: header.table(bytes, TableId::OrientedCuboids)?,
            cones: header.table(bytes, TableId::Cones)?,
            tori: header.table(bytes, TableId::Tori)?,
            moving_shapes: header.table(bytes, TableId::Moving)?,
        };
        let parts = SceneDescriptor {
            geometry,
            material_ids: header.table(bytes, TableId::MaterialIds)?,
            materials: header.table(bytes, TableId::Materials)?,
            textures: header.table(bytes, TableId::Textures)?,
            lights: header.table(bytes, TableId::Lights)?,
            ambient: header.ambient,
            background: header.background,
            colored_shadows: header.colored_shadows != 0,
        };
        let scene = Scene::new(parts).map_err(BakedSceneError::Scene)?;
        let [width, height] = header.resolution;
        let size =
            Resolution::new(width, height).ok_or(BakedSceneError::Section(BakedSection::Resolution))?;
        Ok(BakedScene { header, bytes, scene, resolution: size })
    }

    /// The scene.
    pub const fn scene(&self) -> &Scene<'s> {
        &self.scene
    }

    /// The size of the picture that it was baked for. A device may take another.
    pub const fn resolution(&self) -> Resolution {
        self.resolution
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
    pub const fn camera_descriptor(&self) -> &'s CameraDescriptor {
        &self.header.camera
    }

    /// The camera of a picture of `size`.
    pub fn camera(&self, size: Resolution) -> Result<Camera, CameraError> {
        Camera::new(self.camera_descriptor(), size)
    }

    /// How many items there are.
    fn item_count(&self) -> u32 {
        self.scene.descriptor().geometry.shapes.len() as u32
    }

    /// Every item in order: an accelerator that needs nothing.
    pub fn bare_list(&self) -> BareList {
        BareList(self.item_count())
    }

    /// The grid, checked here; [`BakedSection::Accelerator`] is in error when there is none.
    pub fn grid<const MAILBOX: usize>(&self) -> Result<Grid<'s, MAILBOX>, BakedSceneError> {
        let (header, bytes) = (self.header, self.bytes);
        header.expect_accelerator(header::GRID)?;
        let cell_starts = header.table(bytes, TableId::Nodes)?;
        let entries = header.table(bytes, TableId::Entries)?;
        let (bounds, resolution) = (header.bounds, header.cells);
        let parts = GridParts { bounds, resolution, cell_starts, entries };
        Grid::from_parts(parts, self.item_count()).ok_or(BakedSceneError::Section(BakedSection::Accelerator))
    }

    /// The octree, checked here; [`BakedSection::Accelerator`] is in error when there is none.
    pub fn octree<const MAILBOX: usize>(&self) -> Result<Octree<'s, MAILBOX>, BakedSceneError> {
        let (header, bytes) = (self.header, self.bytes);
        header.expect_accelerator(header::OCTREE)?;
        let nodes = header.table(bytes, TableId::Nodes)?;
        let entries = header.table(bytes, TableId::Entries)?;
        let parts = OctreeParts { bounds: header.bounds, nodes, entries };
        Octree::from_parts(parts, self.item_count())
            .ok_or(BakedSceneError::Section(BakedSection::Accelerator))
    }

    /// The hierarchy, checked here, for walks whose parts wait in a `W`; [`BakedSection::Accelerator`] is
    /// in error when there is none.
    pub fn bvh<W>(&self) -> Result<Bvh<'s, W>, BakedSceneError> {
        let (header, bytes) = (self.header, self.bytes);
        header.expect_accelerator(header::BVH)?;
        let nodes = header.table(bytes, TableId::Nodes)?;
        let entries = header.table(bytes, TableId::Entries)?;
        let parts = BvhParts { nodes, entries, depth: header.depth };
        Bvh::from_parts(parts, self.item_count()).ok_or(BakedSceneError::Section(BakedSection::Accelerator))
    }

    /// Whatever it was baked with. A device that knows asks for that, and carries no code for the
    /// others.
    pub fn accelerator(&self) -> Result<BakedAccelerator<'s>, BakedSceneError> {
        Ok(match self.header.accelerator {
            header::BARE => BakedAccelerator::BareList(self.bare_list()),
            header::GRID => BakedAccelerator::Grid(self.grid()?),
            header::OCTREE => BakedAccelerator::Octree(self.octree()?),
            _ => BakedAccelerator::Bvh(self.bvh()?),
        })
    }
}

/// The bytes of a file, as [`include_bytes!`] has them, aligned for [`BakedScene::open`].
///
/// ```ignore
/// static SCENE: &[u8] = strahl_core::include_baked_scene!("scene.strahl");
/// ```
#[macro_export]
macro_rules! include_baked_scene {
    ($path:expr $(,)?) => {{
        #[repr(C, align(4))]
        struct Aligned<Bytes: ?Sized>(Bytes);
        static ALIGNED: &Aligned<[u8]> = &Aligned(*include_bytes!($path));
        &ALIGNED.0
    }};
}
