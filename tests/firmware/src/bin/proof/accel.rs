//! Accelerators of anything, in lent memory of any length.

use core::ops::ControlFlow;

use strahl_core::*;

use crate::any::{any, any_item, any_ray, number, slice, used};
use crate::geometry::any_geometry;
use crate::text::displayed;

pub fn doors() {
    used(group_count(any(1)));
    for list in lists(&mut [Aabb::EMPTY], [&mut [Ball::EMPTY], &mut [Ball::EMPTY]]) {
        used(list.size_in_bytes());
        list.traverse(&any_ray(), &mut (), &mut Anybody);
    }
    tree::<TraversalStack<2>>();
    tree::<TraversalHeap<2>>();
    subdivisions::<0>();
    subdivisions::<8>();
    let (buffer, needed, provided) = (any(Buffer::GroupBounds), any(1), any(0));
    displayed(any(BuildError::BufferTooSmall { buffer, needed, provided }));
}

/// Offers what it likes, as often as it likes.
pub struct Stranger;

impl Accelerator for Stranger {
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

/// Looks for nobody knows what.
struct Anybody;

impl Query for Anybody {
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

/// Lists of any length, in lent memory of any length.
pub fn lists<'s>(lent: &'s mut [Aabb], balls: [&'s mut [Ball]; 2]) -> [List<'s>; 3] {
    let bare = List::without_bounds(any(1));
    let boxes = slice(&[Aabb::EMPTY]);
    let [items, groups] = balls.map(any);
    [
        bare,
        List::with_boxes(boxes, any(lent)).unwrap_or(bare),
        List::with_spheres(boxes, items, groups).unwrap_or(bare),
    ]
}

/// A hierarchy of anything, in lent memory of any length.
fn tree<W: TraversalQueue>() {
    used(BvhSize::recommended(any(1)));
    let (mut nodes, mut items) = ([BvhNode::EMPTY; 2], [LeafEntry::EMPTY; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    let boxes = slice(&[Aabb::EMPTY]);
    let geometry = any_geometry();
    match any(LeafLayout::TriangleBlocks(&geometry)) {
        LeafLayout::Entries => {
            let Ok(tree) = Bvh::<()>::build(boxes, nodes, items) else { return };
            hierarchy(tree.with_queue::<W>());
        }
        leaves => {
            let Ok(grown) = BvhBuilder::new(boxes, leaves, nodes, items) else { return };
            used(grown.block_count());
            let mut runs = [TriangleBlock::EMPTY; 2];
            let Ok(tree) = grown.into_bvh_with_blocks::<W>(&geometry, any(runs.as_mut_slice())) else {
                return;
            };
            hierarchy(tree);
        }
    }
    if let Ok(grown) =
        BvhBuilder::new(boxes, any(LeafLayout::Entries), &mut [BvhNode::EMPTY], &mut [LeafEntry::EMPTY])
    {
        hierarchy(grown.into_bvh::<W>());
    }
}

fn hierarchy<W: TraversalQueue, L: LeafElement>(tree: Bvh<'_, W, L>) {
    used((tree.size_in_bytes(), tree.leaf_count(), tree.entry_count(), tree.depth()));
    tree.with_queue::<W>().traverse(&any_ray(), &mut W::default(), &mut Anybody);
    used(any(TriangleBlock::EMPTY).items().count());
}

/// A grid and an octree of anything, in lent memory of any length.
fn subdivisions<const MAILBOX: usize>() {
    let boxes = slice(&[Aabb::EMPTY]);
    let mut mailbox = any(Mailbox::<MAILBOX>::new());
    mailbox.clear();
    used((GridSize::recommended(boxes), GridSize::estimated(any(1)), OctreeSize::recommended(any(1))));

    let (mut cells, mut items) = ([0; 2], [0; 2]);
    let (cells, items) = (any(cells.as_mut_slice()), any(items.as_mut_slice()));
    if let Ok(grid) = Grid::<MAILBOX>::with_density(number(), boxes, cells, items) {
        used((grid.size_in_bytes(), grid.cell_count(), grid.entry_count(), grid.resolution()));
        grid.traverse(&any_ray(), &mut mailbox, &mut Anybody);
        grid.without_item_bounds().traverse(&any_ray(), &mut mailbox, &mut Anybody);
    }
    let mut memory = StaticGrid::<5, 7>::new();
    if let Ok(grid) = memory.build::<MAILBOX>(boxes) {
        grid.traverse(&any_ray(), &mut mailbox, &mut Anybody);
    }

    let (mut nodes, mut items) = ([OctreeNode::EMPTY; 2], [0; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    used(Octree::<MAILBOX>::build(boxes, nodes, items).is_ok());
    if let Ok(tree) = Octree::<MAILBOX>::with_limits(any(OctreeLimits::DEFAULT), boxes, nodes, items) {
        used((
            tree.size_in_bytes(),
            tree.occupied_leaf_count(),
            tree.entry_count(),
            tree.node_count(),
            tree.depth(),
        ));
        tree.traverse(&any_ray(), &mut mailbox, &mut Anybody);
        tree.without_item_bounds().traverse(&any_ray(), &mut mailbox, &mut Anybody);
    }
}
