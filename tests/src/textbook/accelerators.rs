//! Accelerators as in introductions: a grid traversed with accumulated distances (Amanatides and Woo), an
//! octree through which a point is moved, and a binary BVH.

#![allow(missing_docs)] // as in the core's own

use strahl_core::geometry::{Aabb, Ray};
use strahl_core::{AllEffects, Geometry, Shape, Vec3, vec3};

use super::intersect::slabs;
use super::{EPSILON, narrow};
use strahl_test_scene::{TestRay, TestShape};

/// Nearest hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestHit {
    pub item: u32,
    pub t: f64,
}

/// Axis-aligned boxes, intersected by the core: only the traversals are the textbook's.
pub struct BoxList {
    cuboids: Vec<strahl_core::geometry::Cuboid>,
}

impl BoxList {
    pub fn of(shapes: &[TestShape]) -> BoxList {
        let cuboid = |shape: &TestShape| match shape {
            TestShape::Cuboid { min, max } => {
                strahl_core::geometry::Cuboid { min: narrow(*min), max: narrow(*max) }
            }
            other => unreachable!("{other:?} is not a box"),
        };
        BoxList { cuboids: shapes.iter().map(cuboid).collect() }
    }

    fn bounds(&self) -> (Vec3, Vec3) {
        let all = self.cuboids.iter().flat_map(|cuboid| [cuboid.min, cuboid.max]);
        let Aabb { min, max } = Aabb::enclosing(all);
        (min, max)
    }

    /// Tests an item. Of two items at the same distance the one that is tested first wins.
    fn test(&self, item: u32, ray: &TestRay, best: &mut Option<(f32, u32)>) {
        let geometry = Geometry { cuboids: &self.cuboids, ..Geometry::EMPTY };
        let ray = Ray::new(narrow(ray.origin), narrow(ray.direction));
        if let Some(t) = geometry.intersect::<AllEffects>(&Shape::Cuboid(item), &ray)
            && best.is_none_or(|best| t < best.0)
        {
            *best = Some((t, item));
        }
    }
}

fn nearest_hit(best: Option<(f32, u32)>) -> Option<NearestHit> {
    best.map(|(t, item)| NearestHit { item, t: t.into() })
}

/// Step limit of a traversal that makes no progress.
const MAX_STEPS: u32 = 10_000;

/// Uniform grid.
///
/// Source: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987.
pub struct TextbookGrid {
    min: Vec3,
    max: Vec3,
    size: Vec3,
    /// Number of cells along each axis.
    resolution: [i32; 3],
    cells: Vec<Vec<u32>>,
}

/// Number of cells per box.
const CELLS: f32 = 8.0;

impl TextbookGrid {
    pub fn of(boxes: &BoxList) -> TextbookGrid {
        let (min, max) = boxes.bounds();
        let extent = max - min;
        let space = extent.element_product();
        let side = if space > 0.0 {
            libm::cbrtf(space / (CELLS * boxes.cuboids.len() as f32))
        } else {
            extent.max_element() / CELLS
        };
        let resolution = extent.to_array().map(|extent| ((extent / side) as i32).clamp(1, 4096));
        let size = extent / Vec3::from_array(resolution.map(|side| side as f32));
        let cells = vec![Vec::new(); resolution.iter().product::<i32>() as usize];
        let mut grid = TextbookGrid { min, max, size, resolution, cells };
        for (cuboid, item) in boxes.cuboids.iter().zip(0..) {
            let (low, high) = (grid.cell(cuboid.min), grid.cell(cuboid.max));
            for z in low[2]..=high[2] {
                for y in low[1]..=high[1] {
                    for x in low[0]..=high[0] {
                        let index = grid.index([x, y, z]);
                        grid.cells[index].push(item);
                    }
                }
            }
        }
        grid
    }

    fn cell(&self, p: Vec3) -> [i32; 3] {
        let along = |axis: usize| {
            (((p[axis] - self.min[axis]) / self.size[axis]) as i32).clamp(0, self.resolution[axis] - 1)
        };
        [0, 1, 2].map(along)
    }

    fn index(&self, [x, y, z]: [i32; 3]) -> usize {
        ((z * self.resolution[1] + y) * self.resolution[0] + x) as usize
    }

    pub fn nearest(&self, boxes: &BoxList, ray: &TestRay) -> Option<NearestHit> {
        let (o, d) = (narrow(ray.origin), narrow(ray.direction));
        let (entry, _) = interval(self.min, self.max, o, d)?;
        let mut cell = self.cell(o + d * entry);
        let step = [0, 1, 2].map(|axis| if d[axis] >= 0.0 { 1 } else { -1 });
        let mut next = [0, 1, 2].map(|axis| {
            let plane = self.min[axis] + (cell[axis] + i32::from(step[axis] > 0)) as f32 * self.size[axis];
            (plane - o[axis]) / d[axis]
        });
        let delta = [0, 1, 2].map(|axis| self.size[axis] / d[axis].abs());
        let mut best = None;
        for _ in 0..MAX_STEPS {
            for item in &self.cells[self.index(cell)] {
                boxes.test(*item, ray, &mut best);
            }
            let axis = if next[0] < next[1] {
                if next[0] < next[2] { 0 } else { 2 }
            } else if next[1] < next[2] {
                1
            } else {
                2
            };
            if best.is_some_and(|best| best.0 <= next[axis]) {
                break;
            }
            cell[axis] += step[axis];
            if cell[axis] < 0 || cell[axis] >= self.resolution[axis] {
                break;
            }
            next[axis] += delta[axis];
        }
        nearest_hit(best)
    }
}

