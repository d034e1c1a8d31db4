//! What every accelerator is held to: the answers of the bare list.

use strahl_core::accel::{
    Accelerator, Bvh, BvhBuilder, BvhNode, BvhSize, Grid, GridSize, LeafEntry, LeafLayout, List, Octree,
    OctreeLimits, OctreeNode, OctreeSize, TraversalHeap, TraversalStack, TriangleBlock,
};
use strahl_core::geometry::{Aabb, Hit, ItemId, Ray, SurfaceInteraction};
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Real, World};
use strahl_tests::Random;
use strahl_tests::single::Stage;

/// Everything that a world can be asked about a ray, but who is in the way, which may be
/// anybody.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    pub hit: Option<(ItemId, u32)>,
    surface: Option<SurfaceInteraction>,
    pub is_blocked: bool,
}

pub fn nearest<A: Accelerator>(world: &World<A>, ray: &Ray, reach: Real) -> Option<Hit> {
    world.nearest::<AllEffects, _>(ray, reach, RayKind::Camera, &mut A::Scratch::default(), &mut ())
}

pub fn blocker<A: Accelerator>(world: &World<A>, ray: &Ray, reach: Real) -> Option<ItemId> {
    world.blocker::<AllEffects, _>(ray, reach, RayKind::Shadow, &mut A::Scratch::default(), &mut ())
}

fn answer<A: Accelerator>(world: &World<A>, ray: &Ray, reach: Real, scratch: &mut A::Scratch) -> Answer {
    let hit = world.nearest::<AllEffects, _>(ray, reach, RayKind::Camera, scratch, &mut ());
    let blocker = world.blocker::<AllEffects, _>(ray, reach, RayKind::Shadow, scratch, &mut ());
    Answer {
        hit: hit.map(|hit| (hit.item, hit.t.to_bits())),
        surface: hit.and_then(|hit| world.surface::<AllEffects>(ray, hit)),
        is_blocked: blocker.is_some(),
    }
}

/// A question about a ray, and the answer of the bare list.
pub struct Case {
    pub ray: Ray,
    pub reach: Real,
    pub truth: Answer,
}

impl Case {
    /// Each ray cut off nowhere, at the hit, just before it, and anywhere.
    pub fn all(bare: &World<List>, rays: &[Ray], random: &mut Random) -> Vec<Case> {
        let mut cases = Vec::new();
        for ray in rays {
            let truth = answer(bare, ray, Real::INFINITY, &mut ());
            let t = truth.hit.map_or(1.0, |(_, bits)| Real::from_bits(bits));
            for reach in [Real::INFINITY, t, t.next_down(), t * random.unit() as Real * 2.0] {
                let truth = answer(bare, ray, reach, &mut ());
                assert_eq!(truth.hit.is_some(), truth.is_blocked, "{ray:?} {reach}");
                cases.push(Case { ray: *ray, reach, truth });
            }
        }
        cases
    }
}

/// What an accelerator is held to: the cases of a scene.
pub struct Hold<'s> {
    pub stage: &'s Stage,
    pub boxes: Vec<Aabb>,
    pub cases: Vec<Case>,
}

impl<'s> Hold<'s> {
    /// The cases of these rays.
    pub fn new(stage: &'s Stage, rays: &[Ray], random: &mut Random) -> Self {
        let bare = World::new(stage.scene(), List::without_bounds(stage.item_count()));
        Hold { stage, boxes: stage.bounds(), cases: Case::all(&bare, rays, random) }
    }

    /// How many of the rays hit something.
    pub fn hits(&self) -> usize {
        self.cases.iter().filter(|case| case.reach == Real::INFINITY && case.truth.hit.is_some()).count()
    }

    /// Holds an accelerator against the truth, from the first case to the last with the same
    /// scratch, so that it remembers earlier rays.
    pub fn against<A: Accelerator>(&self, name: &str, accelerator: A) {
        let world = World::new(self.stage.scene(), accelerator);
        let mut scratch = A::Scratch::default();
        for Case { ray, reach, truth } in &self.cases {
            assert_eq!(answer(&world, ray, *reach, &mut scratch), *truth, "{name}: {ray:?} {reach}");
        }
    }

    /// A hierarchy in each of its walks.
    pub fn against_hierarchy(&self, lent: usize) {
        let room = BvhSize::recommended(self.boxes.len());
        let mut nodes = vec![BvhNode::EMPTY; lent];
        let mut items = vec![LeafEntry::EMPTY; room.entries];
        let tree = Bvh::<TraversalStack<64>>::build(&self.boxes, &mut nodes, &mut items).unwrap();
        self.against("by a stack", tree);
        self.against("by a stack of one", tree.with_queue::<TraversalStack<1>>());
        self.against("by no stack", tree.with_queue::<TraversalStack<0>>());
        self.against("by a heap", tree.with_queue::<TraversalHeap<64>>());
        self.against("by a heap of four", tree.with_queue::<TraversalHeap<4>>());
        self.against("by a heap of one", tree.with_queue::<TraversalHeap<1>>());
        self.against("by no heap", tree.with_queue::<TraversalHeap<0>>());

        let geometry = self.stage.scene().parts().geometry;
        let (mut nodes, mut items) = (vec![BvhNode::EMPTY; lent], vec![LeafEntry::EMPTY; room.entries]);
        let grown =
            BvhBuilder::new(&self.boxes, LeafLayout::TriangleBlocks(&geometry), &mut nodes, &mut items)
                .unwrap();
        let mut runs = vec![TriangleBlock::EMPTY; grown.block_count()];
        let tree = grown.into_bvh_with_blocks::<TraversalStack<64>>(&geometry, &mut runs).unwrap();
        assert_eq!(tree.entry_count(), self.boxes.iter().filter(|aabb| !aabb.is_empty()).count());
        self.against("in runs, by a stack", tree);
        self.against("in runs, by a heap of one", tree.with_queue::<TraversalHeap<1>>());
    }

    /// A grid and an octree in this much memory, with a mailbox.
    pub fn against_subdivisions<const MAILBOX: usize>(&self, grid: GridSize, octree: OctreeSize) {
        let (mut cells, mut items) = (vec![0; grid.cells], vec![0; grid.entries]);
        let lattice = Grid::<MAILBOX>::build(&self.boxes, &mut cells, &mut items).unwrap();
        self.against(&format!("{grid:?}, mailbox {MAILBOX}"), lattice);
        self.against(&format!("{grid:?}, mailbox {MAILBOX}, no boxes"), lattice.without_item_bounds());
        let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; octree.nodes], vec![0; octree.entries]);
        let limits = OctreeLimits { max_leaf_items: 1, ..OctreeLimits::DEFAULT };
        let tree = Octree::<MAILBOX>::with_limits(limits, &self.boxes, &mut nodes, &mut items).unwrap();
        self.against(&format!("{octree:?}, mailbox {MAILBOX}"), tree);
        self.against(&format!("{octree:?}, mailbox {MAILBOX}, no boxes"), tree.without_item_bounds());
    }
}
