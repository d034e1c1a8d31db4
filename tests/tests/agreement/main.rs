//! Every way of finding gives the same answer, to the last bit.

mod buffers;
mod check;
mod mailbox;
mod scenes;

use std::ops::ControlFlow;

use check::{AcceleratorCheck, QueryCase, nearest, occluder};
use strahl_core::accel::{
    Accelerator, Buffer, BuildError, BvhSize, GridSize, List, OctreeSize, Query, group_count,
};
use strahl_core::geometry::{Aabb, BoundingSphere, Hit, ItemId, Ray};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{AllEffects, Real, Vec3, World, vec3};
use strahl_tests::single::TestScene;
use strahl_tests::{DVec3, SplitMix64, TestShape, TestShapeKind, dvec3};

const SEED: u64 = 0x5eed_0003;

/// Offers the items in any order that it is told, some of them more than once.
#[derive(Clone, Debug)]
struct PermutedList(Vec<u32>);

impl Accelerator for PermutedList {
    type Scratch = ();

    fn traverse<Q: Query>(&self, _: &Ray, _: &mut (), query: &mut Q) {
        let end = self.0.iter().try_for_each(|item| query.test_item(ItemId(*item)));
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = end;
    }
}

impl PermutedList {
    /// All items in some order, and a few of them again.
    fn any(items: u32, rng: &mut SplitMix64) -> Self {
        let mut order: Vec<u32> = (0..items).collect();
        for i in (1..order.len()).rev() {
            order.swap(i, rng.below(i as u32 + 1) as usize);
        }
        for _ in 0..items / 4 {
            order.push(rng.below(items));
        }
        PermutedList(order)
    }
}

/// Holds every way of finding against the bare list; answers how many hits there were.
fn all_agree(scene: &TestScene, rays: &[Ray], rng: &mut SplitMix64) -> usize {
    // The scenes of a test do not depend on how many numbers are taken here.
    let rng = &mut SplitMix64::new(rng.bits());
    let bare = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let check = AcceleratorCheck::new(scene, rays, rng);
    let AcceleratorCheck { boxes, cases, .. } = &check;

    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let boxed = List::with_boxes(boxes, &mut groups).unwrap();
    check.check("with boxes", boxed);
    let (mut balls, mut round) =
        (vec![BoundingSphere::EMPTY; boxes.len()], vec![BoundingSphere::EMPTY; group_count(boxes.len())]);
    check.check("with balls", List::with_spheres(boxes, &mut balls, &mut round).unwrap());
    check.check("in another order", PermutedList::any(scene.item_count(), rng));

    // Any memory from the floor upwards.
    let nodes = BvhSize::recommended(boxes.len()).nodes;
    check.check_bvh(if nodes == 0 { 0 } else { 1 + rays.len() % nodes });
    let items = boxes.iter().filter(|aabb| **aabb != Aabb::EMPTY).count();
    let (grid, octree) = (GridSize::recommended(boxes), OctreeSize::recommended(boxes.len()));
    check.check_grid_and_octree::<64>(grid, octree);
    check.check_grid_and_octree::<0>(
        GridSize { cells: 2, entries: items },
        OctreeSize { nodes: 1, entries: items },
    );
    let mut any = |floor: usize, most: usize| floor + rng.below((most - floor + 1) as u32) as usize;
    check.check_grid_and_octree::<1>(
        GridSize { cells: any(2, grid.cells), entries: any(items, grid.entries) },
        OctreeSize { nodes: any(1, octree.nodes), entries: any(items, octree.entries) },
    );
    check.check_grid_and_octree::<8>(
        GridSize { cells: grid.cells, entries: any(items, grid.entries) },
        OctreeSize { nodes: octree.nodes, entries: any(items, octree.entries) },
    );

    let boxed = World::new(scene.as_scene(), boxed);
    for QueryCase { ray, t_max, expected } in cases {
        assert_eq!(occluder(&boxed, ray, *t_max), occluder(&bare, ray, *t_max), "{ray:?} {t_max}");
        if *t_max == Real::INFINITY
            && let Some((_, bits)) = expected.hit
        {
            let before = nearest(&bare, ray, Real::from_bits(bits).next_down());
            assert_eq!(before, None, "nearer than the nearest: {ray:?}");
        }
    }
    check.hits()
}

