//! Every accelerator agrees with the list on every hard ray, bit for bit.

use strahl_core::accel::{
    Accelerator, Bvh, BvhEntry, BvhNode, BvhSize, Grid, GridSize, List, Octree, OctreeNode, OctreeSize,
    TraversalHeap, TraversalStack,
};
use strahl_core::geometry::{Hit, Ray};
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Real, Vec3, World, vec3};
use strahl_test_scene::{DVec3, TestRay, TestScene, TestShape};
use strahl_tests::hard::{HardCase, cases};

/// The nearest hit of each ray, and whether it is occluded up to just before the hit, and up to it.
fn answers<A: Accelerator>(scene: &TestScene, accelerator: A, rays: &[Ray]) -> Vec<(Option<Hit>, [bool; 2])> {
    let world = World::new(scene.as_scene(), accelerator);
    let mut scratch = A::Scratch::default();
    let answer = |ray: &Ray| {
        let hit = world.nearest_hit::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut scratch, &mut ());
        let t = hit.map_or(1.0, |hit| hit.t);
        let mut is_occluded = |t_max| {
            world.occluder::<AllEffects, _>(ray, t_max, RayKind::Shadow, &mut scratch, &mut ()).is_some()
        };
        (hit, [is_occluded(t.next_down()), is_occluded(t)])
    };
    rays.iter().map(answer).collect()
}

fn core_ray(ray: &TestRay) -> Ray {
    let narrow = |v: DVec3| -> Vec3 { vec3(v.x as f32, v.y as f32, v.z as f32) };
    Ray::new(narrow(ray.origin), narrow(ray.direction))
}

/// Compares the accelerators in one scene of all given shapes, however different in size and position.
/// Returns the number of hits.
fn check(case: &str, aims: &[(TestShape, Vec<TestRay>)]) -> usize {
    let mut scene = TestScene::new();
    aims.iter().for_each(|(shape, _)| _ = scene.add_shape(shape));
    let rays: Vec<Ray> = aims.iter().flat_map(|(_, rays)| rays).map(core_ray).collect();
    let boxes = scene.bounds();
    let expected = answers(&scene, List::without_bounds(scene.item_count()), &rays);
    let assert_agrees = |name: &str, got: Vec<_>| {
        for ((ray, expected), got) in rays.iter().zip(&expected).zip(&got) {
            assert_eq!(got, expected, "{name}; {case}: {ray:?}");
        }
    };

    let size = BvhSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![BvhNode::EMPTY; size.nodes], vec![BvhEntry::EMPTY; size.entries]);
    let tree = Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap();
    assert_agrees("BVH, stack", answers(&scene, tree, &rays));
    assert_agrees("BVH, heap", answers(&scene, tree.with_queue::<TraversalHeap<64>>(), &rays));
    assert_agrees("BVH, stack of none", answers(&scene, tree.with_queue::<TraversalStack<0>>(), &rays));
    let size = GridSize::recommended(&boxes);
    let (mut cells, mut items) = (vec![0; size.cells], vec![0; size.entries]);
    assert_agrees("grid", answers(&scene, Grid::<8>::build(&boxes, &mut cells, &mut items).unwrap(), &rays));
    let size = OctreeSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; size.nodes], vec![0; size.entries]);
    assert_agrees(
        "octree",
        answers(&scene, Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap(), &rays),
    );
    expected.iter().filter(|(hit, _)| hit.is_some()).count()
}

#[test]
fn every_accelerator_agrees_with_the_list_on_every_hard_ray() {
    let check_case = |case: HardCase| -> usize {
        let name = format!("{}, {}", case.family, case.name);
        case.all_aims().chunks(12).map(|aims| check(&name, aims)).sum()
    };
    // In two threads.
    let half = |odd: usize| cases().into_iter().skip(odd).step_by(2).map(check_case).sum::<usize>();
    let hits = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        half(0) + other.join().unwrap()
    });
    assert!(hits > 200_000, "{hits}");
}
