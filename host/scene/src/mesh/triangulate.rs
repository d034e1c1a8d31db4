//! Polygons become triangles: as a fan where that is right, else ear by ear.
//!
//! A fan from the first corner is right for a convex polygon only. Of any other the ears are
//! cut off: corners that turn inwards and whose triangle holds no other corner of the polygon.
//! A simple polygon always has one (Meisters, "Polygons have ears", 1975). Corners on a
//! straight line are no ears, so they stay until a triangle with area takes them in, and
//! neighbours meet without a gap.
//!
//! The work is bounded: what crosses itself, or asks for more tests than its corners earn,
//! is cut to its end without looking. Every polygon of `n` corners gives `n - 2` triangles.

use crate::description::Float3;

/// Tests of one corner against one triangle, for each corner of a polygon.
const TESTS_PER_VERTEX: usize = 4096;

/// How a polygon was cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Triangulation {
    /// The triangles cover the polygon and nothing else.
    Exact,
    /// The polygon crosses itself, has no area or is too intricate.
    BestEffort,
}

/// A corner in the plane.
type Point2 = [f64; 2];

/// Cuts the polygon with these corners; the triangles name corners by their places, and turn
/// the way that the polygon does.
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

/// The corners in the plane of the polygon, counterclockwise; none without area.
fn project_to_plane(corners: &[Float3]) -> Option<Vec<Point2>> {
    let at = |i: usize| corners[i % corners.len()].map(f64::from);
    let middle = at(0);
    let mut normal = [0.0; 3];
    for i in 0..corners.len() {
        // Newell's sum; from the first corner, so that places far from zero cost no digits.
        let (p, q) = (difference(at(i), middle), difference(at(i + 1), middle));
        for (axis, sum) in normal.iter_mut().enumerate() {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            *sum += (p[j] - q[j]) * (p[k] + q[k]);
        }
    }
    // Along the longest axis of the normal the plane is seen best.
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

/// Twice the area of a triangle; more than zero when it turns left.
fn orientation(a: Point2, b: Point2, c: Point2) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether all corners turn left, and once round in all.
fn is_convex(flat: &[Point2]) -> bool {
    let n = flat.len();
    let at = |i: usize| flat[i % n];
    let left = (0..n).all(|i| orientation(at(i), at(i + 1), at(i + 2)) > 0.0);
    // A star turns left everywhere too, but not all of its fan does.
    left && (2..n).all(|third| orientation(at(0), at(third - 1), at(third)) > 0.0)
}

/// What is left of a polygon while ears are cut off.
struct EarClipper<'p> {
    points: &'p [Point2],
    previous: Vec<u32>,
    next: Vec<u32>,
    /// The corners that did not turn left in the beginning. Only they can lie in an ear, and
    /// those that are cut off later do no harm: they lie in no ear.
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
            // A corner met twice, as where a hole is joined to the rim, is no obstacle.
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
            // What was no ear before may be one now.
            (tip, passed, left) = (a, 0, left - 1);
        }
        triangles.push(self.triangle(tip));
        done
    }
}
