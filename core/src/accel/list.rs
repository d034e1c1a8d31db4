//! Lists: every item in order, the reference for the other accelerators.
//!
//! The list without bounds passes every item to the query, for every ray. With bounding volumes (boxes or spheres) it
//! first tests the ray against the volume of a group of consecutive items, then against the volume of each
//! item of the group: a ray that misses a volume misses its contents.

use core::ops::ControlFlow;

use super::{Accelerator, Buffer, BuildError, Query};
use crate::geometry::{Aabb, BoundingSphere, BoundingSphereRay, ItemId, Ray};
use crate::math::Real;

/// Number of items that share the bounding volume of a group.
const GROUP_SIZE: usize = 16;

/// Number of groups of 16 items in a [`List`] of `items` items: the number of group volumes that
/// [`List::with_boxes`] and [`List::with_spheres`] need.
pub const fn group_count(items: usize) -> usize {
    items.div_ceil(GROUP_SIZE)
}

/// The volumes of one group after the other; the last slice may be shorter or empty.
fn group_chunks<V>(volumes: &[V]) -> impl Iterator<Item = &[V]> {
    let (full, rest) = volumes.as_chunks::<GROUP_SIZE>();
    full.iter().map(|group| group.as_slice()).chain([rest])
}

/// An accelerator without memory: tests each ray against all items in order.
///
/// It contains no code for bounding volumes, which [`List`] has: for devices with a handful of items.
#[derive(Clone, Copy, Debug)]
pub struct ListWithoutBounds(
    /// Number of items of the scene, planes included. Items with this id or a higher one are not tested;
    /// planes are always tested, by the world.
    pub u32,
);

impl Accelerator for ListWithoutBounds {
    type Scratch = ();

    #[inline(always)]
    fn traverse<Q: Query>(&self, _: &Ray, _: &mut (), query: &mut Q) {
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = test_all(self.0, query);
    }
}

/// An accelerator that tests items in order, and skips those whose bounding volume a ray misses.
///
/// * Each item has a bounding volume (a box or a sphere), and so has each group of 16 consecutive items. A ray
///   that misses the volume of a group is not tested against its items.
/// * [`List::without_bounds`] skips no item.
/// * Memory: one volume per item, plus one per group of 16 items; none without bounding volumes.
#[derive(Clone, Copy, Debug)]
pub struct List<'s> {
    items: u32,
    volumes: BoundingVolumes<'s>,
}

/// The bounding volumes of the items, in order, and those of the groups of [`GROUP_SIZE`] items.
#[derive(Clone, Copy, Debug)]
enum BoundingVolumes<'s> {
    None,
    Boxes { items: &'s [Aabb], groups: &'s [Aabb] },
    Spheres { items: &'s [BoundingSphere], groups: &'s [BoundingSphere] },
}

const fn too_small(buffer: Buffer, needed: usize, provided: usize) -> BuildError {
    BuildError::BufferTooSmall { buffer, needed, provided }
}

impl<'s> List<'s> {
    /// The list of the items `0..items`, without bounding volumes: each ray is tested against each item.
    pub const fn without_bounds(items: u32) -> Self {
        List { items, volumes: BoundingVolumes::None }
    }

    /// A list whose bounding volumes are the boxes in `bounds`, which it borrows.
    ///
    /// `bounds`: one box per item. `groups`: caller-provided buffer for the boxes of groups, at least
    /// [`group_count`] long.
    ///
    /// # Errors
    ///
    /// [`BuildError::BufferTooSmall`] for `groups`.
    pub fn with_boxes(bounds: &'s [Aabb], groups: &'s mut [Aabb]) -> Result<Self, BuildError> {
        let items = item_count(bounds)?;
        let groups = checked_prefix(groups, Buffer::GroupBounds, group_count(bounds.len()))?;
        for (group, aabb) in groups.iter_mut().zip(group_boxes(bounds)) {
            *group = aabb;
        }
        Ok(List { items, volumes: BoundingVolumes::Boxes { items: bounds, groups } })
    }