fn narrow(v: DVec3) -> Vec3 {
    vec3(v.x as Real, v.y as Real, v.z as Real)
}

/// A ray through the ball of `radius` round the origin, of any length; one in four along an
/// axis, and some with zeros of both signs.
fn random_ray(radius: f64, rng: &mut SplitMix64) -> Ray {
    let origin = rng.in_ball(DVec3::ZERO, 2.0 * radius);
    let target = rng.in_ball(DVec3::ZERO, radius);
    let mut way = (target - origin) * rng.log_between(0.01, 100.0);
    if rng.below(4) == 0 {
        let zero = [0.0, -0.0][rng.below(2) as usize];
        match rng.below(6) {
            0 => way = dvec3(way.x, zero, -zero),
            1 => way = dvec3(zero, way.y, zero),
            2 => way = dvec3(-zero, zero, way.z),
            3 => way.x = zero,
            4 => way.y = zero,
            _ => way.z = zero,
        }
    }
    Ray::new(narrow(origin), narrow(way))
}

fn random_scene(items: u32, rng: &mut SplitMix64) -> TestScene {
    let mut scene = TestScene::new();
    for _ in 0..items {
        // A plane would hide too much if there were many.
        let kind = loop {
            let kind = TestShapeKind::ALL[rng.below(TestShapeKind::ALL.len() as u32) as usize];
            if kind != TestShapeKind::Plane || rng.below(8) == 0 {
                break kind;
            }
        };
        let place = rng.in_ball(DVec3::ZERO, 8.0);
        let size = rng.log_between(0.1, 3.0);
        scene.add_shape(&TestShape::random(kind, place, size, rng));
    }
    scene
}

/// The same at some time, often at one of the ends.
fn timed_ray(radius: f64, rng: &mut SplitMix64) -> Ray {
    let time = [0.0, 1.0, 0.5, rng.unit() as Real][rng.below(4) as usize];
    random_ray(radius, rng).with_time(time)
}

/// SplitMix64 things, and every third of them moves: not at all, along an axis, anywhere.
fn moving_scene(items: u32, rng: &mut SplitMix64) -> TestScene {
    let mut scene = random_scene(items, rng);
    for item in (0..items).filter(|item| item % 3 == 0) {
        let mut way = || narrow(rng.in_ball(DVec3::ZERO, 3.0));
        let (opening, closing) = match item % 4 {
            0 => (Vec3::ZERO, Vec3::ZERO),
            1 => (Vec3::ZERO, Vec3::X * way().x),
            _ => (way(), way()),
        };
        scene.set_motion(ItemId(item), opening, closing);
    }
    scene
}

#[test]
fn things_that_move_are_found_at_their_time_by_every_accelerator() {
    let mut rng = SplitMix64::new(SEED + 10);
    let mut hits = 0;
    for _ in 0..30 {
        let items = 1 + rng.below(70);
        let scene = moving_scene(items, &mut rng);
        let rays: Vec<Ray> = (0..250).map(|_| timed_ray(9.0, &mut rng)).collect();
        hits += all_agree(&scene, &rays, &mut rng);
    }
    assert!(hits > 2_500 && hits < 7_500, "{hits}");
}

