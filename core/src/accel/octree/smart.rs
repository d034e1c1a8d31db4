//! Walking through an octree by SMART: two kinds of steps, decided by whole numbers.
//!
//! *Vertical*, from a node to the child in which the ray enters it; *horizontal*, from a child
//! to the sibling behind the wall between them. Siblings are numbered in the direction of the ray:
//! bit `a` of the relative Morton index is set for those behind the middle wall of axis `a`, so a
//! horizontal step is an XOR with that bit, and the sibling of index 7 is the last. The decision
//! vector of a node holds the distances of its three middle walls, as whole numbers that are
//! ordered like the distances (the bits of a floating-point number are, up to the sign). A step
//! takes the least of them; a wall that the ray crosses before it enters the node or after it
//! leaves it is taken out at the vertical step, and with the last one the node ends.
//!
//! No position along the ray is computed. The distances of a node's middle walls are, once, when
//! the node is entered, and from the numbers of the walls, as the slab test does it: that is what
//! the proof in [`cell_planes`] needs. Where walls are so close to each other that the slab test's widening
//! reaches from one to the next, the siblings between the two are entered too.
//!
//! Source: "The SMART Navigation of a Ray Through an Oct-tree", Spackman and Willis, Computers &
//! Graphics 15(2), 1991. Differs from it: the decision vectors are not carried on by sums and
//! shifts, which would drift away from the slab test; there is a stack and no recursion.
//!
//! [`cell_planes`]: crate::accel::cell_planes

use core::ops::ControlFlow;

use heapless::Vec as Stack;

use super::{Octree, OctreeNode};
use crate::geometry::{Ray, Span, WIDEN};
use crate::math::{Ordered, Real, Vec3, morton, vec3};

/// The bits of a wall's distance that tell its axis instead: bit `a` for axis `a`.
const AXIS: Ordered = 7;

/// How far apart two walls may be, in such numbers, where the slab test's widening reaches from one
/// to the other: 8 steps (a step is at least half an epsilon of the number), and what the bits for
/// the axes hide, 7 of either.
const NEAR: Ordered = 24;
const _: () = assert!(WIDEN <= 1.0 + 4.0 * Real::EPSILON);

/// The least distance at which something may be met, and the walls behind the origin are behind.
const ORIGIN: Ordered = NEAR + AXIS + 1;

/// Comes after every distance: the wall is not, or not any more, in the way.
const NEVER: Ordered = Ordered::MAX;

/// The whole number that is ordered among others like the distances are. What lies behind the
/// origin, or is no number, is 0.
#[inline(always)]
fn ordered(distance: Real) -> Ordered {
    let ahead = if distance > 0.0 { distance } else { 0.0 };
    ahead.to_bits() as Ordered
}

/// A node that is cut, while a ray is in it.
#[derive(Clone, Copy)]
struct Inside {
    /// The middle walls that will be crossed, nearest first, with their axes; then [`NEVER`]s.
    walls: [Ordered; 3],
    /// Where the node ends.
    end: Ordered,
    /// Where the child begins that the ray is in.
    begin: Ordered,
    /// The place of the first child.
    children: u32,
    /// Which children have items, by absolute index.
    occupied: u8,
    /// The relative Morton index of the child that the ray is in.
    child: u8,
    /// The axes whose walls are crossed at one place, while the children there are entered.
    crossing: u8,
}

