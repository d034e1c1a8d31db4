//! The line between light and shadow on coarse smooth balls: a point whose shading normal faces the
//! light must not stand in the shadow of its own ball, and in that of something else it must.

use super::case::{Case, Solver, Tally, aside, held, length, towards};
use super::mesh::Mesh;
use crate::cast::{Core, Found};
use crate::textbook;
use crate::thing::{Line, Thing};
use crate::vector::{Vector, vector};
use crate::{Random, single};

const fn case(name: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own("shadow terminator", name, naive, 0.0, check)
}

pub(super) const CASES: [Case; 2] = [
    case("smooth balls of 20 to 320 triangles", "whole triangles lie in their own shadow", |random| {
        tried(false, random)
    }),
    case("the same with a plate before the light", "a plate that is skipped casts no shadow", |random| {
        tried(true, random)
    })
    .easy(),
];

/// A smooth ball of triangles, with a plate towards the light or without.
fn ball(level: u32, center: Vector, radius: f64, plate: Option<Vector>) -> Vec<Thing> {
    let mesh = Mesh::icosphere(level, center, radius);
    let corners = |triangle: &[u32; 3]| triangle.map(|corner| mesh.points[corner as usize]);
    let smooth = |corners: [Vector; 3]| Thing::SmoothTriangle {
        corners,
        normals: corners.map(|corner| held((corner - center) / length(corner - center))),
    };
    let mut things: Vec<Thing> = mesh.triangles.iter().map(corners).map(smooth).collect();
    if let Some(light) = plate {
        things.push(Thing::Disc {
            center: held(center + light * (1.6 * radius)),
            normal: light,
            radius: 3.0 * radius,
        });
    }
    things
}

/// Rays at a ball from the side, so that the line between light and shadow is seen, and not through
/// the plate.
fn eyes(center: Vector, radius: f64, light: Vector, random: &mut Random) -> Vec<Line> {
    let ray = |_| {
        let side = aside(light, random) - light * random.between(-0.4, 0.6);
        let eye = held(center + side * (radius * random.between(2.0, 9.0)));
        towards(eye, random.near(center, radius))
    };
    (0..110).map(ray).collect()
}

fn tried(with_plate: bool, random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for round in 0..24 {
        let radius = random.scale(1e-3, 1e3);
        let center = random.near(Vector::ZERO, 10.0 * radius);
        let light = random.direction();
        let things = ball(round % 3, center, radius, with_plate.then_some(light));
        let eyes = eyes(center, radius, light, random);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let (shown, lit) = match solver {
                Solver::Textbook => in_textbook(&things, &eyes, light),
                Solver::Single => in_single::lit(&things, &eyes, light),
                Solver::Double => in_double::lit(&things, &eyes, light),
            };
            for ((found, eye), lit) in shown.iter().zip(&eyes).zip(lit) {
                let is_plate = |item: u32| matches!(things[item as usize], Thing::Disc { .. });
                let Some(found) = found.filter(|found| !is_plate(found.item)) else { continue };
                let facing = |n: Vector| if found.normal.dot(eye.direction) > 0.0 { -n } else { n };
                // What shows least of the light is left to rounding.
                if facing(found.shading).dot(light) <= 1e-3 {
                    continue;
                }
                tally.rays += 1;
                tally.faults += usize::from(lit == with_plate);
            }
        }
    }
    tallies
}

/// What the core sees, lit where nothing is in the way of a ray from a little above it.
fn in_textbook(things: &[Thing], eyes: &[Line], light: Vector) -> (Vec<Option<Found>>, Vec<bool>) {
    let stage = single::Stage::with(things);
    let found = stage.cast(eyes);
    let narrow = |v: Vector| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let shadow = |(found, eye): (&Option<Found>, &Line)| {
        let found = found.as_ref()?;
        let side = if found.normal.dot(eye.direction) > 0.0 { -found.normal } else { found.normal };
        let from = textbook::leave(narrow(found.point), narrow(side));
        Some(Line { origin: vector(from.x.into(), from.y.into(), from.z.into()), direction: light })
    };
    let lit = found.iter().zip(eyes).map(shadow);
    let lit = lit.map(|line| line.is_some_and(|line| stage.cast(&[line])[0].is_none())).collect();
    (found, lit)
}

/// What one of both cores sees, and whether its tracer shows it lit.
macro_rules! core {
    ($room:ident, $core:ident, $stage:path) => {
        mod $room {
            use $core::math::try_normalize;
            use $core::{Light, Limits, Rgb, Source, vec3};

            use $stage as Stage;

            use super::{Core, Found, Line, Thing, Vector};

            pub fn lit(things: &[Thing], eyes: &[Line], light: Vector) -> (Vec<Option<Found>>, Vec<bool>) {
                let narrow = |v: Vector| vec3(v.x as _, v.y as _, v.z as _);
                let mut stage = Stage::with(things);
                let found = stage.cast(eyes);
                let toward = try_normalize(narrow(light)).unwrap();
                let source = Source::Directional { toward };
                stage.lights.push(Light { source, color: Rgb::WHITE, shadows: true });
                let look = |eye: &Line| {
                    let limits = Limits { levels: 1, cutoff: 0.0 };
                    !stage.look(narrow(eye.origin), narrow(eye.origin + eye.direction), limits).is_black()
                };
                let lit = eyes.iter().map(look).collect();
                (found, lit)
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::Stage);
core!(in_double, strahl_core_double, crate::double::Stage);
