//! Rays that start on a surface.

use super::case::{Case, Solver, Tally, ULP, answers, held, length, towards};
use crate::cast::{Core, Found};
use crate::oracle::distance;
use crate::textbook::{self, Form};
use crate::thing::{Kind, Line, Thing};
use crate::vector::{Vector, vector};
use crate::{Random, double, single};

const fn case(name: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own("leaving", name, naive, BOUND, check)
}

/// A step off the surface may be some roundings of coordinates and sizes, and no more.
const BOUND: f64 = 64.0;

const FIXED: &str = "an offset of 1e-4 is too small far away, too large for small things";

pub(super) const CASES: [Case; 15] = [
    case("a sphere", FIXED, |random| again(Kind::Sphere, random)),
    case("an open cylinder", FIXED, |random| again(Kind::OpenCylinder, random)),
    case("a capped cylinder", FIXED, |random| again(Kind::CappedCylinder, random)),
    case("an open cone", FIXED, |random| again(Kind::OpenCone, random)),
    case("a capped cone", FIXED, |random| again(Kind::CappedCone, random)),
    case("a torus", FIXED, |random| again(Kind::Torus, random)),
    case("a box", FIXED, |random| again(Kind::Cuboid, random)),
    case("a turned box", FIXED, |random| again(Kind::OrientedCuboid, random)),
    case("a plane", FIXED, |random| again(Kind::Plane, random)),
    case("a disc", FIXED, |random| again(Kind::Disc, random)),
    case("a triangle", FIXED, |random| again(Kind::Triangle, random)),
    case("a smooth triangle", FIXED, |random| again(Kind::SmoothTriangle, random)),
    case("a polygon", FIXED, |random| again(Kind::Polygon, random)),
    case("a smooth polygon", FIXED, |random| again(Kind::SmoothPolygon, random)),
    case("between two plates, 1e-3 of their size apart", "the offset skips the other plate", plates),
];

/// A direction to the side of `normal`, some of them grazing it.
fn outward(normal: Vector, random: &mut Random) -> Vector {
    let direction = random.direction();
    let height = direction.dot(normal);
    let wanted = if random.below(2) == 0 { height.abs() } else { random.scale(2e-4, 1e-1) };
    held(direction + normal * (wanted.max(2e-4) - height))
}

const THINGS: usize = 40;

/// A thing, rays that see it, and for each of them the seeds of directions in which rays leave.
struct Seen {
    thing: Thing,
    radius: f64,
    eyes: Vec<Line>,
    seeds: Vec<Vec<u64>>,
}

fn seen(kind: Kind, random: &mut Random) -> Seen {
    const HITS: usize = 25;
    const RAYS: usize = 10;
    let size = random.scale(1e-4, 1e4);
    let away = if random.below(3) == 0 { 0.0 } else { size * random.scale(1.0, 1e4) };
    let thing = Thing::random(kind, random.direction() * away, size, random);
    let (center, radius) = thing.ball();
    let radius = if kind == Kind::Plane { size } else { radius };
    let eyes = (0..HITS)
        .map(|_| {
            let eye = held(center + random.direction() * (radius * random.scale(1.2, 10.0)));
            towards(eye, random.near(center, radius))
        })
        .collect();
    let seeds = (0..HITS).map(|_| (0..RAYS).map(|_| random.bits()).collect()).collect();
    Seen { thing, radius, eyes, seeds }
}

/// Rays to the side from which hits are seen, of things of sizes from 1e-4 to 1e4, at places up to
/// 1e4 sizes away: none may meet the thing again where it starts, and none may start farther away
/// than rounding asks for.
fn again(kind: Kind, random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for _ in 0..THINGS {
        let Seen { thing, radius, eyes, seeds } = seen(kind, random);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let starts = starts(solver, &thing, &eyes);
            let met = |lines: &[Line]| met(solver, &thing, lines);
            left(&thing, radius, &starts, &seeds, met, tally);
        }
    }
    tallies
}

/// Counts the rays that leave a thing from `starts`, each with the normal there, in directions that
/// `seeds` say.
fn left(
    thing: &Thing,
    radius: f64,
    starts: &[Option<(Vector, Vector)>],
    seeds: &[Vec<u64>],
    met: impl Fn(&[Line]) -> Vec<Option<f64>>,
    tally: &mut Tally,
) {
    for (from, seeds) in starts.iter().zip(seeds) {
        let Some((origin, normal)) = *from else { continue };
        let line = |seed: &u64| Line { origin, direction: outward(normal, &mut Random::new(*seed)) };
        let lines: Vec<Line> = seeds.iter().map(line).collect();
        let step = distance(thing, origin).abs() / (ULP * (length(origin) + 2.0 * radius));
        tally.worst = tally.worst.max(step);
        for (line, met) in lines.iter().zip(met(&lines)) {
            let is_right = met.is_none_or(|t| t >= least(thing, origin, line.direction, normal));
            tally.rays += 1;
            tally.faults += usize::from(!is_right || step > BOUND);
        }
    }
}

/// How near a ray may meet a thing again that it leaves at `p` along `direction`, the normal there
/// being `normal`. What is flat or convex it does not meet again. A hollow of the radius of
/// curvature `r` it meets not before `2 r` times the cosine to the normal; half of that will do.
fn least(thing: &Thing, p: Vector, direction: Vector, normal: Vector) -> f64 {
    let hollow = |radius: f64| radius * direction.dot(normal) / direction.dot(direction);
    match thing {
        Thing::Cone { base, end, capped: false, .. } => {
            let (q, axis) = (p - *base, (*end - *base) / length(*end - *base));
            let out = q - axis * q.dot(axis);
            if out.dot(normal) > 0.0 { f64::INFINITY } else { hollow(length(out)) }
        }
        Thing::Torus { center, axis, major, minor } => {
            let (q, axis) = (p - *center, *axis / length(*axis));
            let out = length(q - axis * q.dot(axis));
            // The outer half of the tube is convex.
            if out > *major { f64::INFINITY } else { hollow(major - minor) }
        }
        _ => f64::INFINITY,
    }
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

/// How far away the rays meet the thing.
fn met(solver: Solver, thing: &Thing, lines: &[Line]) -> Vec<Option<f64>> {
    answers(solver, thing, lines).into_iter().map(|answer| answer.map(|answer| answer.t)).collect()
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
                tally.faults += met(solver, &upper, &lines).into_iter().filter(Option::is_none).count();
            }
        }
    }
    tallies
}
