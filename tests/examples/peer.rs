//! Compares the firmware's picture of the peer scene (`peer.ppm`, the first argument) with a renderer of the
//! scene's description that shares no code with the core, and names the cause of every pixel that differs by
//! more than 2/255. Fails if more than 1 % of all pixels differ.
//!
//! A cause is a rule of the description that strahl does not follow. It is the cause of a pixel if the
//! renderer without that rule gives strahl's pixel:
//!
//! * *total reflection*: the description continues along (1, 0, 0), strahl reflects the ray;
//! * *threshold*: the description ignores hits nearer than 0.001, strahl offsets the ray origin;
//! * *edge*: the renderer gives strahl's pixel with a ray that is displaced by a hundredth of a pixel.

// The peer's own arithmetic, on one machine.
#![allow(clippy::disallowed_methods)]

use std::error::Error;

type PeerVector = [f32; 3];

const W: usize = 160;
const H: usize = 120;
const SKY: PeerVector = [0.2, 0.7, 0.8];

struct PeerMaterial {
    index: f32,
    /// Diffuse, highlight, mirror, glass.
    share: [f32; 4],
    color: PeerVector,
    exponent: f32,
}

const fn material(index: f32, share: [f32; 4], color: PeerVector, exponent: f32) -> PeerMaterial {
    PeerMaterial { index, share, color, exponent }
}

static IVORY: PeerMaterial = material(1.0, [0.9, 0.5, 0.1, 0.0], [0.4, 0.4, 0.3], 50.0);
static GLASS: PeerMaterial = material(1.5, [0.0, 0.9, 0.1, 0.8], [0.6, 0.7, 0.8], 125.0);
static RUBBER: PeerMaterial = material(1.0, [1.4, 0.3, 0.0, 0.0], [0.3, 0.1, 0.1], 10.0);
static MIRROR: PeerMaterial = material(1.0, [0.0, 16.0, 0.8, 0.0], [1.0, 1.0, 1.0], 1425.0);
static LIGHT_TILE: PeerMaterial = material(1.0, [2.0, 0.0, 0.0, 0.0], [0.3, 0.3, 0.3], 0.0);
static DARK_TILE: PeerMaterial = material(1.0, [2.0, 0.0, 0.0, 0.0], [0.3, 0.2, 0.1], 0.0);
static SPHERES: [(PeerVector, f32, &PeerMaterial); 4] = [
    ([-3.0, 0.0, -16.0], 2.0, &IVORY),
    ([-1.0, -1.5, -12.0], 2.0, &GLASS),
    ([1.5, -0.5, -18.0], 3.0, &RUBBER),
    ([7.0, 5.0, -18.0], 4.0, &MIRROR),
];
const LIGHTS: [PeerVector; 3] = [[-20.0, 20.0, 20.0], [30.0, 50.0, -25.0], [30.0, 20.0, 30.0]];