#[test]
fn a_thing_that_moves_is_met_like_one_that_stands_where_it_is() {
    // Coordinates in sixteenths, so that moving it rounds nothing.
    let mut rng = SplitMix64::new(SEED + 11);
    let exact = |v: Vec3| (v * 16.0).round() / 16.0;
    let mut hits = 0;
    for _ in 0..400 {
        let (center, radius) =
            (exact(narrow(rng.in_ball(DVec3::ZERO, 3.0))), 1.0 + rng.below(16) as Real / 16.0);
        let way = exact(narrow(rng.in_ball(DVec3::ZERO, 4.0)));
        let (mut moves, mut stands) = (TestScene::new(), TestScene::new());
        let ball = moves.sphere(center - way, radius);
        moves.set_motion(ball, Vec3::ZERO, way * 4.0);
        stands.sphere(center, radius);
        for _ in 0..10 {
            let ray = random_ray(4.0, &mut rng);
            let ray = Ray::new(exact(ray.origin), ray.direction).with_time(0.25);
            let world = World::new(moves.as_scene(), List::without_bounds(1));
            let expected = World::new(stands.as_scene(), List::without_bounds(1));
            let (hit, want) = (nearest(&world, &ray, Real::MAX), nearest(&expected, &ray, Real::MAX));
            // The box of the one that stands is tighter: so a few grazing hits may differ.
            if let (Some(hit), Some(want)) = (hit, want) {
                hits += 1;
                let (a, b) = (hit.t, want.t);
                assert!((a - b).abs() <= 4.0 * Real::EPSILON * b, "{a} {b}");
                let surfaces =
                    (world.surface::<AllEffects>(&ray, hit), expected.surface::<AllEffects>(&ray, want));
                let (Some(it), Some(want)) = surfaces else { panic!("no surface") };
                let off = (it.point - want.point).abs();
                assert!(off.cmple(it.point_error + want.point_error).all(), "{off}");
            } else {
                assert_eq!(hit, want, "{ray:?}");
            }
        }
    }
    assert!(hits > 500, "{hits}");
}

#[test]
fn the_list_with_boxes_answers_like_the_bare_list() {
    let mut rng = SplitMix64::new(SEED);
    let mut hits = 0;
    for _ in 0..60 {
        let items = 1 + rng.below(70);
        let scene = random_scene(items, &mut rng);
        let rays: Vec<Ray> = (0..250).map(|_| random_ray(9.0, &mut rng)).collect();
        hits += all_agree(&scene, &rays, &mut rng);
    }
    assert!(hits > 5_000 && hits < 15_000, "{hits}");
}

#[test]
fn the_nearest_of_all_is_the_nearest_of_each_alone() {
    let mut rng = SplitMix64::new(SEED + 1);
    let shapes: Vec<TestShape> = TestShapeKind::ALL
        .map(|kind| TestShape::random(kind, rng.in_ball(DVec3::ZERO, 3.0), 1.5, &mut rng))
        .into();
    let mut scene = TestScene::new();
    shapes.iter().for_each(|shape| assert!(scene.add_shape(shape).0 < 14));
    let alone: Vec<TestScene> = shapes
        .iter()
        .map(|shape| {
            let mut scene = TestScene::new();
            scene.add_shape(shape);
            scene
        })
        .collect();
    let all = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    for _ in 0..2_000 {
        let ray = random_ray(4.0, &mut rng);
        let hits = alone.iter().zip(0..).filter_map(|(scene, number)| {
            let hit = nearest(&World::new(scene.as_scene(), List::without_bounds(1)), &ray, Real::MAX)?;
            Some(Hit { item: ItemId(number), ..hit })
        });
        let first = hits.min_by(|a, b| (a.t, a.item).partial_cmp(&(b.t, b.item)).unwrap());
        assert_eq!(nearest(&all, &ray, Real::MAX), first, "{ray:?}");
    }
}

