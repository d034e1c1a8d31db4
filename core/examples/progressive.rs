//! Progressive rendering to a display: coarse blocks first, refined in place.
//!
//! The display holds the picture; the tracer holds one row of block corners and a cache of other traced
//! pixels.
//!
//! ```text
//! cargo run --release -p strahl-core --example progressive            # as text, pass by pass
//! cargo run --release -p strahl-core --example progressive -- FOLDER  # 320 x 240 as PPM files, pass by pass
//! ```
//!
//! After each pass it prints how many rays were traced and how many pixels were written. At 320 x 240, with a
//! row of 41 corners (820 bytes) and a cache of 2048 entries of 32 bytes:
//!
//! | blocks of | rays so far | pixels written so far |
//! |---|---|---|
//! | 8 x 8 | 1,271 | 76,800 |
//! | 4 x 4 | 4,662 | 125,312 |
//! | 2 x 2 | 15,780 | 158,560 |
//! | 1 x 1 | 46,780 | 179,328 |
//!
//! One ray per pixel is 76,800 rays: the first picture takes a sixtieth of them.

use std::error::Error;
use std::path::{Path, PathBuf};

use strahl_core::geometry::ItemId;
use strahl_core::image::{CacheEntry, ContrastThreshold, CornerRowCache, PixelSelection, PixelSelector};
use strahl_core::scene::{CameraSample, Texture, TextureId};
use strahl_core::trace::PixelSample;
use strahl_core::{
    AllEffects, Camera, CameraDescriptor, CenterSampler, Falloff, Geometry, Light, LightSource, Limits,
    ListWithoutBounds, Material, MaterialId, Plane, Projection, Resolution, Rgb, Scene, SceneDescriptor,
    Shape, Sphere, Tile, Tracer, Vec3, Worker, World, vec3,
};

/// Pixels along one side of the coarsest blocks.
const STEP: u32 = 8;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let (width, height) = if folder.is_some() { (320, 240) } else { (72, 36) };
    let resolution = Resolution::new(width, height).ok_or("invalid resolution")?;

    let textures = [Texture::Checker {
        even: Rgb::gray(0.9),
        odd: Rgb::gray(0.35),
        origin: Vec3::ZERO,
        frequency: vec3(1.0, 0.0, 1.0),
    }];
    let sphere = |x, z, radius| Shape::Sphere(Sphere { center: vec3(x, radius, z), radius });
    let shapes = [Shape::Plane(0), sphere(-1.1, 0.0, 1.0), sphere(1.0, 0.6, 0.7), sphere(0.2, 1.8, 0.35)];
    let source = LightSource::Point { position: vec3(4.0, 7.0, 5.0), falloff: Falloff::NONE };
    let specular = Material {
        reflection: Rgb::gray(0.25),
        diffuse: Rgb::new(0.6, 0.2, 0.15),
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    let lights = [Light { source, color: Rgb::gray(0.8), casts_shadows: true }];
    let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) }];
    let materials = [Material { texture: TextureId(0), ambient: Rgb::WHITE, ..Material::MATTE }, specular];
    let scene = Scene::new(SceneDescriptor {
        geometry: Geometry { shapes: &shapes, planes: &planes, ..Geometry::EMPTY },
        material_ids: &[MaterialId(0), MaterialId(1), MaterialId(1), MaterialId(1)],
        materials: &materials,
        textures: &textures,
        lights: &lights,
        ambient: Rgb::gray(0.15),
        background: strahl_core::Background::Color(Rgb::new(0.5, 0.65, 0.9)),
        ..SceneDescriptor::EMPTY
    })?;
    let camera = CameraDescriptor {
        position: vec3(0.0, 2.2, 6.5),
        target: vec3(0.0, 0.7, 0.0),
        up: Vec3::Y,
        projection: Projection::Perspective { field_of_view: 0.6 },
    };
    let world = World::new(scene, ListWithoutBounds(shapes.len() as u32));
    let limits = Limits { levels: 3, ..Limits::DEFAULT };
    let tracer = Tracer::<_, AllEffects, 3>::new(&world, Camera::new(&camera, resolution)?, limits)?;

    // All memory besides the display.
    let mut row = [PixelSample::BLACK; 41];
    let mut cache = [CacheEntry::EMPTY; 2048];
    let threshold = ContrastThreshold::new(0.04).ok_or("invalid threshold")?;
    let selection = PixelSelection::new(STEP, threshold).ok_or("invalid step")?;
    let corners = width.div_ceil(STEP) as usize + 1;
    let mut selector =
        PixelSelector::new(selection, CenterSampler, CornerRowCache::new(&mut row[..corners]), &mut cache);

    let tile = Tile::full(resolution);
    let mut display = vec![Rgb::BLACK; tile.len()];
    let (mut rays, mut writes) = (0, 0);
    let mut worker = Worker::<_, (), 3>::new(());
    selector.reset();
    for side in selection.refinement_sides() {
        for block in selection.block_range(tile).pixels() {
            let mut trace = |sample: CameraSample| {
                rays += 1;
                tracer.trace(sample, &mut worker)
            };
            selector.refine_block(block, side, &mut trace, &mut |pixel, sample| {
                if let Some(entry) = tile.index_of(pixel).and_then(|index| display.get_mut(index)) {
                    *entry = sample.color;
                    writes += 1;
                }
            });
        }
        println!(
            "blocks of {side} x {side}: {rays} rays and {writes} pixels written so far, of {}",
            tile.len()
        );
        match &folder {
            Some(folder) => write(&folder.join(format!("progressive-{side}.ppm")), resolution, &display)?,
            None => print(resolution, &display),
        }
    }
    Ok(())
}

/// Prints the picture as text, one character per pixel.
fn print(resolution: Resolution, display: &[Rgb]) {
    const RAMP: &[u8] = b" .:-=+*#%@";
    for row in display.chunks(resolution.width() as usize) {
        let character = |color: &Rgb| {
            let level = usize::from(color.to_srgb8()[1]) * (RAMP.len() - 1) / 255;
            char::from(RAMP.get(level).copied().unwrap_or(b'?'))
        };
        println!("{}", row.iter().map(character).collect::<String>());
    }
}

/// Writes the picture as a PPM file.
fn write(path: &Path, resolution: Resolution, display: &[Rgb]) -> std::io::Result<()> {
    let mut bytes = format!("P6\n{} {}\n255\n", resolution.width(), resolution.height()).into_bytes();
    bytes.extend(display.iter().flat_map(|color| color.to_srgb8()));
    std::fs::write(path, bytes)
}
