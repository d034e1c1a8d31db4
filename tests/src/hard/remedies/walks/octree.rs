//! The walk through an octree.

use strahl_core::{Aabb, Vec3, vec3};

use super::inside::{AXIS, Inside, NEAR, ordered};
use super::{Met, Nearest, Ready, Walls, span};

/// An octree of cubes, cut where there are more than a few boxes.
pub struct Octree {
    boxes: Vec<Aabb>,
    bounds: Aabb,
    walls: Walls,
    /// The root first; then blocks of eight.
    nodes: Vec<Node>,
    items: Vec<u32>,
}

impl AsRef<[Aabb]> for Octree {
    fn as_ref(&self) -> &[Aabb] {
        &self.boxes
    }
}

#[derive(Clone, Copy)]
enum Node {
    /// The place of the first child, and which have items, a bit for each.
    Cut(u32, u8),
    /// Where its items begin and end.
    Leaf(u32, u32),
}

/// How often space may be halved, and how many boxes a leaf may list before it is cut.
const HALVINGS: u32 = 21;
const DEPTH: u32 = 6;
const LEAF: usize = 4;
/// A node is not cut where its boxes would be listed more often than this in the mean.
const MOST_GROWTH: usize = 4;

impl Octree {
    /// The octree of some boxes.
    pub fn of(boxes: Vec<Aabb>) -> Octree {
        let bounds = boxes.iter().fold(Aabb::EMPTY, |all, aabb| all.union(*aabb));
        let side = (bounds.max - bounds.min).max_element();
        let space = Aabb { min: bounds.min, max: bounds.min + side };
        let walls = Walls::new(space, Vec3::splat((1 << HALVINGS) as f32));
        let all = (0..boxes.len() as u32).collect();
        let mut tree = Octree { boxes, bounds, walls, nodes: vec![Node::Leaf(0, 0)], items: Vec::new() };
        tree.fill(0, all, [0; 3], 1 << HALVINGS);
        tree
    }

    fn fill(&mut self, place: usize, items: Vec<u32>, first: [u32; 3], size: u32) {
        let half = size >> 1;
        let [x, y, z] = first.map(|wall| (wall + half) as f32);
        let middle = self.walls.at(vec3(x, y, z));
        let is_in = |item: u32, octant: u32| {
            let aabb = &self.boxes[item as usize];
            // A box that only touches the wall is on one side of it.
            (0..3).all(|axis| {
                let (low, high, middle) = (aabb.min[axis], aabb.max[axis], middle[axis]);
                if octant >> axis & 1 == 1 { high > middle } else { low < middle || high <= middle }
            })
        };
        let part = |octant: u32| items.iter().copied().filter(|item| is_in(*item, octant)).collect();
        let parts: [Vec<u32>; 8] = [0, 1, 2, 3, 4, 5, 6, 7].map(part);
        let total: usize = parts.iter().map(Vec::len).sum();
        let is_deep = size >> (HALVINGS - DEPTH) <= 1;
        if items.len() <= LEAF || is_deep || total > MOST_GROWTH * items.len() {
            let start = self.items.len() as u32;
            self.items.extend(items);
            self.nodes[place] = Node::Leaf(start, self.items.len() as u32);
            return;
        }
        let children = self.nodes.len();
        let occupied = parts.iter().zip(0..).map(|(part, i)| u8::from(!part.is_empty()) << i).sum();
        self.nodes[place] = Node::Cut(children as u32, occupied);
        self.nodes.extend([Node::Leaf(0, 0); 8]);
        for (part, octant) in parts.into_iter().zip(0..) {
            let far = |axis: u32| first[axis as usize] + (octant >> axis & 1) * half;
            self.fill(children + octant as usize, part, [far(0), far(1), far(2)], half);
        }
    }

    #[inline(always)]
    fn enter(&self, (start, end): (u32, u32), nearest: &mut Nearest) {
        for item in &self.items[start as usize..end as usize] {
            nearest.test::<true>(*item);
        }
    }

    /// `strahl_core`'s walk.
    ///
    /// * `COMPUTED`: the distances of middle walls from their numbers; else from those of the node
    ///   round it and what lies between both, as SMART has it.
    /// * `CORNERS`: close to an edge the siblings on both sides of it are entered.
    /// * `SIDES`: a ray in a wall is walked on both sides of it.
    #[inline(always)]
    pub fn nearest<const COMPUTED: bool, const CORNERS: bool, const SIDES: bool>(
        &self,
        ray: &Ready,
    ) -> Option<Met> {
        let span = span::<true>(&self.bounds, ray)?;
        let mut nearest = Nearest::new(&self.boxes, ray);
        if !SIDES || ray.inverse.is_finite() {
            self.smart::<COMPUTED, CORNERS>(ray.o, ray.inverse, span.entry, span.exit, &mut nearest);
        } else {
            self.along_walls::<COMPUTED, CORNERS>(ray, span.entry, span.exit, &mut nearest);
        }
        nearest.met()
    }

