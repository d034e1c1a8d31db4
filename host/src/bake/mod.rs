//! The command `bake`: a scene with its accelerator, ready to be traced from flash.

pub mod chip;
mod rust;
mod settings;

pub use settings::BakeSettings;

use std::fmt::Write as _;
use std::path::Path;

use strahl_core::accel::{
    Bvh, BvhNode, BvhSize, Grid, GridSize, LeafEntry, Mailbox, Octree, OctreeNode, OctreeSize, TraversalStack,
};
use strahl_core::baked::{BakedAccelerator, BakedScene, BakedSceneWriter};
use strahl_core::geometry::Aabb;
use strahl_core::scene::EffectSet;
use strahl_core::tally::Counters;
use strahl_core::{ListWithoutBounds, Projection, Resolution, Scene, Worker};
use strahl_engine::{NoProgress, RenderError, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_scene::quantity::quantity;
use strahl_scene::{SourceFiles, load_from};
use strahl_session::tables::single::{self, scene_tables};
use strahl_settings::accelerator::DEFAULT_MAILBOX_SLOTS;
use strahl_settings::{
    Accel, AccelKind, AccelSettings, Bounds, DEFAULT_SIZE, Group, SETTINGS, Setting, Settings,
    SettingsOverrides,
};

use crate::args::BakeArgs;
use crate::failure::Failure;
use crate::output::{Guard, refuse_terminal, say, tell};

/// Bakes one scene.
pub fn run(args: &BakeArgs) -> Result<(), Failure> {
    if let Some(misfit) = args.misfit() {
        return Err(Failure::Usage(misfit));
    }
    refuse_terminal(&args.output, "the baked scene")?;
    let files = SourceFiles::on_disk();
    let description = load_from(&files, &args.scene, args.settings.given.size.unwrap_or(DEFAULT_SIZE))?;
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        say(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    for left_out in left_out(&description.settings).iter().filter(|_| !args.quiet) {
        say(format_args!("{}: warning: {left_out}", args.scene.display()));
    }
    let output = Guard::of(files.named_paths()).prepare(&args.output)?;
    let wrong = |reason: String| Failure::Input { path: args.scene.clone(), line: None, reason };
    let stock = scene_tables(&description);
    let scene = stock.scene().map_err(|error| wrong(error.to_string()))?;
    let Settings { size, levels, cutoff, .. } =
        Settings::resolve(&args.settings.given, &description.settings)?;
    let asked = BakeSettings {
        accelerator: args.accel.and_then(Accel::explicit_kind).unwrap_or(AccelKind::Bvh),
        nodes: args.nodes.map(|nodes| nodes as usize),
        view: single::view(&description.camera),
        size,
        levels,
        cutoff,
    };

    if args.is_source() {
        return output.commit(source(&args.scene, &scene, &asked).as_bytes());
    }
    let bytes = bake(&scene, &asked).map_err(wrong)?;
    output.commit(&bytes)?;
    if !args.quiet {
        let counts = counted(&description, &asked).map_err(|fault| wrong(fault.to_string()))?;
        tell(needs(&args.output, &scene, &asked, bytes.len(), &counts));
    }
    Ok(())
}

/// What a scene asks for that no baked scene holds: the firmware is built for it.
fn left_out(settings: &SettingsOverrides) -> Vec<String> {
    let (asked, default) = (Settings::from(settings.clone()), Settings::default());
    let is_of_firmware = |it: &&Setting| matches!(it.group, Group::Sampling | Group::Precision);
    let told = |setting: &Setting| {
        let word = setting.word(&asked).filter(|word| Some(word) != setting.word(&default).as_ref())?;
        let name = setting.name;
        Some(format!(
            "asks for the {name} `{word}`, which a baked scene does not hold: the firmware chooses it"
        ))
    };
    SETTINGS.iter().filter(is_of_firmware).filter_map(told).collect()
}

/// The scene as Rust constants, named after a file.
pub fn source(path: &Path, scene: &Scene<'_>, asked: &BakeSettings) -> String {
    rust::source(path, scene, asked)
}

/// What happens in the picture that is asked for, or in one of its shape of at most so many pixels:
/// more of them would tell no more about one.
pub fn counted(description: &LoadedScene, asked: &BakeSettings) -> Result<Counted, RenderError> {
    const MOST: u64 = 160 * 120;
    let (width, height) = (asked.size.width(), asked.size.height());
    let pixels = u64::from(width) * u64::from(height);
    let shrink = if pixels > MOST { (pixels as f64 / MOST as f64).sqrt() } else { 1.0 };
    let smaller = |side: u32| ((f64::from(side) / shrink) as u32).max(1);
    let size = Resolution::new(smaller(width), smaller(height)).unwrap_or(asked.size);
    let accelerator = AccelSettings { bounds: Bounds::None, ..AccelSettings::with_kind(asked.accelerator) };
    let settings = Settings { size, levels: asked.levels, cutoff: asked.cutoff, ..Settings::default() };
    let settings = settings.with_acceleration(accelerator);
    let output = strahl_session::render(description, &settings, &RenderOptions::COUNT_TESTS, &NoProgress)?;
    let pixels = u64::from(size.width()) * u64::from(size.height());
    Ok(Counted { counts: output.counters, pixels })
}

/// What happened in some pixels.
#[derive(Clone, Copy, Debug)]
pub struct Counted {
    /// How often everything.
    pub counts: Counters,
    /// How many pixels.
    pub pixels: u64,
}

/// The bytes of a scene and the accelerator that is asked for.
pub fn bake(scene: &Scene<'_>, asked: &BakeSettings) -> Result<Vec<u8>, String> {
    let boxes: Vec<Aabb> = scene.descriptor().geometry.all_bounds().collect();
    let fault = |error: strahl_core::accel::BuildError| error.to_string();
    let with = |finder: BakedAccelerator<'_>| {
        let BakeSettings { view, size, levels, cutoff, .. } = *asked;
        let baking = BakedSceneWriter {
            scene: *scene,
            camera: view,
            resolution: size,
            levels,
            cutoff,
            accelerator: finder,
        };
        let mut bytes = Vec::with_capacity(baking.size_in_bytes().unwrap_or(0) as usize);
        if !baking.write_to(|piece| bytes.extend_from_slice(piece)) {
            return Err("a baked scene has at most 4 GiB".into());
        }
        Ok(bytes)
    };
    let most = |wanted: usize| asked.nodes.map_or(wanted, |most| wanted.min(most));
    match asked.accelerator {
        AccelKind::List => with(BakedAccelerator::ListWithoutBounds(ListWithoutBounds(boxes.len() as u32))),
        AccelKind::Grid => {
            let room = GridSize::recommended(&boxes);
            let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.entries]);
            with(BakedAccelerator::Grid(Grid::build(&boxes, &mut cells, &mut items).map_err(fault)?))
        }
        AccelKind::Octree => {
            let room = OctreeSize::recommended(boxes.len());
            let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; most(room.nodes)], vec![0; room.entries]);
            with(BakedAccelerator::Octree(Octree::build(&boxes, &mut nodes, &mut items).map_err(fault)?))
        }
        AccelKind::Bvh => {
            let room = BvhSize::recommended(boxes.len());
            let (mut nodes, mut items) =
                (vec![BvhNode::EMPTY; most(room.nodes)], vec![LeafEntry::EMPTY; room.entries]);
            with(BakedAccelerator::Bvh(Bvh::build(&boxes, &mut nodes, &mut items).map_err(fault)?))
        }
    }
}

