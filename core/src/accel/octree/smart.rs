//! The SMART traversal of an octree: two kinds of steps, decided by integers.
//!
//! A *vertical* step goes from a node to the child in which the ray enters it, a *horizontal* step from a
//! child to the sibling behind the center plane between them. Siblings are numbered in the direction of the
//! ray: bit `a` of the relative Morton index is set for the siblings behind the center plane of axis `a`. So
//! a horizontal step is an XOR with that bit, and the sibling of index 7 is the last. The decision vector of
//! a node ([`NodeState`]) holds the `t` of its three center planes as integers. A horizontal step takes the
//! smallest of them. A vertical step removes the planes that the ray crosses before it enters the node or
//! after it leaves it; when none is left, the node ends.
//!
//! Positions along the ray are not computed. The `t` of the center planes is computed once, when the ray
//! enters the node, from the indices of the planes and as in the slab test, as the proof in [`cell_planes`]
//! requires. Where planes are so close to each other that the widening of the slab test reaches from one to
//! the next, the siblings between them are visited too.
//!
//! Source: Spackman and Willis, "The SMART Navigation of a Ray Through an Oct-tree", Computers & Graphics
//! 15(2), 1991.
//! Difference: the decision vectors are not updated by sums and shifts, which would drift away from the
//! slab test, and an explicit stack replaces the recursion.
//!
//! [`cell_planes`]: crate::accel::cell_planes

use core::ops::ControlFlow;

use heapless::Vec;

use super::node_state::{MIN_ORDERED_T, NodeState, ordered_bits};
use super::{Octree, OctreeNode};
use crate::geometry::{Ray, RayInterval};
use crate::math::{OrderedBits, Real, Vec3, morton, vec3};

impl<const MAILBOX_ENTRIES: usize> Octree<'_, MAILBOX_ENTRIES> {
    /// Calls `visit` with the leaves along the ray that have entries and begin within `t_max`. `visit`
    /// returns the remaining `t_max`, or breaks.
    ///
    /// `span`: the interval of the ray in the bounds. `t_max`: finite.
    #[inline(always)]
    pub(super) fn traverse_smart(
        &self,
        ray: &Ray,
        span: RayInterval,
        t_max: Real,
        mut visit: impl FnMut(OctreeNode) -> ControlFlow<(), Real>,
    ) -> ControlFlow<()> {
        let mut t_max = ordered_bits(t_max);
        let t_begin = ordered_bits(span.t_entry).max(MIN_ORDERED_T);
        let Some(root) = self.nodes.first().copied() else { return ControlFlow::Continue(()) };
        if ordered_bits(span.t_entry) > t_max {
            return ControlFlow::Continue(());
        }
        if !root.is_inner() {
            visit(root)?;
            return ControlFlow::Continue(());
        }
        // Converts relative to absolute Morton indices and back, by XOR: the octant that the ray comes from.
        let is_negative = |x: Real| u8::from(x.is_sign_negative());
        let Vec3 { x, y, z } = ray.inverse_direction;
        let direction_mask = is_negative(x) | is_negative(y) << 1 | is_negative(z) << 2;

        // The ancestors of `node`, as many as the tree is deep at most.
        let mut stack = Vec::<NodeState, { morton::BITS_PER_AXIS as usize }>::new();
        // Per axis, the index of the node's first plane; and half the number of cells that it covers.
        let (mut first, mut half) = ([0_u32; 3], 1_u32 << (morton::BITS_PER_AXIS - 1));
        let t_end = ordered_bits(span.t_exit);
        let mut node = self.step_vertical(ray, root, first.map(|plane| plane + half), t_begin, t_end);
        loop {
            let octant = node.child ^ direction_mask;
            if node.occupied >> octant & 1 == 1 {
                let index = node.first_child.wrapping_add(u32::from(octant));
                let child = self.nodes.get(index as usize).copied().unwrap_or(OctreeNode::EMPTY);
                if child.is_inner() {
                    let is_upper = |axis: u8| u32::from(octant >> axis & 1);
                    let [x, y, z] = first;
                    first = [x + is_upper(0) * half, y + is_upper(1) * half, z + is_upper(2) * half];
                    half >>= 1;
                    let (t_begin, t_end) = (node.t_begin, node.child_end());
                    // It is never full.
                    let (Ok(()) | Err(_)) = stack.push(node);
                    node = self.step_vertical(ray, child, first.map(|plane| plane + half), t_begin, t_end);
                    continue;
                }
                t_max = ordered_bits(visit(child)?);
            }
            // To the next sibling, or to that of the nearest ancestor that has one.
            while !node.step_horizontal(t_max) {
                match stack.pop() {
                    Some(parent) => node = parent,
                    None => return ControlFlow::Continue(()),
                }
                half <<= 1;
                first = first.map(|plane| plane & !half);
            }
        }
    }

    /// Enters an inner node. `center`: indices of its center planes.
    #[inline(always)]
    fn step_vertical(
        &self,
        ray: &Ray,
        node: OctreeNode,
        center: [u32; 3],
        t_begin: OrderedBits,
        t_end: OrderedBits,
    ) -> NodeState {
        let [x, y, z] = center.map(|plane| plane as i32 as Real);
        let center_t = (self.planes.position(vec3(x, y, z)) - ray.origin) * ray.inverse_direction;
        NodeState::new(node, center_t, t_begin, t_end)
    }
}

