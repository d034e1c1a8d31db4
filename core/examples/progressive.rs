//! A picture for a display that is looked at while it is drawn: coarse blocks at first, refined in
//! place. The display holds the picture; the tracer holds one row of corners, and what else it is
//! lent.
//!
//! ```text
//! cargo run --release -p strahl-core --example progressive            # as text, pass by pass
//! cargo run --release -p strahl-core --example progressive -- FOLDER  # 320 x 240 as PPM files, pass by pass
//! ```
//!
//! It tells after each pass how many rays were traced and how many pixels put. At 320 x 240, with
//! a row of 41 corners (820 bytes) and 2048 slots of 32 bytes for others:
//!
//! | parts of | rays so far | pixels put so far |
//! |---|---|---|
//! | 8 x 8 | 1,271 | 76,800 |
//! | 4 x 4 | 4,662 | 125,312 |
//! | 2 x 2 | 15,780 | 158,560 |
//! | 1 x 1 | 46,780 | 179,328 |
//!
//! One ray for each pixel are 76,800: the first picture is there after a sixtieth of them.

use std::error::Error;
use std::path::{Path, PathBuf};

use strahl_core::geometry::ItemId;
use strahl_core::image::{Agreement, CornerRow, Kept, Selected, Selection};
use strahl_core::scene::{CameraSample, Texture, TextureId};
use strahl_core::trace::PixelSample;
use strahl_core::{
    AllEffects, BareList, Camera, CameraDescriptor, Falloff, Geometry, Light, LightSource, Limits, Material,
    MaterialId, Plane, Projection, Resolution, Rgb, Scene, SceneDescriptor, Shape, Single, Sphere, Tile,
    Tracer, Vec3, Worker, World, vec3,
};

const STEP: u32 = 8;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let (width, height) = if folder.is_some() { (320, 240) } else { (72, 36) };
    let size = Resolution::new(width, height).ok_or("no such size")?;

    let tiles = [Texture::Checker {
        even: Rgb::gray(0.9),
        odd: Rgb::gray(0.35),
        origin: Vec3::ZERO,
        frequency: vec3(1.0, 0.0, 1.0),
    }];
    let ball = |x, z, radius| Shape::Sphere(Sphere { center: vec3(x, radius, z), radius });
    let shapes = [Shape::Plane(0), ball(-1.1, 0.0, 1.0), ball(1.0, 0.6, 0.7), ball(0.2, 1.8, 0.35)];
    let source = LightSource::Point { position: vec3(4.0, 7.0, 5.0), falloff: Falloff::NONE };
    let shiny =
        Material { reflection: Rgb::gray(0.25), diffuse: Rgb::new(0.6, 0.2, 0.15), ..Material::MATTE };
    let lights = [Light { source, color: Rgb::gray(0.8), casts_shadows: true }];
    let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(0) }];
    let materials = [Material { texture: TextureId(0), ..Material::MATTE }, shiny];
    let scene = Scene::new(SceneDescriptor {
        geometry: Geometry { shapes: &shapes, planes: &planes, ..Geometry::EMPTY },
        material_ids: &[MaterialId(0), MaterialId(1), MaterialId(1), MaterialId(1)],
        materials: &materials,
        textures: &tiles,
        lights: &lights,
        ambient: Rgb::gray(0.15),
        background: strahl_core::Background::Color(Rgb::new(0.5, 0.65, 0.9)),
        ..SceneDescriptor::EMPTY
    })?;
    let view = CameraDescriptor {
        position: vec3(0.0, 2.2, 6.5),
        target: vec3(0.0, 0.7, 0.0),
        up: Vec3::Y,
        projection: Projection::Perspective { field_of_view: 0.6 },
    };
    let world = World::new(scene, BareList(shapes.len() as u32));
    let limits = Limits { levels: 3, ..Limits::DEFAULT };
    let tracer = Tracer::<_, AllEffects, 3>::new(&world, Camera::new(&view, size)?, limits)?;

    // All the memory that there is beside the display.
    let mut row = [PixelSample::BLACK; 41];
    let mut lent = [Kept::NOTHING; 2048];
    let agreement = Agreement::of_colors(0.04).ok_or("no such threshold")?;
    let selection = Selection::new(STEP, agreement).ok_or("no such step")?;
    let corners = width.div_ceil(STEP) as usize + 1;
    let mut selected = Selected::new(selection, Single, CornerRow::new(&mut row[..corners]), &mut lent);

    let tile = Tile::whole(size);
    let mut display = vec![Rgb::BLACK; tile.len()];
    let (mut rays, mut puts) = (0, 0);
    let mut worker = Worker::<_, (), 3>::new(());
    selected.begin();
    for side in selection.sides() {
        for block in selection.blocks(tile).pixels() {
            let mut trace = |sample: CameraSample| {
                rays += 1;
                tracer.trace(sample, &mut worker)
            };
            selected.refine_block(block, side, &mut trace, &mut |pixel, sample| {
                if let Some(slot) = tile.place(pixel).and_then(|place| display.get_mut(place)) {
                    *slot = sample.color;
                    puts += 1;
                }
            });
        }
        println!("parts of {side} x {side}: {rays} rays and {puts} pixels so far, of {}", tile.len());
        match &folder {
            Some(folder) => write(&folder.join(format!("progressive-{side}.ppm")), size, &display)?,
            None => draw(size, &display),
        }
    }
    Ok(())
}

/// As text, the brighter the more ink.
fn draw(size: Resolution, display: &[Rgb]) {
    const INK: &[u8] = b" .:-=+*#%@";
    for row in display.chunks(size.width() as usize) {
        let ink = |color: &Rgb| {
            let bright = usize::from(color.to_srgb8()[1]) * (INK.len() - 1) / 255;
            char::from(INK.get(bright).copied().unwrap_or(b'?'))
        };
        println!("{}", row.iter().map(ink).collect::<String>());
    }
}

fn write(path: &Path, size: Resolution, display: &[Rgb]) -> std::io::Result<()> {
    let mut bytes = format!("P6\n{} {}\n255\n", size.width(), size.height()).into_bytes();
    bytes.extend(display.iter().flat_map(|color| color.to_srgb8()));
    std::fs::write(path, bytes)
}
