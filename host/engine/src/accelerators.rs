//! Construction of acceleration structures.
//!
//! Settings are converted to types only here: [`build`] returns the structure as a trait object. To add a structure, add
//! a name in [`strahl_settings::accelerator`] and an arm in [`build`].
//!
//! Sizes that are type parameters come from short lists ([`MAILBOX_SLOTS`], [`HEAP_ENTRIES`]). The ray tracer is compiled
//! with all prepared effect sets only for the structures that `auto` selects, with few sets for other structures, and
//! with one set for sizes other than the default (module `prepared`).
//!
//! [`MAILBOX_SLOTS`]: strahl_settings::accelerator::MAILBOX_SLOTS
//! [`HEAP_ENTRIES`]: strahl_settings::accelerator::HEAP_ENTRIES

use std::time::Instant;

use strahl_core::accel::{
    Accelerator, BuildError, Bvh, BvhBuilder, BvhEntry, BvhNode, BvhSize, Grid, GridSize, LeafLayout, List,
    Octree, OctreeNode, OctreeSize, TraversalHeap, TraversalQueue, TraversalStack, TriangleBlock,
    group_count,
};
use strahl_core::geometry::{Aabb, BoundingSphere};
use strahl_core::{Scene, World};
use strahl_settings::accelerator::{DEFAULT_MAILBOX_SLOTS, STACK_ENTRIES};
use strahl_settings::{AccelKind, AccelSettings, Bounds, ResolvedAccel, Walk};

use crate::effects::{SelectRayTracers, all_effects};
#[cfg(feature = "double")]
use crate::effects::{all_effects as few_prepared, all_effects as all_prepared};
use crate::output::AccelStats;
#[cfg(not(feature = "double"))]
use crate::prepared::{all_prepared, few_prepared};
use crate::world::{AnyWorld, TypedWorld};

/// The memory of an acceleration structure, provided by the caller for as long as the structure is used.
#[derive(Debug, Default)]
pub struct AccelMemory {
    boxes: Vec<Aabb>,
    groups: Vec<Aabb>,
    spheres: Vec<BoundingSphere>,
    sphere_groups: Vec<BoundingSphere>,
    grid_cells: Vec<u32>,
    entries: Vec<u32>,
    octree_nodes: Vec<OctreeNode>,
    bvh_nodes: Vec<BvhNode>,
    leaf_entries: Vec<BvhEntry>,
    triangle_blocks: Vec<TriangleBlock>,
}

/// A scene with an acceleration structure, and the statistics of the structure.
pub type BuiltWorld<'s> = (Box<dyn AnyWorld + 's>, AccelStats);

/// Builds the requested acceleration structure, or for `auto` the one selected for the scene.
pub fn build<'s>(
    scene: Scene<'s>,
    settings: &AccelSettings,
    memory: &'s mut AccelMemory,
) -> Result<BuiltWorld<'s>, BuildError> {
    let start = Instant::now();
    memory.boxes = scene.descriptor().geometry.all_bounds().collect();
    let choice = settings.resolve(memory.boxes.iter().filter(|aabb| !aabb.is_empty()).count());
    let builder = AccelBuilder { scene, choice, start, memory };
    match (choice.kind, choice.mailbox, choice.walk, choice.heap) {
        (AccelKind::List, ..) => builder.list(all_prepared),
        (AccelKind::Grid, DEFAULT_MAILBOX_SLOTS, ..) => builder.grid::<DEFAULT_MAILBOX_SLOTS>(few_prepared),
        (AccelKind::Grid, 8, ..) => builder.grid::<8>(all_effects),
        (AccelKind::Grid, ..) => builder.grid::<0>(all_effects),
        (AccelKind::Octree, DEFAULT_MAILBOX_SLOTS, ..) => {
            builder.octree::<DEFAULT_MAILBOX_SLOTS>(few_prepared)
        }
        (AccelKind::Octree, 8, ..) => builder.octree::<8>(all_effects),
        (AccelKind::Octree, ..) => builder.octree::<0>(all_effects),
        (AccelKind::Bvh, _, Walk::Stack, _) => builder.bvh::<TraversalStack<STACK_ENTRIES>>(all_prepared),
        (AccelKind::Bvh, _, Walk::Heap, 64) => builder.bvh::<TraversalHeap<64>>(all_effects),
        (AccelKind::Bvh, _, Walk::Heap, 4) => builder.bvh::<TraversalHeap<4>>(all_effects),
        (AccelKind::Bvh, _, Walk::Heap, 1) => builder.bvh::<TraversalHeap<1>>(all_effects),
        (AccelKind::Bvh, _, Walk::Heap, _) => builder.bvh::<TraversalHeap<0>>(all_effects),
    }
}

/// The statistics of the requested acceleration structure, which is built and dropped.
pub fn stats(scene: Scene<'_>, settings: &AccelSettings) -> Result<AccelStats, BuildError> {
    build(scene, settings, &mut AccelMemory::default()).map(|(_, stats)| stats)
}

