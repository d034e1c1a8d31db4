//! The mailbox's two cases: an item in many regions is tested once, and a hit beyond the region that
//! offers it neither ends the walk nor is lost.

use strahl_core::accel::{Accelerator, Grid, GridSize, Octree, OctreeLimits, OctreeNode};
use strahl_core::geometry::{Hit, ItemId, Ray};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{AllEffects, Real, Vec3, World, vec3};
use strahl_tests::single::TestScene;

/// A long needle of a box across the whole scene, to be hit far from where it is first offered; a
/// small sphere before that hit; corners of the scene, so that there are many regions.
fn needle_and_sphere() -> TestScene {
    let mut scene = TestScene::new();
    // Number 0 fills a triangle from one end of the scene to the other: its box is all of it.
    scene.triangle([vec3(-8.0, -8.0, 6.0), vec3(8.0, -8.0, 6.0), vec3(-8.0, 8.0, -6.0)]);
    scene.sphere(vec3(-4.0, -4.0, 5.0), 0.5);
    for i in 0..64 {
        let (x, y, z) = ((i % 4) as Real, (i / 4 % 4) as Real, (i / 16) as Real);
        scene.sphere(vec3(x, y, z) * 5.0 - 7.5, 0.01);
    }
    scene
}

/// What a ray meets with all mailboxes, and the work with each.
fn met(scene: &TestScene, ray: &Ray, t_max: Real) -> (Option<Hit>, Vec<Counters>) {
    fn ask<A: Accelerator>(
        scene: &TestScene,
        accelerator: A,
        ray: &Ray,
        t_max: Real,
    ) -> (Option<Hit>, Counters) {
        let mut counters = Counters::new();
        let world = World::new(scene.as_scene(), accelerator);
        let hit = world.nearest::<AllEffects, _>(
            ray,
            t_max,
            RayKind::Camera,
            &mut A::Scratch::default(),
            &mut counters,
        );
        (hit, counters)
    }
    let boxes = scene.bounds();
    let room = GridSize::recommended(&boxes);
    let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.entries]);
    let grid = Grid::<0>::build(&boxes, &mut cells, &mut items).unwrap().without_item_bounds();
    let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; 1 + 8 * 300], vec![0; 3000]);
    let limits = OctreeLimits { max_depth: 4, max_leaf_items: 1 };
    let octree =
        Octree::<0>::with_limits(limits, &boxes, &mut nodes, &mut items).unwrap().without_item_bounds();
    assert!(
        grid.cell_count() > 100 && octree.occupied_leaf_count() > 60,
        "{} {}",
        grid.cell_count(),
        octree.occupied_leaf_count()
    );
    let answers = [
        ask(scene, grid, ray, t_max),
        ask(scene, grid.with_mailbox::<1>(), ray, t_max),
        ask(scene, grid.with_mailbox::<64>(), ray, t_max),
        ask(scene, octree, ray, t_max),
        ask(scene, octree.with_mailbox::<1>(), ray, t_max),
        ask(scene, octree.with_mailbox::<64>(), ray, t_max),
    ];
    let hit = answers[0].0;
    assert!(answers.iter().all(|(other, _)| *other == hit), "{answers:?}");
    (hit, answers.into_iter().map(|(_, counters)| counters).collect())
}

#[test]
fn a_hit_beyond_the_region_that_offers_it_does_not_hide_what_lies_before_it() {
    let scene = needle_and_sphere();
    // Along x at first it is in regions of the triangle only; it meets the triangle after the sphere.
    let ray = Ray::new(vec3(-4.0, -4.0, 9.0), vec3(0.0, 0.0, -1.0));
    let (hit, _) = met(&scene, &ray, Real::MAX);
    assert_eq!(hit, Some(Hit { t: 3.5, item: ItemId(1) }));
    let beside = Ray::new(vec3(-4.0, -5.0, 9.0), vec3(0.0, 0.0, -1.0));
    assert!(met(&scene, &beside, Real::MAX).0.is_some_and(|hit| hit.item == ItemId(0) && hit.t > 4.0));
}

#[test]
fn a_hit_beyond_the_region_that_offers_it_is_not_lost_when_the_mailbox_leaves_it_out_later() {
    let scene = needle_and_sphere();
    let start = vec3(-7.9, -7.0, -5.5);
    // It runs under the triangle for a long way: offered in the first region, hit in one of the last.
    let target = vec3(2.0, -7.0, 5.25);
    let ray = Ray::new(start, target - start);
    let (hit, counters) = met(&scene, &ray, Real::MAX);
    assert!(hit.is_some_and(|hit| hit.item == ItemId(0) && (hit.t - 1.0).abs() < 1e-5), "{hit:?}");
    for (with, without) in [(2, 0), (5, 3)] {
        let (with, without) = (&counters[with], &counters[without]);
        let kind = RayKind::Camera;
        assert_eq!(without.mailbox_hits[kind], 0);
        assert!(with.mailbox_hits[kind] > 3, "{with:?}");
        assert_eq!(
            with.shape_tests[kind] + with.mailbox_hits[kind],
            without.shape_tests[kind],
            "skipped or tested"
        );
        assert_eq!(with.leaf_visits[kind], without.leaf_visits[kind], "the walk is the same");
    }
    // And when the hit is out of reach it is no hit, wherever it was offered.
    assert_eq!(met(&scene, &ray, hit.unwrap().t.next_down()).0, None);
    assert_eq!(met(&scene, &ray, hit.unwrap().t).0, hit);
    assert_eq!(met(&scene, &Ray::new(Vec3::splat(20.0), Vec3::ONE), Real::MAX).0, None);
}
