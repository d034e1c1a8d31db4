//! The input of the firmware, and the host's pictures for comparison.
//!
//! Writes into the folder of the first argument, for each scene that is drawn on the chip: the scene baked
//! with its accelerator (`NAME.strahl`), its picture as linear floats (`NAME.f32`), for one scene also Rust
//! constants (`NAME.rs`), and the pictures of the table of flash. Prints the program's estimates of stack and
//! instructions. With a second argument, the folder of the procedural databases, the scenes include `balls`.
//!
//! The host uses the alternatives wherever they exist: all effects, a list with boxes, tables that were never
//! baked. None of them may change a bit.

use std::error::Error;
use std::path::{Path, PathBuf};

use strahl::bake::{BakeSettings, bake, chip, count_events, source};
use strahl_core::accel::{List, group_count};
use strahl_core::geometry::Aabb;
use strahl_core::image::Framebuffer;
use strahl_core::{
    AllEffects, Camera, CenterSampler, Limits, Resolution, Rgb, Tile, Tracer, Worker, World, render,
};
use strahl_device::{flash, scene as golden};
use strahl_scene::load_for_size;
use strahl_session::tables::single::{camera_descriptor, scene_tables};
use strahl_settings::AccelKind;

/// A scene that is drawn on the chip.
struct ChipScene {
    name: &'static str,
    file: &'static str,
    accelerator: AccelKind,
    size: Resolution,
    levels: u8,
    /// Maximum number of BVH nodes, to fit into flash.
    nodes: Option<usize>,
}

const SMALL: Resolution = Resolution::new(64, 48).unwrap();

/// Scenes of the project: Whitted's classic with an octree, columns around a glass sphere with a grid, a mesh
/// with a BVH, and one with a list.
const SCENES: [ChipScene; 4] = [
    ChipScene {
        name: "classic",
        file: "classic",
        accelerator: AccelKind::Octree,
        size: SMALL,
        levels: 6,
        nodes: None,
    },
    ChipScene {
        name: "rotunda",
        file: "rotunda",
        accelerator: AccelKind::Grid,
        size: SMALL,
        levels: 6,
        nodes: None,
    },
    ChipScene { name: "mesh", file: "", accelerator: AccelKind::Bvh, size: SMALL, levels: 6, nodes: None },
    ChipScene {
        name: "first",
        file: "first",
        accelerator: AccelKind::List,
        size: SMALL,
        levels: 6,
        nodes: None,
    },
];

/// The sphereflake of the procedural databases.
const BALLS: ChipScene = ChipScene {
    name: "balls",
    file: "balls.nff",
    accelerator: AccelKind::Bvh,
    size: Resolution::new(128, 96).unwrap(),
    levels: 5,
    nodes: Some(1800),
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let folder = arguments.next().ok_or("usage: chip FOLDER [FOLDER_WITH_THE_DATABASES]")?;
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("scenes");
    // A curved sheet of triangles, with the default light and camera of a model.
    std::fs::write(folder.join("sheet.obj"), sheet())?;
    for scene in SCENES {
        let file = if scene.file.is_empty() {
            folder.join("sheet.obj")
        } else {
            in_any_format(&scenes.join(scene.file))
        };
        make(&scene, &file, &folder)?;
    }
    let constants = strahl_core::Scene::new(golden::parts())?;
    let (camera, size, limits) = (golden::VIEW, golden::SIZE, golden::LIMITS);
    let Limits { levels, cutoff } = limits;
    let settings = BakeSettings { accelerator: AccelKind::Grid, nodes: None, camera, size, levels, cutoff };
    bake_and_draw("golden", &constants, &settings, &folder)?;
    if let Some(databases) = arguments.next() {
        make(&BALLS, &databases.join(BALLS.file), &folder)?;
    }
    step::<flash::FlashLocal>("local", &folder)?;
    step::<flash::FlashShadows>("shadows", &folder)?;
    step::<flash::FlashMirrors>("mirrors", &folder)?;
    step::<flash::FlashGlass>("glass", &folder)?;
    step::<flash::FlashDistributed>("distributed", &folder)?;
    for stack in &chip::STACK_USAGE {
        println!("stack {} {}", stack.name, stack.bytes);
    }
    println!("factor {}", chip::ESTIMATE_FACTOR);
    Ok(())
}

