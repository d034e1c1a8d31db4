//! Memory of the core: it is provided by the caller, bounded, and never allocated. Buffers that are too small
//! are refused or cost time, and never change a picture.

#![expect(unsafe_code, reason = "an allocator implements an unsafe trait")]

mod effects;
mod levels;
mod pictures;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use strahl_core::accel::{Accelerator, List, group_count};
use strahl_core::geometry::{Aabb, ItemId, ShapeKind, ShapeKindSet};
use strahl_core::image::{
    AdaptiveSampler, CacheEntry, Confidence, ContrastThreshold, CornerRowCache, Filter, Framebuffer, Pixel,
    PixelSelection, PixelSelector, PretracedCorners, RegularSampler, Sampler, Sink, StochasticSampler,
    Subdivision, UncachedCorners, UpperLeftCornerSampler,
};
use strahl_core::math::{SobolSequence, try_normalize};
use strahl_core::render::render_selected;
use strahl_core::scene::{
    CameraSample, EffectSet, Effects, FilmPoint, FresnelModel, LevelLimitRadiance, LightKind, LightKindSet,
    Texture, TextureKind, TextureKindSet,
};
use strahl_core::tally::{CountedEvent, Counters, RayKind, Tally};
use strahl_core::trace::{HitId, PixelSample, RayTracer, TracerError};
use strahl_core::{
    AllEffects, Background, Camera, CameraDescriptor, CenterSampler, Falloff, Light, LightSource, Limits,
    ListWithoutBounds, Material, Projection, Real, Resolution, Rgb, Scene, Tile, Tracer, Vec3, Worker, World,
    render, vec3,
};
use strahl_test_scene::{DVec3, SplitMix64, TestScene, TestShape, TestShapeKind};

const SEED: u64 = 0x5eed_0004;

/// The system's allocator, with a count of the allocations of each thread.
struct CountingAllocator;

