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
//! the proof in [`walls`] needs. Where walls are so close to each other that the slab test's widening
//! reaches from one to the next, the siblings between the two are entered too.
//!
//! Source: "The SMART Navigation of a Ray Through an Oct-tree", Spackman and Willis, Computers &
//! Graphics 15(2), 1991. Differs from it: the decision vectors are not carried on by sums and
//! shifts, which would drift away from the slab test; there is a stack and no recursion.
//!
//! [`walls`]: crate::accel::walls

use core::ops::ControlFlow;

use super::{Octree, OctreeNode, WALLS};
use crate::geometry::{Ray, Span, WIDEN};
use crate::math::{Ordered, Real, Vec3, morton, ordered, vec3};

/// So many steps of [`ordered`] numbers away is what [`WIDEN`] reaches: a step is at least half an
/// epsilon of the number.
const NEAR: Ordered = 8;
const _: () = assert!(WIDEN <= 1.0 + 4.0 * Real::EPSILON);

/// Comes after every distance: the wall is not, or not any more, in the way.
const NEVER: Ordered = Ordered::MAX;

/// A node that is cut, while a ray is in it.
#[derive(Clone, Copy)]
struct Inside {
    /// The place of the first child.
    children: u32,
    /// Which children have items, by absolute index.
    occupied: u8,
    /// The relative Morton index of the child that the ray is in.
    child: u8,
    /// The axes whose walls are crossed at one place, while the children there are entered.
    crossing: u8,
    /// How far the middle walls are that will be crossed.
    walls: [Ordered; 3],
    /// Where the child, and where the node, begins and ends.
    begin: Ordered,
    end: Ordered,
    /// The numbers of its middle walls.
    middle: Vec3,
}

impl Inside {
    const NOWHERE: Inside = Inside {
        children: 0,
        occupied: 0,
        child: 0,
        crossing: 0,
        walls: [NEVER; 3],
        begin: 0,
        end: 0,
        middle: Vec3::ZERO,
    };
}

/// The nodes round the one that the ray is in.
struct Stack {
    nodes: [Inside; morton::HALVINGS as usize],
    height: usize,
}

impl Stack {
    #[inline(always)]
    fn push(&mut self, node: &Inside) {
        if let Some(place) = self.nodes.get_mut(self.height) {
            *place = *node;
            self.height += 1;
        }
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<Inside> {
        self.height = self.height.checked_sub(1)?;
        self.nodes.get(self.height).copied()
    }
}

#[inline(always)]
fn least(a: Ordered, b: Ordered) -> Ordered {
    if a < b { a } else { b }
}

#[inline(always)]
fn most(a: Ordered, b: Ordered) -> Ordered {
    if a > b { a } else { b }
}

/// The axes whose walls are not beyond `edge`, a bit for each.
#[inline(always)]
fn until(walls: [Ordered; 3], edge: Ordered) -> u8 {
    let [x, y, z] = walls;
    u8::from(x <= edge) | u8::from(y <= edge) << 1 | u8::from(z <= edge) << 2
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
    ) {
        let mut reach = ordered(reach);
        let begin = ordered(if span.entry > 0.0 { span.entry } else { 0.0 });
        let Some(root) = self.nodes.first().copied() else { return };
        if begin > reach {
            return;
        }
        if !root.is_cut() {
            let (ControlFlow::Continue(_) | ControlFlow::Break(())) = enter(root);
            return;
        }
        let backward = |x: Real| u8::from(x.is_sign_negative());
        // Relative to absolute indices and back: the XOR with the corner from which the ray comes.
        let Vec3 { x, y, z } = ray.inverse;
        let corner = backward(x) | backward(y) << 1 | backward(z) << 2;

        let mut stack = Stack { nodes: [Inside::NOWHERE; morton::HALVINGS as usize], height: 0 };
        let middle = Vec3::splat(0.5 * WALLS);
        let mut half = 0.5 * WALLS;
        let mut node = self.vertical(ray, root, middle, begin, ordered(span.exit));
        loop {
            let octant = node.child ^ corner;
            if node.occupied >> octant & 1 == 1 {
                let place = node.children.wrapping_add(u32::from(octant));
                let child = self.nodes.get(place as usize).copied().unwrap_or(OctreeNode::EMPTY);
                if child.is_cut() {
                    half *= 0.5;
                    let side = |bit: u8| if octant & bit == 0 { -half } else { half };
                    let middle = node.middle + vec3(side(1), side(2), side(4));
                    let end = node.end_of_child();
                    let begin = node.begin;
                    stack.push(&node);
                    node = self.vertical(ray, child, middle, begin, end);
                    continue;
                }
                match enter(child) {
                    ControlFlow::Continue(left) => reach = ordered(left),
                    ControlFlow::Break(()) => return,
                }
            }
            // To the sibling behind the next wall, or of the node round this one, ...
            while !node.horizontal(reach) {
                match stack.pop() {
                    Some(outer) => node = outer,
                    None => return,
                }
                half *= 2.0;
            }
        }
    }

