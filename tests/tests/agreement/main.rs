//! Every accelerator finds what the list without bounds finds, bit for bit.

mod buffers;
mod check;
mod list;
mod mailbox;
mod motion;
mod scenes;

use std::ops::ControlFlow;

use check::{AcceleratorCheck, QueryCase, nearest, occluder};
use strahl_core::accel::{
    Accelerator, Buffer, BuildError, BvhSize, GridSize, List, OctreeSize, Query, group_count,
};
use strahl_core::geometry::{Aabb, BoundingSphere, Hit, ItemId, Ray};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{AllEffects, Real, Vec3, World, vec3};
use strahl_test_scene::{DVec3, SplitMix64, TestScene, TestShape, TestShapeKind, dvec3};

const SEED: u64 = 0x5eed_0003;

/// Offers the items in a given order, some of them more than once.
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
    /// All items in random order, and a quarter of them again.
    fn random(items: u32, rng: &mut SplitMix64) -> Self {
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

/// Compares every accelerator with the list without bounds. Returns the number of hits.
fn all_agree(scene: &TestScene, rays: &[Ray], rng: &mut SplitMix64) -> usize {
    // A generator of its own: scenes do not depend on how many numbers are drawn here.
    let rng = &mut SplitMix64::new(rng.bits());
    let unbounded = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let check = AcceleratorCheck::new(scene, rays, rng);
    let AcceleratorCheck { boxes, cases, .. } = &check;

    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let bounded = List::with_boxes(boxes, &mut groups).unwrap();
    check.check("with bounding boxes", bounded);
    let (mut spheres, mut groups_of_spheres) =
        (vec![BoundingSphere::EMPTY; boxes.len()], vec![BoundingSphere::EMPTY; group_count(boxes.len())]);
    check.check(
        "with bounding spheres",
        List::with_spheres(boxes, &mut spheres, &mut groups_of_spheres).unwrap(),
    );
    check.check("in another order", PermutedList::random(scene.item_count(), rng));

    // Buffers of any accepted size.
    let nodes = BvhSize::recommended(boxes.len()).nodes;
    check.check_bvh(if nodes == 0 { 0 } else { 1 + rays.len() % nodes });
    let items = boxes.iter().filter(|aabb| **aabb != Aabb::EMPTY).count();
    let (grid, octree) = (GridSize::recommended(boxes), OctreeSize::recommended(boxes.len()));
    check.check_grid_and_octree::<64>(grid, octree);
    check.check_grid_and_octree::<0>(
        GridSize { cells: 2, entries: items },
        OctreeSize { nodes: 1, entries: items },
    );
    let mut any = |min: usize, max: usize| min + rng.below((max - min + 1) as u32) as usize;
    check.check_grid_and_octree::<1>(
        GridSize { cells: any(2, grid.cells), entries: any(items, grid.entries) },
        OctreeSize { nodes: any(1, octree.nodes), entries: any(items, octree.entries) },
    );
    check.check_grid_and_octree::<8>(
        GridSize { cells: grid.cells, entries: any(items, grid.entries) },
        OctreeSize { nodes: octree.nodes, entries: any(items, octree.entries) },
    );

    let bounded = World::new(scene.as_scene(), bounded);
    for QueryCase { ray, t_max, expected } in cases {
        assert_eq!(occluder(&bounded, ray, *t_max), occluder(&unbounded, ray, *t_max), "{ray:?} {t_max}");
        if *t_max == Real::INFINITY
            && let Some((_, bits)) = expected.hit
        {
            let before = nearest(&unbounded, ray, Real::from_bits(bits).next_down());
            assert_eq!(before, None, "nearer than the nearest hit: {ray:?}");
        }
    }
    check.hits()
}

fn narrow(v: DVec3) -> Vec3 {
    vec3(v.x as Real, v.y as Real, v.z as Real)
}

/// A ray through the ball of `radius` around the origin, with a direction of any length. One in four has zero
/// components, of either sign.
fn random_ray(radius: f64, rng: &mut SplitMix64) -> Ray {
    let origin = rng.in_ball(DVec3::ZERO, 2.0 * radius);
    let target = rng.in_ball(DVec3::ZERO, radius);
    let mut direction = (target - origin) * rng.log_between(0.01, 100.0);
    if rng.below(4) == 0 {
        let zero = [0.0, -0.0][rng.below(2) as usize];
        match rng.below(6) {
            0 => direction = dvec3(direction.x, zero, -zero),
            1 => direction = dvec3(zero, direction.y, zero),
            2 => direction = dvec3(-zero, zero, direction.z),
            3 => direction.x = zero,
            4 => direction.y = zero,
            _ => direction.z = zero,
        }
    }
    Ray::new(narrow(origin), narrow(direction))
}

fn random_scene(items: u32, rng: &mut SplitMix64) -> TestScene {
    let mut scene = TestScene::new();
    for _ in 0..items {
        // Many planes would hide everything else.
        let kind = loop {
            let kind = TestShapeKind::ALL[rng.below(TestShapeKind::ALL.len() as u32) as usize];
            if kind != TestShapeKind::Plane || rng.below(8) == 0 {
                break kind;
            }
        };
        let center = rng.in_ball(DVec3::ZERO, 8.0);
        let size = rng.log_between(0.1, 3.0);
        scene.add_shape(&TestShape::random(kind, center, size, rng));
    }
    scene
}

#[test]
fn every_accelerator_agrees_with_the_list_in_random_scenes() {
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
fn the_nearest_hit_is_the_nearest_of_the_hits_of_each_item_alone() {
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
fn the_lowest_id_wins_among_equal_items() {
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
fn the_lower_id_wins_a_tie_in_any_order() {
    let down = Ray::new(vec3(0.25, 0.25, 4.0), vec3(0.0, 0.0, -1.0));
    let corners = [vec3(-1.0, -1.0, 0.0), vec3(3.0, -1.0, 0.0), vec3(-1.0, 3.0, 0.0)];
    // The tops of all of them lie in z = 0.
    let add: [fn(&mut TestScene, [Vec3; 3]) -> ItemId; 6] = [
        |scene, corners| scene.triangle(corners),
        |scene, [a, b, c]| scene.triangle([b, c, a]),
        |scene, corners| scene.polygon(&corners, &[]),
        |scene, _| scene.disc(Vec3::ZERO, Vec3::Z, 1.0),
        |scene, _| scene.plane(vec3(5.0, 0.0, 0.0), Vec3::Z),
        |scene, _| scene.cuboid(vec3(-1.0, -1.0, -1.0), vec3(1.0, 1.0, 0.0)),
    ];
    let mut rng = SplitMix64::new(SEED + 4);
    for first in 0..add.len() {
        // Each time another one comes first.
        let mut scene = TestScene::new();
        for i in 0..add.len() {
            add[(first + i) % add.len()](&mut scene, corners);
        }
        for _ in 0..20 {
            let world = World::new(scene.as_scene(), PermutedList::random(scene.item_count(), &mut rng));
            assert_eq!(nearest(&world, &down, Real::MAX), Some(Hit { t: 4.0, item: ItemId(0) }), "{first}");
        }
        assert_eq!(all_agree(&scene, &[down], &mut rng), 1);
    }
}

#[test]
fn flat_items_agree_with_the_list() {
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
    // From above; in their planes, along axes and oblique; from their edges and corners.
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
fn a_ray_along_an_axis_through_rows_of_boxes_hits_the_first_of_its_row() {
    // The boxes touch, and half of the rays run in their faces.
    let mut scene = TestScene::new();
    for (x, y, z) in (0..64).map(|i| (i % 4, i / 4 % 4, i / 16)) {
        let min = vec3(x as Real, y as Real, z as Real);
        scene.cuboid(min, min + Vec3::ONE);
    }
    let mut rays = Vec::new();
    for zero in [0.0, -0.0] {
        for (i, j) in (0..81).map(|i| (i % 9, i / 9)) {
            let (a, b) = (0.5 * i as Real, 0.5 * j as Real);
            for (start, direction) in [(-1.0, 1.0), (5.0, -2.0), (1.0, 1.0), (1.5, -1.0)] {
                rays.push(Ray::new(vec3(start, a, b), vec3(direction, zero, zero)));
                rays.push(Ray::new(vec3(a, start, b), vec3(-zero, direction, zero)));
                rays.push(Ray::new(vec3(a, b, start), vec3(zero, -zero, direction)));
            }
        }
    }
    let mut rng = SplitMix64::new(SEED + 6);
    assert_eq!(all_agree(&scene, &rays, &mut rng), rays.len());
    // On paper: the first box of a row has the id 4 (y + 4 z); of two boxes that share a face the lower id
    // wins.
    let world = World::new(scene.as_scene(), List::without_bounds(64));
    for (y, z, row) in
        [(0.5, 0.5, 0), (1.5, 2.5, 4 * (1 + 4 * 2)), (1.0, 0.5, 0), (4.0, 4.0, 60), (2.0, 3.0, 36)]
    {
        let hit = nearest(&world, &Ray::new(vec3(-1.0, y, z), Vec3::X), Real::MAX);
        assert_eq!(hit, Some(Hit { t: 1.0, item: ItemId(row) }), "{y} {z}");
    }
}

#[test]
fn a_hit_at_t_max_counts_and_one_beyond_does_not() {
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
    assert_eq!(nearest(&world, &ray, Real::NAN).map(|hit| hit.item.0), Some(0), "NaN is no limit");
}

#[test]
fn nothing_is_hit_in_an_empty_scene() {
    let scene = TestScene::new();
    assert_eq!(all_agree(&scene, &[Ray::new(Vec3::ZERO, Vec3::X)], &mut SplitMix64::new(SEED + 7)), 0);
    assert_eq!(group_count(0), 0);
    assert!(List::with_boxes(&[], &mut []).is_ok_and(|list| list.size_in_bytes() == 0));
}
