//! A grid and an octree find the same hits in buffers of any size, from the smallest that is accepted.

use strahl_core::accel::{Buffer, BuildError, Grid, GridSize, Octree, OctreeNode, OctreeSize, StaticGrid};
use strahl_core::geometry::{Aabb, ItemId, Ray};
use strahl_core::{Real, Vec3, vec3};
use strahl_test_scene::SplitMix64;

use crate::check::AcceleratorCheck;
use crate::{random_ray, random_scene};

const SEED: u64 = 0x5eed_0014;

#[test]
fn buffers_of_every_accepted_size_give_the_same_hits() {
    let mut rng = SplitMix64::new(SEED);
    let mut scene = random_scene(39, &mut rng);
    scene.plane(vec3(0.0, 0.0, -9.0), Vec3::Z);
    let rays: Vec<Ray> = (0..20).map(|_| random_ray(9.0, &mut rng)).collect();
    let check = AcceleratorCheck::new(&scene, &rays, &mut rng);
    let items = check.boxes.iter().filter(|aabb| **aabb != Aabb::EMPTY).count();
    let (grid, octree) = (GridSize::recommended(&check.boxes), OctreeSize::recommended(items));
    assert!(grid.cells > 100 && grid.entries > items && items < 40, "{grid:?}");
    for cells in 2..grid.cells {
        let more = items + cells % 50;
        let octree = OctreeSize { nodes: 1 + cells % octree.nodes, entries: more };
        check.check_grid_and_octree::<8>(GridSize { cells, entries: grid.entries }, octree);
    }
    for items in items..grid.entries {
        let octree = OctreeSize { entries: items, ..octree };
        check.check_grid_and_octree::<8>(GridSize { cells: grid.cells, entries: items }, octree);
    }
}

#[test]
fn a_buffer_that_is_one_entry_too_small_is_refused_with_both_sizes() {
    let mut rng = SplitMix64::new(SEED + 1);
    let mut scene = random_scene(29, &mut rng);
    scene.plane(Vec3::ZERO, Vec3::Z);
    let boxes = scene.bounds();
    let needed = boxes.iter().filter(|aabb| **aabb != Aabb::EMPTY).count();
    assert!(needed < 30, "planes have no bounds");
    let too_small = |buffer, needed, provided| Some(BuildError::BufferTooSmall { buffer, needed, provided });

    let (mut cells, mut nodes) = (vec![0; 2], vec![OctreeNode::EMPTY; 1]);
    let mut items = vec![0; needed];
    let grid = |cells: &mut [u32], items: &mut [u32]| Grid::<8>::build(&boxes, cells, items).err();
    assert_eq!(grid(&mut cells[..0], &mut items), too_small(Buffer::Cells, 2, 0));
    assert_eq!(grid(&mut cells[..1], &mut items), too_small(Buffer::Cells, 2, 1));
    assert_eq!(grid(&mut cells, &mut items[..needed - 1]), too_small(Buffer::Entries, needed, needed - 1));
    assert_eq!(grid(&mut cells, &mut items), None);
    let octree = |nodes: &mut [OctreeNode], items: &mut [u32]| Octree::<8>::build(&boxes, nodes, items).err();
    assert_eq!(octree(&mut nodes[..0], &mut items), too_small(Buffer::Nodes, 1, 0));
    assert_eq!(octree(&mut nodes, &mut items[..needed - 1]), too_small(Buffer::Entries, needed, needed - 1));
    assert_eq!(octree(&mut nodes, &mut items), None);
    assert_eq!(too_small(Buffer::Cells, 2, 1).unwrap().to_string(), "cells: 2 needed, 1 provided");
}