fn add(a: PeerVector, b: PeerVector) -> PeerVector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
fn times(a: PeerVector, s: f32) -> PeerVector {
    a.map(|x| x * s)
}
fn sub(a: PeerVector, b: PeerVector) -> PeerVector {
    add(a, times(b, -1.0))
}
fn dot(a: PeerVector, b: PeerVector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
fn unit(a: PeerVector) -> PeerVector {
    times(a, 1.0 / libm::sqrtf(dot(a, a)))
}
fn mirrored(d: PeerVector, n: PeerVector) -> PeerVector {
    sub(d, times(n, 2.0 * dot(d, n)))
}

/// PeerRules of the description. Without one of them the renderer follows strahl.
#[derive(Clone, Copy)]
struct PeerRules {
    along_x: bool,
    threshold: bool,
}

struct PeerHit {
    point: PeerVector,
    normal: PeerVector,
    material: &'static PeerMaterial,
}

impl PeerRules {
    /// Nearest hit of a ray.
    fn nearest(self, o: PeerVector, d: PeerVector) -> Option<PeerHit> {
        let t_min = if self.threshold { 0.001 } else { 2e-5 };
        let mut nearest = 1e10_f32;
        let mut hit = None;
        if d[1].abs() > 0.001 {
            let t = -(o[1] + 4.0) / d[1];
            let p = add(o, times(d, t));
            if t > t_min && t < nearest && p[0].abs() < 10.0 && p[2] < -10.0 && p[2] > -30.0 {
                nearest = t;
                let odd = ((0.5 * p[0] + 1000.0) as i32 + (0.5 * p[2]) as i32) & 1 == 1;
                let material = if odd { &LIGHT_TILE } else { &DARK_TILE };
                hit = Some(PeerHit { point: p, normal: [0.0, 1.0, 0.0], material });
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
            let t = if along - half > t_min { along - half } else { along + half };
            if t > t_min && t < nearest {
                nearest = t;
                let point = add(o, times(d, t));
                hit = Some(PeerHit { point, normal: unit(sub(point, center)), material });
            }
        }
        hit.filter(|_| nearest < 1000.0)
    }

    fn refracted(self, d: PeerVector, n: PeerVector, index: f32) -> PeerVector {
        let cos = -dot(d, n).clamp(-1.0, 1.0);
        if cos < 0.0 {
            return self.through(d, times(n, -1.0), -cos, index);
        }
        self.through(d, n, cos, 1.0 / index)
    }

    fn through(self, d: PeerVector, n: PeerVector, cos: f32, eta: f32) -> PeerVector {
        let k = 1.0 - eta * eta * (1.0 - cos * cos);
        if k < 0.0 {
            return if self.along_x { [1.0, 0.0, 0.0] } else { mirrored(d, n) };
        }
        add(times(d, eta), times(n, eta * cos - libm::sqrtf(k)))
    }

    fn cast(self, o: PeerVector, d: PeerVector, depth: u32) -> PeerVector {
        let hit = if depth > 4 { None } else { self.nearest(o, d) };
        let Some(PeerHit { point, normal, material }) = hit else { return SKY };
        let [diffuse, highlight, mirror, glass] = material.share;
        let (mut lit, mut shine) = (0.0, 0.0);
        for light in LIGHTS {
            let to_light = sub(light, point);
            let toward = unit(to_light);
            let occluded = self.nearest(point, toward).is_some_and(|hit| {
                let far = sub(hit.point, point);
                dot(far, far) < dot(to_light, to_light)
            });
            if !occluded {
                lit += dot(toward, normal).max(0.0);
                let cos = -dot(mirrored(times(toward, -1.0), normal), d);
                shine += libm::powf(cos.max(0.0), material.exponent);
            }
        }
        let mut color = add(times(material.color, lit * diffuse), times([1.0; 3], shine * highlight));
        if mirror > 0.0 {
            let d = unit(mirrored(d, normal));
            color = add(color, times(self.cast(point, d, depth + 1), mirror));
        }
        if glass > 0.0 {
            let d = unit(self.refracted(d, normal, material.index));
            color = add(color, times(self.cast(point, d, depth + 1), glass));
        }
        color
    }

    fn pixel(self, i: usize, j: usize, displacement: [f32; 2]) -> [u8; 3] {
        let (x, y) = (i as f32 + 0.5 + displacement[0], j as f32 + 0.5 + displacement[1]);
        let z = -(H as f32) / (2.0 * libm::tanf(1.05 / 2.0));
        let color = self.cast([0.0; 3], unit([x - W as f32 / 2.0, H as f32 / 2.0 - y, z]), 0);
        let brightest = color.iter().fold(1.0_f32, |brightest, x| brightest.max(*x));
        color.map(|x| (255.0 * (x / brightest)) as u8)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: peer PICTURE.ppm")?;
    let file = std::fs::read(path)?;
    let pixels = file.strip_prefix(b"P6\n160 120\n255\n").ok_or("not a picture of 160 x 120")?;
    let near = |a: &[u8], b: [u8; 3]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 2);
    let rules = PeerRules { along_x: true, threshold: true };
    let names = ["total reflection", "threshold", "both", "edge", "edge of a total reflection", "unknown"];
    let mut causes = [0; 6];
    for (pixel, index) in pixels.chunks_exact(3).zip(0..W * H) {
        let (i, j) = (index % W, index / W);
        let at = |rules: PeerRules, displacement| near(pixel, rules.pixel(i, j, displacement));
        if at(rules, [0.0; 2]) {
            continue;
        }
        let (mirrors, close) =
            (PeerRules { along_x: false, ..rules }, PeerRules { threshold: false, ..rules });
        let neither = PeerRules { along_x: false, threshold: false };
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
        return Err("the picture differs from the description".into());
    }
    Ok(())
}