impl<const MAILBOX: usize> Octree<'_, MAILBOX> {
    /// Calls `enter` with the leaves along the ray that begin within reach, but those without
    /// items; it answers with the reach that is left, or breaks.
    ///
    /// `span` is the part of the ray in the bounds, and `reach` is finite.
    #[inline(always)]
    pub(super) fn smart(
        &self,
        ray: &Ray,
        span: Span,
        reach: Real,
        mut enter: impl FnMut(OctreeNode) -> ControlFlow<(), Real>,
    ) -> ControlFlow<()> {
        let mut reach = ordered(reach);
        let begin = greatest(ordered(span.entry), ORIGIN);
        let Some(root) = self.nodes.first().copied() else { return ControlFlow::Continue(()) };
        if ordered(span.entry) > reach {
            return ControlFlow::Continue(());
        }
        if !root.is_cut() {
            enter(root)?;
            return ControlFlow::Continue(());
        }
        // Relative to absolute indices and back: the XOR with the corner from which the ray comes.
        let backward = |x: Real| u8::from(x.is_sign_negative());
        let Vec3 { x, y, z } = ray.inverse;
        let corner = backward(x) | backward(y) << 1 | backward(z) << 2;

        let mut around = Stack::<Inside, { morton::BITS_PER_AXIS as usize }>::new();
        // The number of the first wall of the node along each axis, and how many cells its half takes.
        let (mut first, mut half) = ([0_u32; 3], 1_u32 << (morton::BITS_PER_AXIS - 1));
        let mut node = self.vertical(ray, root, first.map(|wall| wall + half), begin, ordered(span.exit));
        loop {
            let octant = node.child ^ corner;
            if node.occupied >> octant & 1 == 1 {
                let place = node.children.wrapping_add(u32::from(octant));
                let child = self.nodes.get(place as usize).copied().unwrap_or(OctreeNode::EMPTY);
                if child.is_cut() {
                    let is_far = |axis: u8| u32::from(octant >> axis & 1);
                    let [x, y, z] = first;
                    first = [x + is_far(0) * half, y + is_far(1) * half, z + is_far(2) * half];
                    half >>= 1;
                    let (begin, end) = (node.begin, node.end_of_child());
                    // It is as high as the tree is deep.
                    let (Ok(()) | Err(_)) = around.push(node);
                    node = self.vertical(ray, child, first.map(|wall| wall + half), begin, end);
                    continue;
                }
                reach = ordered(enter(child)?);
            }
            // To the sibling behind the next wall, or of the node round this one, ...
            while !node.horizontal(reach) {
                match around.pop() {
                    Some(outer) => node = outer,
                    None => return ControlFlow::Continue(()),
                }
                half <<= 1;
                first = first.map(|wall| wall & !half);
            }
        }
    }

    /// Into a node that is cut, where the ray enters it; `middle` are the numbers of its middle walls.
    #[inline(always)]
    fn vertical(
        &self,
        ray: &Ray,
        node: OctreeNode,
        middle: [u32; 3],
        begin: Ordered,
        end: Ordered,
    ) -> Inside {
        let [x, y, z] = middle.map(|wall| wall as i32 as Real);
        let distance = (self.walls.position(vec3(x, y, z)) - ray.origin) * ray.inverse;
        let mut child = 0;
        let mut wall = |distance: Real, axis: Ordered| {
            let wall = ordered(distance) & !AXIS | axis;
            // All bits are set, or none.
            let is_behind = is_negative(wall + NEAR - begin);
            let is_beyond = is_negative(end + NEAR - wall);
            child |= is_behind & axis;
            wall | (is_behind | is_beyond) & NEVER
        };
        let (x, y, z) = (wall(distance.x, 1), wall(distance.y, 2), wall(distance.z, 4));
        let (x, y) = (least(x, y), greatest(x, y));
        let (y, z) = (least(y, z), greatest(y, z));
        let (x, y) = (least(x, y), greatest(x, y));
        Inside {
            walls: [x, y, z],
            end,
            begin,
            children: node.first,
            occupied: node.content as u8,
            child: child as u8,
            crossing: 0,
        }
    }
}

/// All bits set if it is, else none.
#[inline(always)]
fn is_negative(x: Ordered) -> Ordered {
    x >> (Ordered::BITS - 1)
}

#[inline(always)]
fn least(a: Ordered, b: Ordered) -> Ordered {
    if a < b { a } else { b }
}

#[inline(always)]
fn greatest(a: Ordered, b: Ordered) -> Ordered {
    if a > b { a } else { b }
}

/// The axis of a wall, as a bit.
#[inline(always)]
fn axis(wall: Ordered) -> u8 {
    (wall & AXIS) as u8
}