    #[cold]
    fn along_walls<const COMPUTED: bool, const CORNERS: bool>(
        &self,
        ray: &Ready,
        entry: f32,
        exit: f32,
        nearest: &mut Nearest,
    ) {
        let number = (ray.o - self.walls.first) / self.walls.spacing;
        let both = |axis: usize| {
            let is_wall = |offset: f32| {
                let number = Vec3::splat(libm::floorf(number[axis] + 0.5) + offset);
                self.walls.at(number)[axis] == ray.o[axis]
            };
            let runs_in_wall = !ray.inverse[axis].is_finite() && [-1.0, 0.0, 1.0].into_iter().any(is_wall);
            if runs_in_wall { &[1.0, -1.0][..] } else { &[1.0] }
        };
        for x in both(0) {
            for y in both(1) {
                for z in both(2) {
                    let inverse = ray.inverse * vec3(*x, *y, *z);
                    self.smart::<COMPUTED, CORNERS>(ray.o, inverse, entry, exit, nearest);
                }
            }
        }
    }

    // By itself, so that no form is compiled into more places than another.
    #[inline(never)]
    fn smart<const COMPUTED: bool, const CORNERS: bool>(
        &self,
        origin: Vec3,
        inverse: Vec3,
        entry: f32,
        exit: f32,
        nearest: &mut Nearest,
    ) {
        let near = if CORNERS { NEAR } else { 0 };
        let (children, occupied) = match self.nodes[0] {
            Node::Leaf(start, end) => return self.enter((start, end), nearest),
            Node::Cut(children, occupied) => (children, occupied),
        };
        let backward = |x: f32| u8::from(x.is_sign_negative());
        let corner = backward(inverse.x) | backward(inverse.y) << 1 | backward(inverse.z) << 2;
        let computed = |middle: [u32; 3]| {
            let [x, y, z] = middle.map(|wall| wall as i32 as f32);
            (self.walls.at(vec3(x, y, z)) - origin) * inverse
        };

        let (mut first, mut half) = ([0_u32; 3], 1_u32 << (HALVINGS - 1));
        // Between the middle walls of a node and those of the node round it, twice.
        let mut apart =
            if COMPUTED { Vec3::ZERO } else { (self.walls.spacing * inverse).abs() * half as f32 };
        let mut around = [Inside::NONE; DEPTH as usize];
        let mut depth = 0;
        let begin = ordered(entry).max(near + AXIS + 1);
        let middles = computed([half; 3]);
        let mut node = Inside::new((children, occupied), middles, begin, ordered(exit), near);
        loop {
            let octant = node.child ^ corner;
            if node.occupied >> octant & 1 == 1 {
                match self.nodes[node.children as usize + usize::from(octant)] {
                    Node::Cut(children, occupied) => {
                        let is_far = |axis: u8| u32::from(octant >> axis & 1);
                        if COMPUTED {
                            let [x, y, z] = first;
                            first = [x + is_far(0) * half, y + is_far(1) * half, z + is_far(2) * half];
                        }
                        half >>= 1;
                        let middles = if COMPUTED {
                            computed(first.map(|wall| wall + half))
                        } else {
                            apart *= 0.5;
                            let behind = |axis: u8| if node.child >> axis & 1 == 1 { 1.0 } else { -1.0 };
                            node.middles + apart * vec3(behind(0), behind(1), behind(2))
                        };
                        let (begin, end) = (node.begin, node.end_of_child(near));
                        around[depth] = node;
                        depth += 1;
                        node = Inside::new((children, occupied), middles, begin, end, near);
                        continue;
                    }
                    Node::Leaf(start, end) => self.enter((start, end), nearest),
                }
            }
            while !node.horizontal::<CORNERS>(ordered(nearest.reach)) {
                if depth == 0 {
                    return;
                }
                depth -= 1;
                node = around[depth];
                half <<= 1;
                if COMPUTED {
                    first = first.map(|wall| wall & !half);
                } else {
                    apart *= 2.0;
                }
            }
        }
    }

    /// A point is moved along the ray, each time a little beyond the wall of its cell; the cell is
    /// looked for from the root.
    #[inline(always)]
    pub fn moved(&self, ray: &Ready) -> Option<Met> {
        let around = span::<false>(&self.bounds, ray)?;
        let mut nearest = Nearest::new(&self.boxes, ray);
        let mut t = if around.entry > 0.0 { around.entry } else { 0.0 };
        for _ in 0..MOST_STEPS {
            let point = ray.o + ray.d * (t + BEYOND);
            let (mut node, mut first, mut size) = (self.nodes[0], [0; 3], 1_u32 << HALVINGS);
            while let Node::Cut(children, _) = node {
                size >>= 1;
                let [x, y, z] = first.map(|wall: u32| (wall + size) as f32);
                let middle = self.walls.at(vec3(x, y, z));
                let far = point.cmpge(middle).bitmask();
                first = std::array::from_fn(|axis| first[axis] + (far >> axis & 1) * size);
                node = self.nodes[(children + far) as usize];
            }
            let Node::Leaf(start, end) = node else { break };
            self.enter((start, end), &mut nearest);
            let number = |at: u32| {
                let [x, y, z] = first.map(|wall: u32| (wall + at) as f32);
                self.walls.at(vec3(x, y, z))
            };
            let Some(cell) = span::<false>(&Aabb { min: number(0), max: number(size) }, ray) else { break };
            if nearest.reach <= cell.exit || around.exit <= cell.exit {
                break;
            }
            t = cell.exit;
        }
        nearest.met()
    }
}

/// How far beyond a wall a point is moved, and how many steps no walk needs.
const BEYOND: f32 = 1e-4;
const MOST_STEPS: u32 = 1000;
