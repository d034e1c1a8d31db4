//! Items that move while the shutter is open.

use crate::*;

/// A random ray at a random time, often 0 or 1.
fn timed_ray(radius: f64, rng: &mut SplitMix64) -> Ray {
    let time = [0.0, 1.0, 0.5, rng.unit() as Real][rng.below(4) as usize];
    random_ray(radius, rng).with_time(time)
}

/// Random shapes. Every third has a motion: of length zero, along an axis, or arbitrary.
fn moving_scene(items: u32, rng: &mut SplitMix64) -> TestScene {
    let mut scene = random_scene(items, rng);
    for item in (0..items).filter(|item| item % 3 == 0) {
        let mut direction = || narrow(rng.in_ball(DVec3::ZERO, 3.0));
        let (opening, closing) = match item % 4 {
            0 => (Vec3::ZERO, Vec3::ZERO),
            1 => (Vec3::ZERO, Vec3::X * direction().x),
            _ => (direction(), direction()),
        };
        scene.set_motion(ItemId(item), opening, closing);
    }
    scene
}

#[test]
fn every_accelerator_finds_moving_items_at_the_time_of_the_ray() {
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
fn a_moving_item_is_hit_like_a_static_one_at_its_position() {
    // Coordinates are multiples of 1/16, so that moving the sphere rounds nothing.
    let mut rng = SplitMix64::new(SEED + 11);
    let exact = |v: Vec3| (v * 16.0).round() / 16.0;
    let mut hits = 0;
    for _ in 0..400 {
        let (center, radius) =
            (exact(narrow(rng.in_ball(DVec3::ZERO, 3.0))), 1.0 + rng.below(16) as Real / 16.0);
        let direction = exact(narrow(rng.in_ball(DVec3::ZERO, 4.0)));
        let (mut moving, mut fixed) = (TestScene::new(), TestScene::new());
        let sphere = moving.sphere(center - direction, radius);
        moving.set_motion(sphere, Vec3::ZERO, direction * 4.0);
        fixed.sphere(center, radius);
        for _ in 0..10 {
            let ray = random_ray(4.0, &mut rng);
            let ray = Ray::new(exact(ray.origin), ray.direction).with_time(0.25);
            let world = World::new(moving.as_scene(), List::without_bounds(1));
            let expected = World::new(fixed.as_scene(), List::without_bounds(1));
            let (hit, want) = (nearest(&world, &ray, Real::MAX), nearest(&expected, &ray, Real::MAX));
            // The bounds of the static sphere are tighter, so that a few grazing hits may differ.
            if let (Some(hit), Some(want)) = (hit, want) {
                hits += 1;
                let (a, b) = (hit.t, want.t);
                assert!((a - b).abs() <= 4.0 * Real::EPSILON * b, "{a} {b}");
                let surfaces = (
                    world.surface_interaction::<AllEffects>(&ray, hit),
                    expected.surface_interaction::<AllEffects>(&ray, want),
                );
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
