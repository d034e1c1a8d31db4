//! Accelerators over arbitrary bounds, in buffers of any length.

use core::ops::ControlFlow;

use strahl_core::Real;
use strahl_core::accel::{
    Accelerator, Buffer, BuildError, Bvh, BvhBuilder, BvhEntry, BvhNode, BvhSize, Grid, GridSize,
    LeafElement, LeafLayout, List, Mailbox, Octree, OctreeLimits, OctreeNode, OctreeSize, Query, StaticGrid,
    TraversalHeap, TraversalQueue, TraversalStack, TriangleBlock, group_count,
};
use strahl_core::geometry::{Aabb, BoundingSphere, ItemId, Ray};

use crate::any::{any, any_item, any_ray, number, slice, used};
use crate::geometry::any_geometry;
use crate::text::displayed;

pub fn entry_points() {
    used(group_count(any(1)));
    for list in lists(&mut [Aabb::EMPTY], [&mut [BoundingSphere::EMPTY], &mut [BoundingSphere::EMPTY]]) {
        used(List::size_in_bytes(&list));
        list.traverse(&any_ray(), &mut (), &mut ArbitraryQuery);
    }
    tree::<TraversalStack<2>>();
    tree::<TraversalHeap<2>>();
    subdivisions::<0>();
    subdivisions::<8>();
    let (buffer, needed, provided) = (any(Buffer::GroupBounds), any(1), any(0));
    displayed(any(BuildError::BufferTooSmall { buffer, needed, provided }));
}

/// Offers arbitrary items, any number of times.
pub struct ArbitraryAccelerator;

impl Accelerator for ArbitraryAccelerator {
    type Scratch = u32;

    fn traverse<Q: Query>(&self, ray: &Ray, scratch: &mut u32, query: &mut Q) {
        used((ray, any(scratch)));
        while any(true) {
            query.count_leaf_visit();
            query.count_box_tests(any(1));
            used(query.t_max());
            if query.test_item(any_item()).is_break() {
                return;
            }
        }
    }
}

/// An arbitrary query.
struct ArbitraryQuery;

impl Query for ArbitraryQuery {
    fn t_max(&self) -> Real {
        number()
    }

    fn test_item(&mut self, item: ItemId) -> ControlFlow<()> {
        used(item);
        any(ControlFlow::Continue(()))
    }

    fn count_box_tests(&mut self, count: u32) {
        used(count);
    }

    fn count_leaf_visit(&mut self) {}

    fn count_mailbox_hit(&mut self) {}
}

/// Lists of any length, in buffers of any length.
pub fn lists<'s>(buffers: &'s mut [Aabb], spheres: [&'s mut [BoundingSphere]; 2]) -> [List<'s>; 3] {
    let unbounded = List::without_bounds(any(1));
    let boxes = slice(&[Aabb::EMPTY]);
    let [items, groups] = spheres.map(any);
    [
        unbounded,
        List::with_boxes(boxes, any(buffers)).unwrap_or(unbounded),
        List::with_spheres(boxes, items, groups).unwrap_or(unbounded),
    ]
}

/// A BVH over arbitrary bounds, in buffers of any length.
fn tree<W: TraversalQueue>() {
    used(BvhSize::recommended(any(1)));
    let (mut nodes, mut items) = ([BvhNode::EMPTY; 2], [BvhEntry::EMPTY; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    let boxes = slice(&[Aabb::EMPTY]);
    let geometry = any_geometry();
    match any(LeafLayout::TriangleBlocks(&geometry)) {
        LeafLayout::Entries => {
            let Ok(tree) = Bvh::<()>::build(boxes, nodes, items) else { return };
            bvh(Bvh::with_queue::<W>(tree));
        }
        leaves => {
            let Ok(builder) = BvhBuilder::new(boxes, leaves, nodes, items) else { return };
            used(BvhBuilder::block_count(&builder));
            let mut block_buffer = [TriangleBlock::EMPTY; 2];
            let Ok(tree) =
                BvhBuilder::into_block_bvh::<W>(builder, &geometry, any(block_buffer.as_mut_slice()))
            else {
                return;
            };
            bvh(tree);
        }
    }
    if let Ok(builder) =
        BvhBuilder::new(boxes, any(LeafLayout::Entries), &mut [BvhNode::EMPTY], &mut [BvhEntry::EMPTY])
    {
        bvh(BvhBuilder::into_bvh::<W>(builder));
    }
}

fn bvh<W: TraversalQueue, L: LeafElement>(tree: Bvh<'_, W, L>) {
    used((Bvh::size_in_bytes(&tree), Bvh::leaf_count(&tree), Bvh::entry_count(&tree), Bvh::depth(&tree)));
    Bvh::with_queue::<W>(tree).traverse(&any_ray(), &mut W::default(), &mut ArbitraryQuery);
    used(TriangleBlock::items(&any(TriangleBlock::EMPTY)).count());
}

/// A grid and an octree over arbitrary bounds, in buffers of any length.
fn subdivisions<const MAILBOX: usize>() {
    let boxes = slice(&[Aabb::EMPTY]);
    let mut mailbox = any(Mailbox::<MAILBOX>::new());
    used((GridSize::recommended(boxes), GridSize::estimated(any(1)), OctreeSize::recommended(any(1))));

    let (mut cells, mut items) = ([0; 2], [0; 2]);
    let (cells, items) = (any(cells.as_mut_slice()), any(items.as_mut_slice()));
    used(Grid::<MAILBOX>::build(boxes, cells, items).is_ok());
    if let Ok(grid) = Grid::<MAILBOX>::build_with_density(number(), boxes, cells, items) {
        used((Grid::size_in_bytes(&grid), Grid::cell_count(&grid), Grid::entry_count(&grid)));
        used(Grid::resolution(&grid));
        grid.traverse(&any_ray(), &mut mailbox, &mut ArbitraryQuery);
        Grid::without_item_bounds(grid).traverse(&any_ray(), &mut mailbox, &mut ArbitraryQuery);
    }
    let mut memory = StaticGrid::<5, 7>::new();
    if let Ok(grid) = StaticGrid::build::<MAILBOX>(&mut memory, boxes) {
        grid.traverse(&any_ray(), &mut mailbox, &mut ArbitraryQuery);
    }

    let (mut nodes, mut items) = ([OctreeNode::EMPTY; 2], [0; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    used(Octree::<MAILBOX>::build(boxes, nodes, items).is_ok());
    if let Ok(tree) = Octree::<MAILBOX>::build_with_limits(any(OctreeLimits::DEFAULT), boxes, nodes, items) {
        used((
            Octree::size_in_bytes(&tree),
            Octree::occupied_leaf_count(&tree),
            Octree::entry_count(&tree),
            Octree::node_count(&tree),
            Octree::depth(&tree),
        ));
        tree.traverse(&any_ray(), &mut mailbox, &mut ArbitraryQuery);
        Octree::without_item_bounds(tree).traverse(&any_ray(), &mut mailbox, &mut ArbitraryQuery);
    }
}