#[cfg(test)]
mod tests {
    use core::ops::ControlFlow;

    use heapless::Vec;

    use super::Octree;
    use crate::accel::OctreeLimits;
    use crate::accel::octree::OctreeNode;
    use crate::accel::test_rays::SplitMix64;
    use crate::geometry::{Aabb, Ray};
    use crate::math::{Real, Vec3, morton, vec3};

    const MAX_NODES: usize = 400;

    /// A leaf with entries, and the box between its planes.
    #[derive(Clone, Copy, Debug)]
    struct TestLeaf {
        node: OctreeNode,
        bounds: Aabb,
    }

    /// All leaves with entries, found without a ray.
    fn leaves(tree: &Octree<'_, 0>) -> Vec<TestLeaf, MAX_NODES> {
        let mut leaves = Vec::new();
        let mut pending = Vec::<(OctreeNode, morton::MortonCode, u32), 256>::new();
        let _ = pending.push((tree.nodes[0], 0, 0));
        while let Some((node, code, level)) = pending.pop() {
            if node.is_inner() {
                for octant in 0..8 {
                    let child = tree.nodes[node.first as usize + octant];
                    let is_occupied = node.content >> octant & 1 == 1;
                    assert_eq!(is_occupied, child.content > 0);
                    let code = code << 3 | octant as morton::MortonCode;
                    assert!(pending.push((child, code, level + 1)).is_ok());
                }
            } else if node.content > 0 {
                let size = 1 << (morton::BITS_PER_AXIS - level);
                let [x, y, z] = morton::deinterleave(code).map(|n| (n * size) as Real);
                let min = tree.planes.position(vec3(x, y, z));
                let max = tree.planes.position(vec3(x, y, z) + size as Real);
                // The last plane may be slightly outside.
                let bounds = Aabb { min, max: max.min(tree.bounds.max) };
                assert!(leaves.push(TestLeaf { node, bounds }).is_ok());
            }
        }
        leaves
    }

    /// Interval of `t` in the box, by the arithmetic of the slab test but without its widening.
    fn interval(bounds: &Aabb, ray: &Ray) -> (Real, Real) {
        let min = ((bounds.min - ray.origin) * ray.inverse_direction).to_array();
        let max = ((bounds.max - ray.origin) * ray.inverse_direction).to_array();
        let (mut t_entry, mut t_exit) = (Real::NEG_INFINITY, Real::MAX);
        for ((a, b), inverse) in min.into_iter().zip(max).zip(ray.inverse_direction.to_array()) {
            let (near, far) = if inverse >= 0.0 { (a, b) } else { (b, a) };
            t_entry = if near > t_entry { near } else { t_entry };
            t_exit = if far < t_exit { far } else { t_exit };
        }
        (t_entry, t_exit)
    }

