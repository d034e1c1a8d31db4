//! Rays in the walls, edges and corners of an accelerator's cells, and scenes that are hard to cut
//! up: every accelerator must find what the list finds, to the last bit.

use super::case::{HardCase, HardCaseTally, Solver};
use super::lattice::{BoxesAndRays, hard_to_cut, lattice, row, uneven};
use crate::SplitMix64;
use crate::test_shape::{TestRay, TestShape};
use crate::textbook::accelerators::{BoxList, NearestHit, TextbookBvh, TextbookGrid, TextbookOctree};

const fn case(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "rays in walls, edges and corners of cells", naive, 0.0, check)
}

const fn odd(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "flat, one, many at one place, far outlier", naive, 0.0, check)
}

const fn off(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "the same where no wall is a whole number", naive, 0.0, check)
}

const fn long(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "to the end of a row 3000 cells long", naive, 0.0, check)
}

pub(super) const CASES: [HardCase; 11] = [
    case("grid", "distances of walls are summed; 0 and -0 step the wrong way", |rng| {
        tried(TestedAccelerator::Grid, lattice, rng)
    }),
    off("grid", "distances of walls are summed; an item is listed on one side", |rng| {
        tried(TestedAccelerator::Grid, uneven, rng)
    }),
    long("grid", "sums of distances drift", |rng| tried(TestedAccelerator::Grid, row, rng)),
    odd("grid", "a cell without thickness, 0 over 0", |rng| tried(TestedAccelerator::Grid, hard_to_cut, rng)),
    case("octree", "the point is moved a little beyond the wall, and rounded back", |rng| {
        tried(TestedAccelerator::Octree, lattice, rng)
    }),
    off("octree", "the point is moved a little beyond the wall, and rounded back", |rng| {
        tried(TestedAccelerator::Octree, uneven, rng)
    }),
    long("octree", "the point is moved a little beyond the wall", |rng| {
        tried(TestedAccelerator::Octree, row, rng)
    }),
    odd("octree", "the point is moved a little beyond the wall", |rng| {
        tried(TestedAccelerator::Octree, hard_to_cut, rng)
    }),
    case("hierarchy", "0 times infinity decides; ties by the order of visits", |rng| {
        tried(TestedAccelerator::Bvh, lattice, rng)
    }),
    off("hierarchy", "0 times infinity decides; a far end comes before the near one", |rng| {
        tried(TestedAccelerator::Bvh, uneven, rng)
    }),
    odd("hierarchy", "0 times infinity decides; ties by the order of visits", |rng| {
        tried(TestedAccelerator::Bvh, hard_to_cut, rng)
    }),
];

/// Which accelerator.
#[derive(Clone, Copy)]
enum TestedAccelerator {
    Grid,
    Octree,
    Bvh,
}

fn tried(
    kind: TestedAccelerator,
    scene: fn(&mut SplitMix64) -> BoxesAndRays,
    rng: &mut SplitMix64,
) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..40 {
        let (shapes, rays) = scene(rng);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let (truth, answers) = match solver {
                Solver::Textbook => (in_single::list(&shapes, &rays), textbook(kind, &shapes, &rays)),
                Solver::Single => {
                    (in_single::list(&shapes, &rays), in_single::accelerated(kind, &shapes, &rays))
                }
                Solver::Double => {
                    (in_double::list(&shapes, &rays), in_double::accelerated(kind, &shapes, &rays))
                }
            };
            tally.rays += rays.len();
            tally.faults += truth.iter().zip(&answers).filter(|(truth, answer)| truth != answer).count();
        }
    }
    tallies
}

/// The textbook's walk; what it comes to is tested by the core.
fn textbook(kind: TestedAccelerator, shapes: &[TestShape], rays: &[TestRay]) -> Vec<Option<NearestHit>> {
    let scene = BoxList::of(shapes);
    match kind {
        TestedAccelerator::Grid => {
            let grid = TextbookGrid::of(&scene);
            rays.iter().map(|ray| grid.nearest(&scene, ray)).collect()
        }
        TestedAccelerator::Octree => {
            let tree = TextbookOctree::of(&scene);
            rays.iter().map(|ray| tree.nearest(&scene, ray)).collect()
        }
        TestedAccelerator::Bvh => {
            let tree = TextbookBvh::of(&scene);
            rays.iter().map(|ray| tree.nearest(&scene, ray)).collect()
        }
    }
}

/// What one of both cores finds.
macro_rules! core {
    ($room:ident, $core:ident, $scene:path) => {
        mod $room {
            use $core::accel::{
                Accelerator, Bvh, BvhNode, BvhSize, Grid, GridSize, LeafEntry, List, Octree, OctreeNode,
                OctreeSize, TraversalStack,
            };
            use $core::geometry::Ray;
            use $core::tally::RayKind;
            use $core::{AllEffects, Real, World, vec3};

            use $scene as TestScene;

            use super::{NearestHit, TestRay, TestShape, TestedAccelerator};
            use crate::cast::TestedCore;

            #[allow(clippy::useless_conversion)] // in the twin
            fn nearest<A: Accelerator>(
                scene: &TestScene,
                accelerator: A,
                rays: &[TestRay],
            ) -> Vec<Option<NearestHit>> {
                let world = World::new(scene.as_scene(), accelerator);
                let mut scratch = A::Scratch::default();
                let nearest = |ray: &TestRay| {
                    let (o, d) = (ray.origin, ray.direction);
                    let core_ray =
                        Ray::new(vec3(o.x as _, o.y as _, o.z as _), vec3(d.x as _, d.y as _, d.z as _));
                    let hit = world.nearest::<AllEffects, _>(
                        &core_ray,
                        Real::MAX,
                        RayKind::Camera,
                        &mut scratch,
                        &mut (),
                    )?;
                    Some(NearestHit { item: hit.item.0, t: hit.t.into() })
                };
                rays.iter().map(nearest).collect()
            }

            pub fn list(shapes: &[TestShape], rays: &[TestRay]) -> Vec<Option<NearestHit>> {
                let scene = TestScene::with_shapes(shapes);
                nearest(&scene, List::without_bounds(scene.item_count()), rays)
            }

            pub fn accelerated(
                kind: TestedAccelerator,
                shapes: &[TestShape],
                rays: &[TestRay],
            ) -> Vec<Option<NearestHit>> {
                let scene = TestScene::with_shapes(shapes);
                let boxes = scene.bounds();
                match kind {
                    TestedAccelerator::Grid => {
                        let room = GridSize::recommended(&boxes);
                        let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.entries]);
                        nearest(&scene, Grid::<8>::build(&boxes, &mut cells, &mut items).unwrap(), rays)
                    }
                    TestedAccelerator::Octree => {
                        let room = OctreeSize::recommended(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![OctreeNode::EMPTY; room.nodes], vec![0; room.entries]);
                        nearest(&scene, Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap(), rays)
                    }
                    TestedAccelerator::Bvh => {
                        let room = BvhSize::recommended(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![BvhNode::EMPTY; room.nodes], vec![LeafEntry::EMPTY; room.entries]);
                        let tree = Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap();
                        nearest(&scene, tree, rays)
                    }
                }
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::TestScene);
core!(in_double, strahl_core_double, crate::double::TestScene);
