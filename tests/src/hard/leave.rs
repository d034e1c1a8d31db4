//! Rays that start on a surface.

use super::{Case, Solver, Tally, ULP, held, length, towards};
use crate::cast::{Core, Found};
use crate::oracle::distance;
use crate::textbook::{self, Form};
use crate::thing::{Kind, Line, Thing, Vector, vector};
use crate::{Random, double, single};

const fn case(name: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    // A step off the surface may be some roundings of coordinates and sizes, and no more.
    Case::own("leaving", name, naive, 64.0, check)
}

const FIXED: &str = "an offset of 1e-4 is too small far away, too large for small things";

pub(super) const CASES: [Case; 8] = [
    case("a sphere", FIXED, |random| again(Kind::Sphere, random)),
    case("a capped cylinder", FIXED, |random| again(Kind::CappedCylinder, random)),
    case("a capped cone", FIXED, |random| again(Kind::CappedCone, random)),
    case("a box", FIXED, |random| again(Kind::Cuboid, random)),
    case("a turned box", FIXED, |random| again(Kind::TurnedCuboid, random)),
    case("a triangle", FIXED, |random| again(Kind::Triangle, random)),
    case("a polygon", FIXED, |random| again(Kind::Polygon, random)),
    case("between two plates, 1e-3 of their size apart", "the offset skips the other plate", plates),
];

/// A direction to the side of `normal`, some of them grazing it.
fn outward(normal: Vector, random: &mut Random) -> Vector {
    let direction = random.direction();
    let height = direction.dot(normal);
    let wanted = if random.below(2) == 0 { height.abs() } else { random.scale(2e-4, 1e-1) };
    held(direction + normal * (wanted.max(2e-4) - height))
}

/// Rays into the outer half space from hits on convex things, of sizes from 1e-4 to 1e4, at
/// places up to 1e4 sizes away: none may meet the thing again, and none may start farther away
/// than rounding asks for.
fn again(kind: Kind, random: &mut Random) -> [Tally; 3] {
    const THINGS: usize = 40;
    const HITS: usize = 25;
    const RAYS: usize = 10;
    let mut tallies = [Tally::default(); 3];
    for _ in 0..THINGS {
        let size = random.scale(1e-4, 1e4);
        let away = if random.below(3) == 0 { 0.0 } else { size * random.scale(1.0, 1e4) };
        let thing = Thing::random(kind, random.direction() * away, size, random);
        let (center, radius) = thing.ball();
        let eyes: Vec<Line> = (0..HITS)
            .map(|_| {
                let eye = held(center + random.direction() * (radius * random.scale(1.2, 10.0)));
                towards(eye, random.near(center, radius))
            })
            .collect();
        let outward: Vec<Vec<u64>> = (0..HITS).map(|_| (0..RAYS).map(|_| random.bits()).collect()).collect();
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            for (from, seeds) in starts(solver, &thing, &eyes).into_iter().zip(&outward) {
                let Some((origin, normal)) = from else { continue };
                let line =
                    |seed: &u64| Line { origin, direction: self::outward(normal, &mut Random::new(*seed)) };
                let lines: Vec<Line> = seeds.iter().map(line).collect();
                let step = distance(&thing, origin).abs() / (ULP * (length(origin) + 2.0 * radius));
                let met = is_met(solver, &thing, &lines);
                tally.rays += lines.len();
                tally.worst = tally.worst.max(step);
                tally.faults += met.into_iter().filter(|met| *met || step > 64.0).count();
            }
        }
    }
    tallies
}

/// Where rays start that leave the thing to the side from which each line comes, and the normal
/// there on that side.
fn starts(solver: Solver, thing: &Thing, lines: &[Line]) -> Vec<Option<(Vector, Vector)>> {
    let things = std::slice::from_ref(thing);
    let facing = |n: Vector, line: &Line| if n.dot(line.direction) > 0.0 { -n } else { n };
    match solver {
        Solver::Textbook => {
            let form = Form::of(thing);
            let start = |line: &Line| {
                let met = form.met(line)?;
                let narrow = |v: Vector| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
                let wide = |v: strahl_core::Vec3| vector(v.x.into(), v.y.into(), v.z.into());
                let normal = facing(wide(met.normal), line);
                let point = narrow(line.origin) + narrow(line.direction) * met.t;
                Some((wide(textbook::leave(point, narrow(normal))), normal))
            };
            lines.iter().map(start).collect()
        }
        Solver::Single => with::<single::Stage>(things, lines),
        Solver::Double => with::<double::Stage>(things, lines),
    }
}

fn with<C: Core>(things: &[Thing], lines: &[Line]) -> Vec<Option<(Vector, Vector)>> {
    let start = |(found, line): (Option<Found>, &Line)| {
        let found = found?;
        let normal = if found.normal.dot(line.direction) > 0.0 { -found.normal } else { found.normal };
        Some((C::leave(&found, normal), normal))
    };
    C::with(things).cast(lines).into_iter().zip(lines).map(start).collect()
}

fn is_met(solver: Solver, thing: &Thing, lines: &[Line]) -> Vec<bool> {
    let things = std::slice::from_ref(thing);
    match solver {
        Solver::Textbook => {
            let form = Form::of(thing);
            lines.iter().map(|line| form.met(line).is_some()).collect()
        }
        Solver::Single => single::Stage::with(things).cast(lines).iter().map(Option::is_some).collect(),
        Solver::Double => double::Stage::with(things).cast(lines).iter().map(Option::is_some).collect(),
    }
}

/// Light between two plates: from the lower one, through the gap, every ray must meet the upper
/// one, at every scale.
fn plates(random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for _ in 0..200 {
        let size = random.scale(1e-6, 1e6);
        let gap = 1e-3 * size;
        let place = random.near(Vector::ZERO, 3.0 * size);
        let plate = |z: f64| Thing::Cuboid {
            min: held(place + vector(-size, -size, z)),
            max: held(place + vector(size, size, z + gap)),
        };
        let (lower, upper) = (plate(-gap), plate(gap));
        let eye = held(place + vector(1.5 * size, 0.0, 0.5 * gap));
        let eyes: Vec<Line> = (0..10)
            .map(|_| {
                towards(eye, place + vector(random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0.0) * size)
            })
            .collect();
        let seeds: Vec<u64> = (0..10).map(|_| random.bits()).collect();
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            for from in starts(solver, &lower, &eyes) {
                let Some((origin, _)) = from else { continue };
                let line = |seed: &u64| {
                    let mut random = Random::new(*seed);
                    let side = vector(random.between(-0.1, 0.1), random.between(-0.1, 0.1), 1.0);
                    Line { origin, direction: held(side) }
                };
                let lines: Vec<Line> = seeds.iter().map(line).collect();
                tally.rays += lines.len();
                let step = distance(&lower, origin).abs() / (ULP * (length(origin) + 2.0 * size));
                tally.worst = tally.worst.max(step);
                tally.faults += is_met(solver, &upper, &lines).into_iter().filter(|met| !*met).count();
            }
        }
    }
    tallies
}
