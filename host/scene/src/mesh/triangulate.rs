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
const TESTS: usize = 4096;

/// How a polygon was cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// The triangles cover the polygon and nothing else.
    Right,
    /// The polygon crosses itself, has no area or is too intricate.
    Blind,
}

/// A corner in the plane.
type Flat = [f64; 2];

/// Cuts the polygon with these corners; the triangles name corners by their places, and turn
/// the way that the polygon does.
pub fn cut(corners: &[Float3], triangles: &mut Vec<[u32; 3]>) -> Cut {
    let count = corners.len() as u32;
    let fan = (2..count).map(|third| [0, third - 1, third]);
    if count <= 3 {
        triangles.extend(fan);
        return Cut::Right;
    }
    let Some(flat) = flattened(corners) else {
        triangles.extend(fan);
        return Cut::Blind;
    };
    if is_convex(&flat) {
        triangles.extend(fan);
        return Cut::Right;
    }
    Ears::new(&flat).cut(triangles)
}

/// The corners in the plane of the polygon, counterclockwise; none without area.
fn flattened(corners: &[Float3]) -> Option<Vec<Flat>> {
    let at = |i: usize| corners[i % corners.len()].map(f64::from);
    let middle = at(0);
    let mut normal = [0.0; 3];
    for i in 0..corners.len() {
        // Newell's sum; from the first corner, so that places far from zero cost no digits.
        let (p, q) = (minus(at(i), middle), minus(at(i + 1), middle));
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
    Some((0..corners.len()).map(|i| minus(at(i), middle)).map(|p| [p[x], p[y]]).collect())
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Twice the area of a triangle; more than zero when it turns left.
fn turn(a: Flat, b: Flat, c: Flat) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether all corners turn left, and once round in all.
fn is_convex(flat: &[Flat]) -> bool {
    let n = flat.len();
    let at = |i: usize| flat[i % n];
    let left = (0..n).all(|i| turn(at(i), at(i + 1), at(i + 2)) > 0.0);
    // A star turns left everywhere too, but not all of its fan does.
    left && (2..n).all(|third| turn(at(0), at(third - 1), at(third)) > 0.0)
}

/// What is left of a polygon while ears are cut off.
struct Ears<'p> {
    flat: &'p [Flat],
    before: Vec<u32>,
    after: Vec<u32>,
    /// The corners that did not turn left in the beginning. Only they can lie in an ear, and
    /// those that are cut off later do no harm: they lie in no ear.
    hollow: Vec<u32>,
    tests: usize,
}

impl<'p> Ears<'p> {
    fn new(flat: &'p [Flat]) -> Self {
        let n = flat.len() as u32;
        let mut ears = Ears {
            flat,
            before: (0..n).map(|i| (i + n - 1) % n).collect(),
            after: (0..n).map(|i| (i + 1) % n).collect(),
            hollow: Vec::new(),
            tests: flat.len().saturating_mul(TESTS),
        };
        ears.hollow = (0..n).filter(|i| ears.turn_at(*i) <= 0.0).collect();
        ears
    }

    fn triangle(&self, tip: u32) -> [u32; 3] {
        [self.before[tip as usize], tip, self.after[tip as usize]]
    }

    fn turn_at(&self, tip: u32) -> f64 {
        let [a, b, c] = self.triangle(tip).map(|i| self.flat[i as usize]);
        turn(a, b, c)
    }

    fn is_ear(&mut self, tip: u32) -> bool {
        if self.turn_at(tip) <= 0.0 {
            return false;
        }
        self.tests = self.tests.saturating_sub(self.hollow.len());
        let [a, b, c] = self.triangle(tip).map(|i| self.flat[i as usize]);
        self.hollow.iter().map(|i| self.flat[*i as usize]).all(|p| {
            // A corner met twice, as where a hole is joined to the rim, is no obstacle.
            let is_corner = p == a || p == b || p == c;
            is_corner || turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0
        })
    }

    fn cut(mut self, triangles: &mut Vec<[u32; 3]>) -> Cut {
        let mut left = self.flat.len();
        let mut done = Cut::Right;
        let (mut tip, mut passed) = (0, 0);
        while left > 3 {
            let is_blind = passed >= left || self.tests == 0;
            if !is_blind && !self.is_ear(tip) {
                (tip, passed) = (self.after[tip as usize], passed + 1);
                continue;
            }
            if is_blind {
                done = Cut::Blind;
            }
            let [a, b, c] = self.triangle(tip);
            triangles.push([a, b, c]);
            self.after[a as usize] = c;
            self.before[c as usize] = a;
            // What was no ear before may be one now.
            (tip, passed, left) = (a, 0, left - 1);
        }
        triangles.push(self.triangle(tip));
        done
    }
}