#[test]
fn groups_that_are_full_or_have_one_more_answer_like_the_bare_list() {
    let mut rng = SplitMix64::new(SEED + 2);
    let mut hits = 0;
    for items in [1, 2, 15, 16, 17, 31, 32, 33, 256, 257] {
        let scene = random_scene(items, &mut rng);
        let rays: Vec<Ray> = (0..100).map(|_| random_ray(9.0, &mut rng)).collect();
        hits += all_agree(&scene, &rays, &mut rng);
    }
    assert!(hits > 200 && hits < 800, "{hits}");
}

#[test]
fn many_equal_items_answer_with_the_lowest_number() {
    let mut rng = SplitMix64::new(SEED + 3);
    for kind in TestShapeKind::ALL {
        let shape = TestShape::random(kind, dvec3(0.5, -0.25, 1.0), 2.0, &mut rng);
        let mut scene = TestScene::new();
        for _ in 0..40 {
            scene.add_shape(&shape);
        }
        let rays: Vec<Ray> = (0..800).map(|_| random_ray(3.0, &mut rng)).collect();
        assert!(all_agree(&scene, &rays, &mut rng) > 20, "{kind:?}");
        let world = World::new(scene.as_scene(), PermutedList((0..40).rev().collect()));
        for ray in &rays {
            assert!(
                nearest(&world, ray, Real::MAX).is_none_or(|hit| hit.item == ItemId(0)),
                "{kind:?} {ray:?}"
            );
        }
    }
}

#[test]
fn of_two_things_at_one_distance_the_lower_number_wins_from_any_order() {
    let down = Ray::new(vec3(0.25, 0.25, 4.0), vec3(0.0, 0.0, -1.0));
    let corners = [vec3(-1.0, -1.0, 0.0), vec3(3.0, -1.0, 0.0), vec3(-1.0, 3.0, 0.0)];
    // All of them have a part of z = 0 on top.
    let put: [fn(&mut TestScene, [Vec3; 3]) -> ItemId; 6] = [
        |scene, corners| scene.triangle(corners),
        |scene, [a, b, c]| scene.triangle([b, c, a]),
        |scene, corners| scene.polygon(&corners, &[]),
        |scene, _| scene.disc(Vec3::ZERO, Vec3::Z, 1.0),
        |scene, _| scene.plane(vec3(5.0, 0.0, 0.0), Vec3::Z),
        |scene, _| scene.cuboid(vec3(-1.0, -1.0, -1.0), vec3(1.0, 1.0, 0.0)),
    ];
    let mut rng = SplitMix64::new(SEED + 4);
    for first in 0..put.len() {
        // Another of them is the first each time.
        let mut scene = TestScene::new();
        for i in 0..put.len() {
            put[(first + i) % put.len()](&mut scene, corners);
        }
        for _ in 0..20 {
            let world = World::new(scene.as_scene(), PermutedList::any(scene.item_count(), &mut rng));
            assert_eq!(nearest(&world, &down, Real::MAX), Some(Hit { t: 4.0, item: ItemId(0) }), "{first}");
        }
        assert_eq!(all_agree(&scene, &[down], &mut rng), 1);
    }
}

#[test]
fn flat_items_without_thickness_answer_like_in_the_bare_list() {
    let mut rng = SplitMix64::new(SEED + 5);
    let mut scene = TestScene::new();
    for level in -3..3 {
        let z = level as Real;
        let square = [vec3(-2.0, -2.0, z), vec3(2.0, -2.0, z), vec3(2.0, 2.0, z), vec3(-2.0, 2.0, z)];
        scene.polygon(&square, &[]);
        scene.triangle([square[0], square[1], square[2]]);
        scene.disc(vec3(0.0, 0.0, z), Vec3::Z, 2.0);
        scene.cuboid(square[0], square[2]);
    }
    let mut rays: Vec<Ray> = (0..1_000).map(|_| random_ray(4.0, &mut rng)).collect();
    // Down on them; in their planes, along axes and not; from their edges and corners.
    for x in [-2.0, -0.5, 0.0, 0.5, 2.0] {
        for zero in [0.0, -0.0] {
            rays.push(Ray::new(vec3(x, -x, 5.0), vec3(zero, -zero, -1.0)));
            rays.push(Ray::new(vec3(-5.0, x, 1.0), vec3(1.0, zero, zero)));
            rays.push(Ray::new(vec3(-5.0, x, 1.0), vec3(1.0, 0.25, zero)));
            rays.push(Ray::new(vec3(2.0, x, 1.0), vec3(-1.0, zero, -1.0)));
        }
    }
    assert!(all_agree(&scene, &rays, &mut rng) > 300);
}

