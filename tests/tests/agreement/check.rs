//! Comparison of an accelerator with the list without bounds.

use strahl_core::accel::{
    Accelerator, Bvh, BvhBuilder, BvhEntry, BvhNode, BvhSize, Grid, GridSize, LeafLayout, List, Octree,
    OctreeLimits, OctreeNode, OctreeSize, TraversalHeap, TraversalStack, TriangleBlock,
};
use strahl_core::geometry::{Aabb, Hit, ItemId, Ray, SurfaceInteraction};
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Real, World};
use strahl_test_scene::{SplitMix64, TestScene};

/// Answers of all queries for a ray, without the identity of the occluder, which depends on the accelerator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QueryAnswer {
    pub hit: Option<(ItemId, u32)>,
    surface: Option<SurfaceInteraction>,
    pub is_occluded: bool,
}

pub fn nearest<A: Accelerator>(world: &World<A>, ray: &Ray, t_max: Real) -> Option<Hit> {
    world.nearest_hit::<AllEffects, _>(ray, t_max, RayKind::Camera, &mut A::Scratch::default(), &mut ())
}

pub fn occluder<A: Accelerator>(world: &World<A>, ray: &Ray, t_max: Real) -> Option<ItemId> {
    world.occluder::<AllEffects, _>(ray, t_max, RayKind::Shadow, &mut A::Scratch::default(), &mut ())
}

fn answer<A: Accelerator>(world: &World<A>, ray: &Ray, t_max: Real, scratch: &mut A::Scratch) -> QueryAnswer {
    let hit = world.nearest_hit::<AllEffects, _>(ray, t_max, RayKind::Camera, scratch, &mut ());
    let occluder = world.occluder::<AllEffects, _>(ray, t_max, RayKind::Shadow, scratch, &mut ());
    QueryAnswer {
        hit: hit.map(|hit| (hit.item, hit.t.to_bits())),
        surface: hit.and_then(|hit| world.surface_interaction::<AllEffects>(ray, hit)),
        is_occluded: occluder.is_some(),
    }
}

/// A ray query, and its answer by the list without bounds.
pub struct QueryCase {
    pub ray: Ray,
    pub t_max: Real,
    pub expected: QueryAnswer,
}

impl QueryCase {
    /// For each ray four queries: unlimited, up to the hit, up to just before it, and up to a random
    /// distance.
    pub fn all(unbounded: &World<List>, rays: &[Ray], rng: &mut SplitMix64) -> Vec<QueryCase> {
        let mut cases = Vec::new();
        for ray in rays {
            let expected = answer(unbounded, ray, Real::INFINITY, &mut ());
            let t = expected.hit.map_or(1.0, |(_, bits)| Real::from_bits(bits));
            for t_max in [Real::INFINITY, t, t.next_down(), t * rng.unit() as Real * 2.0] {
                let expected = answer(unbounded, ray, t_max, &mut ());
                assert_eq!(expected.hit.is_some(), expected.is_occluded, "{ray:?} {t_max}");
                cases.push(QueryCase { ray: *ray, t_max, expected });
            }
        }
        cases
    }
}

/// The queries of a scene that every accelerator must answer like the list without bounds.
pub struct AcceleratorCheck<'s> {
    pub scene: &'s TestScene,
    pub boxes: Vec<Aabb>,
    pub cases: Vec<QueryCase>,
}

impl<'s> AcceleratorCheck<'s> {
    /// Queries along these rays.
    pub fn new(scene: &'s TestScene, rays: &[Ray], rng: &mut SplitMix64) -> Self {
        let unbounded = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
        AcceleratorCheck { scene, boxes: scene.bounds(), cases: QueryCase::all(&unbounded, rays, rng) }
    }

    /// Number of rays that hit an item.
    pub fn hits(&self) -> usize {
        self.cases.iter().filter(|case| case.t_max == Real::INFINITY && case.expected.hit.is_some()).count()
    }

    /// Asserts that an accelerator gives the expected answers. All queries share one scratch, so that its
    /// caches are tested.
    pub fn check<A: Accelerator>(&self, name: &str, accelerator: A) {
        let world = World::new(self.scene.as_scene(), accelerator);
        let mut scratch = A::Scratch::default();
        for QueryCase { ray, t_max, expected } in &self.cases {
            assert_eq!(answer(&world, ray, *t_max, &mut scratch), *expected, "{name}: {ray:?} {t_max}");
        }
    }

    /// Checks a BVH in a node buffer of this size with every traversal queue.
    pub fn check_bvh(&self, provided: usize) {
        let size = BvhSize::recommended(self.boxes.len());
        let mut nodes = vec![BvhNode::EMPTY; provided];
        let mut items = vec![BvhEntry::EMPTY; size.entries];
        let tree = Bvh::<TraversalStack<64>>::build(&self.boxes, &mut nodes, &mut items).unwrap();
        self.check("stack", tree);
        self.check("stack of one", tree.with_queue::<TraversalStack<1>>());
        self.check("stack of none", tree.with_queue::<TraversalStack<0>>());
        self.check("heap", tree.with_queue::<TraversalHeap<64>>());
        self.check("heap of four", tree.with_queue::<TraversalHeap<4>>());
        self.check("heap of one", tree.with_queue::<TraversalHeap<1>>());
        self.check("heap of none", tree.with_queue::<TraversalHeap<0>>());

        let geometry = self.scene.as_scene().descriptor().geometry;
        let (mut nodes, mut items) = (vec![BvhNode::EMPTY; provided], vec![BvhEntry::EMPTY; size.entries]);
        let builder =
            BvhBuilder::new(&self.boxes, LeafLayout::TriangleBlocks(&geometry), &mut nodes, &mut items)
                .unwrap();
        let mut block_buffer = vec![TriangleBlock::EMPTY; builder.block_count()];
        let tree = builder.into_block_bvh::<TraversalStack<64>>(&geometry, &mut block_buffer).unwrap();
        assert_eq!(tree.entry_count(), self.boxes.iter().filter(|aabb| !aabb.is_empty()).count());
        self.check("triangle blocks, stack", tree);
        self.check("triangle blocks, heap of one", tree.with_queue::<TraversalHeap<1>>());
    }

    /// Checks a grid and an octree in buffers of these sizes, with a mailbox.
    pub fn check_grid_and_octree<const MAILBOX: usize>(&self, grid: GridSize, octree: OctreeSize) {
        let (mut cells, mut items) = (vec![0; grid.cells], vec![0; grid.entries]);
        let uniform = Grid::<MAILBOX>::build(&self.boxes, &mut cells, &mut items).unwrap();
        self.check(&format!("{grid:?}, mailbox {MAILBOX}"), uniform);
        self.check(&format!("{grid:?}, mailbox {MAILBOX}, no item bounds"), uniform.without_item_bounds());
        let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; octree.nodes], vec![0; octree.entries]);
        let limits = OctreeLimits { max_leaf_items: 1, ..OctreeLimits::DEFAULT };
        let tree = Octree::<MAILBOX>::build_with_limits(limits, &self.boxes, &mut nodes, &mut items).unwrap();
        self.check(&format!("{octree:?}, mailbox {MAILBOX}"), tree);
        self.check(&format!("{octree:?}, mailbox {MAILBOX}, no item bounds"), tree.without_item_bounds());
    }
}
