//! Baked scenes: an opened scene equals the baked one, and other bytes are refused.

mod bytes;
mod round_trip;

use strahl_core::accel::{
    Accelerator, Bvh, BvhEntry, BvhNode, BvhSize, Grid, GridSize, List, Octree, OctreeNode, OctreeSize,
    TraversalHeap, TraversalStack,
};
use strahl_core::baked::{BakedAccelerator, BakedScene, BakedSceneError, BakedSceneWriter, BakedSection};
use strahl_core::geometry::Cone;
use strahl_core::image::Pixel;
use strahl_core::scene::{FresnelModel, Texture};
use strahl_core::{
    AllEffects, Background, Camera, CameraDescriptor, CenterSampler, Falloff, Light, LightSource, Limits,
    ListWithoutBounds, Material, Projection, Real, Resolution, Rgb, Scene, Tile, Tracer, Vec3, Worker, World,
    render, vec3,
};
use strahl_test_scene::{SplitMix64, TestScene};
use zerocopy::IntoBytes;

/// Bytes aligned to 4.
struct AlignedBytes {
    words: Vec<u32>,
    length: usize,
}

impl AlignedBytes {
    fn of(bytes: &[u8]) -> Self {
        let mut words = vec![0_u32; bytes.len().div_ceil(4)];
        words.as_mut_bytes()[..bytes.len()].copy_from_slice(bytes);
        AlignedBytes { words, length: bytes.len() }
    }

    fn bytes(&self) -> &[u8] {
        &self.words.as_bytes()[..self.length]
    }
}

const VIEW: CameraDescriptor = CameraDescriptor {
    position: vec3(0.5, 1.0, 9.0),
    target: Vec3::ZERO,
    up: Vec3::Y,
    projection: Projection::Perspective { field_of_view: 0.7 },
};
const SIZE: Resolution = Resolution::new(24, 16).unwrap();

