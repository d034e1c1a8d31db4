//! The walk through a hierarchy.

use strahl_core::Aabb;

use super::{Met, Nearest, Ready, WIDEN};

/// A tree of boxes, four to a node, cut where half of the items lie on either side.
pub struct Hierarchy {
    boxes: Vec<Aabb>,
    nodes: Vec<Node>,
}

impl AsRef<[Aabb]> for Hierarchy {
    fn as_ref(&self) -> &[Aabb] {
        &self.boxes
    }
}

const PARTS: usize = 4;

struct Node {
    /// For each axis the low walls of all parts and then the high ones.
    walls: [[[f32; PARTS]; 2]; 3],
    children: [Child; PARTS],
}

#[derive(Clone, Copy)]
enum Child {
    Node(u32),
    Item(u32),
}

impl Hierarchy {
    /// The tree of some boxes.
    pub fn of(boxes: Vec<Aabb>) -> Hierarchy {
        let all = (0..boxes.len() as u32).collect();
        let mut tree = Hierarchy { boxes, nodes: Vec::new() };
        tree.grow(all);
        tree
    }

    /// A node with these items below it, and its place.
    fn grow(&mut self, items: Vec<u32>) -> u32 {
        let place = self.nodes.len();
        let nothing = [[f32::INFINITY; PARTS], [f32::NEG_INFINITY; PARTS]];
        self.nodes.push(Node { walls: [nothing; 3], children: [Child::Item(0); PARTS] });
        let (one, other) = self.halves(items);
        let ((a, b), (c, d)) = (self.halves(one), self.halves(other));
        for (part, items) in [a, b, c, d].into_iter().enumerate() {
            let around = items.iter().fold(Aabb::EMPTY, |all, item| all.union(self.boxes[*item as usize]));
            let child = match items[..] {
                [] => continue,
                [item] => Child::Item(item),
                _ => Child::Node(self.grow(items)),
            };
            let node = &mut self.nodes[place];
            for (axis, [low, high]) in node.walls.iter_mut().enumerate() {
                (low[part], high[part]) = (around.min[axis], around.max[axis]);
            }
            node.children[part] = child;
        }
        place as u32
    }

    fn halves(&self, mut items: Vec<u32>) -> (Vec<u32>, Vec<u32>) {
        let around = items.iter().fold(Aabb::EMPTY, |all, item| all.union(self.boxes[*item as usize]));
        let axis = (around.max - around.min).max_position();
        let middle = |item: &u32| {
            let aabb = &self.boxes[*item as usize];
            aabb.min[axis] + aabb.max[axis]
        };
        items.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
        let other = items.split_off(items.len().div_ceil(2));
        (items, other)
    }

    /// `strahl_core`'s walk.
    ///
    /// * `WIDENED`: the far ends of boxes, by what rounding may have taken from them.
    /// * `ZEROS`: the sign of the reciprocal orders walls, and what is no number changes nothing;
    ///   else `d >= 0`, and no number is in the way.
    /// * `TIES`: of two at one distance the lower number wins, and a box that begins there is
    ///   entered; else the first that is asked wins.
    #[inline(always)]
    pub fn nearest<const WIDENED: bool, const ZEROS: bool, const TIES: bool>(
        &self,
        ray: &Ready,
    ) -> Option<Met> {
        let mut nearest = Nearest::new(&self.boxes, ray);
        let (origin, inverse) = (ray.o.to_array(), ray.inverse.to_array());
        let falls = [0, 1, 2].map(|axis| if ZEROS { !(inverse[axis] >= 0.0) } else { !(ray.d[axis] >= 0.0) });
        let mut waiting = [(0.0, 0); 64];
        let mut count = 0;
        let mut here = 0;
        loop {
            let node = &self.nodes[here as usize];
            let (mut entry, mut exit) = ([0.0_f32; PARTS], [f32::MAX; PARTS]);
            for axis in 0..3 {
                let (near, far) = (
                    &node.walls[axis][usize::from(falls[axis])],
                    &node.walls[axis][usize::from(!falls[axis])],
                );
                for part in 0..PARTS {
                    let near = (near[part] - origin[axis]) * inverse[axis];
                    let far = (far[part] - origin[axis]) * inverse[axis];
                    if ZEROS {
                        entry[part] = if near > entry[part] { near } else { entry[part] };
                        exit[part] = if far < exit[part] { far } else { exit[part] };
                    } else {
                        entry[part] = if entry[part] > near { entry[part] } else { near };
                        exit[part] = if exit[part] < far { exit[part] } else { far };
                    }
                }
            }
            let mut best: Option<(f32, u32)> = None;
            for part in 0..PARTS {
                let last = if WIDENED { exit[part] * WIDEN } else { exit[part] };
                let begin = entry[part];
                let is_within = if TIES { begin <= nearest.reach } else { begin < nearest.reach };
                if !(begin <= last && is_within) {
                    continue;
                }
                match node.children[part] {
                    Child::Item(item) => nearest.test::<TIES>(item),
                    Child::Node(place) => {
                        let farther = match &mut best {
                            Some(best) if begin < best.0 => std::mem::replace(best, (begin, place)),
                            Some(_) => (begin, place),
                            None => {
                                best = Some((begin, place));
                                continue;
                            }
                        };
                        waiting[count] = farther;
                        count += 1;
                    }
                }
            }
            here = match best {
                Some((_, place)) => place,
                None => loop {
                    if count == 0 {
                        return nearest.met();
                    }
                    count -= 1;
                    let (begin, place) = waiting[count];
                    if if TIES { begin <= nearest.reach } else { begin < nearest.reach } {
                        break place;
                    }
                },
            };
        }
    }
}
