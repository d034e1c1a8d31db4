//! Levels of rays: at most `LEVELS`, whose tasks always fit.

use crate::*;

/// Parallel emitting planes, each half mirror and half glass of index 1. Every ray hits a plane, and so do
/// both of its children.
fn panes(levels: usize) -> TestScene {
    let mut scene = TestScene::new();
    let half = Rgb::gray(0.5);
    let diffuse = Rgb::BLACK;
    scene.material(Material {
        diffuse,
        reflection: half,
        transmission: half,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    });
    for i in 0..levels {
        let x = i as Real + 1.0;
        scene.plane(vec3(x, 0.0, 0.0), Vec3::X);
        scene.plane(vec3(-x, 0.0, 0.0), Vec3::X);
    }
    scene.ambient = Rgb::gray(0.25);
    scene
}

/// The ray through the center of the first pixel.
const CENTER: CameraSample =
    CameraSample { point: FilmPoint { x: 0.5, y: 0.5 }, sequence: SobolSequence::new(0, 0, 0, 0) };

/// A ray perpendicular to the panes, traced with a capacity of `LEVELS` levels.
fn full_tree<const LEVELS: usize>(levels: u8) -> (Rgb, Counters) {
    let scene = panes(levels.into());
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let view = CameraDescriptor { position: Vec3::ZERO, target: Vec3::X, up: Vec3::Y, ..VIEW };
    let limits = Limits { levels, cutoff: 0.0 };
    let tracer =
        Tracer::<_, AllEffects, LEVELS>::new(&world, Camera::new(&view, size(1, 1)).unwrap(), limits)
            .unwrap();
    let mut worker = Worker::new(Counters::new());
    (tracer.trace(CENTER, &mut worker).color, worker.into_tally())
}

#[test]
fn a_full_ray_tree_fits_into_a_task_stack_of_one_entry_per_level() {
    // Each level has twice the rays of half the weight, so that each adds the same light.
    for (levels, (color, counters)) in [
        (1, full_tree::<1>(1)),
        (2, full_tree::<2>(2)),
        (5, full_tree::<5>(5)),
        (12, full_tree::<12>(12)),
        // A larger capacity changes nothing.
        (5, full_tree::<64>(5)),
        (12, full_tree::<64>(12)),
    ] {
        let children = (1 << (levels - 1)) - 1;
        assert_eq!(color, Rgb::gray(0.25 * levels as Real), "{levels}");
        assert_eq!(counters.rays[RayKind::Camera], 1);
        assert_eq!(counters.rays[RayKind::Reflected], children, "{levels}");
        assert_eq!(counters.rays[RayKind::Transmitted], children, "{levels}");
        assert_eq!(counters.rays[RayKind::Shadow], 0);
    }
}

/// Stops a trace after this number of rays.
struct StopAfter(u64);

impl Tally for StopAfter {
    fn count(&mut self, event: CountedEvent) {
        self.0 = self.0.saturating_sub(u64::from(matches!(event, CountedEvent::Ray(_))));
    }

    fn is_cancelled(&mut self) -> bool {
        self.0 == 0
    }
}

#[test]
fn a_stopped_trace_ends_at_once_with_the_light_of_its_rays() {
    let scene = panes(64);
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let view = CameraDescriptor { position: Vec3::ZERO, target: Vec3::X, up: Vec3::Y, ..VIEW };
    let camera = Camera::new(&view, size(1, 1)).unwrap();
    // The whole tree has 2^64 rays.
    let limits = Limits { levels: 64, cutoff: 0.0 };
    let tracer = Tracer::<_, AllEffects, 64>::new(&world, camera, limits).unwrap();
    let mut worker = Worker::new(StopAfter(0));
    // One ray of each of the first levels: 1/4 times 1, 1/2, 1/4, ...
    for (rays, light) in [(1, 0.25), (2, 0.375), (3, 0.4375), (1, 0.25)] {
        worker.tally_mut().0 = rays;
        assert_eq!(tracer.trace(CENTER, &mut worker).color, Rgb::gray(light), "{rays}");
        assert_eq!(worker.tally().0, 0);
    }
}