    /// Into a node that is cut, where the ray enters it.
    #[inline(always)]
    fn vertical(&self, ray: &Ray, node: OctreeNode, middle: Vec3, begin: Ordered, end: Ordered) -> Inside {
        let distance = (self.walls.at(middle) - ray.origin) * ray.inverse;
        let mut child = 0;
        let last = end.saturating_add(NEAR);
        let mut wall = |distance: Real, bit: u8| {
            let distance = ordered(distance);
            let is_behind = distance.saturating_add(NEAR) < begin;
            child |= if is_behind { bit } else { 0 };
            if is_behind || distance > last { NEVER } else { distance }
        };
        let walls = [wall(distance.x, 1), wall(distance.y, 2), wall(distance.z, 4)];
        Inside {
            children: node.first,
            occupied: node.content as u8,
            child,
            crossing: 0,
            walls,
            begin,
            end,
            middle,
        }
    }
}

impl Inside {
    /// Where the child ends that the ray is in: at the next wall, or with the node.
    #[inline(always)]
    fn end_of_child(&self) -> Ordered {
        if self.crossing != 0 {
            // Some of the walls at this place are still ahead.
            return self.begin.saturating_add(2 * NEAR);
        }
        let [x, y, z] = self.walls;
        least(self.end, least(x, least(y, z)))
    }

    /// To the next sibling, if there is one that begins within reach.
    #[inline(always)]
    fn horizontal(&mut self, reach: Ordered) -> bool {
        if self.crossing != 0 {
            return self.cross_on();
        }
        let [x, y, z] = self.walls;
        let next = least(x, least(y, z));
        // Strictly beyond: an item at the same distance may have the lower number, and must win.
        if next > reach {
            return false;
        }
        let edge = next.saturating_add(NEAR);
        let crossed = until(self.walls, edge);
        self.begin = most(self.begin, next);
        if crossed & (crossed - 1) != 0 {
            return self.cross_many();
        }
        self.child ^= crossed;
        for (wall, bit) in self.walls.iter_mut().zip([1, 2, 4]) {
            *wall = if crossed & bit == 0 { *wall } else { NEVER };
        }
        true
    }

    /// Begins to cross several walls at one place: all siblings round it are entered.
    #[cold]
    fn cross_many(&mut self) -> bool {
        let [x, y, z] = self.walls;
        let mut edge = least(x, least(y, z));
        // A wall that is near one that is near: three walls at most.
        for _ in 0..2 {
            let reached = until(self.walls, edge.saturating_add(NEAR));
            for (wall, bit) in self.walls.into_iter().zip([1, 2, 4]) {
                edge = if reached & bit == 0 { edge } else { most(edge, wall) };
            }
        }
        self.crossing = until(self.walls, edge.saturating_add(NEAR));
        for (wall, bit) in self.walls.iter_mut().zip([1, 2, 4]) {
            *wall = if self.crossing & bit == 0 { *wall } else { NEVER };
        }
        self.cross_on()
    }

    /// The next sibling behind some of the walls that are crossed at one place, in the order of
    /// relative indices; the last is behind all of them.
    #[cold]
    fn cross_on(&mut self) -> bool {
        let all = self.crossing;
        let behind = (self.child | !all).wrapping_add(1) & all;
        self.child = self.child & !all | behind;
        if behind == all {
            self.crossing = 0;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use core::ops::ControlFlow;

    use heapless::Vec;

    use super::Octree;
    use crate::accel::octree::{OctreeLimits, OctreeNode};
    use crate::accel::sample::Random;
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
        let mut waiting = Vec::<(OctreeNode, morton::Code, u32), 256>::new();
        let _ = waiting.push((tree.nodes[0], 0, 0));
        while let Some((node, code, level)) = waiting.pop() {
            if node.is_cut() {
                for octant in 0..8 {
                    let child = tree.nodes[node.first as usize + octant];
                    let is_occupied = node.content >> octant & 1 == 1;
                    assert_eq!(is_occupied, child.content > 0);
                    assert!(waiting.push((child, code << 3 | octant as morton::Code, level + 1)).is_ok());
                }
            } else if node.content > 0 {
                let size = 1 << (morton::HALVINGS - level);
                let [x, y, z] = morton::numbers(code).map(|n| (n * size) as Real);
                let near = vec3(x, y, z);
                let walls = Aabb { min: tree.walls.at(near), max: tree.walls.at(near + size as Real) };
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
            tree.smart(ray, span, Real::MAX, |node| {
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
            let loose = 1.0 + 32.0 * Real::EPSILON;
            let reached = exit * loose;
            assert!(entry <= reached && reached >= 0.0, "{leaf:?} is not met by {ray:?}");
            assert!(last <= 0.0 || entry * loose >= last, "{entry} after {last}: {ray:?}");
            last = if entry > last { entry } else { last };
        }
        let runs_in_walls = [ray.inverse.x, ray.inverse.y, ray.inverse.z].map(|i| i.is_infinite());
        if tree.bounds.span(ray).is_some() && runs_in_walls == [false; 3] {
            for leaf in leaves.iter().filter(|leaf| leaf.walls.span(ray).is_some()) {
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
    fn boxes(random: &mut Random) -> [Aabb; 12] {
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
        let mut random = Random(0x5eed_6002);
        let (mut walked, mut deepest) = (0, 0);
        for _ in 0..20 {
            with_tree(&boxes(&mut random), |tree| {
                let leaves = leaves(tree);
                deepest = if tree.depth() > deepest { tree.depth() } else { deepest };
                assert_eq!(leaves.len(), tree.regions());
                for _ in 0..50_000 {
                    let wall = |random: &mut Random| {
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
