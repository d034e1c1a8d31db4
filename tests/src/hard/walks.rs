//! Rays in the walls, edges and corners of an accelerator's cells, and scenes that are hard to cut
//! up: every accelerator must find what the list finds, to the last bit.

use super::case::{Case, Solver, Tally};
use super::lattice::{Scene, hard_to_cut, lattice, row, uneven};
use crate::Random;
use crate::textbook::walks::{self, Found};
use crate::thing::{Line, Thing};

const fn case(family: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own(family, "rays in walls, edges and corners of cells", naive, 0.0, check)
}

const fn odd(family: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own(family, "flat, one, many at one place, far outlier", naive, 0.0, check)
}

const fn off(family: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own(family, "the same where no wall is a whole number", naive, 0.0, check)
}

const fn long(family: &'static str, naive: &'static str, check: fn(&mut Random) -> [Tally; 3]) -> Case {
    Case::own(family, "to the end of a row 3000 cells long", naive, 0.0, check)
}

pub(super) const CASES: [Case; 11] = [
    case("grid", "distances of walls are summed; 0 and -0 step the wrong way", |random| {
        tried(Kind::Grid, lattice, random)
    }),
    off("grid", "distances of walls are summed; an item is listed on one side", |random| {
        tried(Kind::Grid, uneven, random)
    }),
    long("grid", "sums of distances drift", |random| tried(Kind::Grid, row, random)),
    odd("grid", "a cell without thickness, 0 over 0", |random| tried(Kind::Grid, hard_to_cut, random)),
    case("octree", "the point is moved a little beyond the wall, and rounded back", |random| {
        tried(Kind::Octree, lattice, random)
    }),
    off("octree", "the point is moved a little beyond the wall, and rounded back", |random| {
        tried(Kind::Octree, uneven, random)
    }),
    long("octree", "the point is moved a little beyond the wall", |random| tried(Kind::Octree, row, random)),
    odd("octree", "the point is moved a little beyond the wall", |random| {
        tried(Kind::Octree, hard_to_cut, random)
    }),
    case("hierarchy", "0 times infinity decides; ties by the order of visits", |random| {
        tried(Kind::Hierarchy, lattice, random)
    }),
    off("hierarchy", "0 times infinity decides; a far end comes before the near one", |random| {
        tried(Kind::Hierarchy, uneven, random)
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
            use $core::accel::{
                Accelerator, Bvh, BvhNode, BvhSize, Grid, GridSize, LeafEntry, List, Octree, OctreeNode,
                OctreeSize, TraversalStack,
            };
            use $core::geometry::Ray;
            use $core::tally::RayKind;
            use $core::{AllEffects, Real, World, vec3};

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
                    let hit = world.nearest::<AllEffects, _>(
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
                nearest(&stage, List::without_bounds(stage.item_count()), lines)
            }

            pub fn walked(kind: Kind, things: &[Thing], lines: &[Line]) -> Vec<Option<Found>> {
                let stage = Stage::with(things);
                let boxes = stage.bounds();
                match kind {
                    Kind::Grid => {
                        let room = GridSize::recommended(&boxes);
                        let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.entries]);
                        nearest(&stage, Grid::<8>::build(&boxes, &mut cells, &mut items).unwrap(), lines)
                    }
                    Kind::Octree => {
                        let room = OctreeSize::recommended(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![OctreeNode::EMPTY; room.nodes], vec![0; room.entries]);
                        nearest(&stage, Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap(), lines)
                    }
                    Kind::Hierarchy => {
                        let room = BvhSize::recommended(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![BvhNode::EMPTY; room.nodes], vec![LeafEntry::EMPTY; room.entries]);
                        let tree = Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap();
                        nearest(&stage, tree, lines)
                    }
                }
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::Stage);
core!(in_double, strahl_core_double, crate::double::Stage);