    /// Visits all leaves along the ray, and checks that they are those that the slab test finds, in the order
    /// of `t_entry`. Returns their number.
    fn check(tree: &Octree<'_, 0>, leaves: &[TestLeaf], ray: &Ray) -> usize {
        let mut visited = Vec::<OctreeNode, MAX_NODES>::new();
        if let Some(span) = tree.bounds.intersect(ray) {
            let _ = tree.traverse_smart(ray, span, Real::MAX, |node| {
                assert!(!visited.contains(&node), "{node:?} is visited twice: {ray:?}");
                visited.push(node).unwrap();
                ControlFlow::Continue(Real::MAX)
            });
        }
        let mut last = Real::NEG_INFINITY;
        for node in &visited {
            let leaf = leaves.iter().find(|leaf| leaf.node == *node).unwrap();
            let (t_entry, t_exit) = interval(&leaf.bounds, ray);
            // The integers have a larger tolerance than the slab test.
            let tolerance = 1.0 + 64.0 * Real::EPSILON;
            let widened_exit = t_exit * tolerance;
            assert!(t_entry <= widened_exit && widened_exit >= 0.0, "{ray:?} misses {leaf:?}");
            assert!(last <= 0.0 || t_entry * tolerance >= last, "{t_entry} after {last}: {ray:?}");
            last = if t_entry > last { t_entry } else { last };
        }
        let is_parallel = [ray.inverse_direction.x, ray.inverse_direction.y, ray.inverse_direction.z]
            .map(|i| i.is_infinite());
        if tree.bounds.intersect(ray).is_some() && is_parallel == [false; 3] {
            // There are no hits at `t = 0`.
            let is_hit = |leaf: &&TestLeaf| leaf.bounds.intersect(ray).is_some_and(|span| span.t_exit > 0.0);
            for leaf in leaves.iter().filter(is_hit) {
                assert!(
                    visited.contains(&leaf.node),
                    "{:?} is not visited: {ray:?} {:?} {:?}",
                    leaf,
                    leaf.bounds.intersect(ray),
                    tree.bounds.intersect(ray)
                );
            }
        }
        visited.len()
    }

    fn with_tree(boxes: &[Aabb], test: impl FnOnce(&Octree<'_, 0>)) {
        let (mut nodes, mut entries) = ([OctreeNode::EMPTY; MAX_NODES], [0; 2 * MAX_NODES]);
        let limits = OctreeLimits { max_depth: 21, max_leaf_items: 1 };
        test(&Octree::build_with_limits(limits, boxes, &mut nodes, &mut entries).unwrap());
    }

    /// Small boxes, some of them very close to each other.
    fn boxes(random: &mut SplitMix64) -> [Aabb; 12] {
        let mut cluster = Vec3::ZERO;
        core::array::from_fn(|i| {
            if i % 4 == 0 {
                cluster = random.point(-0.8, 0.8);
            }
            let scale = [1.0, 0.3, 0.01, 0.001][i % 4];
            let center = cluster + random.point(-0.2, 0.2) * scale;
            let half_extent = random.point(0.0, 0.03) * scale;
            Aabb { min: center - half_extent, max: center + half_extent }
        })
    }

    #[test]
    fn traversal_visits_the_leaves_on_the_ray_in_order_of_t_entry() {
        let mut random = SplitMix64(0x5eed_6002);
        let (mut visit_count, mut max_depth) = (0, 0);
        for _ in 0..20 {
            with_tree(&boxes(&mut random), |tree| {
                let leaves = leaves(tree);
                max_depth = if tree.depth() > max_depth { tree.depth() } else { max_depth };
                assert_eq!(leaves.len(), tree.occupied_leaf_count());
                for _ in 0..50_000 {
                    let plane = |random: &mut SplitMix64| {
                        let bounds = leaves[random.below(leaves.len() as u32) as usize].bounds;
                        if random.below(2) == 0 { bounds.min } else { bounds.max }
                    };
                    visit_count += check(tree, &leaves, &random.ray(plane));
                }
            });
        }
        assert!(visit_count > 200_000 && max_depth > 10, "{visit_count} leaves, depth {max_depth}");
    }
}