/// The input of construction.
struct AccelBuilder<'s> {
    scene: Scene<'s>,
    choice: ResolvedAccel,
    start: Instant,
    memory: &'s mut AccelMemory,
}

/// The size of an acceleration structure.
struct AccelSize {
    bytes: usize,
    regions: usize,
    entries: usize,
    depth: Option<u32>,
}

impl<'s> AccelBuilder<'s> {
    fn list(self, select: SelectRayTracers<List<'s>>) -> Result<BuiltWorld<'s>, BuildError> {
        let AccelBuilder { scene, choice, start, memory } = self;
        let entries = memory.boxes.len();
        let (list, regions) = match choice.bounds {
            Bounds::None => (List::without_bounds(entries as u32), 1),
            Bounds::Sphere => {
                let regions = group_count(entries);
                memory.spheres = vec![BoundingSphere::EMPTY; entries];
                memory.sphere_groups = vec![BoundingSphere::EMPTY; regions];
                (List::with_spheres(&memory.boxes, &mut memory.spheres, &mut memory.sphere_groups)?, regions)
            }
            Bounds::Box => {
                let regions = group_count(entries);
                memory.groups = vec![Aabb::EMPTY; regions];
                (List::with_boxes(&memory.boxes, &mut memory.groups)?, regions)
            }
        };
        let size = AccelSize { bytes: list.size_in_bytes(), regions, entries, depth: None };
        Ok(built_world(scene, list, select, size.stats(choice, start)))
    }

    fn grid<const SLOTS: usize>(
        self,
        select: SelectRayTracers<Grid<'s, SLOTS>>,
    ) -> Result<BuiltWorld<'s>, BuildError> {
        let AccelBuilder { scene, choice, start, memory } = self;
        let recommended = GridSize::recommended(&memory.boxes);
        (memory.grid_cells, memory.entries) = (vec![0; recommended.cells], vec![0; recommended.entries]);
        let grid = Grid::build(&memory.boxes, &mut memory.grid_cells, &mut memory.entries)?;
        let (bytes, regions, entries) = (grid.size_in_bytes(), grid.cell_count(), grid.entry_count());
        let size = AccelSize { bytes, regions, entries, depth: None };
        Ok(built_world(scene, grid, select, size.stats(choice, start)))
    }

    fn octree<const SLOTS: usize>(
        self,
        select: SelectRayTracers<Octree<'s, SLOTS>>,
    ) -> Result<BuiltWorld<'s>, BuildError> {
        let AccelBuilder { scene, choice, start, memory } = self;
        let recommended = OctreeSize::recommended(memory.boxes.len());
        (memory.octree_nodes, memory.entries) =
            (vec![OctreeNode::EMPTY; recommended.nodes], vec![0; recommended.entries]);
        let tree = Octree::build(&memory.boxes, &mut memory.octree_nodes, &mut memory.entries)?;
        let (bytes, regions, entries) =
            (tree.size_in_bytes(), tree.occupied_leaf_count(), tree.entry_count());
        let size = AccelSize { bytes, regions, entries, depth: Some(u32::from(tree.depth())) };
        Ok(built_world(scene, tree, select, size.stats(choice, start)))
    }

    fn bvh<W: TraversalQueue + 's>(
        self,
        select: SelectRayTracers<Bvh<'s, W, TriangleBlock>>,
    ) -> Result<BuiltWorld<'s>, BuildError> {
        let AccelBuilder { scene, choice, start, memory } = self;
        let geometry = scene.descriptor().geometry;
        let recommended = BvhSize::recommended(memory.boxes.len());
        (memory.bvh_nodes, memory.leaf_entries) =
            (vec![BvhNode::EMPTY; recommended.nodes], vec![BvhEntry::EMPTY; recommended.entries]);
        let leaves = LeafLayout::TriangleBlocks(&geometry);
        let bvh = BvhBuilder::new(&memory.boxes, leaves, &mut memory.bvh_nodes, &mut memory.leaf_entries)?;
        memory.triangle_blocks = vec![TriangleBlock::EMPTY; bvh.block_count()];
        let tree = bvh.into_block_bvh::<W>(&geometry, &mut memory.triangle_blocks)?;
        let (bytes, regions, entries) = (tree.size_in_bytes(), tree.leaf_count(), tree.entry_count());
        let size = AccelSize { bytes, regions, entries, depth: Some(tree.depth()) };
        Ok(built_world(scene, tree, select, size.stats(choice, start)))
    }
}

impl AccelSize {
    fn stats(self, choice: ResolvedAccel, start: Instant) -> AccelStats {
        let AccelSize { bytes, regions, entries, depth } = self;
        AccelStats { choice, bytes, regions, entries, depth, build: start.elapsed() }
    }
}

fn built_world<'s, A: Accelerator + Sync + 's>(
    scene: Scene<'s>,
    accelerator: A,
    select: SelectRayTracers<A>,
    stats: AccelStats,
) -> BuiltWorld<'s> {
    (Box::new(TypedWorld { world: World::new(scene, accelerator), select }), stats)
}