/// Writes the picture of a variant of the table of flash, `flash-NAME.f32`.
fn step<S: flash::FlashVariant>(name: &str, folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut bytes = Vec::new();
    flash::picture::<S>(|float| bytes.extend(float)).ok_or("no picture")?;
    Ok(std::fs::write(folder.join(format!("flash-{name}.f32")), bytes)?)
}

/// The path of the scene with this name.
fn in_any_format(name: &Path) -> PathBuf {
    let toml = name.with_extension("toml");
    if toml.exists() { toml } else { name.with_extension("nff") }
}

/// Bakes and draws the scene of a file.
fn make(scene: &ChipScene, file: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let description = load_for_size(file, scene.size).map_err(|error| error.to_string())?;
    let storage = scene_tables(&description);
    let ChipScene { name, accelerator, size, levels, nodes, .. } = *scene;
    let cutoff = Limits::DEFAULT.cutoff;
    let settings = BakeSettings {
        accelerator,
        nodes,
        camera: camera_descriptor(&description.camera),
        size,
        levels,
        cutoff,
    };
    let tables = storage.scene()?;
    // The program's estimate.
    let count = count_events(&description, &settings)?;
    let estimate = chip::instructions(&count.counts, accelerator) / count.pixels * pixels(size);
    println!("estimate {name} {estimate}");
    if name == CONSTANTS {
        std::fs::write(folder.join(name).with_extension("rs"), source(file, &tables, &settings))?;
    }
    bake_and_draw(name, &tables, &settings, folder)
}

/// The scene that is also drawn from Rust constants.
const CONSTANTS: &str = "first";

fn pixels(size: Resolution) -> u64 {
    u64::from(size.width()) * u64::from(size.height())
}

fn bake_and_draw(
    name: &str,
    tables: &strahl_core::Scene<'_>,
    settings: &BakeSettings,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    std::fs::write(folder.join(name).with_extension("strahl"), bake(tables, settings)?)?;

    let boxes: Vec<Aabb> = tables.descriptor().geometry.all_bounds().collect();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let world = World::new(*tables, List::with_boxes(&boxes, &mut groups)?);
    let limits = Limits { levels: settings.levels, cutoff: settings.cutoff };
    let camera = Camera::new(&settings.camera, settings.size)?;
    let tracer = Tracer::<_, AllEffects, 6>::new(&world, camera, limits)?;
    let tile = Tile::full(settings.size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Framebuffer::new(tile, &mut colors).ok_or("the frame has another size")?;
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, tile.pixels(), &mut frame);
    let bytes: Vec<u8> = colors.iter().flat_map(|c| [c.r, c.g, c.b]).flat_map(f32::to_le_bytes).collect();
    Ok(std::fs::write(folder.join(name).with_extension("f32"), bytes)?)
}

/// A Wavefront model of 14 times 14 squares, each two triangles, with the normals of the sheet.
fn sheet() -> String {
    const N: u32 = 14;
    let mut text = String::new();
    for i in 0..=N {
        for j in 0..=N {
            let (x, z) = (i as f32 / N as f32 * 2.0 - 1.0, j as f32 / N as f32 * 2.0 - 1.0);
            let y = 0.6 * x * x - 0.5 * z * z * x;
            text += &format!("v {x} {y} {z}\nvn {} 1 {}\n", -(1.2 * x - 0.5 * z * z), z * x);
        }
    }
    for i in 0..N {
        for j in 0..N {
            let a = i * (N + 1) + j + 1;
            let (b, c, d) = (a + 1, a + N + 1, a + N + 2);
            text += &format!("f {a}//{a} {b}//{b} {d}//{d}\nf {a}//{a} {d}//{d} {c}//{c}\n");
        }
    }
    text
}
