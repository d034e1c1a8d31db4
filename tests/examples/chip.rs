//! What the firmware needs of a host, and what it is held against: into the folder named by the
//! first argument goes, for each scene that is drawn on the chip, the scene baked with its
//! accelerator (`NAME.strahl`) and its picture as linear floats (`NAME.f32`), one scene as Rust
//! constants too (`NAME.rs`), and the pictures of the steps of the table of flash. It prints what the
//! program would say of stack and instructions. With a second argument, a folder that holds the procedural databases, `balls` is one of them.
//!
//! The host goes the other way wherever there is one: a tracer that can do everything, a list
//! with boxes, tables that were never baked. None of that may change a bit.

#[path = "../firmware/src/flash.rs"]
mod flash;
#[path = "../firmware/src/scene.rs"]
mod golden;

use std::error::Error;
use std::path::{Path, PathBuf};

use strahl::bake::{BakeSettings, bake, chip, counted, source};
use strahl_core::accel::{List, group_count};
use strahl_core::geometry::Aabb;
use strahl_core::image::Frame;
use strahl_core::{AllEffects, Camera, Limits, Resolution, Rgb, Single, Tile, Tracer, Worker, World, render};
use strahl_scene::load_for_size;
use strahl_session::tables::single::{scene_tables, view};
use strahl_settings::AccelKind;

/// A scene that is drawn on the chip.
struct Scene {
    name: &'static str,
    file: &'static str,
    accelerator: AccelKind,
    size: Resolution,
    levels: u8,
    /// The most nodes of the hierarchy: for what flash there is.
    nodes: Option<usize>,
}

const SMALL: Resolution = Resolution::new(64, 48).unwrap();

/// Those of the project: Whitted's classic in an octree, columns round a glass sphere in a grid,
/// a mesh in a hierarchy, and a list.
const SCENES: [Scene; 4] = [
    Scene {
        name: "classic",
        file: "classic",
        accelerator: AccelKind::Octree,
        size: SMALL,
        levels: 6,
        nodes: None,
    },
    Scene {
        name: "rotunda",
        file: "rotunda",
        accelerator: AccelKind::Grid,
        size: SMALL,
        levels: 6,
        nodes: None,
    },
    Scene { name: "mesh", file: "", accelerator: AccelKind::Bvh, size: SMALL, levels: 6, nodes: None },
    Scene { name: "first", file: "first", accelerator: AccelKind::List, size: SMALL, levels: 6, nodes: None },
];

/// The sphereflake of the procedural databases.
const BALLS: Scene = Scene {
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
    // A bent sheet of triangles, with the light and the view that a model gets by itself.
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
    let (view, size, limits) = (golden::VIEW, golden::SIZE, golden::LIMITS);
    let Limits { levels, cutoff } = limits;
    let asked = BakeSettings { accelerator: AccelKind::Grid, nodes: None, view, size, levels, cutoff };
    bake_and_draw("golden", &constants, &asked, &folder)?;
    if let Some(databases) = arguments.next() {
        make(&BALLS, &databases.join(BALLS.file), &folder)?;
    }
    step::<flash::Local>("local", &folder)?;
    step::<flash::Shadows>("shadows", &folder)?;
    step::<flash::Mirrors>("mirrors", &folder)?;
    step::<flash::Glass>("glass", &folder)?;
    step::<flash::Distributed>("distributed", &folder)?;
    for stack in &chip::STACKS {
        println!("stack {} {}", stack.name, stack.bytes);
    }
    println!("doubt {}", chip::DOUBT);
    Ok(())
}

/// The picture of a step of the table of flash, `flash-NAME.f32`.
fn step<S: flash::Step>(name: &str, folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut bytes = Vec::new();
    flash::picture::<S>(|float| bytes.extend(float)).ok_or("it is no picture")?;
    Ok(std::fs::write(folder.join(format!("flash-{name}.f32")), bytes)?)
}

/// The scene file of this name.
fn in_any_format(name: &Path) -> PathBuf {
    let toml = name.with_extension("toml");
    if toml.exists() { toml } else { name.with_extension("nff") }
}

/// Bakes and draws the scene of a file.
fn make(scene: &Scene, file: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let description = load_for_size(file, scene.size).map_err(|error| error.to_string())?;
    let stock = scene_tables(&description);
    let Scene { name, accelerator, size, levels, nodes, .. } = *scene;
    let cutoff = Limits::DEFAULT.cutoff;
    let asked = BakeSettings { accelerator, nodes, view: view(&description.camera), size, levels, cutoff };
    let tables = stock.scene()?;
    // What the program would say of it.
    let count = counted(&description, &asked)?;
    let estimate = chip::instructions(&count.counts, accelerator) / count.pixels * pixels(size);
    println!("estimate {name} {estimate}");
    if name == CONSTANTS {
        std::fs::write(folder.join(name).with_extension("rs"), source(file, &tables, &asked))?;
    }
    bake_and_draw(name, &tables, &asked, folder)
}

/// The scene that is drawn from Rust constants as well.
const CONSTANTS: &str = "first";

fn pixels(size: Resolution) -> u64 {
    u64::from(size.width()) * u64::from(size.height())
}

fn bake_and_draw(
    name: &str,
    tables: &strahl_core::Scene<'_>,
    asked: &BakeSettings,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    std::fs::write(folder.join(name).with_extension("strahl"), bake(tables, asked)?)?;

    let boxes: Vec<Aabb> = tables.descriptor().geometry.all_bounds().collect();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let world = World::new(*tables, List::with_boxes(&boxes, &mut groups)?);
    let limits = Limits { levels: asked.levels, cutoff: asked.cutoff };
    let camera = Camera::new(&asked.view, asked.size)?;
    let tracer = Tracer::<_, AllEffects, 6>::new(&world, camera, limits)?;
    let tile = Tile::whole(asked.size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Frame::new(tile, &mut colors).ok_or("the frame has another size")?;
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut Single, tile.pixels(), &mut frame);
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
