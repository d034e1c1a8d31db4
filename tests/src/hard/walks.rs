//! Rays in the walls, edges and corners of an accelerator's cells, and scenes that are hard to cut
//! up: every accelerator must find what the list finds, to the last bit.

use super::{Case, Solver, Tally, held};
use crate::Random;
use crate::textbook::walks::{self, Found};
use crate::thing::{Line, Thing, Vector, vector};

const fn case(family: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own(family, "rays in walls, edges and corners of cells", naive, 0.0, check)
}

const fn odd(family: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own(family, "flat, one, many at one place, far outlier", naive, 0.0, check)
}

pub(super) const CASES: [Case; 6] = [
    case("grid", "distances of walls are summed; 0 and -0 step the wrong way", |random| {
        tried(Kind::Grid, lattice, random)
    }),
    odd("grid", "a cell without thickness, 0 over 0", |random| tried(Kind::Grid, hard_to_cut, random)),
    case("octree", "the point is moved a little beyond the wall, and rounded back", |random| {
        tried(Kind::Octree, lattice, random)
    }),
    odd("octree", "the point is moved a little beyond the wall", |random| {
        tried(Kind::Octree, hard_to_cut, random)
    }),
    case("hierarchy", "0 times infinity decides; ties by the order of visits", |random| {
        tried(Kind::Hierarchy, lattice, random)
    }),
    odd("hierarchy", "0 times infinity decides; ties by the order of visits", |random| {
        tried(Kind::Hierarchy, hard_to_cut, random)
    }),
];

/// Which accelerator.
#[derive(Clone, Copy)]
enum Kind {
    Grid,
    Octree,
    Hierarchy,
}

/// Boxes upright on the axes, and rays.
type Scene = (Vec<Thing>, Vec<Line>);

const RAYS: usize = 250;

fn tried(kind: Kind, scene: fn(&mut Random) -> Scene, random: &mut Random) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for _ in 0..40 {
        let (things, lines) = scene(random);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let (truth, answers) = match solver {
                Solver::Textbook => (in_single::list(&things, &lines), textbook(kind, &things, &lines)),
                Solver::Single => {
                    (in_single::list(&things, &lines), in_single::walked(kind, &things, &lines))
                }
                Solver::Double => {
                    (in_double::list(&things, &lines), in_double::walked(kind, &things, &lines))
                }
            };
            tally.rays += lines.len();
            tally.faults += truth.iter().zip(&answers).filter(|(truth, answer)| truth != answer).count();
        }
    }
    tallies
}

/// The textbook's walk; what it comes to is tested by the core.
fn textbook(kind: Kind, things: &[Thing], lines: &[Line]) -> Vec<Option<Found>> {
    let scene = walks::Boxes::of(things);
    match kind {
        Kind::Grid => {
            let grid = walks::Grid::of(&scene);
            lines.iter().map(|line| grid.nearest(&scene, line)).collect()
        }
        Kind::Octree => {
            let tree = walks::Octree::of(&scene);
            lines.iter().map(|line| tree.nearest(&scene, line)).collect()
        }
        Kind::Hierarchy => {
            let tree = walks::Hierarchy::of(&scene);
            lines.iter().map(|line| tree.nearest(&scene, line)).collect()
        }
    }
}

/// What one of both cores finds.
macro_rules! core {
    ($room:ident, $core:ident, $stage:path) => {
        mod $room {
            use $core::{
                Accelerator, Bvh, BvhRoom, Everything, Grid, GridRoom, LastFirst, List, Node, Octree,
                OctreeNode, OctreeRoom, Ray, RayKind, Real, Slot, World, vec3,
            };

            use $stage as Stage;

            use super::{Found, Kind, Line, Thing};
            use crate::cast::Core;

            #[allow(clippy::useless_conversion)] // in the twin
            fn nearest<A: Accelerator>(stage: &Stage, accelerator: A, lines: &[Line]) -> Vec<Option<Found>> {
                let world = World::new(stage.scene(), accelerator);
                let mut scratch = A::Scratch::default();
                let nearest = |line: &Line| {
                    let (o, d) = (line.origin, line.direction);
                    let ray =
                        Ray::new(vec3(o.x as _, o.y as _, o.z as _), vec3(d.x as _, d.y as _, d.z as _));
                    let hit = world.nearest::<Everything, _>(
                        &ray,
                        Real::MAX,
                        RayKind::Camera,
                        &mut scratch,
                        &mut (),
                    )?;
                    Some(Found { item: hit.item.0, t: hit.t.into() })
                };
                lines.iter().map(nearest).collect()
            }

            pub fn list(things: &[Thing], lines: &[Line]) -> Vec<Option<Found>> {
                let stage = Stage::with(things);
                nearest(&stage, List::bare(stage.len()), lines)
            }

            pub fn walked(kind: Kind, things: &[Thing], lines: &[Line]) -> Vec<Option<Found>> {
                let stage = Stage::with(things);
                let boxes = stage.boxes();
                match kind {
                    Kind::Grid => {
                        let room = GridRoom::comfortable(&boxes);
                        let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.items]);
                        nearest(&stage, Grid::<8>::build(&boxes, &mut cells, &mut items).unwrap(), lines)
                    }
                    Kind::Octree => {
                        let room = OctreeRoom::comfortable(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![OctreeNode::EMPTY; room.nodes], vec![0; room.items]);
                        nearest(&stage, Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap(), lines)
                    }
                    Kind::Hierarchy => {
                        let room = BvhRoom::comfortable(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![Node::EMPTY; room.nodes], vec![Slot::EMPTY; room.items]);
                        let tree = Bvh::<LastFirst<64>>::build(&boxes, &mut nodes, &mut items).unwrap();
                        nearest(&stage, tree, lines)
                    }
                }
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::Stage);
core!(in_double, strahl_core_double, crate::double::Stage);

/// Boxes with corners in whole numbers, which is where halves and equal parts of the scene end.
fn lattice(random: &mut Random) -> Scene {
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
fn hard_to_cut(random: &mut Random) -> Scene {
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
