//! Triangulation of polygons: a fan if the polygon is convex, otherwise ear clipping.
//!
//! An ear is a convex vertex whose triangle contains no other vertex of the polygon. Collinear vertices are not ears, so
//! they stay until a triangle with area includes them, and adjacent polygons have no gap between them.
//!
//! Bounded work: after 4096 point-in-triangle tests per vertex, or if no ear is left (self-intersecting input), the
//! remaining polygon is clipped without tests and [`Triangulation::BestEffort`] is returned. A polygon of `n` vertices
//! always gives `n - 2` triangles.
//!
//! Source: Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975.

use crate::description::Float3;

/// The maximum number of point-in-triangle tests per vertex of a polygon.
const TESTS_PER_VERTEX: usize = 4096;

/// The quality of a triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Triangulation {
    /// The triangles cover exactly the polygon.
    Exact,
    /// The polygon intersects itself, has no area, or exceeded the number of tests; the triangles may overlap.
    BestEffort,
}

/// A vertex in the plane of the polygon.
type Point2 = [f64; 2];

/// Triangulates the polygon with these vertices. The triangles are indices into `corners`, with the orientation of the
/// polygon.
pub fn triangulate(corners: &[Float3], triangles: &mut Vec<[u32; 3]>) -> Triangulation {
    let count = corners.len() as u32;
    let fan = (2..count).map(|third| [0, third - 1, third]);
    if count <= 3 {
        triangles.extend(fan);
        return Triangulation::Exact;
    }
    let Some(flat) = project_to_plane(corners) else {
        triangles.extend(fan);
        return Triangulation::BestEffort;
    };
    if is_convex(&flat) {
        triangles.extend(fan);
        return Triangulation::Exact;
    }
    EarClipper::new(&flat).clip(triangles)
}

/// The vertices projected to a coordinate plane, counterclockwise; `None` if the polygon has no area.
fn project_to_plane(corners: &[Float3]) -> Option<Vec<Point2>> {
    let at = |i: usize| corners[i % corners.len()].map(f64::from);
    let middle = at(0);
    let mut normal = [0.0; 3];
    for i in 0..corners.len() {
        // Newell's method, relative to the first vertex, so that positions far from the origin lose no digits.
        let (p, q) = (difference(at(i), middle), difference(at(i + 1), middle));
        for (axis, sum) in normal.iter_mut().enumerate() {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            *sum += (p[j] - q[j]) * (p[k] + q[k]);
        }
    }
    // Project along the longest axis of the normal.
    let longest = (0..3).max_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs()))?;
    if normal[longest] == 0.0 {
        return None;
    }
    let (x, y) = ((longest + 1) % 3, (longest + 2) % 3);
    let (x, y) = if normal[longest] > 0.0 { (x, y) } else { (y, x) };
    Some((0..corners.len()).map(|i| difference(at(i), middle)).map(|p| [p[x], p[y]]).collect())
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Twice the signed area of a triangle; positive if it is counterclockwise.
fn orientation(a: Point2, b: Point2, c: Point2) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the polygon is convex and counterclockwise.
fn is_convex(flat: &[Point2]) -> bool {
    let n = flat.len();
    let at = |i: usize| flat[i % n];
    let left = (0..n).all(|i| orientation(at(i), at(i + 1), at(i + 2)) > 0.0);
    // A star also turns left at every vertex, but not all triangles of its fan do.
    left && (2..n).all(|third| orientation(at(0), at(third - 1), at(third)) > 0.0)
}

/// The remaining polygon while ears are clipped, as a linked list.
struct EarClipper<'p> {
    points: &'p [Point2],
    previous: Vec<u32>,
    next: Vec<u32>,
    /// The vertices that were reflex or collinear at the start. Only these can be in an ear; those that have been
    /// clipped are in no ear.
    reflex: Vec<u32>,
    test_budget: usize,
}

impl<'p> EarClipper<'p> {
    fn new(flat: &'p [Point2]) -> Self {
        let n = flat.len() as u32;
        let mut ears = EarClipper {
            points: flat,
            previous: (0..n).map(|i| (i + n - 1) % n).collect(),
            next: (0..n).map(|i| (i + 1) % n).collect(),
            reflex: Vec::new(),
            test_budget: flat.len().saturating_mul(TESTS_PER_VERTEX),
        };
        ears.reflex = (0..n).filter(|i| ears.orientation_at(*i) <= 0.0).collect();
        ears
    }

    fn triangle(&self, tip: u32) -> [u32; 3] {
        [self.previous[tip as usize], tip, self.next[tip as usize]]
    }

    fn orientation_at(&self, tip: u32) -> f64 {
        let [a, b, c] = self.triangle(tip).map(|i| self.points[i as usize]);
        orientation(a, b, c)
    }

    fn is_ear(&mut self, tip: u32) -> bool {
        if self.orientation_at(tip) <= 0.0 {
            return false;
        }
        self.test_budget = self.test_budget.saturating_sub(self.reflex.len());
        let [a, b, c] = self.triangle(tip).map(|i| self.points[i as usize]);
        self.reflex.iter().map(|i| self.points[*i as usize]).all(|p| {
            // A vertex that occurs twice, such as at the bridge to a hole, does not block an ear.
            let is_corner = p == a || p == b || p == c;
            is_corner
                || orientation(a, b, p) < 0.0
                || orientation(b, c, p) < 0.0
                || orientation(c, a, p) < 0.0
        })
    }

    fn clip(mut self, triangles: &mut Vec<[u32; 3]>) -> Triangulation {
        let mut left = self.points.len();
        let mut done = Triangulation::Exact;
        let (mut tip, mut passed) = (0, 0);
        while left > 3 {
            let is_blind = passed >= left || self.test_budget == 0;
            if !is_blind && !self.is_ear(tip) {
                (tip, passed) = (self.next[tip as usize], passed + 1);
                continue;
            }
            if is_blind {
                done = Triangulation::BestEffort;
            }
            let [a, b, c] = self.triangle(tip);
            triangles.push([a, b, c]);
            self.next[a as usize] = c;
            self.previous[c as usize] = a;
            // The previous vertex may have become an ear.
            (tip, passed, left) = (a, 0, left - 1);
        }
        triangles.push(self.triangle(tip));
        done
    }
}
