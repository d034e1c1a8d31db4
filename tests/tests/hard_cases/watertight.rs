//! Watertight meshes: no ray escapes between the triangles of a closed mesh.

use strahl_core::accel::{
    Bvh, BvhEntry, BvhNode, BvhSize, Grid, GridSize, List, Octree, OctreeNode, OctreeSize, TraversalStack,
};
use strahl_core::geometry::Ray;
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Geometry, Material, MaterialId, Real, Scene, SceneDescriptor, World, vec3};
use strahl_test_scene::{DVec3, SplitMix64, dvec3};
use strahl_tests::hard::{ClosedMesh, escapes, odd_crossings};

const SEED: u64 = 0x5eed_0008;

/// Far from the origin, where coordinates are coarse.
const FAR: DVec3 = DVec3::new(2e5, -1.3e5, 0.7e5);

/// Meshes, and numbers of rays. A ray at the apex of a cone tests all of its slivers, so that it gets fewer
/// rays.
fn meshes() -> Vec<(&'static str, ClosedMesh, usize)> {
    vec![
        ("a sphere", ClosedMesh::icosphere(5, DVec3::ZERO, 1.0), 300_000),
        ("a sphere far away", ClosedMesh::icosphere(5, FAR, 100.0), 300_000),
        ("a cube", ClosedMesh::cube(dvec3(0.1, 0.2, 0.3), 1.0), 100_000),
        ("a cube far away", ClosedMesh::cube(FAR, 3.0), 100_000),
        ("a sheet", ClosedMesh::sheet(50, DVec3::ZERO, 1.0), 80_000),
        ("a sheet far away", ClosedMesh::sheet(50, FAR, 100.0), 80_000),
        ("a cone of slivers", ClosedMesh::fan(1000, DVec3::ZERO, 1.0), 20_000),
        ("a cone of slivers far away", ClosedMesh::fan(1000, FAR, 100.0), 20_000),
    ]
}

#[test]
fn none_of_a_million_rays_at_edges_and_vertices_escapes() {
    let mut rays = 0;
    for (name, mesh, count) in meshes() {
        assert_eq!(escapes(&mesh, count, &mut SplitMix64::new(SEED)), 0, "{name}");
        rays += count;
    }
    assert_eq!(rays, 1_000_000);
}

#[test]
fn a_ray_from_outside_crosses_a_closed_mesh_an_even_number_of_times() {
    for (name, mesh) in [
        ("a sphere", ClosedMesh::icosphere(3, DVec3::ZERO, 1.0)),
        ("a sphere far away", ClosedMesh::icosphere(3, FAR, 100.0)),
        ("a cube", ClosedMesh::cube(dvec3(0.1, 0.2, 0.3), 1.0)),
        ("a cube far away", ClosedMesh::cube(FAR, 3.0)),
    ] {
        assert_eq!(odd_crossings(&mesh, 5_000, &mut SplitMix64::new(SEED + 1)), 0, "{name}");
    }
}

#[test]
fn no_accelerator_lets_a_ray_through() {
    for (name, mesh, _) in meshes() {
        let (points, shapes) = mesh.tables();
        let geometry = Geometry { vertices: &points, shapes: &shapes, ..Geometry::EMPTY };
        let material_ids = vec![MaterialId(0); shapes.len()];
        let parts = SceneDescriptor {
            geometry,
            material_ids: &material_ids,
            materials: &[Material::MATTE],
            ..SceneDescriptor::EMPTY
        };
        let scene = Scene::new(parts).unwrap();
        let boxes: Vec<_> = geometry.all_bounds().collect();

        let mut rng = SplitMix64::new(SEED + 2);
        let rays: Vec<Ray> = (0..4_000)
            .map(|_| {
                let (ray, _) = mesh.aim(&mut rng);
                let narrow = |v: DVec3| vec3(v.x as f32, v.y as f32, v.z as f32);
                Ray::new(narrow(ray.origin), narrow(ray.direction))
            })
            .collect();
        let mut expected = Vec::new();

        macro_rules! assert_watertight {
            ($kind:literal, $accelerator:expr) => {
                let world = World::new(scene, $accelerator);
                let mut scratch = Default::default();
                for (i, ray) in rays.iter().enumerate() {
                    let hit = world.nearest_hit::<AllEffects, _>(
                        ray,
                        Real::MAX,
                        RayKind::Camera,
                        &mut scratch,
                        &mut (),
                    );
                    assert!(hit.is_some(), "{name}, {}: {ray:?}", $kind);
                    if expected.len() <= i {
                        expected.push(hit);
                    }
                    assert_eq!(hit, expected[i], "{name}, {}: {ray:?}", $kind);
                }
            };
        }

        let size = BvhSize::recommended(boxes.len());
        let (mut nodes, mut items) = (vec![BvhNode::EMPTY; size.nodes], vec![BvhEntry::EMPTY; size.entries]);
        assert_watertight!("BVH", Bvh::<TraversalStack<64>>::build(&boxes, &mut nodes, &mut items).unwrap());
        let size = GridSize::recommended(&boxes);
        let (mut cells, mut items) = (vec![0; size.cells], vec![0; size.entries]);
        assert_watertight!("grid", Grid::<64>::build(&boxes, &mut cells, &mut items).unwrap());
        let size = OctreeSize::recommended(boxes.len());
        let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; size.nodes], vec![0; size.entries]);
        assert_watertight!("octree", Octree::<64>::build(&boxes, &mut nodes, &mut items).unwrap());
        // The list tests all of thousands of triangles: a few rays are enough.
        let world = World::new(scene, List::without_bounds(shapes.len() as u32));
        for (ray, expected) in rays.iter().zip(&expected).take(100) {
            let hit = world.nearest_hit::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut ());
            assert_eq!(hit, *expected, "{name}, list: {ray:?}");
        }
    }
}
