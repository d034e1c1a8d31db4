//! Octree: space is cut into eighths where there are many items, and walked by SMART.
//!
//! The nodes lie in one array. The eight children of a node follow each other in the order of
//! their Morton codes, and so do, depth first, the blocks of eight; a node knows the first of its
//! children by its place, and nothing else points anywhere. The leaves list the items whose boxes
//! touch them, in one array as well, in the same order.
//!
//! An octree is deep where items are small and close together, so that it suits scenes that are
//! too uneven for a uniform grid. An item that lies across many leaves is listed in each.

mod build;
#[cfg(not(feature = "double"))]
mod parts;
mod smart;

pub use build::{OctreeLimits, OctreeRoom};
#[cfg(not(feature = "double"))]
pub(crate) use parts::OctreeParts;

use core::ops::ControlFlow;

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::cell_planes::CellPlanes;
use super::mailbox::{Mailbox, MailboxQuery};
use super::{Accelerator, Query};
use crate::geometry::{Aabb, Ray};
use crate::math::{Real, Vec3, floor, largest, morton, vec3};

/// How many of the walls stand between the ends of an octree's space, and one more: the walls
/// of the smallest cells.
const WALLS: Real = (1_u32 << morton::BITS_PER_AXIS) as Real;

/// A node of an octree: one that is cut into eight, or a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct OctreeNode {
    /// Of a node that is cut: the place of its first child. Of a leaf: where its items begin.
    first: u32,
    /// Of a node that is cut: [`OctreeNode::CUT`], and which of its children have items, one bit for each. Of a leaf:
    /// how many items it lists.
    content: u32,
}

impl OctreeNode {
    /// A leaf without items.
    pub const EMPTY: OctreeNode = OctreeNode { first: 0, content: 0 };

    /// Marks a node that is cut. No leaf lists so many items.
    const CUT: u32 = 1 << 31;

    const fn is_cut(self) -> bool {
        self.content & Self::CUT != 0
    }
}

/// An octree in lent memory; walks remember the items of a ray in `MAILBOX` slots.
///
/// * Shape: `MAILBOX` is zero or a power of two.
/// * Memory: 8 bytes per node, and 4 per entry: an item has one in each leaf that its box touches.
#[derive(Clone, Copy, Debug)]
pub struct Octree<'s, const MAILBOX: usize> {
    /// The smallest box round all items.
    bounds: Aabb,
    walls: CellPlanes,
    /// The root first; then blocks of eight.
    nodes: &'s [OctreeNode],
    /// The items of the leaves, one leaf after the other.
    items: &'s [u32],
    /// The boxes of all items, by their numbers; or none.
    boxes: &'s [Aabb],
    /// How many leaves list items.
    regions: u32,
    /// How often space is cut, at most.
    depth: u8,
}

impl<'s, const MAILBOX: usize> Octree<'s, MAILBOX> {
    /// The same octree, walked with a mailbox of another size.
    pub const fn with_mailbox<const SLOTS: usize>(self) -> Octree<'s, SLOTS> {
        let Octree { bounds, walls, nodes, items, regions, depth, boxes } = self;
        Octree { bounds, walls, nodes, items, regions, depth, boxes }
    }

    /// The same octree, but it gives back the boxes: it takes less memory, and each item of a leaf
    /// is tested, whether the ray comes near it or not.
    pub const fn without_boxes(self) -> Self {
        Octree { boxes: &[], ..self }
    }

    /// How many leaves list items.
    pub const fn regions(&self) -> usize {
        self.regions as usize
    }

    /// How many items all leaves list, each counted in each leaf.
    pub const fn entries(&self) -> usize {
        self.items.len()
    }

    /// How often space is cut on the way to the deepest leaf; a root that is a leaf has depth 0.
    pub const fn depth(&self) -> u8 {
        self.depth
    }

    /// How many nodes there are, leaves without items among them.
    pub const fn nodes(&self) -> usize {
        self.nodes.len()
    }

    /// The memory it uses, in bytes.
    pub const fn bytes(&self) -> usize {
        size_of_val(self.nodes) + size_of_val(self.items) + size_of_val(self.boxes)
    }

    /// The items of a leaf.
    #[inline(always)]
    fn items_of(&self, leaf: OctreeNode) -> &[u32] {
        let start = leaf.first as usize;
        self.items.get(start..start.wrapping_add(leaf.content as usize)).unwrap_or(&[])
    }
}

/// The space of an octree round `bounds`, in walls of its smallest cells. All cells are cubes, so
/// that a flat scene is not cut into plates.
fn space(bounds: Aabb) -> CellPlanes {
    let side = largest(bounds.max - bounds.min);
    CellPlanes::new(Aabb { min: bounds.min, max: bounds.min + side }, Vec3::splat(WALLS))
}

impl<const MAILBOX: usize> Accelerator for Octree<'_, MAILBOX> {
    type Scratch = Mailbox<MAILBOX>;

    fn walk<Q: Query>(&self, ray: &Ray, mailbox: &mut Mailbox<MAILBOX>, query: &mut Q) {
        query.boxes(1);
        let Some(span) = self.bounds.span(ray) else { return };
        mailbox.begin_ray();
        let mut walk = |ray: &Ray| {
            let reach = query.reach();
            let mut asking = MailboxQuery { ray, item_bounds: self.boxes, mailbox, query };
            self.smart(ray, span, reach, |leaf| asking.test_items(self.items_of(leaf)))
        };
        let end = if ray.inverse.is_finite() { walk(ray) } else { self.along_walls(ray, walk) };
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = end;
    }
}

impl<const MAILBOX: usize> Octree<'_, MAILBOX> {
    /// Walks along a ray that is parallel to some walls. Where it runs in a wall, it must be walked
    /// on both sides, for a box that touches the wall lies on one. On which side of such a
    /// wall a walk goes is decided by the sign of the infinite reciprocal.
    #[cold]
    fn along_walls(&self, ray: &Ray, mut walk: impl FnMut(&Ray) -> ControlFlow<()>) -> ControlFlow<()> {
        let nearest = self.walls.fractional_index(ray.origin);
        let is_in_wall = |offset: Real| {
            let number = |x: Real| floor(x + 0.5) + offset;
            let wall = self.walls.position(vec3(number(nearest.x), number(nearest.y), number(nearest.z)));
            let runs = |inverse: Real, wall: Real, origin: Real| !inverse.is_finite() && wall == origin;
            let (i, o) = (ray.inverse, ray.origin);
            [runs(i.x, wall.x, o.x), runs(i.y, wall.y, o.y), runs(i.z, wall.z, o.z)]
        };
        // The nearest wall by rounding, and its neighbours in case of rounding.
        let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = [-1.0, 0.0, 1.0].map(is_in_wall);
        let both = |is_in_wall: bool| if is_in_wall { &[1.0, -1.0][..] } else { &[1.0] };
        for x in both(x0 | x1 | x2) {
            for y in both(y0 | y1 | y2) {
                for z in both(z0 | z1 | z2) {
                    let mut side = *ray;
                    side.inverse *= vec3(*x, *y, *z);
                    walk(&side)?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}
