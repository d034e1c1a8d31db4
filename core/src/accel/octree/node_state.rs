//! The SMART decisions inside one octree node: which child the ray enters next.
//!
//! The `t` of a cell plane is an integer with the same order as the floating-point number (the bits of
//! non-negative numbers have it). Its three lowest bits are replaced by the axis of the plane.

use super::OctreeNode;
use crate::geometry::WIDEN;
use crate::math::{OrderedBits, Real, Vec3};

/// The bits of a crossing that hold its axis instead of its `t`: bit `a` for axis `a`.
pub(super) const AXIS_MASK: OrderedBits = 7;

/// Largest difference between two ordered `t` at which the widening of the slab test reaches from one plane
/// to the other: 8 steps for the widening (a step is at least half an epsilon of the number), and up to 7
/// that the axis bits hide in each of the two.
const CROSSING_TOLERANCE: OrderedBits = 24;
const _: () = assert!(WIDEN <= 1.0 + 4.0 * Real::EPSILON);

/// The smallest begin of a node. Crossings behind the origin of the ray, whose `t` is 0, are before it by
/// more than [`CROSSING_TOLERANCE`].
pub(super) const MIN_ORDERED_T: OrderedBits = CROSSING_TOLERANCE + AXIS_MASK + 1;

/// A plane that the ray does not cross inside the node, or has crossed already. Larger than every crossing.
const NO_CROSSING: OrderedBits = OrderedBits::MAX;

/// `t` as an integer with the same order; 0 if it is negative or NaN.
#[inline(always)]
pub(super) fn ordered_bits(t: Real) -> OrderedBits {
    let non_negative = if t > 0.0 { t } else { 0.0 };
    non_negative.to_bits() as OrderedBits
}

/// The state of a traversal in an inner node. All `t` are ordered integers.
#[derive(Clone, Copy)]
pub(super) struct NodeState {
    /// The decision vector: the crossings of center planes that are ahead, nearest first, then
    /// [`NO_CROSSING`].
    crossings: [OrderedBits; 3],
    /// The `t` at which the ray leaves the node.
    t_end: OrderedBits,
    /// The `t` at which the ray enters the current child.
    pub(super) t_begin: OrderedBits,
    /// Index of the first child.
    pub(super) first_child: u32,
    /// One bit per child that has entries, by absolute Morton index.
    pub(super) occupied: u8,
    /// Relative Morton index of the current child.
    pub(super) child: u8,
    /// The axes whose planes are crossed at an edge or corner, while the children around it are visited; else
    /// 0.
    corner_axes: u8,
}

impl NodeState {
    /// The state where the ray enters `node`. `center_t`: the `t` of the center plane of each axis.
    #[inline(always)]
    pub(super) fn new(node: OctreeNode, center_t: Vec3, t_begin: OrderedBits, t_end: OrderedBits) -> Self {
        let mut child = 0;
        let mut crossing = |t: Real, axis: OrderedBits| {
            let crossing = ordered_bits(t) & !AXIS_MASK | axis;
            let is_before = sign_mask(crossing + CROSSING_TOLERANCE - t_begin);
            let is_after = sign_mask(t_end + CROSSING_TOLERANCE - crossing);
            child |= is_before & axis;
            crossing | (is_before | is_after) & NO_CROSSING
        };
        let (x, y, z) = (crossing(center_t.x, 1), crossing(center_t.y, 2), crossing(center_t.z, 4));
        let (x, y) = (x.min(y), x.max(y));
        let (y, z) = (y.min(z), y.max(z));
        let (x, y) = (x.min(y), x.max(y));
        NodeState {
            crossings: [x, y, z],
            t_end,
            t_begin,
            first_child: node.first,
            occupied: node.content as u8,
            child: child as u8,
            corner_axes: 0,
        }
    }

    /// The `t` at which the ray leaves the current child: that of the next crossing, or of the end of the
    /// node.
    #[inline(always)]
    pub(super) fn child_end(&self) -> OrderedBits {
        if self.corner_axes != 0 {
            // Some of the crossings at this corner are still ahead.
            return (self.t_begin + 2 * CROSSING_TOLERANCE).min(self.t_end);
        }
        let [next, ..] = self.crossings;
        next.min(self.t_end)
    }

    /// Steps to the next sibling. Returns false if there is none that begins within `t_max`.
    #[inline(always)]
    pub(super) fn step_horizontal(&mut self, t_max: OrderedBits) -> bool {
        if self.corner_axes != 0 {
            self.next_corner_sibling();
            return true;
        }
        let [next, second, third] = self.crossings;
        // The end only if strictly beyond: at equal `t` the item with the lower id wins, and it may be in the
        // sibling.
        if next & !AXIS_MASK > t_max {
            return false;
        }
        self.t_begin = next;
        if second <= next + CROSSING_TOLERANCE {
            self.begin_corner();
            return true;
        }
        self.child ^= axis_of(next);
        self.crossings = [second, third, NO_CROSSING];
        true
    }

    /// Starts to cross several planes at an edge or corner: all siblings around it are visited.
    #[cold]
    fn begin_corner(&mut self) {
        let [next, second, third] = self.crossings;
        self.corner_axes = axis_of(next) | axis_of(second);
        // The third plane may be near the second one only.
        self.crossings = if third <= second + CROSSING_TOLERANCE {
            self.corner_axes |= axis_of(third);
            [NO_CROSSING; 3]
        } else {
            [third, NO_CROSSING, NO_CROSSING]
        };
        self.next_corner_sibling();
    }

    /// Steps to the next sibling around an edge or corner, in the order of relative indices; the last one is
    /// behind all planes that are crossed there.
    #[cold]
    fn next_corner_sibling(&mut self) {
        let axes = self.corner_axes;
        let crossed = (self.child | !axes).wrapping_add(1) & axes;
        self.child = self.child & !axes | crossed;
        if crossed == axes {
            self.corner_axes = 0;
        }
    }
}

/// All bits set if `x` is negative, else 0.
#[inline(always)]
fn sign_mask(x: OrderedBits) -> OrderedBits {
    x >> (OrderedBits::BITS - 1)
}

/// The axis of a crossing, as a bit.
#[inline(always)]
fn axis_of(crossing: OrderedBits) -> u8 {
    (crossing & AXIS_MASK) as u8
}