/// Every kind of shape, texture and light, and many small spheres.
fn mixed_scene() -> TestScene {
    let mut scene = TestScene::new();
    let checker = scene.add_texture(Texture::Checker {
        even: Rgb::WHITE,
        odd: Rgb::gray(0.25),
        origin: Vec3::ZERO,
        frequency: vec3(1.0, 0.0, 1.0),
    });
    let gradient = scene.add_texture(Texture::Gradient {
        start_color: Rgb::new(0.9, 0.1, 0.2),
        end_color: Rgb::WHITE,
        origin: Vec3::ZERO,
        axis: Vec3::Y,
    });
    let shiny = Material {
        highlight: Rgb::gray(0.5),
        highlight_exponent: 20.0,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    scene.material(Material { texture: checker, two_sided: false, ambient: Rgb::WHITE, ..Material::MATTE });
    scene.plane(vec3(0.0, -2.0, 0.0), Vec3::Y);
    let zone_plate = scene.add_texture(Texture::ZonePlate {
        start_color: Rgb::BLACK,
        end_color: Rgb::WHITE,
        origin: Vec3::ZERO,
        frequency: 3.0,
    });
    scene.material(Material { texture: zone_plate, ..shiny });
    scene.triangle([vec3(-1.0, 2.0, -1.0), vec3(0.0, 2.0, -1.0), vec3(-0.5, 3.0, -1.0)]);
    scene.material(Material { texture: gradient, ..shiny });
    scene.disc(vec3(-2.0, 0.0, -1.0), vec3(1.0, 0.0, 2.0), 0.8);
    scene.triangle([vec3(2.0, -1.0, 0.0), vec3(3.0, -1.0, 0.0), vec3(2.5, 1.0, -0.5)]);
    let normals = [vec3(-0.2, 0.0, 1.0), vec3(0.2, 0.0, 1.0), vec3(0.0, 0.2, 1.0)];
    scene.smooth_triangle([vec3(-3.0, -1.0, 0.0), vec3(-2.0, -1.0, 0.0), vec3(-2.5, 1.0, 0.5)], normals);
    scene.polygon(
        &[vec3(0.0, 1.0, -2.0), vec3(1.0, 1.5, -2.0), vec3(2.0, 1.0, -2.0), vec3(1.0, 3.0, -2.0)],
        &[],
    );
    scene.material(Material { reflection: Rgb::new(0.7, 0.8, 0.9), ..shiny });
    let block = scene.cuboid(vec3(-1.0, -1.5, -1.0), vec3(0.0, -0.5, 0.0));
    scene.set_motion(block, Vec3::ZERO, vec3(0.0, 0.3, 0.5));
    scene.oriented_cuboid(vec3(1.5, -1.0, 1.0), vec3(0.4, 0.3, 0.2), vec3(1.0, 0.5, 0.0), Vec3::Z);
    scene.material(Material {
        transmission: Rgb::gray(0.9),
        refractive_index: 1.5,
        fresnel: FresnelModel::Dielectric,
        attenuation_length: Rgb::new(1.0, 2.0, Real::INFINITY),
        priority: 3,
        ..shiny
    });
    let cone = Cone::new(vec3(-1.5, -1.0, 1.5), 0.5, vec3(-1.5, 0.2, 1.5), 0.2, true);
    scene.cone(cone.unwrap());
    scene.torus(vec3(0.5, 0.5, 1.0), vec3(0.2, 1.0, 0.3), 0.6, 0.2);
    scene.material(shiny);
    let mut rng = SplitMix64::new(7);
    for _ in 0..150 {
        let mut coordinate = || 4.0 * (rng.unit() as Real) - 2.0;
        scene.sphere(vec3(coordinate(), coordinate(), coordinate()), 0.08);
    }
    let falloff = Falloff { constant: 0.5, linear: 0.01, quadratic: 0.001 };
    let white = Rgb::gray(0.5);
    for source in [
        LightSource::Point { position: vec3(5.0, 6.0, 7.0), falloff },
        LightSource::Directional { to_light: Vec3::Y },
        LightSource::Spot {
            position: vec3(-4.0, 5.0, 4.0),
            direction: vec3(0.0, -0.6, -0.8),
            cos_inner: 0.9,
            cos_outer: 0.5,
            falloff,
        },
        LightSource::Sphere { position: vec3(0.0, 6.0, 2.0), radius: 0.5, falloff },
        LightSource::Rectangle {
            position: vec3(4.0, 4.0, 2.0),
            half_edges: [vec3(0.0, 0.0, 0.5), vec3(0.5, -0.5, 0.0)],
            soft_shadows: true,
            falloff,
        },
    ] {
        scene.lights.push(Light { source, color: white, casts_shadows: true });
    }
    scene.ambient = Rgb::gray(0.1);
    scene.background =
        Background::Gradient { up: Vec3::Y, below: Rgb::gray(0.8), above: Rgb::new(0.1, 0.2, 0.9) };
    scene
}

fn baked(scene: Scene<'_>, accelerator: BakedAccelerator<'_>) -> Vec<u8> {
    let baking =
        BakedSceneWriter { scene, camera: VIEW, resolution: SIZE, levels: 4, cutoff: 0.01, accelerator };
    let mut bytes = Vec::new();
    assert!(baking.write_to(|piece| bytes.extend_from_slice(piece)));
    assert_eq!(Some(bytes.len() as u32), baking.size_in_bytes());
    bytes
}

/// The scene, baked with each of the four accelerators.
fn baked_with_every_accelerator(scene: &TestScene) -> Vec<Vec<u8>> {
    let boxes = scene.bounds();
    let size = GridSize::recommended(&boxes);
    let (mut cells, mut entries) = (vec![0; size.cells], vec![0; size.entries]);
    let grid = Grid::build(&boxes, &mut cells, &mut entries).unwrap();
    let size = OctreeSize::recommended(boxes.len());
    let (mut octants, mut listed) = (vec![OctreeNode::EMPTY; size.nodes], vec![0; size.entries]);
    let octree = Octree::build(&boxes, &mut octants, &mut listed).unwrap();
    let size = BvhSize::recommended(boxes.len());
    let (mut nodes, mut items) = (vec![BvhNode::EMPTY; size.nodes], vec![BvhEntry::EMPTY; size.entries]);
    let bvh = Bvh::build(&boxes, &mut nodes, &mut items).unwrap();
    let accelerators = [
        BakedAccelerator::ListWithoutBounds(ListWithoutBounds(scene.item_count())),
        BakedAccelerator::Grid(grid),
        BakedAccelerator::Octree(octree),
        BakedAccelerator::Bvh(bvh),
    ];
    accelerators.into_iter().map(|accelerator| baked(scene.as_scene(), accelerator)).collect()
}

fn picture<A: Accelerator>(scene: Scene<'_>, accelerator: A, camera: Camera) -> Vec<[u32; 3]> {
    let world = World::new(scene, accelerator);
    let limits = Limits { levels: 4, cutoff: 0.01 };
    let tracer = Tracer::<_, AllEffects, 4>::new(&world, camera, limits).unwrap();
    let mut colors = Vec::new();
    let mut sink = |_: Pixel, color: Rgb| colors.push([color.r, color.g, color.b].map(f32::to_bits));
    let pixels = Tile::full(SIZE).pixels();
    let Ok(()) = render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, pixels, &mut sink);
    colors
}

/// The picture of a baked scene, traced with its accelerator.
fn picture_of(pack: &BakedScene<'_>) -> Result<Vec<[u32; 3]>, BakedSceneError> {
    let (scene, camera) = (*pack.scene(), pack.camera(SIZE).unwrap());
    Ok(match pack.accelerator()? {
        BakedAccelerator::ListWithoutBounds(list) => picture(scene, list, camera),
        BakedAccelerator::Grid(grid) => picture(scene, grid.with_mailbox::<8>(), camera),
        BakedAccelerator::Octree(octree) => picture(scene, octree.with_mailbox::<8>(), camera),
        BakedAccelerator::Bvh(bvh) => picture(scene, bvh.with_queue::<TraversalStack<16>>(), camera),
    })
}