impl Inside {
    /// Where the child ends that the ray is in: at the next wall, or with the node.
    #[inline(always)]
    fn end_of_child(&self) -> Ordered {
        if self.crossing != 0 {
            // Some of the walls at this place are still ahead.
            return least(self.begin + 2 * NEAR, self.end);
        }
        let [next, ..] = self.walls;
        least(next, self.end)
    }

    /// To the next sibling, if there is one that begins within reach.
    #[inline(always)]
    fn horizontal(&mut self, reach: Ordered) -> bool {
        if self.crossing != 0 {
            self.cross_on();
            return true;
        }
        let [next, second, third] = self.walls;
        // Strictly beyond: an item at the same distance may have the lower number, and must win.
        if next & !AXIS > reach {
            return false;
        }
        self.begin = next;
        if second <= next + NEAR {
            self.cross_many();
            return true;
        }
        self.child ^= axis(next);
        self.walls = [second, third, NEVER];
        true
    }

    /// Begins to cross several walls at one place: all siblings round it are entered.
    #[cold]
    fn cross_many(&mut self) {
        let [next, second, third] = self.walls;
        self.crossing = axis(next) | axis(second);
        // A wall may be near one that is near.
        self.walls = if third <= second + NEAR {
            self.crossing |= axis(third);
            [NEVER; 3]
        } else {
            [third, NEVER, NEVER]
        };
        self.cross_on();
    }

    /// The next sibling behind some of the walls that are crossed at one place, in the order of
    /// relative indices; the last is behind all of them.
    #[cold]
    fn cross_on(&mut self) {
        let all = self.crossing;
        let behind = (self.child | !all).wrapping_add(1) & all;
        self.child = self.child & !all | behind;
        if behind == all {
            self.crossing = 0;
        }
    }
}

#[cfg(test)]
mod tests {
    use core::ops::ControlFlow;

    use heapless::Vec;

    use super::Octree;
    use crate::accel::octree::{OctreeLimits, OctreeNode};
    use crate::accel::test_rays::SplitMix64;
    use crate::geometry::{Aabb, Ray};
    use crate::math::{Real, Vec3, morton, vec3};

    const MOST: usize = 400;

    /// A leaf with items, and the box between its walls.
    #[derive(Clone, Copy, Debug)]
    struct Leaf {
        node: OctreeNode,
        walls: Aabb,
    }

    /// All leaves with items, by the codes of the nodes.
    fn leaves(tree: &Octree<'_, 0>) -> Vec<Leaf, MOST> {
        let mut found = Vec::new();
        let mut waiting = Vec::<(OctreeNode, morton::MortonCode, u32), 256>::new();
        let _ = waiting.push((tree.nodes[0], 0, 0));
        while let Some((node, code, level)) = waiting.pop() {
            if node.is_cut() {
                for octant in 0..8 {
                    let child = tree.nodes[node.first as usize + octant];
                    let is_occupied = node.content >> octant & 1 == 1;
                    assert_eq!(is_occupied, child.content > 0);
                    assert!(
                        waiting.push((child, code << 3 | octant as morton::MortonCode, level + 1)).is_ok()
                    );
                }
            } else if node.content > 0 {
                let size = 1 << (morton::BITS_PER_AXIS - level);
                let [x, y, z] = morton::deinterleave(code).map(|n| (n * size) as Real);
                let near = vec3(x, y, z);
                let walls =
                    Aabb { min: tree.walls.position(near), max: tree.walls.position(near + size as Real) };
                // The last wall may stand a little outside.
                let walls = Aabb { min: walls.min, max: walls.max.min(tree.bounds.max) };
                assert!(found.push(Leaf { node, walls }).is_ok());
            }
        }
        found
    }

    /// Where the ray is between the walls, by the arithmetic of the slab test but without its widening.
    fn interval(walls: &Aabb, ray: &Ray) -> (Real, Real) {
        let low = ((walls.min - ray.origin) * ray.inverse).to_array();
        let high = ((walls.max - ray.origin) * ray.inverse).to_array();
        let (mut entry, mut exit) = (Real::NEG_INFINITY, Real::MAX);
        for ((a, b), inverse) in low.into_iter().zip(high).zip(ray.inverse.to_array()) {
            let (near, far) = if inverse >= 0.0 { (a, b) } else { (b, a) };
            entry = if near > entry { near } else { entry };
            exit = if far < exit { far } else { exit };
        }
        (entry, exit)
    }