#[test]
fn the_recommended_size_is_exactly_what_a_grid_uses() {
    let mut rng = SplitMix64::new(SEED + 2);
    for items in [1, 2, 10, 100, 1000] {
        let boxes = random_scene(items, &mut rng).bounds();
        let size = GridSize::recommended(&boxes);
        let (mut cells, mut entries) = (vec![0; size.cells], vec![0; size.entries]);
        let grid = Grid::<8>::build(&boxes, &mut cells, &mut entries).unwrap();
        assert_eq!((grid.cell_count() + 1, grid.entry_count()), (size.cells, size.entries));
        let bytes = 4 * (size.cells + size.entries) + size_of_val(&boxes[..]);
        assert_eq!(
            (grid.size_in_bytes(), grid.without_item_bounds().size_in_bytes()),
            (bytes, bytes - size_of_val(&boxes[..]))
        );
        // One entry less of either buffer gives a coarser grid.
        for (less_cells, less_items) in [(1, 0), (0, 1)].into_iter().filter(|_| items >= 100) {
            let (cells, entries) =
                (&mut vec![0; size.cells - less_cells], &mut vec![0; size.entries - less_items]);
            assert!(Grid::<8>::build(&boxes, cells, entries).unwrap().cell_count() < size.cells - 1);
        }
    }
}

#[test]
fn larger_buffers_give_an_octree_smaller_leaves() {
    let mut rng = SplitMix64::new(SEED + 3);
    let boxes: Vec<Aabb> = (0..1000)
        .map(|_| {
            let center = rng.in_ball(strahl_test_scene::DVec3::ZERO, 10.0);
            let (x, y, z) = (center.x as Real, center.y as Real, center.z as Real);
            Aabb { min: vec3(x, y, z), max: vec3(x, y, z) + 0.1 }
        })
        .collect();
    let mean = |provided: usize| {
        let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; provided], vec![0; 8000]);
        let tree = Octree::<8>::build(&boxes, &mut nodes, &mut items).unwrap();
        assert!(
            tree.node_count() <= provided
                && tree.size_in_bytes() >= 4 * tree.entry_count() + 8 * tree.node_count()
        );
        tree.entry_count() as f64 / tree.occupied_leaf_count() as f64
    };
    let means = [1, 9, 80, 400, 4001].map(mean);
    assert!(means.is_sorted_by(|more, less| more > less), "{means:?}");
    assert!(means[0] == 1000.0 && means[4] < 10.0, "{means:?}");
}

#[test]
fn bounds_that_are_not_finite_are_refused_with_their_item() {
    let unit = Aabb { min: Vec3::ZERO, max: Vec3::ONE };
    for bad in [Real::NAN, Real::INFINITY, Real::NEG_INFINITY, Real::MAX] {
        for boxes in [
            [unit, Aabb::EMPTY, Aabb { max: vec3(1.0, bad, 1.0), ..unit }],
            [unit, Aabb::EMPTY, Aabb { min: vec3(0.0, 0.0, bad), ..unit }],
        ] {
            let error = Some(BuildError::NotFinite { item: ItemId(2) });
            assert_eq!(Grid::<8>::build(&boxes, &mut [0; 9], &mut [0; 9]).err(), error, "{bad}");
            let nodes = &mut [OctreeNode::EMPTY; 9];
            assert_eq!(Octree::<8>::build(&boxes, nodes, &mut [0; 9]).err(), error, "{bad}");
        }
    }
}

#[test]
fn a_grid_with_buffers_of_constant_size_agrees_with_the_list() {
    const ITEMS: usize = 50;
    const SIZE: GridSize = GridSize::estimated(ITEMS);
    let mut rng = SplitMix64::new(SEED + 4);
    let scene = random_scene(ITEMS as u32, &mut rng);
    let rays: Vec<Ray> = (0..200).map(|_| random_ray(9.0, &mut rng)).collect();
    let check = AcceleratorCheck::new(&scene, &rays, &mut rng);
    let mut memory = StaticGrid::<{ SIZE.cells }, { SIZE.entries }>::new();
    check.check("static", memory.build::<8>(&check.boxes).unwrap());
    let mut smallest = StaticGrid::<2, ITEMS>::new();
    check.check("static and small", smallest.build::<0>(&check.boxes).unwrap());
}
