//! Boxes and rays that are hard for whoever cuts space into cells.

use super::case::{held, towards};
use crate::Random;
use crate::thing::{Line, Thing};
use crate::vector::{Vector, vector};

/// Boxes upright on the axes, and rays.
pub(super) type Scene = (Vec<Thing>, Vec<Line>);

const RAYS: usize = 250;

/// Boxes with corners in whole numbers, which is where halves and equal parts of the scene end.
pub(super) fn lattice(random: &mut Random) -> Scene {
    const SIDE: u32 = 8;
    let cube = |low: Vector, size: Vector| Thing::Cuboid { min: low, max: low + size };
    // Two in opposite corners, so that the scene is as large as it should be.
    let mut things = vec![cube(Vector::ZERO, Vector::ONE), cube(Vector::splat(7.0), Vector::ONE)];
    for _ in 0..60 {
        let mut place = || f64::from(random.below(SIDE));
        let low = vector(place(), place(), place());
        let mut size = || f64::from(random.below(3)) * 0.5;
        let size = vector(size(), size(), size());
        things.push(cube(low, size));
    }
    let lines = (0..RAYS).map(|_| wall_ray(f64::from(SIDE), random)).collect();
    (things, lines)
}

/// A ray through places where walls meet: in a wall, along an edge, through corners, from one of
/// them, or any.
fn wall_ray(side: f64, random: &mut Random) -> Line {
    let whole = |random: &mut Random| f64::from(random.below(2 * side as u32 + 1)) * 0.5;
    let any = |random: &mut Random| random.between(-0.5 * side, 1.5 * side);
    let sign = |random: &mut Random| if random.below(2) == 0 { 1.0 } else { -1.0 };
    let corner = vector(whole(random), whole(random), whole(random));
    let way = vector(sign(random), sign(random), sign(random));
    match random.below(5) {
        // Through corners of cells: all walls at once.
        0 => Line { origin: corner - way * 20.0, direction: way * random.scale(0.25, 4.0) },
        // From a corner, an edge or a wall.
        1 => {
            let mut origin = corner;
            for _ in 0..random.below(3) {
                origin[random.below(3) as usize] = any(random);
            }
            Line { origin, direction: held(random.direction()) }
        }
        // In a wall or along an edge.
        2 | 3 => {
            let (mut origin, mut direction) = (corner - way * 20.0, held(random.direction()));
            for axis in 0..3 {
                if random.below(2) == 0 {
                    origin[axis] = corner[axis];
                    direction[axis] = if random.below(2) == 0 { 0.0 } else { -0.0 };
                }
            }
            if direction == Vector::ZERO {
                direction = Vector::X;
            }
            Line { origin, direction }
        }
        _ => {
            let (from, to) = (
                vector(any(random), any(random), any(random)),
                vector(any(random), any(random), any(random)),
            );
            Line { origin: from, direction: held(to - from) }
        }
    }
}

/// A scene without thickness, of one thing, of many at one place, or with one far away.
pub(super) fn hard_to_cut(random: &mut Random) -> Scene {
    let (things, lines) = lattice(random);
    let bounds = |thing: &Thing| match thing {
        Thing::Cuboid { min, max } => (*min, *max),
        _ => (Vector::ZERO, Vector::ZERO),
    };
    let pieces = things.iter().map(bounds);
    let things = match random.below(4) {
        0 => {
            let axis = random.below(3) as usize;
            let level = |v: Vector| {
                let mut v = v;
                v[axis] = 3.0;
                v
            };
            pieces.map(|(min, max)| Thing::Cuboid { min: level(min), max: level(max) }).collect()
        }
        1 => vec![things[2 + random.below(60) as usize].clone()],
        2 => {
            let (min, _) = bounds(&things[2 + random.below(60) as usize]);
            (0..100).map(|_| Thing::Cuboid { min, max: min + Vector::splat(1.5) }).collect()
        }
        _ => {
            let far = held(random.direction() * random.scale(1e3, 1e6));
            let mut things: Vec<Thing> = pieces.map(|(min, max)| Thing::Cuboid { min, max }).collect();
            things.push(Thing::Cuboid { min: far, max: held(far + Vector::ONE) });
            things
        }
    };
    (things, lines)
}

/// The same as [`lattice`] where no face and no wall is a whole number, so that all that should
/// be equal is a little off.
pub(super) fn uneven(random: &mut Random) -> Scene {
    let (things, lines) = lattice(random);
    let (size, shift) = (random.scale(0.01, 100.0), random.near(Vector::ZERO, 10.0));
    let place = |v: Vector| held((v + shift) * size);
    let thing = |thing: Thing| match thing {
        Thing::Cuboid { min, max } => Thing::Cuboid { min: place(min), max: place(max) },
        other => other,
    };
    let line = |line: Line| Line { origin: place(line.origin), ..line };
    (things.into_iter().map(thing).collect(), lines.into_iter().map(line).collect())
}

/// Long bars, and small plates across their lower faces: a ray comes to a plate after hundreds of
/// cells, and to the bar, which it has been told of long before, right behind it.
pub(super) fn row(random: &mut Random) -> Scene {
    const LENGTH: f64 = 3000.0;
    let (mut things, mut lines) = (Vec::new(), Vec::new());
    for _ in 0..5 {
        let (level, aside) = (random.between(0.3, 0.9), random.between(0.1, 0.9));
        let (y, z) = (Vector::Y * level, Vector::Z * aside);
        let (min, max) = (y + z - Vector::Z * 0.05, y + z + vector(LENGTH, 0.05, 0.05));
        things.push(Thing::Cuboid { min: held(min), max: held(max) });
        for _ in 0..RAYS / 5 {
            let at = random.between(10.0, LENGTH);
            let (place, half) = (Vector::X * at + y + z, vector(0.0, 0.003, 0.003));
            things.push(Thing::Cuboid { min: held(place - half), max: held(place + half) });
            let eye = vector(-random.between(1.0, 10.0), level - 0.2, random.between(0.0, 1.0));
            lines.push(towards(held(eye), held(place + Vector::X * random.scale(1e-3, 0.3))));
        }
    }
    (things, lines)
}
