//! Other sizes, rays that are none, and the end of a ray.

use super::case::{Answer, Case, Solver, Tally, answers, towards};
use crate::Random;
use crate::textbook::Form;
use crate::thing::{Kind, Line, Thing};
use crate::vector::{Vector, vector};

pub(super) const CASES: [Case; 3] = [
    Case::own("scale", "every kind, times 2^-30 to 2^30", "thresholds and fourth powers", 0.0, scaled),
    Case::own("bad rays", "NaN, infinite, without direction", "NaN passes every comparison", 0.0, none),
    Case::own(
        "end of a ray",
        "just before a hit, at it, behind it",
        "`t < tmax` leaves out the end",
        0.0,
        ends,
    ),
];

const THINGS: usize = 8;
const RAYS: usize = 40;

/// Things of every kind and rays at them.
fn scenes(random: &mut Random) -> Vec<(Thing, Vec<Line>)> {
    let scene = |kind: &Kind| {
        let place = random.near(Vector::ZERO, 5.0);
        let thing = Thing::random(*kind, place, random.scale(0.1, 3.0), random);
        let line = |random: &mut Random| towards(random.near(place, 12.0), random.near(place, 2.0));
        (thing, (0..RAYS).map(|_| line(random)).collect())
    };
    Kind::ALL.iter().cycle().take(THINGS * Kind::ALL.len()).map(scene).collect()
}

/// The distance grows with the scene, and the normal does not change, bit for bit.
fn scaled(random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for (thing, lines) in scenes(random) {
        let exponent = random.below(61) as i32 - 30;
        let scale = libm::scalbn(1.0, exponent);
        let other = thing.mapped(|p| p * scale, |d| d, scale);
        let rays: Vec<Line> =
            lines.iter().map(|line| Line { origin: line.origin * scale, ..*line }).collect();
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let truth = answers(solver, &thing, &lines);
            for (truth, answer) in truth.into_iter().zip(answers(solver, &other, &rays)) {
                let grown = truth.map(|truth| (truth.t * scale, truth.normal));
                tally.rays += 1;
                tally.faults += usize::from(answer.map(|Answer { t, normal }| (t, normal)) != grown);
            }
        }
    }
    tallies
}

/// A ray that is none meets nothing.
fn none(random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for (thing, mut lines) in scenes(random) {
        for line in &mut lines {
            let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][random.below(3) as usize];
            let axis = random.below(3) as usize;
            match random.below(3) {
                0 => line.origin[axis] = bad,
                1 => line.direction[axis] = bad,
                _ => line.direction = vector(0.0, -0.0, 0.0),
            }
        }
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            tally.rays += lines.len();
            tally.faults += answers(solver, &thing, &lines).iter().flatten().count();
        }
    }
    tallies
}

/// A hit is met by a ray that ends there or behind it, and by none that ends before it.
fn ends(random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for (thing, lines) in scenes(random) {
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let answers = match solver {
                Solver::Textbook => in_textbook(&thing, &lines),
                Solver::Single => in_single::ends(&thing, &lines),
                Solver::Double => in_double::ends(&thing, &lines),
            };
            tally.rays += 3 * answers.len();
            tally.faults += answers.iter().flatten().filter(|is_right| !**is_right).count();
        }
    }
    tallies
}

/// Whether it is right of each ray that meets the thing, when it ends just before, at, and behind.
fn in_textbook(thing: &Thing, lines: &[Line]) -> Vec<[bool; 3]> {
    let form = Form::of(thing);
    let ends = |line: &Line| {
        let t = form.met(line)?.t;
        let is_met = |reach: f32| form.met(line).is_some_and(|met| met.t < reach);
        Some([!is_met(t.next_down()), is_met(t), is_met(t.next_up())])
    };
    lines.iter().filter_map(ends).collect()
}

macro_rules! core {
    ($room:ident, $core:ident, $stage:path) => {
        mod $room {
            use $core::accel::List;
            use $core::geometry::Ray;
            use $core::tally::RayKind;
            use $core::{AllEffects, Real, World, vec3};

            use $stage as Stage;

            use super::{Line, Thing};
            use crate::cast::Core;

            pub fn ends(thing: &Thing, lines: &[Line]) -> Vec<[bool; 3]> {
                let stage = Stage::with(std::slice::from_ref(thing));
                let world = World::new(stage.scene(), List::without_bounds(stage.item_count()));
                let ends = |line: &Line| {
                    let (o, d) = (line.origin, line.direction);
                    let ray =
                        Ray::new(vec3(o.x as _, o.y as _, o.z as _), vec3(d.x as _, d.y as _, d.z as _));
                    let nearest = |reach: Real| {
                        world.nearest::<AllEffects, _>(&ray, reach, RayKind::Camera, &mut (), &mut ())
                    };
                    let is_met = |reach: Real| {
                        let blocker =
                            world.blocker::<AllEffects, _>(&ray, reach, RayKind::Shadow, &mut (), &mut ());
                        assert_eq!(nearest(reach).is_some(), blocker.is_some());
                        blocker.is_some()
                    };
                    let t = nearest(Real::INFINITY)?.t;
                    Some([!is_met(t.next_down()), is_met(t), is_met(t.next_up())])
                };
                lines.iter().filter_map(ends).collect()
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::Stage);
core!(in_double, strahl_core_double, crate::double::Stage);
