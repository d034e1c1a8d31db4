//! Random shapes of all kinds, from all sides, against an oracle that solves no equation.

use strahl_tests::oracle::{Contact, PRECISION, Truth, distance, meet, shading, size};

use crate::*;

const SEED: u64 = 0x5eed_0001;

/// Things of each kind, and rays for each of them.
const THINGS: usize = 150;
const RAYS: usize = 150;

/// How many roundoffs, times [`size`] over slope, a way may be off: 4 units in the last place,
/// whatever the formula. Half of it is what is found.
const MULTIPLE: f64 = 8.0;

/// What was checked, and the worst that was found.
#[derive(Debug, Default)]
struct Report {
    hits: usize,
    misses: usize,
    unclear: usize,
    /// Of a way, in roundoffs times size over slope.
    way: f64,
    /// Of a normal, in roundoffs, and on a curved surface as many as the point may be off.
    normal: f64,
    /// Of a point, in the errors that the core has promised.
    point: f64,
    /// Of a shading normal, in roundoffs, and as many as the point may be off.
    shading: f64,
}

/// Holds the answers of both cores against the truth.
fn hold(thing: &Thing, rays: &[Line], reports: &mut [Report; 2]) {
    let truths: Vec<Truth> = rays.iter().map(|line| meet(thing, line)).collect();
    for (core, report) in CORES.iter().zip(reports) {
        for ((line, truth), found) in rays.iter().zip(&truths).zip((core.cast)(thing, rays)) {
            let about = || format!("{}\n{thing:?}\n{line:?}\n{truth:?}\n{found:?}", core.name);
            assert!(found.is_none_or(|found| found.is_finite()), "{}", about());
            match (truth, found) {
                (Truth::Unclear, _) => report.unclear += 1,
                (Truth::Miss, None) => report.misses += 1,
                (Truth::Hit(contact), Some(found)) => {
                    report.hits += 1;
                    report.check(core, thing, line, contact, &found, &about);
                }
                _ => panic!("hit or miss is wrong: {}", about()),
            }
        }
    }
}

/// Prints what was found; else little would have been checked when so few are hit, missed, and
/// clear.
fn conclude(name: &str, reports: &[Report; 2], hits: f64, misses: f64, unclear: f64) {
    for (core, report) in CORES.iter().zip(reports) {
        println!("{name} in {} precision: {report:?}", core.name);
        let all = (report.hits + report.misses + report.unclear) as f64;
        let share = |count: usize| count as f64 / all;
        assert!(share(report.hits) >= hits, "{report:?}");
        assert!(share(report.misses) >= misses, "{report:?}");
        assert!(share(report.unclear) <= unclear, "{report:?}");
    }
}

fn random_thing(kind: Kind, random: &mut Random) -> Thing {
    let size = random.scale(0.1, 10.0);
    let place = random.near(Vector::ZERO, 3.0 * size);
    Thing::random(kind, place, size, random)
}

fn is_met_where_the_truth_is(kind: Kind) {
    let mut random = Random::new(SEED + kind as u64);
    let mut reports = CORES.map(|_| Report::default());
    for _ in 0..THINGS {
        let thing = random_thing(kind, &mut random);
        let rays: Vec<Line> = (0..RAYS).map(|_| random_ray(&thing, &mut random)).collect();
        hold(&thing, &rays, &mut reports);
    }
    conclude(&format!("{kind:?}"), &reports, 0.25, 0.05, 0.01);
}

/// Rays ever closer to a silhouette, a rim or an edge, from both sides: between a point where
/// the thing is met and one beside it the border is found by halving.
fn rays_at_the_border(thing: &Thing, random: &mut Random) -> Vec<Line> {
    let (center, radius) = thing.ball();
    let away = radius * random.scale(2.0, 20.0);
    let eye = random.near(center, away);
    let (mut on, mut beside) = (target(thing, random), random.near(center, 2.0 * radius));
    let is_met =
        |point: Vector| !matches!(meet(thing, &Line { origin: eye, direction: point - eye }), Truth::Miss);
    if !is_met(on) || is_met(beside) {
        return Vec::new();
    }
    let across = beside - on;
    for _ in 0..22 {
        let middle = (on + beside) * 0.5;
        if is_met(middle) { on = middle } else { beside = middle }
    }
    (0..18)
        .flat_map(|k| {
            let step = across / f64::from(16 << k);
            [towards(eye, on - step, 1.0), towards(eye, beside + step, 1.0)]
        })
        .collect()
}

fn ends_where_the_truth_does(kind: Kind) {
    let mut random = Random::new(SEED + 50 + kind as u64);
    let mut reports = CORES.map(|_| Report::default());
    for _ in 0..THINGS {
        let thing = random_thing(kind, &mut random);
        let rays = rays_at_the_border(&thing, &mut random);
        hold(&thing, &rays, &mut reports);
    }
    if kind != Kind::Plane {
        conclude(&format!("the border of {kind:?}"), &reports, 0.2, 0.2, 0.4);
    }
}

