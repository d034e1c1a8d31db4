//! Baked scenes: a scene and its accelerator in bytes, traced in place.
//!
//! A host bakes a scene once ([`BakedSceneWriter`]); a device keeps the bytes in flash and opens them
//! ([`BakedScene::open`]). The device copies nothing and builds nothing: the tables of the scene are slices of the
//! bytes. All bytes are validated when they are opened, so that no input can cause a panic or an out-of-bounds
//! read.
//!
//! # The format, version 3
//!
//! Little-endian, all sections aligned to 4 bytes:
//!
//! 1. A header: magic number, version, total length, checksum of the bytes after it (FNV-1a, 32 bits), resolution,
//!    limits, camera, ambient light and background, fields of the accelerator, and the start and length of each
//!    table.
//! 2. The tables. Their entries have the layout of the core's types in `repr(C)`.
//!
//! A baked scene is in single precision.

mod error;
mod header;
mod layout;
mod write;

pub use error::{BakedSceneError, BakedSection};
pub use write::BakedSceneWriter;

use crate::accel::{Bvh, BvhParts, Grid, GridParts, ListWithoutBounds, Octree, OctreeParts};
use crate::geometry::Geometry;
use crate::math::Real;
use crate::scene::{Camera, CameraDescriptor, CameraError, Resolution, Scene, SceneDescriptor};
use header::{BakedHeader, TableId};

