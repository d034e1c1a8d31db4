//! Every accelerator answers every hard ray like the list, to the last bit.

use strahl_core::accel::{
    Accelerator, Bvh, BvhNode, BvhSize, Grid, GridSize, LeafEntry, List, Octree, OctreeNode, OctreeSize,
    TraversalHeap, TraversalStack,
};
use strahl_core::geometry::{Hit, Ray};
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Real, Vec3, World, vec3};
use strahl_tests::hard::{HardCase, cases};
use strahl_tests::single::TestScene;
use strahl_tests::{DVec3, TestRay, TestShape};

/// The nearest hit of each ray, and whether anything is in the way just before it and at it.
fn answers<A: Accelerator>(scene: &TestScene, accelerator: A, rays: &[Ray]) -> Vec<(Option<Hit>, [bool; 2])> {
    let world = World::new(scene.as_scene(), accelerator);
    let mut scratch = A::Scratch::default();
    let answer = |ray: &Ray| {
        let hit = world.nearest_hit::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut scratch, &mut ());
        let t = hit.map_or(1.0, |hit| hit.t);
        let mut is_blocked = |t_max| {
            world.occluder::<AllEffects, _>(ray, t_max, RayKind::Shadow, &mut scratch, &mut ()).is_some()
        };
        (hit, [is_blocked(t.next_down()), is_blocked(t)])
    };
    rays.iter().map(answer).collect()
}

fn core_ray(ray: &TestRay) -> Ray {
    let narrow = |v: DVec3| -> Vec3 { vec3(v.x as f32, v.y as f32, v.z as f32) };
    Ray::new(narrow(ray.origin), narrow(ray.direction))
}

/// Things of one case together, as different as they are in size and place: how many rays meet one.
fn hold(about: &str, aims: &[(TestShape, Vec<TestRay>)]) -> usize {
    let mut scene = TestScene::new();
    aims.iter().for_each(|(shape, _)| _ = scene.add_shape(shape));
    let rays: Vec<Ray> = aims.iter().flat_map(|(_, rays)| rays).map(core_ray).collect();
    let boxes = scene.bounds();
    let truth = answers(&scene, List::without_bounds(scene.item_count()), &rays);
    let hold = |name: &str, got: Vec<_>| {
        for ((ray, truth), got) in rays.iter().zip(&truth).zip(&got) {
            assert_eq!(got, truth, "{name}; {about}: {ray:?}");
        }
    };

    let room = BvhSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![BvhNode::EMPTY; room.nodes], vec![LeafEntry::EMPTY; room.entries]);
    let tree = Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap();
    hold("hierarchy by a stack", answers(&scene, tree, &rays));
    hold("hierarchy by a heap", answers(&scene, tree.with_queue::<TraversalHeap<64>>(), &rays));
    hold("hierarchy by nothing", answers(&scene, tree.with_queue::<TraversalStack<0>>(), &rays));
    let room = GridSize::recommended(&boxes);
    let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.entries]);
    hold("grid", answers(&scene, Grid::<8>::build(&boxes, &mut cells, &mut items).unwrap(), &rays));
    let room = OctreeSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; room.nodes], vec![0; room.entries]);
    hold("octree", answers(&scene, Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap(), &rays));
    truth.iter().filter(|(hit, _)| hit.is_some()).count()
}

#[test]
fn every_accelerator_answers_every_hard_ray_like_the_list() {
    let hold_case = |case: HardCase| -> usize {
        let about = format!("{}, {}", case.family, case.name);
        case.all_aims().chunks(12).map(|aims| hold(&about, aims)).sum()
    };
    // Two halves side by side.
    let half = |odd: usize| cases().into_iter().skip(odd).step_by(2).map(hold_case).sum::<usize>();
    let hits = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        half(0) + other.join().unwrap()
    });
    assert!(hits > 200_000, "{hits}");
}