/// What a device must have for it.
fn needs(path: &Path, scene: &Scene<'_>, asked: &BakeSettings, bytes: usize, counted: &Counted) -> String {
    const SLOTS: usize = DEFAULT_MAILBOX_SLOTS;
    const PLACES: usize = 32;
    let tables = scene.descriptor().size_in_bytes();
    let frame = bytes.saturating_sub(tables).saturating_sub(BakedScene::MIN_SIZE_IN_BYTES);
    let task =
        Worker::<ListWithoutBounds, (), 2>::SIZE_IN_BYTES - Worker::<ListWithoutBounds, (), 1>::SIZE_IN_BYTES;
    let levels = usize::from(asked.levels);
    let (what, memory) = match asked.accelerator {
        AccelKind::List => ("the list", 0),
        AccelKind::Grid | AccelKind::Octree => ("a mailbox of 64 slots", size_of::<Mailbox<SLOTS>>()),
        AccelKind::Bvh => ("a stack of 32 places", size_of::<TraversalStack<PLACES>>()),
    };
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}: {}, walked by {}",
        path.display(),
        quantity(scene.descriptor().material_ids.len(), "item"),
        asked.accelerator.name()
    );
    let _ = writeln!(
        text,
        "  flash   {bytes} bytes: scene {tables}, accelerator {frame}, header {}",
        BakedScene::MIN_SIZE_IN_BYTES
    );
    let _ = writeln!(
        text,
        "  worker  {} bytes of RAM: {} of {task}, {what} {memory}",
        levels * task + memory + size_of::<usize>(),
        quantity(levels, "level"),
    );
    let asks = scene.required_effects();
    let shapes: Vec<&str> = asks.shapes.iter().map(|shape| shape.name()).collect();
    let _ = writeln!(text, "  shapes  {}", shapes.join(", "));
    // What the camera asks for is no part of the scene's own demand.
    let lens = matches!(asked.view.projection, Projection::ThinLens { .. });
    if let Some(stack) = chip::stack(&EffectSet { depth_of_field: lens, ..asks }) {
        let more = levels.saturating_sub(usize::from(stack.levels)) * task;
        let _ = writeln!(
            text,
            "  stack   {} bytes, the worker among them, as measured on a Cortex-M4F for {}",
            stack.bytes + more,
            stack.name
        );
    }
    let per_pixel = chip::instructions(&counted.counts, asked.accelerator) / counted.pixels.max(1);
    let _ = writeln!(
        text,
        "  time    about {per_pixel} instructions a pixel there with one ray in each, from what is counted here (within a \
         factor of {})",
        chip::DOUBT
    );
    text
}
