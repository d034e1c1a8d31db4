//! The walk: nearer half first, no recursion, bounded memory.
//!
//! That the far ends of boxes are widened takes a twentieth of its instructions; zeros of either sign, and
//! ties, take a hundredth or nothing (`tests/HARD-CASES.md`).

use core::mem::replace;
use core::ops::ControlFlow;

use super::node::{Child, Goes, Node, PARTS, Seen, Slabs};
use super::waiting::{Part, Waiting};
use super::{Bvh, Leaf};
use crate::accel::{Accelerator, Query};
use crate::geometry::{ItemId, Ray};

impl<W: Waiting, L: Leaf> Accelerator for Bvh<'_, W, L> {
    type Scratch = W;

    #[inline]
    fn walk<Q: Query>(&self, ray: &Ray, waiting: &mut W, query: &mut Q) {
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = self.nearer_first(ray, waiting, query);
    }
}

impl<W: Waiting, L: Leaf> Bvh<'_, W, L> {
    #[inline(never)]
    fn nearer_first<Q: Query>(&self, ray: &Ray, waiting: &mut W, query: &mut Q) -> ControlFlow<()> {
        let slabs = Slabs::of(ray);
        waiting.clear();
        let mut here = Child::node(0);
        loop {
            let onward = match here.goes() {
                Goes::Lone(item) => {
                    lone(item, query)?;
                    None
                }
                Goes::Out(first) => {
                    self.leaf(first, query)?;
                    None
                }
                Goes::On(place) => {
                    let Some(node) = self.nodes.get(place as usize) else { return ControlFlow::Continue(()) };
                    query.boxes(PARTS as u32);
                    let mut seen = node.seen(&slabs, query.reach());
                    let mut nearest = seen.next(node);
                    while let Some(part) = seen.next(node) {
                        let farther = match &mut nearest {
                            Some(nearest) if Q::ORDERED && part.entry < nearest.entry => {
                                replace(nearest, part)
                            }
                            _ => part,
                        };
                        // No room: that part is swept, which needs none.
                        if let Err(part) = waiting.wait(farther) {
                            self.sweep(part.child, &slabs, query)?;
                        }
                    }
                    nearest
                }
            };
            let next = match onward {
                Some(part) => Some(waiting.first(part)),
                None => waiting.next(query.reach()),
            };
            match next {
                Some(part) => here = part.child,
                None => return ControlFlow::Continue(()),
            }
        }
    }

    #[inline(always)]
    fn leaf<Q: Query>(&self, first: u32, query: &mut Q) -> ControlFlow<()> {
        query.enter();
        for piece in self.leaves.get(first as usize..).unwrap_or_default() {
            piece.offer(query)?;
            if piece.is_last() {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// A whole part of the tree in the order of storage, with no memory.
    #[cold]
    fn sweep<Q: Query>(&self, from: Child, slabs: &Slabs, query: &mut Q) -> ControlFlow<()> {
        let mut place = match from.goes() {
            Goes::Lone(item) => return lone(item, query),
            Goes::Out(first) => return self.leaf(first, query),
            Goes::On(place) => place,
        };
        let end = self.nodes.get(place as usize).map_or(0, Node::end);
        while place < end
            && let Some(node) = self.nodes.get(place as usize)
        {
            query.boxes(PARTS as u32);
            // On to the first part below that the ray meets; where it meets none, behind all.
            let mut next = node.end();
            let mut seen = node.seen(slabs, query.reach());
            while let Some(part) = seen.next(node) {
                match part.child.goes() {
                    Goes::Lone(item) => lone(item, query)?,
                    Goes::Out(first) => self.leaf(first, query)?,
                    Goes::On(below) if below < next => next = below,
                    Goes::On(_) => {}
                }
            }
            // Nodes lie depth first, so that the next one is always further on.
            place = if next > place { next } else { end };
        }
        ControlFlow::Continue(())
    }
}

/// A leaf of one item.
#[inline(always)]
fn lone<Q: Query>(item: ItemId, query: &mut Q) -> ControlFlow<()> {
    query.enter();
    query.test(item)
}

impl Seen {
    /// The next part of the node that the ray meets. No iterator: those are moved about in
    /// memory, and a walk does little else than this.
    #[inline(always)]
    fn next(&mut self, node: &Node) -> Option<Part> {
        let place = self.meets.trailing_zeros() as usize;
        let entry = *self.entry.0.get(place)?;
        self.meets &= self.meets - 1;
        Some(Part { entry, child: node.child(place) })
    }
}