/// The accelerator that a scene is baked with.
#[derive(Clone, Copy, Debug)]
pub enum BakedAccelerator<'s> {
    /// All items in order.
    ListWithoutBounds(ListWithoutBounds),
    /// A uniform grid.
    Grid(Grid<'s, 0>),
    /// An octree.
    Octree(Octree<'s, 0>),
    /// A bounding volume hierarchy.
    Bvh(Bvh<'s, ()>),
}

/// A scene in validated bytes, with a camera, a resolution, limits and an accelerator: traced in place,
/// without copying.
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
    /// Version of the format that is written and read.
    pub const VERSION: u32 = header::VERSION;

    /// Smallest size of a baked scene, in bytes: that of its header.
    pub const MIN_SIZE_IN_BYTES: usize = size_of::<BakedHeader>();

    /// Validates `bytes` and borrows the scene from them, in one pass and without memory.
    ///
    /// `bytes`: aligned to 4 bytes, as by [`include_baked_scene!`](crate::include_baked_scene!).
    ///
    /// # Errors
    ///
    /// See [`BakedSceneError`].
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
        let descriptor = SceneDescriptor {
            geometry,
            material_ids: header.table(bytes, TableId::MaterialIds)?,
            materials: header.table(bytes, TableId::Materials)?,
            textures: header.table(bytes, TableId::Textures)?,
            lights: header.table(bytes, TableId::Lights)?,
            ambient: header.ambient,
            background: header.background,
            colored_shadows: header.colored_shadows != 0,
        };
        let scene = Scene::new(descriptor).map_err(BakedSceneError::Scene)?;
        let [width, height] = header.resolution;
        let resolution =
            Resolution::new(width, height).ok_or(BakedSceneError::Section(BakedSection::Resolution))?;
        Ok(BakedScene { header, bytes, scene, resolution })
    }

    /// The scene, valid and borrowed from the bytes.
    pub const fn scene(&self) -> &Scene<'s> {
        &self.scene
    }

    /// Resolution that it was baked for. A device may use another.
    pub const fn resolution(&self) -> Resolution {
        self.resolution
    }

    /// Level limit that it was baked with ([`Limits::levels`](crate::Limits::levels)).
    pub const fn levels(&self) -> u8 {
        let levels = self.header.levels;
        if levels < 256 { levels as u8 } else { u8::MAX }
    }

    /// Cutoff that it was baked with ([`Limits::cutoff`](crate::Limits::cutoff)).
    pub const fn cutoff(&self) -> Real {
        self.header.cutoff
    }

    /// The description of the camera that is stored with the scene; [`BakedScene::camera`] makes a camera of
    /// it.
    pub const fn camera_descriptor(&self) -> &'s CameraDescriptor {
        &self.header.camera
    }

    /// The camera that it was baked with, for pictures of `resolution`.
    ///
    /// # Errors
    ///
    /// Those of [`Camera::new`].
    pub fn camera(&self, resolution: Resolution) -> Result<Camera, CameraError> {
        Camera::new(self.camera_descriptor(), resolution)
    }

    /// Number of items.
    fn item_count(&self) -> u32 {
        self.scene.descriptor().geometry.shapes.len() as u32
    }

    /// All items in order: an accelerator without memory, for any baked scene.
    pub fn list_without_bounds(&self) -> ListWithoutBounds {
        ListWithoutBounds(self.item_count())
    }

    /// Validates and borrows the grid.
    ///
    /// # Errors
    ///
    /// [`BakedSection::Accelerator`] if it is not valid, or if the accelerator is of another kind.
    pub fn grid<const MAILBOX_ENTRIES: usize>(&self) -> Result<Grid<'s, MAILBOX_ENTRIES>, BakedSceneError> {
        let (header, bytes) = (self.header, self.bytes);
        header.expect_accelerator(header::GRID)?;
        let cell_starts = header.table(bytes, TableId::Nodes)?;
        let entries = header.table(bytes, TableId::Entries)?;
        let (bounds, resolution) = (header.bounds, header.cells);
        let parts = GridParts { bounds, resolution, cell_starts, entries };
        Grid::from_parts(parts, self.item_count()).ok_or(BakedSceneError::Section(BakedSection::Accelerator))
    }

    /// Validates and borrows the octree.
    ///
    /// # Errors
    ///
    /// As for [`BakedScene::grid`].
    pub fn octree<const MAILBOX_ENTRIES: usize>(
        &self,
    ) -> Result<Octree<'s, MAILBOX_ENTRIES>, BakedSceneError> {
        let (header, bytes) = (self.header, self.bytes);
        header.expect_accelerator(header::OCTREE)?;
        let nodes = header.table(bytes, TableId::Nodes)?;
        let entries = header.table(bytes, TableId::Entries)?;
        let parts = OctreeParts { bounds: header.bounds, nodes, entries };
        Octree::from_parts(parts, self.item_count())
            .ok_or(BakedSceneError::Section(BakedSection::Accelerator))
    }

    /// Validates and borrows the bounding volume hierarchy. `Queue`: its traversal queue, such as
    /// [`TraversalStack`](crate::accel::TraversalStack).
    ///
    /// # Errors
    ///
    /// As for [`BakedScene::grid`].
    pub fn bvh<Queue>(&self) -> Result<Bvh<'s, Queue>, BakedSceneError> {
        let (header, bytes) = (self.header, self.bytes);
        header.expect_accelerator(header::BVH)?;
        let nodes = header.table(bytes, TableId::Nodes)?;
        let entries = header.table(bytes, TableId::Entries)?;
        let parts = BvhParts { nodes, entries, depth: header.depth };
        Bvh::from_parts(parts, self.item_count()).ok_or(BakedSceneError::Section(BakedSection::Accelerator))
    }

    /// Validates and borrows the accelerator, of any kind.
    ///
    /// A device that knows the kind calls [`BakedScene::grid`], [`BakedScene::octree`] or [`BakedScene::bvh`] instead
    /// and needs no code for the others.
    ///
    /// # Errors
    ///
    /// As for [`BakedScene::grid`].
    pub fn accelerator(&self) -> Result<BakedAccelerator<'s>, BakedSceneError> {
        Ok(match self.header.accelerator {
            header::LIST => BakedAccelerator::ListWithoutBounds(self.list_without_bounds()),
            header::GRID => BakedAccelerator::Grid(self.grid()?),
            header::OCTREE => BakedAccelerator::Octree(self.octree()?),
            _ => BakedAccelerator::Bvh(self.bvh()?),
        })
    }
}

/// Includes the bytes of a file like [`include_bytes!`], aligned for [`BakedScene::open`].
///
/// The example is not compiled, because it needs a file.
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