    /// Walks the whole way, and holds the leaves against all that the slab test says the ray meets,
    /// in the order of their beginnings. Answers how many there are.
    fn check(tree: &Octree<'_, 0>, leaves: &[Leaf], ray: &Ray) -> usize {
        let mut walked = Vec::<OctreeNode, MOST>::new();
        if let Some(span) = tree.bounds.span(ray) {
            let _ = tree.smart(ray, span, Real::MAX, |node| {
                assert!(!walked.contains(&node), "{node:?} is entered twice by {ray:?}");
                walked.push(node).unwrap();
                ControlFlow::Continue(Real::MAX)
            });
        }
        let mut last = Real::NEG_INFINITY;
        for node in &walked {
            let leaf = leaves.iter().find(|leaf| leaf.node == *node).unwrap();
            let (entry, exit) = interval(&leaf.walls, ray);
            // Whole numbers reach a little farther than the slab test does.
            let loose = 1.0 + 64.0 * Real::EPSILON;
            let reached = exit * loose;
            assert!(entry <= reached && reached >= 0.0, "{leaf:?} is not met by {ray:?}");
            assert!(last <= 0.0 || entry * loose >= last, "{entry} after {last}: {ray:?}");
            last = if entry > last { entry } else { last };
        }
        let runs_in_walls = [ray.inverse.x, ray.inverse.y, ray.inverse.z].map(|i| i.is_infinite());
        if tree.bounds.span(ray).is_some() && runs_in_walls == [false; 3] {
            // Nothing is met at distance 0.
            let is_met = |leaf: &&Leaf| leaf.walls.span(ray).is_some_and(|span| span.exit > 0.0);
            for leaf in leaves.iter().filter(is_met) {
                assert!(
                    walked.contains(&leaf.node),
                    "{:?} is left out: {ray:?} {:?} {:?}",
                    leaf,
                    leaf.walls.span(ray),
                    tree.bounds.span(ray)
                );
            }
        }
        walked.len()
    }

    fn with_tree(boxes: &[Aabb], test: impl FnOnce(&Octree<'_, 0>)) {
        let (mut nodes, mut entries) = ([OctreeNode::EMPTY; MOST], [0; 2 * MOST]);
        let limits = OctreeLimits { depth: 21, leaf: 1 };
        test(&Octree::with_limits(limits, boxes, &mut nodes, &mut entries).unwrap());
    }

    /// Small boxes; a few of them very close to each other.
    fn boxes(random: &mut SplitMix64) -> [Aabb; 12] {
        let mut cluster = Vec3::ZERO;
        core::array::from_fn(|i| {
            if i % 4 == 0 {
                cluster = random.point(-0.8, 0.8);
            }
            let scale = [1.0, 0.3, 0.01, 0.001][i % 4];
            let center = cluster + random.point(-0.2, 0.2) * scale;
            let half = random.point(0.0, 0.03) * scale;
            Aabb { min: center - half, max: center + half }
        })
    }

    #[test]
    fn the_leaves_of_a_walk_are_those_that_the_ray_meets_sorted_by_their_beginnings() {
        let mut random = SplitMix64(0x5eed_6002);
        let (mut walked, mut deepest) = (0, 0);
        for _ in 0..20 {
            with_tree(&boxes(&mut random), |tree| {
                let leaves = leaves(tree);
                deepest = if tree.depth() > deepest { tree.depth() } else { deepest };
                assert_eq!(leaves.len(), tree.regions());
                for _ in 0..50_000 {
                    let wall = |random: &mut SplitMix64| {
                        let walls = leaves[random.below(leaves.len() as u32) as usize].walls;
                        if random.below(2) == 0 { walls.min } else { walls.max }
                    };
                    walked += check(tree, &leaves, &random.ray(wall));
                }
            });
        }
        assert!(walked > 200_000 && deepest > 10, "{walked} leaves, depth {deepest}");
    }
}
