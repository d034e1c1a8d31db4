//! The list with bounding volumes of items and of groups.

use crate::*;

#[test]
fn full_groups_and_groups_with_one_item_agree_with_the_list() {
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
fn too_few_groups_are_refused_with_both_sizes() {
    for (items, needed) in [(1, 1), (16, 1), (17, 2), (32, 2), (33, 3), (1000, 63)] {
        assert_eq!(group_count(items), needed);
        let boxes = vec![Aabb { min: Vec3::ZERO, max: Vec3::ONE }; items];
        let mut groups = vec![Aabb::EMPTY; needed + 1];
        for provided in 0..needed {
            let error = List::with_boxes(&boxes, &mut groups[..provided]).unwrap_err();
            assert_eq!(error, BuildError::BufferTooSmall { buffer: Buffer::GroupBounds, needed, provided });
            assert_eq!(error.to_string(), format!("group bounds: {needed} needed, {provided} provided"));
        }
        let mut spheres = vec![BoundingSphere::EMPTY; items];
        let error = List::with_spheres(&boxes, &mut spheres[1..], &mut []).unwrap_err();
        assert_eq!(
            error,
            BuildError::BufferTooSmall { buffer: Buffer::ItemBounds, needed: items, provided: items - 1 }
        );
        let error = List::with_spheres(&boxes, &mut spheres, &mut []).unwrap_err();
        assert_eq!(error, BuildError::BufferTooSmall { buffer: Buffer::GroupBounds, needed, provided: 0 });
        for provided in [needed, needed + 1] {
            let list = List::with_boxes(&boxes, &mut groups[..provided]).unwrap();
            assert_eq!(list.size_in_bytes(), (items + needed) * size_of::<Aabb>());
        }
    }
}

#[test]
fn bounds_save_shape_tests_and_groups_save_box_tests() {
    let mut rng = SplitMix64::new(SEED + 8);
    let mut scene = TestScene::new();
    for i in 0..320 {
        // Neighbors in the list are neighbors in space; otherwise groups would save nothing.
        let center = dvec3(f64::from(i) - 160.0, 0.0, 0.0);
        scene.add_shape(&TestShape::random(TestShapeKind::Sphere, center, 0.5, &mut rng));
    }
    let boxes = scene.bounds();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let bounded = World::new(scene.as_scene(), List::with_boxes(&boxes, &mut groups).unwrap());
    let (mut spheres, mut groups_of_spheres) =
        (vec![BoundingSphere::EMPTY; boxes.len()], vec![BoundingSphere::EMPTY; group_count(boxes.len())]);
    let with_spheres = World::new(
        scene.as_scene(),
        List::with_spheres(&boxes, &mut spheres, &mut groups_of_spheres).unwrap(),
    );
    let unbounded = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let rays: Vec<Ray> = (0..100)
        .map(|_| {
            let origin = rng.in_ball(dvec3(0.0, 100.0, 0.0), 50.0);
            Ray::new(narrow(origin), narrow(rng.in_ball(DVec3::ZERO, 50.0) - origin))
        })
        .collect();

    let mut without = Counters::new();
    let mut with = Counters::new();
    let mut by_spheres = Counters::new();
    for ray in &rays {
        with_spheres.nearest_hit::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut by_spheres);
        unbounded.nearest_hit::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut without);
        bounded.nearest_hit::<AllEffects, _>(ray, Real::MAX, RayKind::Camera, &mut (), &mut with);
    }
    let kind = RayKind::Camera;
    assert_eq!(
        (without.shape_tests[kind], without.box_tests[kind], without.leaf_visits[kind]),
        (32_000, 0, 100)
    );
    assert!(
        by_spheres.shape_tests[kind] < 6_400 && by_spheres.shape_tests[kind] >= with.shape_tests[kind],
        "{by_spheres:?}"
    );
    // Far above the counts that are measured.
    assert!(with.shape_tests[kind] < 3_200, "{with:?}");
    assert!(with.box_tests[kind] >= 2_000 && with.box_tests[kind] < 16_000, "{with:?}");
    assert_eq!(
        with.box_tests[kind],
        2_000 + 16 * with.leaf_visits[kind],
        "all groups, and the contents of those that are hit"
    );
}