    /// The list of the items with these bounds, with bounding spheres.
    ///
    /// `bounds`: one box per item; not kept. `spheres` and `groups`: caller-provided buffers for the spheres
    /// of items and of groups, at least as long as `bounds` and as [`group_count`].
    ///
    /// # Errors
    ///
    /// [`BuildError::BufferTooSmall`] for `spheres` or `groups`.
    pub fn with_spheres(
        bounds: &[Aabb],
        spheres: &'s mut [BoundingSphere],
        groups: &'s mut [BoundingSphere],
    ) -> Result<Self, BuildError> {
        let items = item_count(bounds)?;
        let spheres = checked_prefix(spheres, Buffer::ItemBounds, bounds.len())?;
        let groups = checked_prefix(groups, Buffer::GroupBounds, group_count(bounds.len()))?;
        for (sphere, aabb) in spheres.iter_mut().zip(bounds) {
            *sphere = BoundingSphere::of_box(aabb);
        }
        for (group, aabb) in groups.iter_mut().zip(group_boxes(bounds)) {
            *group = BoundingSphere::of_box(&aabb);
        }
        Ok(List { items, volumes: BoundingVolumes::Spheres { items: spheres, groups } })
    }

    /// Size of its bounding volumes, in bytes.
    pub const fn size_in_bytes(&self) -> usize {
        match self.volumes {
            BoundingVolumes::None => 0,
            BoundingVolumes::Boxes { items, groups } => size_of_val(items) + size_of_val(groups),
            BoundingVolumes::Spheres { items, groups } => size_of_val(items) + size_of_val(groups),
        }
    }
}

/// Number of items with these bounds, as a `u32`.
fn item_count(bounds: &[Aabb]) -> Result<u32, BuildError> {
    u32::try_from(bounds.len()).map_err(|_| too_small(Buffer::ItemBounds, bounds.len(), u32::MAX as usize))
}

/// The first `needed` elements of a caller-provided buffer.
fn checked_prefix<V>(volumes: &mut [V], buffer: Buffer, needed: usize) -> Result<&mut [V], BuildError> {
    let provided = volumes.len();
    volumes.get_mut(..needed).ok_or(too_small(buffer, needed, provided))
}

/// The box of each group of items with these bounds.
fn group_boxes(bounds: &[Aabb]) -> impl Iterator<Item = Aabb> {
    group_chunks(bounds).map(|group| group.iter().fold(Aabb::EMPTY, |all, item| all.union(*item)))
}

impl Accelerator for List<'_> {
    type Scratch = ();

    fn traverse<Q: Query>(&self, ray: &Ray, _: &mut (), query: &mut Q) {
        // A miss only if strictly beyond: at equal `t` the item with the lower id wins, and it may be this
        // one.
        let hits_box = |aabb: &Aabb, t_max| aabb.intersect(ray).is_some_and(|span| span.t_entry <= t_max);
        let end = match self.volumes {
            BoundingVolumes::None => test_all(self.items, query),
            BoundingVolumes::Boxes { items, groups } => test_bounded(items, groups, query, hits_box),
            BoundingVolumes::Spheres { items, groups } => {
                let line = BoundingSphereRay::new(ray);
                test_bounded(items, groups, query, |sphere, t_max| sphere.is_hit(&line, t_max))
            }
        };
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = end;
    }
}

/// Tests the items `0..items`.
#[inline(always)]
fn test_all<Q: Query>(items: u32, query: &mut Q) -> ControlFlow<()> {
    query.count_leaf_visit();
    query.test_first(items)
}

/// Tests the items whose own volume and whose group's volume are hit within `t_max`.
fn test_bounded<V, Q: Query>(
    items: &[V],
    groups: &[V],
    query: &mut Q,
    is_hit: impl Fn(&V, Real) -> bool,
) -> ControlFlow<()> {
    query.count_box_tests(groups.len() as u32);
    for ((group, volumes), group_index) in groups.iter().zip(group_chunks(items)).zip(0..) {
        if !is_hit(group, query.t_max()) {
            continue;
        }
        query.count_leaf_visit();
        query.count_box_tests(volumes.len() as u32);
        for (volume, index) in volumes.iter().zip(0..) {
            if is_hit(volume, query.t_max()) {
                query.test_item(ItemId(group_index * GROUP_SIZE as u32 + index))?;
            }
        }
    }
    ControlFlow::Continue(())
}
