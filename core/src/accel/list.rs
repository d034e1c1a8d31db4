//! Every item in order: the truth that the other accelerators are held to.
//!
//! The bare list offers every item to every ray. With bounding volumes it asks first whether the
//! ray meets the box or the ball round an item, and before that the one round a group of items
//! that follow each other in the scene: a miss of the volume is a miss of its content.

use core::ops::ControlFlow;

use super::{Accelerator, BuildError, Query, Storage};
use crate::geometry::{Aabb, Ball, ItemId, Line, Ray};
use crate::math::Real;

/// How many items share the volume of a group.
const GROUP: usize = 16;

/// How many volumes [`List::boxed`] and [`List::balled`] need for the groups of `items` items.
pub const fn groups_of(items: usize) -> usize {
    items.div_ceil(GROUP)
}

/// The volumes of one group after the other; nothing, perhaps, at the end.
fn in_groups<V>(volumes: &[V]) -> impl Iterator<Item = &[V]> {
    let (full, rest) = volumes.as_chunks::<GROUP>();
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

/// All items in the order of their numbers, with volumes round them or without.
#[derive(Clone, Copy, Debug)]
pub struct List<'s> {
    items: u32,
    volumes: Volumes<'s>,
}

/// What is round the items, one for each, and round each [`GROUP`] of them.
#[derive(Clone, Copy, Debug)]
enum Volumes<'s> {
    None,
    Boxes { items: &'s [Aabb], groups: &'s [Aabb] },
    Balls { items: &'s [Ball], groups: &'s [Ball] },
}

const fn too_small(what: Storage, needed: usize, lent: usize) -> BuildError {
    BuildError::StorageTooSmall { what, needed, lent }
}

impl<'s> List<'s> {
    /// The bare list of items `0..items`.
    pub const fn bare(items: u32) -> Self {
        List { items, volumes: Volumes::None }
    }

    /// The list of the items inside `boxes`, one box for each, in their order.
    ///
    /// `groups` is lent for the boxes of groups: [`groups_of`] as many as there are items, or
    /// [`BuildError::StorageTooSmall`] says so.
    pub fn boxed(boxes: &'s [Aabb], groups: &'s mut [Aabb]) -> Result<Self, BuildError> {
        let items = count(boxes)?;
        let groups = lent(groups, Storage::Groups, groups_of(boxes.len()))?;
        for (group, aabb) in groups.iter_mut().zip(boxes_of_groups(boxes)) {
            *group = aabb;
        }
        Ok(List { items, volumes: Volumes::Boxes { items: boxes, groups } })
    }

    /// The list of the items inside `boxes` with balls in their place.
    ///
    /// `balls` is lent for those round the items, as many as there are boxes, and `groups` for
    /// those round groups: [`groups_of`] as many, or [`BuildError::StorageTooSmall`] says so.
    pub fn balled(boxes: &[Aabb], balls: &'s mut [Ball], groups: &'s mut [Ball]) -> Result<Self, BuildError> {
        let items = count(boxes)?;
        let balls = lent(balls, Storage::Boxes, boxes.len())?;
        let groups = lent(groups, Storage::Groups, groups_of(boxes.len()))?;
        for (ball, aabb) in balls.iter_mut().zip(boxes) {
            *ball = Ball::round(aabb);
        }
        for (group, aabb) in groups.iter_mut().zip(boxes_of_groups(boxes)) {
            *group = Ball::round(&aabb);
        }
        Ok(List { items, volumes: Volumes::Balls { items: balls, groups } })
    }

    /// The memory it uses, in bytes.
    pub const fn bytes(&self) -> usize {
        match self.volumes {
            Volumes::None => 0,
            Volumes::Boxes { items, groups } => size_of_val(items) + size_of_val(groups),
            Volumes::Balls { items, groups } => size_of_val(items) + size_of_val(groups),
        }
    }
}

/// How many items there are.
fn count(boxes: &[Aabb]) -> Result<u32, BuildError> {
    u32::try_from(boxes.len()).map_err(|_| too_small(Storage::Boxes, boxes.len(), u32::MAX as usize))
}

/// The part of what is lent that is needed.
fn lent<V>(volumes: &mut [V], what: Storage, needed: usize) -> Result<&mut [V], BuildError> {
    let lent = volumes.len();
    volumes.get_mut(..needed).ok_or(too_small(what, needed, lent))
}

/// The boxes round the groups of those that have these.
fn boxes_of_groups(boxes: &[Aabb]) -> impl Iterator<Item = Aabb> {
    in_groups(boxes).map(|content| content.iter().fold(Aabb::EMPTY, |all, item| all.union(*item)))
}

impl Accelerator for List<'_> {
    type Scratch = ();

    fn walk<Q: Query>(&self, ray: &Ray, _: &mut (), query: &mut Q) {
        // Strictly beyond: an item at the same distance may have the lower number, and must win.
        let in_box = |aabb: &Aabb, reach| aabb.span(ray).is_some_and(|span| span.entry <= reach);
        let end = match self.volumes {
            Volumes::None => bare(self.items, query),
            Volumes::Boxes { items, groups } => through(items, groups, query, in_box),
            Volumes::Balls { items, groups } => {
                let line = Line::of(ray);
                through(items, groups, query, |ball, reach| ball.meets(&line, reach))
            }
        };
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = end;
    }
}

#[inline(always)]
fn bare<Q: Query>(items: u32, query: &mut Q) -> ControlFlow<()> {
    query.enter();
    query.all(items)
}

/// Offers the items whose volumes the ray `meets` within reach, in groups of which it does.
fn through<V, Q: Query>(
    items: &[V],
    groups: &[V],
    query: &mut Q,
    meets: impl Fn(&V, Real) -> bool,
) -> ControlFlow<()> {
    query.boxes(groups.len() as u32);
    for ((group, volumes), number) in groups.iter().zip(in_groups(items)).zip(0..) {
        if !meets(group, query.reach()) {
            continue;
        }
        query.enter();
        query.boxes(volumes.len() as u32);
        for (volume, place) in volumes.iter().zip(0..) {
            if meets(volume, query.reach()) {
                query.test(ItemId(number * GROUP as u32 + place))?;
            }
        }
    }
    ControlFlow::Continue(())
}