thread_local! {
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

// SAFETY: all calls are forwarded to the system's allocator. Counting allocates nothing: the count is
// initialized in a constant and has no destructor.
unsafe impl GlobalAlloc for CountingAllocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static GLOBAL: CountingAllocator = CountingAllocator;

/// Number of allocations of `work`.
fn allocations(work: impl FnOnce()) -> u64 {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

const VIEW: CameraDescriptor = CameraDescriptor {
    position: vec3(0.0, 1.0, 9.0),
    target: vec3(0.0, 0.0, 0.0),
    up: vec3(0.0, 1.0, 0.0),
    projection: Projection::Perspective { field_of_view: 0.9 },
};

fn size(width: u32, height: u32) -> Resolution {
    Resolution::new(width, height).unwrap()
}

/// All shapes in matte, mirror and glass materials, under all kinds of light.
fn mixed_scene() -> TestScene {
    let mut rng = SplitMix64::new(SEED);
    let mut scene = TestScene::new();
    let checker = scene.add_texture(Texture::Checker {
        even: Rgb::WHITE,
        odd: Rgb::gray(0.25),
        origin: Vec3::ZERO,
        frequency: vec3(1.0, 0.0, 1.0),
    });
    let shiny = Material {
        highlight: Rgb::gray(0.5),
        highlight_exponent: 20.0,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    let materials = [
        Material { texture: checker, ..shiny },
        Material { reflection: Rgb::gray(0.5), ..shiny },
        Material {
            transmission: Rgb::gray(0.9),
            refractive_index: 1.5,
            fresnel: FresnelModel::Dielectric,
            attenuation_length: Rgb::new(3.0, 4.0, 5.0),
            diffuse: Rgb::BLACK,
            ..shiny
        },
    ];
    scene.material(materials[0]);
    scene.plane(vec3(0.0, -3.0, 0.0), Vec3::Y);
    for i in 0..40 {
        scene.material(materials[i % 3]);
        let kind = TestShapeKind::ALL[i % TestShapeKind::ALL.len()];
        if kind != TestShapeKind::Plane {
            let center = rng.in_ball(DVec3::ZERO, 3.0);
            scene.add_shape(&TestShape::random(kind, center, 0.8, &mut rng));
        }
    }
    let falloff = Falloff { constant: 1.0, linear: 0.01, quadratic: 0.0 };
    let position = vec3(6.0, 8.0, 3.0);
    let direction = try_normalize(-position).unwrap();
    for source in [
        LightSource::Point { position: vec3(-5.0, 9.0, 6.0), falloff },
        LightSource::Directional { to_light: Vec3::Y },
        LightSource::Spot { position, direction, cos_inner: 0.95, cos_outer: 0.9, falloff },
    ] {
        scene.lights.push(Light { source, color: Rgb::gray(0.4), casts_shadows: true });
    }
    scene.ambient = Rgb::gray(0.1);
    scene.background =
        Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::new(0.2, 0.4, 0.9) };
    scene
}

/// Renders a picture, and returns it with its counters.
fn picture<A: Accelerator, E: Effects, const LEVELS: usize>(
    world: &World<'_, A>,
    size: Resolution,
    limits: Limits,
    sampler: &mut impl Sampler,
) -> (Vec<Rgb>, Counters) {
    let camera = Camera::new(&VIEW, size).unwrap();
    let tracer = Tracer::<_, E, LEVELS>::new(world, camera, limits).unwrap();
    let tile = Tile::full(size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Framebuffer::new(tile, &mut colors).unwrap();
    let mut worker = Worker::new(Counters::new());
    let Ok(()) = render(&mut tracer.with_worker(&mut worker), sampler, tile.pixels(), &mut frame);
    (colors, worker.into_tally())
}

#[test]
fn the_core_allocates_no_memory() {
    // The caller provides all buffers.
    let scene = mixed_scene();
    let boxes = scene.bounds();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let size = size(24, 16);
    let tile = Tile::full(size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut corners = vec![PixelSample::BLACK; PretracedCorners::corner_tile(tile).len()];
    let mut row = vec![PixelSample::BLACK; 25];
    let mut cache = vec![CacheEntry::EMPTY; 500];
    let colors_agree = ContrastThreshold::new(0.05).unwrap();

    assert_eq!(allocations(|| drop(std::hint::black_box(Box::new(1)))), 1, "allocations are counted");
    let count = allocations(|| {
        let boxed = List::with_boxes(&boxes, &mut groups).unwrap();
        let world = World::new(Scene::new(scene.descriptor()).unwrap(), boxed);
        let camera = Camera::new(&VIEW, size).unwrap();
        let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT).unwrap();
        let mut worker = Worker::new(Counters::new());
        let mut frame = Framebuffer::new(tile, &mut colors).unwrap();
        let Ok(()) =
            render(&mut tracer.with_worker(&mut worker), &mut CenterSampler, tile.pixels(), &mut frame);
        let Ok(()) = render(
            &mut tracer.with_worker(&mut worker),
            &mut RegularSampler::new(2).unwrap(),
            tile.pixels(),
            &mut frame,
        );
        let ends = Confidence { standard_errors: 2.0, tolerance: 0.02 };
        let mut stochastic =
            StochasticSampler::with_range(4, 16, ends).unwrap().with_filter(Filter::Gaussian);
        let Ok(()) = render(&mut tracer.with_worker(&mut worker), &mut stochastic, tile.pixels(), &mut frame);
        let subdivision = Subdivision::new(3, colors_agree).unwrap();
        let mut adaptive = AdaptiveSampler::new(subdivision, CornerRowCache::new(&mut row), &mut cache);
        let Ok(()) = render(&mut tracer.with_worker(&mut worker), &mut adaptive, tile.pixels(), &mut frame);
        let all = PretracedCorners::corner_tile(tile);
        let mut corner_frame = Framebuffer::new(all, &mut corners).unwrap();
        let Ok(()) = render(
            &mut tracer.with_worker(&mut worker),
            &mut UpperLeftCornerSampler(subdivision),
            all.pixels(),
            &mut corner_frame,
        );
        let mut adaptive =
            AdaptiveSampler::new(subdivision, PretracedCorners::new(tile, &corners).unwrap(), &mut cache);
        let Ok(()) = render(&mut tracer.with_worker(&mut worker), &mut adaptive, tile.pixels(), &mut frame);
        let selection = PixelSelection::new(8, colors_agree).unwrap();
        let mut selected = PixelSelector::new(selection, CenterSampler, UncachedCorners, &mut cache);
        let block_corners = selection.block_range(tile).pixels();
        let Ok(()) =
            render_selected(&mut tracer.with_worker(&mut worker), &mut selected, block_corners, &mut frame);
        assert!(
            worker.tally().rays[RayKind::Transmitted] > 100 && worker.tally().rays[RayKind::Reflected] > 100
        );
    });
    assert_eq!(count, 0);
    assert!(colors.iter().any(|color| !color.is_black()));
}
