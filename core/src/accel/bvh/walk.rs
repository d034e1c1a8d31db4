//! The walk: nearer half first, no recursion, bounded memory.

use core::ops::ControlFlow;

use super::Bvh;
use super::node::{Child, Goes, Slabs};
use super::waiting::{Part, Waiting};
use crate::accel::{Accelerator, Query};
use crate::geometry::Ray;

impl<W: Waiting> Accelerator for Bvh<'_, W> {
    type Scratch = W;

    #[inline]
    fn walk<Q: Query>(&self, ray: &Ray, waiting: &mut W, query: &mut Q) {
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = self.nearer_first(ray, waiting, query);
    }
}

impl<W: Waiting> Bvh<'_, W> {
    fn nearer_first<Q: Query>(&self, ray: &Ray, waiting: &mut W, query: &mut Q) -> ControlFlow<()> {
        let slabs = Slabs::of(ray);
        waiting.clear();
        let mut here = Child::node(0);
        loop {
            let onward = match here.goes() {
                Goes::Out(first) => {
                    self.leaf(first, query)?;
                    None
                }
                Goes::On(place) => {
                    let Some(node) = self.nodes.get(place as usize) else { return ControlFlow::Continue(()) };
                    query.boxes(2);
                    let seen = node.seen(&slabs, query.reach());
                    let [first, second] = node.children();
                    let first = Part { entry: seen.entry[0], child: first };
                    let second = Part { entry: seen.entry[1], child: second };
                    match seen.meets {
                        [true, true] => {
                            let swapped = second.entry < first.entry;
                            let (near, far) = if swapped { (second, first) } else { (first, second) };
                            match waiting.wait(far) {
                                Ok(()) => Some(near),
                                // No room: the nearer half is swept, which needs none.
                                Err(far) => {
                                    self.sweep(near.child, &slabs, query)?;
                                    Some(far)
                                }
                            }
                        }
                        [true, false] => Some(first),
                        [false, true] => Some(second),
                        [false, false] => None,
                    }
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
        for slot in self.items.get(first as usize..).unwrap_or_default() {
            query.test(slot.item())?;
            if slot.is_last() {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// A whole part of the tree in the order of storage, with no memory. A part whose box is
    /// missed is left out where it is the second half or both are missed; else it is found
    /// out one step later.
    #[cold]
    fn sweep<Q: Query>(&self, from: Child, slabs: &Slabs, query: &mut Q) -> ControlFlow<()> {
        let mut place = match from.goes() {
            Goes::Out(first) => return self.leaf(first, query),
            Goes::On(place) => place,
        };
        let end = self.nodes.get(place as usize).map_or(0, |node| node.end());
        while place < end
            && let Some(node) = self.nodes.get(place as usize)
        {
            query.boxes(2);
            let seen = node.seen(slabs, query.reach());
            let mut next = node.end();
            for (child, meets) in node.children().into_iter().zip(seen.meets) {
                match child.goes() {
                    Goes::Out(first) if meets => self.leaf(first, query)?,
                    Goes::On(below) if meets && below < next => next = below,
                    _ => {}
                }
            }
            // Nodes lie depth first, so that the next one is always further on.
            place = if next > place { next } else { end };
        }
        ControlFlow::Continue(())
    }
}
