//! Writes baked scenes, on a host.

use super::header::{BVH, BakedHeader, CHECKSUM_BEGIN, Fnv1a, GRID, LIST, MAGIC, OCTREE, TABLES, TableId};
use super::layout::{LayoutWriter, WriteLayout};
use super::{BakedAccelerator, BakedScene};
use crate::geometry::Aabb;
use crate::math::Real;
use crate::scene::{CameraDescriptor, Resolution, Scene};

/// Writes a baked scene: its fields are what is baked.
///
/// ```
/// use strahl_core::baked::{BakedAccelerator, BakedScene, BakedSceneWriter};
/// use strahl_core::*;
///
/// let writer = BakedSceneWriter {
///     scene: Scene::new(SceneDescriptor::EMPTY)?,
///     camera: CameraDescriptor::perspective(Vec3::ZERO, Vec3::X, 1.0),
///     resolution: Resolution::new(64, 48).unwrap(),
///     levels: 5,
///     cutoff: 0.0,
///     accelerator: BakedAccelerator::ListWithoutBounds(ListWithoutBounds(0)),
/// };
/// // Aligned to 4, as `BakedScene::open` requires.
/// #[repr(align(4))]
/// struct Aligned([u8; 4096]);
///
/// let (mut bytes, mut length) = (Aligned([0; 4096]), 0);
/// assert!(writer.write_to(|piece| {
///     bytes.0[length..length + piece.len()].copy_from_slice(piece);
///     length += piece.len();
/// }));
/// assert_eq!(writer.size_in_bytes(), Some(length as u32));
/// assert_eq!(BakedScene::open(&bytes.0[..length]).unwrap().levels(), 5);
/// # Ok::<(), strahl_core::scene::SceneError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BakedSceneWriter<'b> {
    /// Scene to be baked, with all its tables.
    pub scene: Scene<'b>,
    /// Camera that the scene is baked with.
    pub camera: CameraDescriptor,
    /// Resolution of the picture; a device may use another.
    pub resolution: Resolution,
    /// Level limit ([`Limits::levels`](crate::Limits::levels)).
    pub levels: u8,
    /// Cutoff ([`Limits::cutoff`](crate::Limits::cutoff)).
    pub cutoff: Real,
    /// Accelerator, built from the items of the scene.
    pub accelerator: BakedAccelerator<'b>,
}

impl BakedSceneWriter<'_> {
    /// Number of bytes of the baked scene; `None` if they are more than `u32::MAX`.
    pub fn size_in_bytes(&self) -> Option<u32> {
        self.tables().map(|(_, end)| end)
    }

    /// Passes the bytes of the baked scene to `output`, piece by piece.
    ///
    /// Returns false, without any output, if there are more than `u32::MAX` bytes.
    pub fn write_to(&self, mut output: impl FnMut(&[u8])) -> bool {
        let Some((tables, bytes)) = self.tables() else { return false };
        // Once for the checksum, once for the output.
        let mut checksum = Fnv1a::EMPTY;
        self.write_all(&tables, bytes, 0, &mut |piece, written| {
            if written >= CHECKSUM_BEGIN {
                checksum = checksum.update(piece);
            }
        });
        self.write_all(&tables, bytes, checksum.0, &mut |piece, _| output(piece));
        true
    }

    /// Start and number of entries of each table, and the end of the last one.
    fn tables(&self) -> Option<([[u32; 2]; TABLES], u32)> {
        let mut tables = [[0; 2]; TABLES];
        let mut end = size_of::<BakedHeader>();
        let mut location = tables.iter_mut();
        self.for_each_table(&mut |count, size| {
            if let Some(table) = location.next() {
                *table = [u32::try_from(end).unwrap_or(u32::MAX), u32::try_from(count).unwrap_or(u32::MAX)];
            }
            end = end.saturating_add(count.saturating_mul(size)).next_multiple_of(4);
        });
        let end = u32::try_from(end).ok()?;
        Some((tables, end))
    }

    /// Calls `visit` with the number and size of the entries of each table.
    fn for_each_table(&self, visit: &mut dyn FnMut(usize, usize)) {
        let mut discard = |_: &[u8], _: usize| ();
        let mut writer = LayoutWriter { output: &mut discard, written: 0, measure: Some(visit) };
        self.write_tables(&mut writer);
    }

    /// Writes the header and all tables.
    fn write_all(
        &self,
        tables: &[[u32; 2]; TABLES],
        bytes: u32,
        checksum: u32,
        output: &mut dyn FnMut(&[u8], usize),
    ) {
        let mut writer = LayoutWriter { output, written: 0, measure: None };
        let w = &mut writer;
        [MAGIC, BakedScene::VERSION, bytes, checksum].write_padded(w);
        let Self { scene, camera, resolution, levels, cutoff, accelerator } = self;
        [resolution.width(), resolution.height(), u32::from(*levels)].write_padded(w);
        cutoff.write_padded(w);
        camera.write_padded(w);
        scene.descriptor().ambient.write_padded(w);
        scene.descriptor().background.write_padded(w);
        u32::from(scene.descriptor().colored_shadows).write_padded(w);
        let unused = (Aabb::ORIGIN, [0; 3], 0);
        let (kind, (bounds, cells, depth)) = match accelerator {
            BakedAccelerator::ListWithoutBounds(_) => (LIST, unused),
            BakedAccelerator::Grid(grid) => (GRID, (grid.parts().bounds, grid.parts().resolution, 0)),
            BakedAccelerator::Octree(octree) => (OCTREE, (octree.parts().bounds, [0; 3], 0)),
            BakedAccelerator::Bvh(bvh) => (BVH, (Aabb::ORIGIN, [0; 3], bvh.parts().depth)),
        };
        kind.write_padded(w);
        bounds.write_padded(w);
        cells.write_padded(w);
        depth.write_padded(w);
        tables.write_padded(w);
        debug_assert!(w.written == size_of::<BakedHeader>(), "the header has another layout than is written");
        self.write_tables(w);
    }

    /// Writes all tables, in the order of [`TableId`].
    fn write_tables(&self, w: &mut LayoutWriter<'_>) {
        let descriptor = self.scene.descriptor();
        let geometry = &descriptor.geometry;
        const _: () = assert!(TableId::Moving as usize == 10 && TableId::Entries as usize == 16);
        w.table(geometry.shapes);
        w.table(geometry.vertices);
        w.table(geometry.vertex_normals);
        w.table(geometry.planes);
        w.table(geometry.discs);
        w.table(geometry.polygons);
        w.table(geometry.cuboids);
        w.table(geometry.oriented_cuboids);
        w.table(geometry.cones);
        w.table(geometry.tori);
        w.table(geometry.moving_shapes);
        w.table(descriptor.material_ids);
        w.table(descriptor.materials);
        w.table(descriptor.textures);
        w.table(descriptor.lights);
        match &self.accelerator {
            BakedAccelerator::ListWithoutBounds(_) => {
                w.table::<u32>(&[]);
                w.table::<u32>(&[]);
            }
            BakedAccelerator::Grid(grid) => {
                w.table(grid.parts().cell_starts);
                w.table(grid.parts().entries);
            }
            BakedAccelerator::Octree(octree) => {
                w.table(octree.parts().nodes);
                w.table(octree.parts().entries);
            }
            BakedAccelerator::Bvh(bvh) => {
                w.table(bvh.parts().nodes);
                w.table(bvh.parts().entries);
            }
        }
    }
}
