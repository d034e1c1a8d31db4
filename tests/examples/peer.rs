//! Holds the firmware's picture of the peer scene (`peer.ppm`, the first argument) against a
//! renderer of the scene's description that shares no code with the core, and names the cause of
//! every pixel that is more than 2/255 off. Fails when these are more than 1 % of all.
//!
//! A cause is a rule of the description that strahl does otherwise; it is the cause of a pixel
//! when the renderer without that rule gives strahl's pixel:
//!
//! * *total reflection*: the description sends the ray along (1, 0, 0), strahl mirrors it;
//! * *threshold*: the description knows no hit nearer than 0.001, strahl none behind the point
//!   that a ray leaves;
//! * *edge*: the renderer gives strahl's pixel when it looks past the pixel's middle by a hundredth.

// The peer's own arithmetic, on one machine.
#![allow(clippy::disallowed_methods)]

use std::error::Error;

type Vector = [f32; 3];

const W: usize = 160;
const H: usize = 120;
const SKY: Vector = [0.2, 0.7, 0.8];

struct Material {
    index: f32,
    /// Diffuse, highlight, mirror, glass.
    share: [f32; 4],
    color: Vector,
    exponent: f32,
}

const fn material(index: f32, share: [f32; 4], color: Vector, exponent: f32) -> Material {
    Material { index, share, color, exponent }
}

static IVORY: Material = material(1.0, [0.9, 0.5, 0.1, 0.0], [0.4, 0.4, 0.3], 50.0);
static GLASS: Material = material(1.5, [0.0, 0.9, 0.1, 0.8], [0.6, 0.7, 0.8], 125.0);
static RUBBER: Material = material(1.0, [1.4, 0.3, 0.0, 0.0], [0.3, 0.1, 0.1], 10.0);
static MIRROR: Material = material(1.0, [0.0, 16.0, 0.8, 0.0], [1.0, 1.0, 1.0], 1425.0);
static LIGHT_TILE: Material = material(1.0, [2.0, 0.0, 0.0, 0.0], [0.3, 0.3, 0.3], 0.0);
static DARK_TILE: Material = material(1.0, [2.0, 0.0, 0.0, 0.0], [0.3, 0.2, 0.1], 0.0);
static SPHERES: [(Vector, f32, &Material); 4] = [
    ([-3.0, 0.0, -16.0], 2.0, &IVORY),
    ([-1.0, -1.5, -12.0], 2.0, &GLASS),
    ([1.5, -0.5, -18.0], 3.0, &RUBBER),
    ([7.0, 5.0, -18.0], 4.0, &MIRROR),
];
const LIGHTS: [Vector; 3] = [[-20.0, 20.0, 20.0], [30.0, 50.0, -25.0], [30.0, 20.0, 30.0]];

fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
fn times(a: Vector, s: f32) -> Vector {
    a.map(|x| x * s)
}
fn sub(a: Vector, b: Vector) -> Vector {
    add(a, times(b, -1.0))
}
fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
fn unit(a: Vector) -> Vector {
    times(a, 1.0 / libm::sqrtf(dot(a, a)))
}
fn mirrored(d: Vector, n: Vector) -> Vector {
    sub(d, times(n, 2.0 * dot(d, n)))
}

/// The rules that the description has; without one of them the renderer does as strahl does.
#[derive(Clone, Copy)]
struct Rules {
    sideways: bool,
    threshold: bool,
}

struct Met {
    point: Vector,
    normal: Vector,
    material: &'static Material,
}

impl Rules {
    /// What is met from `o` on, if it is not the thing that the ray leaves.
    fn nearest(self, o: Vector, d: Vector) -> Option<Met> {
        let least = if self.threshold { 0.001 } else { 2e-5 };
        let mut nearest = 1e10_f32;
        let mut met = None;
        if d[1].abs() > 0.001 {
            let t = -(o[1] + 4.0) / d[1];
            let p = add(o, times(d, t));
            if t > least && t < nearest && p[0].abs() < 10.0 && p[2] < -10.0 && p[2] > -30.0 {
                nearest = t;
                let odd = ((0.5 * p[0] + 1000.0) as i32 + (0.5 * p[2]) as i32) & 1 == 1;
                let material = if odd { &LIGHT_TILE } else { &DARK_TILE };
                met = Some(Met { point: p, normal: [0.0, 1.0, 0.0], material });
            }
        }
        for (center, radius, material) in SPHERES {
            let l = sub(center, o);
            let along = dot(l, d);
            let d2 = dot(l, l) - along * along;
            if d2 > radius * radius {
                continue;
            }
            let half = libm::sqrtf(radius * radius - d2);
            let t = if along - half > least { along - half } else { along + half };
            if t > least && t < nearest {
                nearest = t;
                let point = add(o, times(d, t));
                met = Some(Met { point, normal: unit(sub(point, center)), material });
            }
        }
        met.filter(|_| nearest < 1000.0)
    }

