//! Every item in order: the truth that the other accelerators are held to.
//!
//! The bare list offers every item to every ray. With boxes it asks first whether the ray
//! meets the box round an item, and before that the box round a group of items that follow
//! each other in the scene: a miss of the box is a miss of its content.

use core::ops::ControlFlow;

use super::{Accelerator, BuildError, Query, Storage};
use crate::geometry::{Aabb, ItemId, Ray};

/// How many items share the box of a group.
const GROUP: usize = 16;

/// How many boxes [`List::boxed`] needs for the groups of `items` items.
pub const fn groups_of(items: usize) -> usize {
    items.div_ceil(GROUP)
}

/// The boxes of one group after the other; nothing, perhaps, at the end.
fn in_groups(boxes: &[Aabb]) -> impl Iterator<Item = &[Aabb]> {
    let (full, rest) = boxes.as_chunks::<GROUP>();
    full.iter().map(|group| group.as_slice()).chain([rest])
}

/// Items `0..self.0` in the order of their numbers, and no code for boxes: for devices with a
/// handful of items.
#[derive(Clone, Copy, Debug)]
pub struct Bare(pub u32);

impl Accelerator for Bare {
    type Scratch = ();

    #[inline(always)]
    fn walk<Q: Query>(&self, _: &Ray, _: &mut (), query: &mut Q) {
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = bare(self.0, query);
    }
}

/// All items in the order of their numbers, with boxes round them or without.
#[derive(Clone, Copy, Debug)]
pub struct List<'s> {
    items: u32,
    /// One box for each item, or none at all.
    boxes: &'s [Aabb],
    /// One box for each [`GROUP`] items.
    groups: &'s [Aabb],
}

impl<'s> List<'s> {
    /// The bare list of items `0..items`.
    pub const fn bare(items: u32) -> Self {
        List { items, boxes: &[], groups: &[] }
    }

    /// The list of the items inside `boxes`, one box for each, in their order.
    ///
    /// `groups` is lent for the boxes of groups: [`groups_of`] as many as there are items, or
    /// [`BuildError::StorageTooSmall`] says so.
    pub fn boxed(boxes: &'s [Aabb], groups: &'s mut [Aabb]) -> Result<Self, BuildError> {
        let (needed, lent) = (groups_of(boxes.len()), groups.len());
        let too_small = |what, needed, lent| BuildError::StorageTooSmall { what, needed, lent };
        let items = u32::try_from(boxes.len())
            .map_err(|_| too_small(Storage::Boxes, boxes.len(), u32::MAX as usize))?;
        let groups = groups.get_mut(..needed).ok_or(too_small(Storage::Groups, needed, lent))?;
        for (group, content) in groups.iter_mut().zip(in_groups(boxes)) {
            *group = content.iter().fold(Aabb::EMPTY, |all, item| all.union(*item));
        }
        Ok(List { items, boxes, groups })
    }

    /// The memory it uses, in bytes.
    pub const fn bytes(&self) -> usize {
        size_of_val(self.boxes) + size_of_val(self.groups)
    }
}

impl Accelerator for List<'_> {
    type Scratch = ();

    fn walk<Q: Query>(&self, ray: &Ray, _: &mut (), query: &mut Q) {
        let end =
            if self.boxes.is_empty() { bare(self.items, query) } else { self.through_boxes(ray, query) };
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = end;
    }
}

#[inline(always)]
fn bare<Q: Query>(items: u32, query: &mut Q) -> ControlFlow<()> {
    query.enter();
    query.all(items)
}

impl List<'_> {
    fn through_boxes<Q: Query>(&self, ray: &Ray, query: &mut Q) -> ControlFlow<()> {
        // Strictly beyond: an item at the same distance may have the lower number, and must win.
        let meets = |aabb: &Aabb, query: &Q| aabb.span(ray).is_some_and(|span| span.entry <= query.reach());
        query.boxes(self.groups.len() as u32);
        for ((group, boxes), number) in self.groups.iter().zip(in_groups(self.boxes)).zip(0..) {
            if !meets(group, query) {
                continue;
            }
            query.enter();
            query.boxes(boxes.len() as u32);
            for (aabb, place) in boxes.iter().zip(0..) {
                if meets(aabb, query) {
                    query.test(ItemId(number * GROUP as u32 + place))?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}