#[test]
fn a_torus_of_any_proportions_is_met_where_the_oracle_says() {
    let mut random = Random::new(SEED + 101);
    let mut reports = CORES.map(|_| Report::default());
    for _ in 0..THINGS {
        let major = random.scale(0.1, 10.0);
        let minor = rounded(major * random.scale(1e-3, 1.0));
        let (center, axis) = (random.near(Vector::ZERO, 3.0), random.direction());
        let torus = Thing::Torus { center, axis, major, minor };
        // At the tube, from up to a hundred sizes away.
        let aim = |random: &mut Random| {
            let middle = random.direction();
            let middle = middle - axis * (middle.dot(axis) / axis.dot(axis));
            let target = random.near(center + middle * (major / length(middle)), 1.2 * minor);
            let away = major * random.scale(0.5, 100.0);
            towards(random.near(center, away), target, 1.0)
        };
        let rays: Vec<Line> = (0..RAYS).map(|_| aim(&mut random)).collect();
        hold(&torus, &rays, &mut reports);
    }
    conclude("a torus of any proportions", &reports, 0.5, 0.02, 0.1);
}

impl Report {
    fn check(
        &mut self,
        core: &Caster,
        thing: &Thing,
        line: &Line,
        truth: &Contact,
        found: &Found,
        about: &dyn Fn() -> String,
    ) {
        // The oracle itself is only so good, and its normals are differences.
        let (u, fine) = (core.roundoff.max(PRECISION), core.roundoff.max(1e-10));
        let size = size(thing, line);
        let conditioning = size / truth.slope;
        let hold = |worst: &mut f64, off: f64, unit: f64, bound: f64| {
            *worst = worst.max(off / unit);
            assert!(off <= bound * unit, "{} off: {}", off / unit, about());
        };

        // How far, in scene lengths.
        let way = found.t * length(line.direction) - truth.way;
        hold(&mut self.way, way.abs(), u * conditioning, MULTIPLE);

        // The normal: of length one, and as promised whichever side is met.
        for normal in [found.normal, found.shading] {
            assert!((normal.dot(normal) - 1.0).abs() <= 1e-6, "{}", about());
        }
        let bent = 1.0 + conditioning / truth.curvature;
        hold(&mut self.normal, length(found.normal - truth.normal), fine * bent, MULTIPLE);

        // The point: on the surface as well as it says, which is no empty promise, and where the way says.
        let promised = found.normal.abs().dot(found.error) + PRECISION * size;
        hold(&mut self.point, distance(thing, found.point).abs(), promised, 1.0);
        let coarse = 64.0 * core.roundoff * (length(found.point) + size);
        assert!(found.error.max_element() <= coarse, "{}", about());
        let moved = length(found.point - truth.point);
        assert!(moved <= 2.0 * MULTIPLE * u * (conditioning + length(found.point)), "{}", about());

        // The normal that shades.
        match shading(thing, truth.point) {
            None => assert_eq!(found.shading, found.normal),
            Some((shading, corner)) => {
                let bent = 1.0 + conditioning / corner;
                // At an edge the shares of a polygon's corners are quotients of small numbers.
                hold(&mut self.shading, length(found.shading - shading), u * bent, 8.0 * MULTIPLE);
            }
        }
    }
}

mod inside {
    use super::*;
    for_every_kind!(is_met_where_the_truth_is, is_met_where_the_oracle_says);
}

mod at_the_border {
    use super::*;
    for_every_kind!(ends_where_the_truth_does, ends_where_the_oracle_says);
}

#[test]
fn both_cores_find_the_same_within_single_precision() {
    let mut random = Random::new(SEED + 100);
    let mut hits = 0;
    for kind in Kind::ALL {
        for _ in 0..22 {
            let thing = Thing::random(kind, Vector::ZERO, 1.0, &mut random);
            let rays: Vec<Line> = (0..100).map(|_| random_ray(&thing, &mut random)).collect();
            let answers = (SINGLE.cast)(&thing, &rays).into_iter().zip((DOUBLE.cast)(&thing, &rays));
            for (line, (single, double)) in rays.iter().zip(answers) {
                let (truth, about) =
                    (meet(&thing, line), || format!("{thing:?}\n{line:?}\n{single:?}\n{double:?}"));
                let Truth::Hit(Contact { slope, .. }) = truth else {
                    assert!(
                        single.is_none() && double.is_none() || matches!(truth, Truth::Unclear),
                        "{}",
                        about()
                    );
                    continue;
                };
                let (Some(single), Some(double)) = (single, double) else { panic!("{}", about()) };
                let bound = MULTIPLE * SINGLE.roundoff * size(&thing, line) / slope;
                assert!((single.t - double.t).abs() * length(line.direction) <= bound, "{}", about());
                hits += 1;
            }
        }
    }
    assert!(hits > 15_000, "{hits}");
}