    fn broken(self, d: Vector, n: Vector, index: f32) -> Vector {
        let cos = -dot(d, n).clamp(-1.0, 1.0);
        if cos < 0.0 {
            return self.through(d, times(n, -1.0), -cos, index);
        }
        self.through(d, n, cos, 1.0 / index)
    }

    fn through(self, d: Vector, n: Vector, cos: f32, eta: f32) -> Vector {
        let k = 1.0 - eta * eta * (1.0 - cos * cos);
        if k < 0.0 {
            return if self.sideways { [1.0, 0.0, 0.0] } else { mirrored(d, n) };
        }
        add(times(d, eta), times(n, eta * cos - libm::sqrtf(k)))
    }

    fn cast(self, o: Vector, d: Vector, depth: u32) -> Vector {
        let met = if depth > 4 { None } else { self.nearest(o, d) };
        let Some(Met { point, normal, material }) = met else { return SKY };
        let [diffuse, highlight, mirror, glass] = material.share;
        let (mut lit, mut shine) = (0.0, 0.0);
        for light in LIGHTS {
            let way = sub(light, point);
            let toward = unit(way);
            let blocked = self.nearest(point, toward).is_some_and(|met| {
                let far = sub(met.point, point);
                dot(far, far) < dot(way, way)
            });
            if !blocked {
                lit += dot(toward, normal).max(0.0);
                let seen = -dot(mirrored(times(toward, -1.0), normal), d);
                shine += libm::powf(seen.max(0.0), material.exponent);
            }
        }
        let mut color = add(times(material.color, lit * diffuse), times([1.0; 3], shine * highlight));
        if mirror > 0.0 {
            let d = unit(mirrored(d, normal));
            color = add(color, times(self.cast(point, d, depth + 1), mirror));
        }
        if glass > 0.0 {
            let d = unit(self.broken(d, normal, material.index));
            color = add(color, times(self.cast(point, d, depth + 1), glass));
        }
        color
    }

    fn pixel(self, i: usize, j: usize, aside: [f32; 2]) -> [u8; 3] {
        let (x, y) = (i as f32 + 0.5 + aside[0], j as f32 + 0.5 + aside[1]);
        let z = -(H as f32) / (2.0 * libm::tanf(1.05 / 2.0));
        let color = self.cast([0.0; 3], unit([x - W as f32 / 2.0, H as f32 / 2.0 - y, z]), 0);
        let most = color.iter().fold(1.0_f32, |most, x| most.max(*x));
        color.map(|x| (255.0 * (x / most)) as u8)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: peer PICTURE.ppm")?;
    let file = std::fs::read(path)?;
    let pixels = file.strip_prefix(b"P6\n160 120\n255\n").ok_or("it is no picture of 160 x 120")?;
    let near = |a: &[u8], b: [u8; 3]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 2);
    let rules = Rules { sideways: true, threshold: true };
    let names = ["total reflection", "threshold", "both", "edge", "edge of a total reflection", "unknown"];
    let mut causes = [0; 6];
    for (pixel, place) in pixels.chunks_exact(3).zip(0..W * H) {
        let (i, j) = (place % W, place / W);
        let at = |rules: Rules, aside| near(pixel, rules.pixel(i, j, aside));
        if at(rules, [0.0; 2]) {
            continue;
        }
        let (mirrors, close) = (Rules { sideways: false, ..rules }, Rules { threshold: false, ..rules });
        let neither = Rules { sideways: false, threshold: false };
        let around =
            |rules| [-0.01, 0.0, 0.01].iter().any(|x| [-0.01, 0.0, 0.01].iter().any(|y| at(rules, [*x, *y])));
        let cause = if at(mirrors, [0.0; 2]) {
            0
        } else if at(close, [0.0; 2]) {
            1
        } else if at(neither, [0.0; 2]) {
            2
        } else if around(rules) {
            3
        } else if around(neither) {
            4
        } else {
            5
        };
        causes[cause] += 1;
    }
    let off: usize = causes.iter().sum();
    println!(
        "{off} of {} pixels are more than 2/255 off ({:.2} %)",
        W * H,
        off as f64 / (W * H) as f64 * 100.0
    );
    for (name, count) in names.iter().zip(causes) {
        println!("  {name}: {count}");
    }
    if off * 100 > W * H || causes[5] > 0 {
        return Err("the picture is another".into());
    }
    Ok(())
}