/// Interval of a ray inside a box.
fn interval(min: Vec3, max: Vec3, o: Vec3, d: Vec3) -> Option<(f32, f32)> {
    let (mut near, mut far) = (0.0_f32, f32::INFINITY);
    for axis in 0..3 {
        let inverse = 1.0 / d[axis];
        let (a, b) = ((min[axis] - o[axis]) * inverse, (max[axis] - o[axis]) * inverse);
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    (near <= far).then_some((near, far))
}

/// Octree. A point is moved along the ray, in each step slightly beyond the plane of its cell.
pub struct TextbookOctree {
    root: OctreeCell,
}

struct OctreeCell {
    min: Vec3,
    max: Vec3,
    /// Eight children, or none.
    children: Vec<OctreeCell>,
    items: Vec<u32>,
}

impl TextbookOctree {
    pub fn of(boxes: &BoxList) -> TextbookOctree {
        let (min, max) = boxes.bounds();
        let items = (0..boxes.cuboids.len() as u32).collect();
        TextbookOctree { root: OctreeCell::of(boxes, min, max, items, 4) }
    }

    pub fn nearest(&self, boxes: &BoxList, ray: &TestRay) -> Option<NearestHit> {
        let (o, d) = (narrow(ray.origin), narrow(ray.direction));
        let (entry, exit) = interval(self.root.min, self.root.max, o, d)?;
        let (mut t, mut best) = (entry, None);
        for _ in 0..MAX_STEPS {
            let cell = self.root.at(o + d * (t + EPSILON));
            for item in &cell.items {
                boxes.test(*item, ray, &mut best);
            }
            let Some((_, out)) = interval(cell.min, cell.max, o, d) else { break };
            if best.is_some_and(|best| best.0 <= out) || exit <= out {
                break;
            }
            t = out;
        }
        nearest_hit(best)
    }
}

impl OctreeCell {
    fn of(boxes: &BoxList, min: Vec3, max: Vec3, items: Vec<u32>, levels: u32) -> OctreeCell {
        if levels == 0 || items.len() <= 4 {
            return OctreeCell { min, max, children: Vec::new(), items };
        }
        let center = (min + max) * 0.5;
        let child = |number: u32| {
            let side = |bit: u32, low: f32, center: f32, high: f32| {
                if number >> bit & 1 == 0 { (low, center) } else { (center, high) }
            };
            let x = side(0, min.x, center.x, max.x);
            let y = side(1, min.y, center.y, max.y);
            let z = side(2, min.z, center.z, max.z);
            let (low, high) = (vec3(x.0, y.0, z.0), vec3(x.1, y.1, z.1));
            let is_in = |item: &&u32| {
                let cuboid = &boxes.cuboids[**item as usize];
                cuboid.min.cmple(high).all() && cuboid.max.cmpge(low).all()
            };
            OctreeCell::of(boxes, low, high, items.iter().filter(is_in).copied().collect(), levels - 1)
        };
        OctreeCell { min, max, children: (0..8).map(child).collect(), items: Vec::new() }
    }

    fn at(&self, p: Vec3) -> &OctreeCell {
        if self.children.is_empty() {
            return self;
        }
        let center = (self.min + self.max) * 0.5;
        let bit = |axis: usize| usize::from(p[axis] >= center[axis]) << axis;
        self.children[bit(0) | bit(1) | bit(2)].at(p)
    }
}

/// Binary BVH, split at the median.
pub enum TextbookBvh {
    Leaf(Vec<u32>),
    Children(Vec3, Vec3, Box<[TextbookBvh; 2]>),
}

impl TextbookBvh {
    pub fn of(boxes: &BoxList) -> TextbookBvh {
        TextbookBvh::of_items(boxes, (0..boxes.cuboids.len() as u32).collect(), 0)
    }

    fn of_items(boxes: &BoxList, mut items: Vec<u32>, axis: usize) -> TextbookBvh {
        if items.len() <= 2 {
            return TextbookBvh::Leaf(items);
        }
        let center = |item: &u32| {
            let cuboid = &boxes.cuboids[*item as usize];
            cuboid.min[axis] + cuboid.max[axis]
        };
        items.sort_by(|a, b| center(a).total_cmp(&center(b)));
        let of = |item: &u32| boxes.cuboids[*item as usize];
        let Aabb { min, max } = Aabb::enclosing(items.iter().flat_map(|item| [of(item).min, of(item).max]));
        let other = items.split_off(items.len() / 2);
        let child = |items| TextbookBvh::of_items(boxes, items, (axis + 1) % 3);
        TextbookBvh::Children(min, max, Box::new([child(items), child(other)]))
    }

    pub fn nearest(&self, boxes: &BoxList, ray: &TestRay) -> Option<NearestHit> {
        let mut best = None;
        self.traverse(boxes, ray, &mut best);
        nearest_hit(best)
    }

    fn traverse(&self, boxes: &BoxList, ray: &TestRay, best: &mut Option<(f32, u32)>) {
        match self {
            TextbookBvh::Leaf(items) => items.iter().for_each(|item| boxes.test(*item, ray, best)),
            TextbookBvh::Children(min, max, children) => {
                if slabs(*min, *max, narrow(ray.origin), narrow(ray.direction)) {
                    children.iter().for_each(|child| child.traverse(boxes, ray, best));
                }
            }
        }
    }
}
