//! Builds the accelerator that the settings ask for.
//!
//! This is the one module that knows every accelerator: the settings become a type here, and [`open`] returns it
//! behind a pointer. For another accelerator: a name in [`strahl_settings::accelerator`], and an arm in [`open`].
//!
//! Sizes that are constants of a type come from short lists ([`MAILBOX_SLOTS`], [`HEAP_ENTRIES`]). The ray tracer is compiled for
//! all prepared effect sets only for the accelerators that `auto` chooses, for few of them where an accelerator is
//! asked for by name, and for one where its size is not the usual one (module `prepared`).
//!
//! [`MAILBOX_SLOTS`]: strahl_settings::accelerator::MAILBOX_SLOTS
//! [`HEAP_ENTRIES`]: strahl_settings::accelerator::HEAP_ENTRIES

use std::time::Instant;

use strahl_core::accel::{
    Accelerator, BuildError, Bvh, BvhBuilder, BvhNode, BvhSize, Grid, GridSize, LeafEntry, LeafLayout, List,
    Octree, OctreeNode, OctreeSize, TraversalHeap, TraversalQueue, TraversalStack, TriangleBlock,
    group_count,
};
use strahl_core::geometry::{Aabb, BoundingSphere};
use strahl_core::{Scene, World};
use strahl_settings::accelerator::{DEFAULT_MAILBOX_SLOTS, STACK_ENTRIES};
use strahl_settings::{AccelKind, AccelSettings, Bounds, ResolvedAccel, Walk};

use crate::effects::{ChooseRayTracers, rarely_used};
#[cfg(feature = "double")]
use crate::effects::{rarely_used as by_name, rarely_used as usual};
use crate::output::AccelStats;
#[cfg(not(feature = "double"))]
use crate::prepared::{by_name, usual};
use crate::world::{AnyWorld, TypedWorld};

/// The memory of an accelerator. The caller keeps it as long as the accelerator is used.
#[derive(Debug, Default)]
pub struct AccelMemory {
    boxes: Vec<Aabb>,
    groups: Vec<Aabb>,
    spheres: Vec<BoundingSphere>,
    sphere_groups: Vec<BoundingSphere>,
    cells: Vec<u32>,
    items: Vec<u32>,
    octree_nodes: Vec<OctreeNode>,
    nodes: Vec<BvhNode>,
    slots: Vec<LeafEntry>,
    runs: Vec<TriangleBlock>,
}

/// A scene with an accelerator of some type, and what that accelerator is like.
pub type Opened<'s> = (Box<dyn AnyWorld + 's>, AccelStats);

/// Builds the accelerator that is asked for, or one that suits the scene.
pub fn open<'s>(
    scene: Scene<'s>,
    settings: &AccelSettings,
    memory: &'s mut AccelMemory,
) -> Result<Opened<'s>, BuildError> {
    let clock = Instant::now();
    memory.boxes = scene.descriptor().geometry.all_bounds().collect();
    let choice = settings.resolve(memory.boxes.iter().filter(|aabb| !aabb.is_empty()).count());
    let building = Building { scene, choice, clock, memory };
    match (choice.kind, choice.mailbox, choice.walk, choice.heap) {
        (AccelKind::List, ..) => building.list(usual),
        (AccelKind::Grid, DEFAULT_MAILBOX_SLOTS, ..) => building.grid::<DEFAULT_MAILBOX_SLOTS>(by_name),
        (AccelKind::Grid, 8, ..) => building.grid::<8>(rarely_used),
        (AccelKind::Grid, ..) => building.grid::<0>(rarely_used),
        (AccelKind::Octree, DEFAULT_MAILBOX_SLOTS, ..) => building.octree::<DEFAULT_MAILBOX_SLOTS>(by_name),
        (AccelKind::Octree, 8, ..) => building.octree::<8>(rarely_used),
        (AccelKind::Octree, ..) => building.octree::<0>(rarely_used),
        (AccelKind::Bvh, _, Walk::Stack, _) => building.bvh::<TraversalStack<STACK_ENTRIES>>(usual),
        (AccelKind::Bvh, _, Walk::Heap, 64) => building.bvh::<TraversalHeap<64>>(rarely_used),
        (AccelKind::Bvh, _, Walk::Heap, 4) => building.bvh::<TraversalHeap<4>>(rarely_used),
        (AccelKind::Bvh, _, Walk::Heap, 1) => building.bvh::<TraversalHeap<1>>(rarely_used),
        (AccelKind::Bvh, _, Walk::Heap, _) => building.bvh::<TraversalHeap<0>>(rarely_used),
    }
}