#[test]
fn a_larger_capacity_of_levels_gives_the_same_picture() {
    let scene = mixed_scene();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let limits = |levels| Limits { levels, ..Limits::DEFAULT };
    let s = size(24, 16);
    let one = picture::<_, AllEffects, 1>(&world, s, limits(1), &mut CenterSampler);
    assert_eq!(picture::<_, AllEffects, 64>(&world, s, limits(1), &mut CenterSampler), one);
    let two = picture::<_, AllEffects, 2>(&world, s, limits(2), &mut CenterSampler);
    assert_eq!(picture::<_, AllEffects, 5>(&world, s, limits(2), &mut CenterSampler), two);
    let five = picture::<_, AllEffects, 5>(&world, s, limits(5), &mut CenterSampler);
    assert_eq!(picture::<_, AllEffects, 64>(&world, s, limits(5), &mut CenterSampler), five);
    assert!(one.0 != two.0 && two.0 != five.0);
}

#[test]
fn a_tracer_refuses_more_levels_than_its_capacity() {
    let scene = TestScene::new();
    let world = World::new(scene.as_scene(), List::without_bounds(0));
    let camera = Camera::new(&VIEW, size(2, 2)).unwrap();
    let error = |levels, cutoff| {
        Tracer::<_, AllEffects, 5>::new(&world, camera, Limits { levels, cutoff })
            .err()
            .map(|e| e.to_string())
    };
    for (levels, cutoff) in [(1, 0.0), (5, 1.0), (5, 1.0 / 512.0)] {
        assert_eq!(error(levels, cutoff), None);
    }
    for levels in [0, 6, 255] {
        assert_eq!(
            error(levels, 0.0),
            Some(format!("`levels` is {levels}, must be in 1..=5: `LEVELS` of the tracer"))
        );
    }
    for (cutoff, shown) in [(-0.001, "-0.001"), (1.001, "1.001"), (Real::NAN, "NaN"), (Real::INFINITY, "inf")]
    {
        assert_eq!(error(5, cutoff).unwrap(), format!("`cutoff` is {shown}, must be in 0..=1"));
    }
}

#[test]
fn an_overflow_of_the_medium_stack_is_counted() {
    // Six shells of glass around the target: the fifth and sixth are not entered.
    let mut scene = TestScene::new();
    scene.material(Material {
        transmission: Rgb::WHITE,
        refractive_index: 1.1,
        diffuse: Rgb::BLACK,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    });
    for radius in 1..7 {
        scene.sphere(Vec3::ZERO, radius as Real);
    }
    let limits = Limits { levels: 64, cutoff: 0.0 };
    let (_, counters) = scene.trace_counted(vec3(0.0, 0.0, 20.0), vec3(0.1, 0.2, 0.0), limits);
    assert_eq!(counters.medium_stack_full, 2);
    assert_eq!(counters.rays[RayKind::Transmitted], 12, "tracing continues");
}

#[test]
fn the_background_replaces_rays_below_the_last_level_and_distant_hits() {
    /// All effects, with the background beyond a distance of 4.5 and below the last level.
    struct LimitedDistance;
    impl Effects for LimitedDistance {
        const SET: EffectSet = EffectSet::ALL;
        const MAX_DISTANCE: Real = 4.5;
        const LEVEL_LIMIT_RADIANCE: LevelLimitRadiance = LevelLimitRadiance::Background;
    }
    let mut scene = panes(1);
    scene.background = Background::Color(Rgb::gray(8.0));
    let color = |from: Real, levels| {
        let world = World::new(scene.as_scene(), ListWithoutBounds(scene.item_count()));
        let view =
            CameraDescriptor { position: vec3(from, 0.0, 0.0), target: vec3(from + 1.0, 0.0, 0.0), ..VIEW };
        let camera = Camera::new(&CameraDescriptor { up: Vec3::Y, ..view }, size(1, 1)).unwrap();
        let limits = Limits { levels, cutoff: 0.0 };
        let tracer = Tracer::<_, LimitedDistance, 3>::new(&world, camera, limits).unwrap();
        tracer.trace(CENTER, &mut Worker::new(())).color
    };
    // The pane, and the background for both of its children: the reflected ray would hit the other pane.
    assert_eq!(color(0.0, 1), Rgb::gray(0.25 + 8.0));
    // That pane is hit, and traces two rays in turn.
    assert_eq!(color(0.0, 2), Rgb::gray(0.25 + 4.0 + 0.5 * (0.25 + 8.0)));
    // From a distance of 4 the first pane is visible, from 4.75 it is not.
    assert_eq!(color(-5.0, 1), Rgb::gray(0.25 + 8.0));
    assert_eq!(color(-5.75, 1), Rgb::gray(8.0));
}
