//! The mailbox: an item in many cells is tested once, and a hit beyond the cell that offers it neither ends
//! the traversal nor is lost.

use strahl_core::accel::{Accelerator, Grid, GridSize, Octree, OctreeLimits, OctreeNode};
use strahl_core::geometry::{Hit, ItemId, Ray};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{AllEffects, Real, Vec3, World, vec3};
use strahl_test_scene::TestScene;

/// A triangle across the whole scene, which is hit far from the cell that offers it first; a small sphere in
/// front of that hit; and many tiny spheres, so that there are many cells.
fn triangle_and_sphere() -> TestScene {
    let mut scene = TestScene::new();
    // The bounds of item 0 are those of the whole scene.
    scene.triangle([vec3(-8.0, -8.0, 6.0), vec3(8.0, -8.0, 6.0), vec3(-8.0, 8.0, -6.0)]);
    scene.sphere(vec3(-4.0, -4.0, 5.0), 0.5);
    for i in 0..64 {
        let (x, y, z) = ((i % 4) as Real, (i / 4 % 4) as Real, (i / 16) as Real);
        scene.sphere(vec3(x, y, z) * 5.0 - 7.5, 0.01);
    }
    scene
}

/// The nearest hit, which must be the same with every mailbox, and the counters of each.
fn traced(scene: &TestScene, ray: &Ray, t_max: Real) -> (Option<Hit>, Vec<Counters>) {
    fn trace<A: Accelerator>(
        scene: &TestScene,
        accelerator: A,
        ray: &Ray,
        t_max: Real,
    ) -> (Option<Hit>, Counters) {
        let mut counters = Counters::new();
        let world = World::new(scene.as_scene(), accelerator);
        let hit = world.nearest_hit::<AllEffects, _>(
            ray,
            t_max,
            RayKind::Camera,
            &mut A::Scratch::default(),
            &mut counters,
        );
        (hit, counters)
    }
    let boxes = scene.bounds();
    let size = GridSize::recommended(&boxes);
    let (mut cells, mut items) = (vec![0; size.cells], vec![0; size.entries]);
    let grid = Grid::<0>::build(&boxes, &mut cells, &mut items).unwrap().without_item_bounds();
    let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; 1 + 8 * 300], vec![0; 3000]);
    let limits = OctreeLimits { max_depth: 4, max_leaf_items: 1 };
    let octree =
        Octree::<0>::build_with_limits(limits, &boxes, &mut nodes, &mut items).unwrap().without_item_bounds();
    assert!(
        grid.cell_count() > 100 && octree.occupied_leaf_count() > 60,
        "{} {}",
        grid.cell_count(),
        octree.occupied_leaf_count()
    );
    let answers = [
        trace(scene, grid, ray, t_max),
        trace(scene, grid.with_mailbox::<1>(), ray, t_max),
        trace(scene, grid.with_mailbox::<64>(), ray, t_max),
        trace(scene, octree, ray, t_max),
        trace(scene, octree.with_mailbox::<1>(), ray, t_max),
        trace(scene, octree.with_mailbox::<64>(), ray, t_max),
    ];
    let hit = answers[0].0;
    assert!(answers.iter().all(|(other, _)| *other == hit), "{answers:?}");
    (hit, answers.into_iter().map(|(_, counters)| counters).collect())
}

#[test]
fn a_hit_beyond_the_cell_that_offers_it_does_not_hide_a_nearer_item() {
    let scene = triangle_and_sphere();
    // The first cells contain only the triangle, which is hit behind the sphere.
    let ray = Ray::new(vec3(-4.0, -4.0, 9.0), vec3(0.0, 0.0, -1.0));
    let (hit, _) = traced(&scene, &ray, Real::MAX);
    assert_eq!(hit, Some(Hit { t: 3.5, item: ItemId(1) }));
    let beside = Ray::new(vec3(-4.0, -5.0, 9.0), vec3(0.0, 0.0, -1.0));
    assert!(traced(&scene, &beside, Real::MAX).0.is_some_and(|hit| hit.item == ItemId(0) && hit.t > 4.0));
}

#[test]
fn a_hit_beyond_the_cell_that_offers_it_stays_when_the_mailbox_skips_the_item_later() {
    let scene = triangle_and_sphere();
    let start = vec3(-7.9, -7.0, -5.5);
    // The triangle is offered in the first cell and hit in one of the last.
    let target = vec3(2.0, -7.0, 5.25);
    let ray = Ray::new(start, target - start);
    let (hit, counters) = traced(&scene, &ray, Real::MAX);
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
        assert_eq!(with.leaf_visits[kind], without.leaf_visits[kind], "the traversal is the same");
    }
    // A hit beyond `t_max` is not reported, wherever the item was offered.
    assert_eq!(traced(&scene, &ray, hit.unwrap().t.next_down()).0, None);
    assert_eq!(traced(&scene, &ray, hit.unwrap().t).0, hit);
    assert_eq!(traced(&scene, &Ray::new(Vec3::splat(20.0), Vec3::ONE), Real::MAX).0, None);
}
