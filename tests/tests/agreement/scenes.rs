//! Property tests: generated scenes, which are reduced to a minimal one when a test fails.

use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use strahl_core::accel::{BvhSize, GridSize, OctreeSize};
use strahl_core::geometry::Ray;
use strahl_core::{Real, Vec3, vec3};
use strahl_test_scene::{SplitMix64, TestScene};

use crate::check::AcceleratorCheck;

/// A coordinate: an integer, next to one, or arbitrary.
fn coordinate() -> impl Strategy<Value = Real> {
    prop_oneof![
        4 => (-8_i8..=8).prop_map(Real::from),
        2 => (-64_i8..=64).prop_map(|x| Real::from(x) / 8.0),
        1 => (-8_i8..=8).prop_map(|x| Real::from(x).next_up()),
        3 => -8.0..8.0_f32,
        1 => Just(0.0),
    ]
}

fn point() -> impl Strategy<Value = Vec3> {
    (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| vec3(x, y, z))
}

/// Extent of an item: none, tiny, a cell, or the whole scene.
fn size() -> impl Strategy<Value = Real> {
    prop_oneof![2 => Just(0.0), 2 => Just(1.0), 1 => Just(1e-6), 2 => 0.001..2.0_f32, 1 => Just(16.0)]
}

/// An item.
#[derive(Clone, Copy, Debug)]
enum ItemBox {
    Box(Vec3, Vec3),
    Sphere(Vec3, Real),
    Triangle(Vec3, Vec3, Vec3),
}

fn item() -> impl Strategy<Value = ItemBox> {
    let extent = || (size(), size(), size()).prop_map(|(x, y, z)| vec3(x, y, z));
    prop_oneof![
        (point(), extent()).prop_map(|(min, extent)| ItemBox::Box(min, min + extent)),
        (point(), 0.001..3.0_f32).prop_map(|(center, radius)| ItemBox::Sphere(center, radius)),
        (point(), point(), point()).prop_map(|(a, b, c)| ItemBox::Triangle(a, b, c)),
    ]
}

/// Up to 23 items, each with the number of its copies, mostly one.
fn items() -> impl Strategy<Value = Vec<(ItemBox, usize)>> {
    let times = prop_oneof![6 => Just(1_usize), 1 => Just(2), 1 => 3..40_usize];
    prop::collection::vec((item(), times), 0..24)
}

/// Rays between such points, so that many run along cell planes and through corners.
fn ray() -> impl Strategy<Value = (Vec3, Vec3)> {
    let zeros = prop_oneof![3 => Just([1.0, 1.0, 1.0]), 1 => Just([0.0, 1.0, 1.0]), 1 => Just([1.0, 0.0, -0.0]), 1 => Just([-0.0, 0.0, 1.0]), 1 => Just([0.0, 1.0, 0.0])];
    let far = prop_oneof![6 => Just(1.0), 1 => Just(1e5_f32)];
    (point(), point(), zeros, far)
        .prop_map(|(from, to, [x, y, z], far)| (from * far, (to - from * far) * vec3(x, y, z)))
        .prop_filter("zero direction", |(_, direction)| *direction != Vec3::ZERO)
}

fn built(items: &[(ItemBox, usize)]) -> TestScene {
    let mut scene = TestScene::new();
    for (item, times) in items {
        for _ in 0..*times {
            match *item {
                ItemBox::Box(min, max) => scene.cuboid(min, max),
                ItemBox::Sphere(center, radius) => scene.sphere(center, radius),
                ItemBox::Triangle(a, b, c) => scene.triangle([a, b, c]),
            };
        }
    }
    scene
}

#[test]
fn every_accelerator_agrees_with_the_list_in_any_scene() {
    let config = Config { cases: 400, failure_persistence: None, ..Config::default() };
    let random = TestRng::from_seed(RngAlgorithm::ChaCha, &[0x5e; 32]);
    let mut runner = TestRunner::new_with_rng(config, random);
    let rays = prop::collection::vec(ray(), 12..24);
    let hits = Cell::new(0);
    runner
        .run(&(items(), rays, any::<u64>()), |(items, rays, seed)| {
            let scene = built(&items);
            let rays: Vec<Ray> =
                rays.into_iter().map(|(from, direction)| Ray::new(from, direction)).collect();
            let rng = &mut SplitMix64::new(seed);
            let check = AcceleratorCheck::new(&scene, &rays, rng);
            let (count, boxes) = (scene.item_count() as usize, &check.boxes);
            let (grid, octree) = (GridSize::recommended(boxes), OctreeSize::recommended(count));
            let mut any = |min: usize, max: usize| min + rng.below((max - min + 1) as u32) as usize;
            let coarse = GridSize { cells: any(2, grid.cells), entries: grid.entries };
            let shallow = OctreeSize { nodes: any(1, octree.nodes), entries: octree.entries };
            hits.set(hits.get() + check.hits());
            check.check_grid_and_octree::<8>(grid, octree);
            check.check_grid_and_octree::<0>(coarse, shallow);
            check.check_grid_and_octree::<1>(grid, shallow);
            check.check_grid_and_octree::<64>(coarse, octree);
            check.check_bvh(BvhSize::recommended(count).nodes);
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
    assert!(hits.get() > 1_000, "only {} hits", hits.get());
}