#[test]
fn a_ray_along_an_axis_through_a_raster_of_boxes_meets_the_first_of_its_row() {
    // Walls touch, and half of the rays run in them.
    let mut scene = TestScene::new();
    for (x, y, z) in (0..64).map(|i| (i % 4, i / 4 % 4, i / 16)) {
        let min = vec3(x as Real, y as Real, z as Real);
        scene.cuboid(min, min + Vec3::ONE);
    }
    let mut rays = Vec::new();
    for zero in [0.0, -0.0] {
        for (i, j) in (0..81).map(|i| (i % 9, i / 9)) {
            let (a, b) = (0.5 * i as Real, 0.5 * j as Real);
            for (start, way) in [(-1.0, 1.0), (5.0, -2.0), (1.0, 1.0), (1.5, -1.0)] {
                rays.push(Ray::new(vec3(start, a, b), vec3(way, zero, zero)));
                rays.push(Ray::new(vec3(a, start, b), vec3(-zero, way, zero)));
                rays.push(Ray::new(vec3(a, b, start), vec3(zero, -zero, way)));
            }
        }
    }
    let mut rng = SplitMix64::new(SEED + 6);
    assert_eq!(all_agree(&scene, &rays, &mut rng), rays.len());
    // On paper: the row of boxes numbers 4 (y + 4 z), of two boxes beside a wall the lower one.
    let world = World::new(scene.as_scene(), List::without_bounds(64));
    for (y, z, row) in
        [(0.5, 0.5, 0), (1.5, 2.5, 4 * (1 + 4 * 2)), (1.0, 0.5, 0), (4.0, 4.0, 60), (2.0, 3.0, 36)]
    {
        let hit = nearest(&world, &Ray::new(vec3(-1.0, y, z), Vec3::X), Real::MAX);
        assert_eq!(hit, Some(Hit { t: 1.0, item: ItemId(row) }), "{y} {z}");
    }
}

#[test]
fn a_hit_at_the_very_reach_counts_and_one_beyond_does_not() {
    let mut scene = TestScene::new();
    scene.sphere(vec3(0.0, 0.0, -5.0), 1.0);
    scene.plane(vec3(0.0, 0.0, -7.0), Vec3::Z);
    let world = World::new(scene.as_scene(), List::without_bounds(2));
    let ray = Ray::new(Vec3::ZERO, -Vec3::Z);
    for (t_max, item) in
        [(4.0, Some(0)), (4.0_f32.next_down(), None), (100.0, Some(0)), (0.0, None), (-1.0, None)]
    {
        assert_eq!(nearest(&world, &ray, t_max).map(|hit| hit.item.0), item, "{t_max}");
        assert_eq!(occluder(&world, &ray, t_max).is_some(), item.is_some(), "{t_max}");
    }
    assert_eq!(nearest(&world, &ray, Real::NAN).map(|hit| hit.item.0), Some(0), "no number is no limit");
}

#[test]
fn an_empty_scene_is_met_by_nothing() {
    let scene = TestScene::new();
    assert_eq!(all_agree(&scene, &[Ray::new(Vec3::ZERO, Vec3::X)], &mut SplitMix64::new(SEED + 7)), 0);
    assert_eq!(group_count(0), 0);
    assert!(List::with_boxes(&[], &mut []).is_ok_and(|list| list.size_in_bytes() == 0));
}

