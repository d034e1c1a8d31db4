//! Rays in the planes, edges and corners of an accelerator's cells, and degenerate scenes: every accelerator
//! must find what the list finds, bit for bit.

use super::box_scenes::{BoxesAndRays, at_integers, degenerate, long_row, scaled_and_moved};
use super::case::{HardCase, HardCaseTally, Solver};
use crate::textbook::accelerators::{BoxList, NearestHit, TextbookBvh, TextbookGrid, TextbookOctree};
use strahl_test_scene::{SplitMix64, TestRay, TestShape};

const fn case(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "rays in planes, edges and corners of cells", naive, 0.0, check)
}

const fn odd(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "flat, single, many coincident, far outlier", naive, 0.0, check)
}

const fn off(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "the same without integer cell planes", naive, 0.0, check)
}

const fn long(
    family: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own(family, "to the end of a row 3000 cells long", naive, 0.0, check)
}

pub(super) const CASES: [HardCase; 11] = [
    case("grid", "distances of planes are accumulated; 0 and -0 step the wrong way", |rng| {
        evaluated(TestedAccelerator::Grid, at_integers, rng)
    })
    .seed(0xee96_d26c_5c62_6795),
    off("grid", "distances of planes are accumulated; an item is listed on one side", |rng| {
        evaluated(TestedAccelerator::Grid, scaled_and_moved, rng)
    })
    .seed(0x2f17_f986_44b8_65a5),
    long("grid", "accumulated distances drift", |rng| evaluated(TestedAccelerator::Grid, long_row, rng)),
    odd("grid", "a cell without thickness, 0 over 0", |rng| {
        evaluated(TestedAccelerator::Grid, degenerate, rng)
    })
    .seed(0x4ec4_b6d3_4f08_0aa6),
    case("octree", "the point is moved slightly beyond the plane, and rounded back", |rng| {
        evaluated(TestedAccelerator::Octree, at_integers, rng)
    })
    .seed(0xe70e_d57b_666b_e28b),
    off("octree", "the point is moved slightly beyond the plane, and rounded back", |rng| {
        evaluated(TestedAccelerator::Octree, scaled_and_moved, rng)
    })
    .seed(0x06e3_af33_005a_bb57),
    long("octree", "the point is moved slightly beyond the plane", |rng| {
        evaluated(TestedAccelerator::Octree, long_row, rng)
    }),
    odd("octree", "the point is moved slightly beyond the plane", |rng| {
        evaluated(TestedAccelerator::Octree, degenerate, rng)
    })
    .seed(0x04f7_c5ef_0d44_57a8),
    case("BVH", "0 times infinity decides; ties by the order of visits", |rng| {
        evaluated(TestedAccelerator::Bvh, at_integers, rng)
    })
    .seed(0xa922_f628_cf88_8452),
    off("BVH", "0 times infinity decides; a far end comes before the near one", |rng| {
        evaluated(TestedAccelerator::Bvh, scaled_and_moved, rng)
    })
    .seed(0x403f_01e6_e2b8_c52c),
    odd("BVH", "0 times infinity decides; ties by the order of visits", |rng| {
        evaluated(TestedAccelerator::Bvh, degenerate, rng)
    })
    .seed(0x60d8_e101_3ff7_d7ed),
];

/// Accelerator under test.
#[derive(Clone, Copy)]
enum TestedAccelerator {
    Grid,
    Octree,
    Bvh,
}

fn evaluated(
    kind: TestedAccelerator,
    scene: fn(&mut SplitMix64) -> BoxesAndRays,
    rng: &mut SplitMix64,
) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..40 {
        let (shapes, rays) = scene(rng);
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            let (expected, answers) = match solver {
                Solver::Textbook => (in_single::list(&shapes, &rays), textbook(kind, &shapes, &rays)),
                Solver::Single => {
                    (in_single::list(&shapes, &rays), in_single::accelerated(kind, &shapes, &rays))
                }
                Solver::Double => {
                    (in_double::list(&shapes, &rays), in_double::accelerated(kind, &shapes, &rays))
                }
            };
            tally.rays += rays.len();
            tally.faults +=
                expected.iter().zip(&answers).filter(|(expected, answer)| expected != answer).count();
        }
    }
    tallies
}

/// The textbook's traversal; the boxes are intersected by the core.
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

/// The hits of one core.
macro_rules! core {
    ($module:ident, $core:ident, $scene:path) => {
        mod $module {
            use $core::accel::{
                Accelerator, Bvh, BvhEntry, BvhNode, BvhSize, Grid, GridSize, List, Octree, OctreeNode,
                OctreeSize, TraversalStack,
            };
            use $core::geometry::Ray;
            use $core::tally::RayKind;
            use $core::{AllEffects, Real, World, vec3};

            use $scene as TestScene;

            use super::{NearestHit, TestRay, TestShape, TestedAccelerator};
            use strahl_test_scene::TestedCore;

            #[allow(clippy::useless_conversion)] // where `Real` is f64
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
                    let hit = world.nearest_hit::<AllEffects, _>(
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
                        let size = GridSize::recommended(&boxes);
                        let (mut cells, mut items) = (vec![0; size.cells], vec![0; size.entries]);
                        nearest(&scene, Grid::<8>::build(&boxes, &mut cells, &mut items).unwrap(), rays)
                    }
                    TestedAccelerator::Octree => {
                        let size = OctreeSize::recommended(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![OctreeNode::EMPTY; size.nodes], vec![0; size.entries]);
                        nearest(&scene, Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap(), rays)
                    }
                    TestedAccelerator::Bvh => {
                        let size = BvhSize::recommended(boxes.len());
                        let (mut nodes, mut items) =
                            (vec![BvhNode::EMPTY; size.nodes], vec![BvhEntry::EMPTY; size.entries]);
                        let tree = Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap();
                        nearest(&scene, tree, rays)
                    }
                }
            }
        }
    };
}

core!(in_single, strahl_core, strahl_test_scene::TestScene);
core!(in_double, strahl_core_double, strahl_test_scene_double::TestScene);
