//! Accelerators of anything, in lent memory of any length.

use core::ops::ControlFlow;

use strahl_core::*;

use crate::any::{any, any_item, any_ray, number, slice, used};
use crate::geometry::any_geometry;
use crate::text::displayed;

pub fn doors() {
    used(groups_of(any(1)));
    for list in lists(&mut [Aabb::EMPTY], [&mut [Ball::EMPTY], &mut [Ball::EMPTY]]) {
        used(list.bytes());
        list.walk(&any_ray(), &mut (), &mut Anybody);
    }
    tree::<LastFirst<2>>();
    tree::<NearestFirst<2>>();
    subdivisions::<0>();
    subdivisions::<8>();
    let (what, needed, lent) = (any(Storage::Groups), any(1), any(0));
    displayed(any(BuildError::StorageTooSmall { what, needed, lent }));
}

/// Offers what it likes, as often as it likes.
pub struct Stranger;

impl Accelerator for Stranger {
    type Scratch = u32;

    fn walk<Q: Query>(&self, ray: &Ray, scratch: &mut u32, query: &mut Q) {
        used((ray, any(scratch)));
        while any(true) {
            query.enter();
            query.boxes(any(1));
            used(query.reach());
            if query.test(any_item()).is_break() {
                return;
            }
        }
    }
}

/// Looks for nobody knows what.
struct Anybody;

impl Query for Anybody {
    fn reach(&self) -> Real {
        number()
    }

    fn test(&mut self, item: ItemId) -> ControlFlow<()> {
        used(item);
        any(ControlFlow::Continue(()))
    }

    fn boxes(&mut self, count: u32) {
        used(count);
    }

    fn enter(&mut self) {}

    fn skipped(&mut self) {}
}

/// Lists of any length, in lent memory of any length.
pub fn lists<'s>(lent: &'s mut [Aabb], balls: [&'s mut [Ball]; 2]) -> [List<'s>; 3] {
    let bare = List::bare(any(1));
    let boxes = slice(&[Aabb::EMPTY]);
    let [items, groups] = balls.map(any);
    [bare, List::boxed(boxes, any(lent)).unwrap_or(bare), List::balled(boxes, items, groups).unwrap_or(bare)]
}

/// A hierarchy of anything, in lent memory of any length.
fn tree<W: Waiting>() {
    used(BvhRoom::comfortable(any(1)));
    let (mut nodes, mut items) = ([Node::EMPTY; 2], [Slot::EMPTY; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    let boxes = slice(&[Aabb::EMPTY]);
    let geometry = any_geometry();
    match any(Leaves::Runs(&geometry)) {
        Leaves::Singly => {
            let Ok(tree) = Bvh::<()>::build(boxes, nodes, items) else { return };
            hierarchy(tree.walked::<W>());
        }
        leaves => {
            let Ok(grown) = Grown::build(boxes, leaves, nodes, items) else { return };
            used(grown.runs());
            let mut runs = [Run::EMPTY; 2];
            let Ok(tree) = grown.in_runs::<W>(&geometry, any(runs.as_mut_slice())) else { return };
            hierarchy(tree);
        }
    }
    if let Ok(grown) = Grown::build(boxes, any(Leaves::Singly), &mut [Node::EMPTY], &mut [Slot::EMPTY]) {
        hierarchy(grown.singly::<W>());
    }
}

fn hierarchy<W: Waiting, L: Leaf>(tree: Bvh<'_, W, L>) {
    used((tree.bytes(), tree.regions(), tree.entries(), tree.depth()));
    tree.walked::<W>().walk(&any_ray(), &mut W::default(), &mut Anybody);
    used(any(Run::EMPTY).items().count());
}

/// A grid and an octree of anything, in lent memory of any length.
fn subdivisions<const MAILBOX: usize>() {
    let boxes = slice(&[Aabb::EMPTY]);
    let mut mailbox = any(Mailbox::<MAILBOX>::new());
    mailbox.forget();
    used((GridRoom::comfortable(boxes), GridRoom::of_items(any(1)), OctreeRoom::comfortable(any(1))));

    let (mut cells, mut items) = ([0; 2], [0; 2]);
    let (cells, items) = (any(cells.as_mut_slice()), any(items.as_mut_slice()));
    if let Ok(grid) = Grid::<MAILBOX>::with_density(number(), boxes, cells, items) {
        used((grid.bytes(), grid.regions(), grid.entries(), grid.cells()));
        grid.walk(&any_ray(), &mut mailbox, &mut Anybody);
        grid.without_boxes().walk(&any_ray(), &mut mailbox, &mut Anybody);
    }
    let mut memory = StaticGrid::<5, 7>::new();
    if let Ok(grid) = memory.build::<MAILBOX>(boxes) {
        grid.walk(&any_ray(), &mut mailbox, &mut Anybody);
    }

    let (mut nodes, mut items) = ([OctreeNode::EMPTY; 2], [0; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    used(Octree::<MAILBOX>::build(boxes, nodes, items).is_ok());
    if let Ok(tree) = Octree::<MAILBOX>::with_limits(any(OctreeLimits::DEFAULT), boxes, nodes, items) {
        used((tree.bytes(), tree.regions(), tree.entries(), tree.nodes(), tree.depth()));
        tree.walk(&any_ray(), &mut mailbox, &mut Anybody);
        tree.without_boxes().walk(&any_ray(), &mut mailbox, &mut Anybody);
    }
}