#[test]
fn too_few_groups_are_refused_with_the_numbers_to_act_on() {
    for (items, needed) in [(1, 1), (16, 1), (17, 2), (32, 2), (33, 3), (1000, 63)] {
        assert_eq!(group_count(items), needed);
        let boxes = vec![Aabb { min: Vec3::ZERO, max: Vec3::ONE }; items];
        let mut groups = vec![Aabb::EMPTY; needed + 1];
        for provided in 0..needed {
            let error = List::with_boxes(&boxes, &mut groups[..provided]).unwrap_err();
            assert_eq!(
                error,
                BuildError::BufferTooSmall { buffer: Buffer::GroupBounds, needed, provided: provided }
            );
            assert_eq!(error.to_string(), format!("group bounds: {needed} needed, {provided} provided"));
        }
        let mut balls = vec![BoundingSphere::EMPTY; items];
        let error = List::with_spheres(&boxes, &mut balls[1..], &mut []).unwrap_err();
        assert_eq!(
            error,
            BuildError::BufferTooSmall { buffer: Buffer::ItemBounds, needed: items, provided: items - 1 }
        );
        let error = List::with_spheres(&boxes, &mut balls, &mut []).unwrap_err();
        assert_eq!(error, BuildError::BufferTooSmall { buffer: Buffer::GroupBounds, needed, provided: 0 });
        for provided in [needed, needed + 1] {
            let list = List::with_boxes(&boxes, &mut groups[..provided]).unwrap();
            assert_eq!(list.size_in_bytes(), (items + needed) * size_of::<Aabb>());
        }
    }
}

#[test]
fn boxes_save_tests_of_shapes_and_groups_save_tests_of_boxes() {
    let mut rng = SplitMix64::new(SEED + 8);
    let mut scene = TestScene::new();
    for i in 0..320 {
        // Neighbours in the list are neighbours in space, or groups would be of no use.
        let place = dvec3(f64::from(i) - 160.0, 0.0, 0.0);
        scene.add_shape(&TestShape::random(TestShapeKind::Sphere, place, 0.5, &mut rng));
    }
    let boxes = scene.bounds();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let boxed = World::new(scene.as_scene(), List::with_boxes(&boxes, &mut groups).unwrap());
    let (mut balls, mut round) =
        (vec![BoundingSphere::EMPTY; boxes.len()], vec![BoundingSphere::EMPTY; group_count(boxes.len())]);
    let balled = World::new(scene.as_scene(), List::with_spheres(&boxes, &mut balls, &mut round).unwrap());
    let bare = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let rays: Vec<Ray> = (0..100)
        .map(|_| {
            let origin = rng.in_ball(dvec3(0.0, 100.0, 0.0), 50.0);
            Ray::new(narrow(origin), narrow(rng.in_ball(DVec3::ZERO, 50.0) - origin))
        })
        .collect();

    let mut without = Counters::new();
    let mut with = Counters::new();
    let mut by_balls = Counters::new();
    for ray in &rays {
        balled.nearest::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut by_balls);
        bare.nearest::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut without);
        boxed.nearest::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut with);
    }
    let kind = RayKind::Camera;
    assert_eq!(
        (without.shape_tests[kind], without.box_tests[kind], without.leaf_visits[kind]),
        (32_000, 0, 100)
    );
    assert!(
        by_balls.shape_tests[kind] < 6_400 && by_balls.shape_tests[kind] >= with.shape_tests[kind],
        "{by_balls:?}"
    );
    // A tenth of the shapes, and half of the boxes, is far more than what is found.
    assert!(with.shape_tests[kind] < 3_200, "{with:?}");
    assert!(with.box_tests[kind] >= 2_000 && with.box_tests[kind] < 16_000, "{with:?}");
    assert_eq!(
        with.box_tests[kind],
        2_000 + 16 * with.leaf_visits[kind],
        "groups, and the content of those that were met"
    );
}