/// What the accelerator that is asked for would be like.
pub fn stats(scene: Scene<'_>, settings: &AccelSettings) -> Result<AccelStats, BuildError> {
    open(scene, settings, &mut AccelMemory::default()).map(|(_, stats)| stats)
}

/// What an accelerator is built of.
struct Building<'s> {
    scene: Scene<'s>,
    choice: ResolvedAccel,
    clock: Instant,
    memory: &'s mut AccelMemory,
}

/// How large an accelerator is.
struct Extent {
    bytes: usize,
    regions: usize,
    entries: usize,
    depth: Option<u32>,
}

impl<'s> Building<'s> {
    fn list(self, choose: ChooseRayTracers<List<'s>>) -> Result<Opened<'s>, BuildError> {
        let Building { scene, choice, clock, memory } = self;
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
        let extent = Extent { bytes: list.size_in_bytes(), regions, entries, depth: None };
        Ok(opened(scene, list, choose, extent.stats(choice, clock)))
    }

    fn grid<const MAILBOX: usize>(
        self,
        choose: ChooseRayTracers<Grid<'s, DEFAULT_MAILBOX_SLOTS>>,
    ) -> Result<Opened<'s>, BuildError> {
        let Building { scene, choice, clock, memory } = self;
        let room = GridSize::recommended(&memory.boxes);
        (memory.cells, memory.items) = (vec![0; room.cells], vec![0; room.entries]);
        let grid = Grid::build(&memory.boxes, &mut memory.cells, &mut memory.items)?;
        let (bytes, regions, entries) = (grid.size_in_bytes(), grid.cell_count(), grid.entry_count());
        let extent = Extent { bytes, regions, entries, depth: None };
        Ok(opened(scene, grid, choose, extent.stats(choice, clock)))
    }

    fn octree<const MAILBOX: usize>(
        self,
        choose: ChooseRayTracers<Octree<'s, DEFAULT_MAILBOX_SLOTS>>,
    ) -> Result<Opened<'s>, BuildError> {
        let Building { scene, choice, clock, memory } = self;
        let room = OctreeSize::recommended(memory.boxes.len());
        (memory.octree_nodes, memory.items) = (vec![OctreeNode::EMPTY; room.nodes], vec![0; room.entries]);
        let tree = Octree::build(&memory.boxes, &mut memory.octree_nodes, &mut memory.items)?;
        let (bytes, regions, entries) =
            (tree.size_in_bytes(), tree.occupied_leaf_count(), tree.entry_count());
        let extent = Extent { bytes, regions, entries, depth: Some(u32::from(tree.depth())) };
        Ok(opened(scene, tree, choose, extent.stats(choice, clock)))
    }

    fn bvh<W: TraversalQueue + 's>(
        self,
        choose: ChooseRayTracers<Bvh<'s, W, TriangleBlock>>,
    ) -> Result<Opened<'s>, BuildError> {
        let Building { scene, choice, clock, memory } = self;
        let geometry = scene.descriptor().geometry;
        let room = BvhSize::recommended(memory.boxes.len());
        (memory.nodes, memory.slots) =
            (vec![BvhNode::EMPTY; room.nodes], vec![LeafEntry::EMPTY; room.entries]);
        let leaves = LeafLayout::TriangleBlocks(&geometry);
        let grown = BvhBuilder::new(&memory.boxes, leaves, &mut memory.nodes, &mut memory.slots)?;
        memory.runs = vec![TriangleBlock::EMPTY; grown.block_count()];
        let tree = grown.into_bvh_with_blocks::<W>(&geometry, &mut memory.runs)?;
        let (bytes, regions, entries) = (tree.size_in_bytes(), tree.leaf_count(), tree.entry_count());
        let extent = Extent { bytes, regions, entries, depth: Some(tree.depth()) };
        Ok(opened(scene, tree, choose, extent.stats(choice, clock)))
    }
}

impl Extent {
    fn stats(self, choice: ResolvedAccel, clock: Instant) -> AccelStats {
        let Extent { bytes, regions, entries, depth } = self;
        AccelStats { choice, bytes, regions, entries, depth, build: clock.elapsed() }
    }
}

fn opened<'s, A: Accelerator + Sync + 's>(
    scene: Scene<'s>,
    accelerator: A,
    choose: ChooseRayTracers<A>,
    stats: AccelStats,
) -> Opened<'s> {
    (Box::new(TypedWorld { world: World::new(scene, accelerator), choose }), stats)
}
