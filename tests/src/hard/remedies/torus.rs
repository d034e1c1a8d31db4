//! The torus with a switch for each remedy.

use strahl_core::{CubicRoots, ROUNDOFF, Torus, Vec3, cubic_roots, root_between, sqrt};

use super::Ready;
use crate::textbook::quartic;

/// `strahl_core`'s torus.
///
/// * `MOVED`: from the point of the ray that is nearest to the centre; else from its origin.
/// * `PARTED`: roots parted by the turning points and bracketed; else Ferrari's formulas.
/// * `TUBE`: inside and outside, and where one ends, by the distance to the tube's middle; else by
///   the value of the quartic.
/// * `THIN`: turning points moved to where that distance turns, where the tube is thin.
#[inline(always)]
pub fn torus<const MOVED: bool, const PARTED: bool, const TUBE: bool, const THIN: bool>(
    torus: &Torus,
    ray: &Ready,
) -> Option<f32> {
    let size = torus.major + torus.minor;
    let speed = sqrt(ray.square);
    let d = ray.along / speed;
    let far = (ray.o - torus.center) / size;
    let closest = -far.dot(d);
    let foot = far + d * closest;
    let room = 1.0 + 1e-4 + 32.0 * ROUNDOFF * closest.abs() - foot.dot(foot);
    if !(room > 0.0) {
        return None;
    }
    let reach = sqrt(room);
    if closest + reach < 0.0 {
        return None;
    }
    let (o, shift) = if MOVED { (foot, closest) } else { (far, 0.0) };
    let (low, high) = (closest - reach - shift, closest + reach - shift);
    let start = if -shift > low { -shift } else { low };

    let (major, minor) = (torus.major / size, torus.minor / size);
    let line = Line::new(o, d, torus.axis, major);
    let [c0, c1, c2, c3] = line.coefficients(minor);
    if !PARTED {
        let t = quartic(c3, c2, c1, c0)
            .into_iter()
            .filter(|t| *t > start && *t <= high)
            .reduce(|a, b| if a < b { a } else { b })?;
        return Some((shift + t) * size / speed * ray.scale).filter(|t| *t > 0.0);
    }
    let f = |t: f32| {
        if TUBE {
            let (tube, change) = line.tube(t);
            (tube - minor, change)
        } else {
            ((((t + c3) * t + c2) * t + c1) * t + c0, ((4.0 * t + 3.0 * c3) * t + 2.0 * c2) * t + c1)
        }
    };
    let mut left = start;
    let mut inside = f(left).0 < 0.0;
    let turns: CubicRoots = cubic_roots([c1, 2.0 * c2, 3.0 * c3, 4.0], start, high);
    for right in turns.iter().chain([high]) {
        let right = if THIN && minor < major / 16.0 { line.nearest(right) } else { right };
        let goes_inside = f(right).0 < 0.0;
        if inside != goes_inside {
            let t = shift + root_between(f, left, right, inside);
            if t > 0.0 {
                return Some(t * size / speed * ray.scale);
            }
        }
        (left, inside) = (right, goes_inside);
    }
    None
}

/// A ray and the circle in the middle of the tube.
struct Line {
    z: f32,
    dz: f32,
    flat: Vec3,
    flat_d: Vec3,
    square: f32,
    beta: f32,
    major: f32,
}

impl Line {
    #[inline(always)]
    fn new(o: Vec3, d: Vec3, axis: Vec3, major: f32) -> Self {
        let (z, dz) = (o.dot(axis), d.dot(axis));
        let (flat, flat_d) = (o - axis * z, d - axis * dz);
        Line { z, dz, flat, flat_d, square: o.dot(o), beta: o.dot(d), major }
    }

    #[inline(always)]
    fn at(&self, t: f32) -> (f32, f32, f32, f32) {
        let flat = self.flat + self.flat_d * t;
        let rho = sqrt(flat.dot(flat));
        (rho, rho - self.major, self.z + self.dz * t, flat.dot(self.flat_d) / rho)
    }

    #[inline(always)]
    fn tube(&self, t: f32) -> (f32, f32) {
        let (_, beyond, z, d_rho) = self.at(t);
        let tube = sqrt(beyond * beyond + z * z);
        (tube, (beyond * d_rho + z * self.dz) / tube)
    }

    /// Of the quartic whose first coefficient is one, the last first.
    #[inline(always)]
    fn coefficients(&self, minor: f32) -> [f32; 4] {
        let (major, beta) = (self.major, self.beta);
        let m = 4.0 * major * major;
        let g = self.square - (major * major + minor * minor);
        [
            g * g + m * (self.z * self.z - minor * minor),
            4.0 * beta * g + 2.0 * m * self.z * self.dz,
            4.0 * beta * beta + 2.0 * g + m * self.dz * self.dz,
            4.0 * beta,
        ]
    }

    #[inline(always)]
    fn nearest(&self, mut t: f32) -> f32 {
        for _ in 0..2 {
            let (rho, beyond, z, d_rho) = self.at(t);
            let slope = beyond * d_rho + z * self.dz;
            let bend = d_rho * d_rho
                + self.dz * self.dz
                + beyond * (self.flat_d.dot(self.flat_d) - d_rho * d_rho) / rho;
            let step = slope / bend;
            if !(step.abs() <= 1e-3) {
                break;
            }
            t -= step;
        }
        t
    }
}
