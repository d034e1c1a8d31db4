//! The command `bake`: writes a scene and its accelerator as a binary that a device renders from flash.

pub mod chip;
mod rust;
mod settings;

pub use settings::BakeSettings;

use std::fmt::Write as _;
use std::path::Path;

use strahl_core::accel::{
    Bvh, BvhEntry, BvhNode, BvhSize, Grid, GridSize, Mailbox, Octree, OctreeNode, OctreeSize, TraversalStack,
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
use crate::error::CommandError;
use crate::output::{OutputGuard, print_message, print_stderr, refuse_terminal};

/// Bakes one scene.
pub fn run(args: &BakeArgs) -> Result<(), CommandError> {
    if let Some(conflict) = args.conflict() {
        return Err(CommandError::Usage(conflict));
    }
    refuse_terminal(&args.output, "the baked scene")?;
    let files = SourceFiles::on_disk();
    let description = load_from(&files, &args.scene, args.settings.given.size.unwrap_or(DEFAULT_SIZE))?;
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        print_message(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    for warning in unbaked_settings(&description.settings).iter().filter(|_| !args.quiet) {
        print_message(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let output = OutputGuard::of(files.named_paths()).prepare(&args.output)?;
    let wrong = |reason: String| CommandError::InvalidInput { path: args.scene.clone(), line: None, reason };
    let tables = scene_tables(&description);
    let scene = tables.scene().map_err(|error| wrong(error.to_string()))?;
    let Settings { size, levels, cutoff, .. } =
        Settings::resolve(&args.settings.given, &description.settings)?;
    let settings = BakeSettings {
        accelerator: args.accel.and_then(Accel::explicit_kind).unwrap_or(AccelKind::Bvh),
        nodes: args.nodes.map(|nodes| nodes as usize),
        camera: single::camera_descriptor(&description.camera),
        size,
        levels,
        cutoff,
    };

    if args.is_rust_source() {
        return output.commit(source(&args.scene, &scene, &settings).as_bytes());
    }
    let bytes = bake(&scene, &settings).map_err(wrong)?;
    output.commit(&bytes)?;
    if !args.quiet {
        let counts = count_events(&description, &settings).map_err(|error| wrong(error.to_string()))?;
        print_stderr(device_requirements(&args.output, &scene, &settings, bytes.len(), &counts));
    }
    Ok(())
}

/// Warnings for settings of the scene that a baked scene does not store.
fn unbaked_settings(overrides: &SettingsOverrides) -> Vec<String> {
    let (settings, default) = (Settings::from(overrides.clone()), Settings::default());
    let is_of_firmware = |it: &&Setting| matches!(it.group, Group::Sampling | Group::Precision);
    let warning = |setting: &Setting| {
        let word = setting.word(&settings).filter(|word| Some(word) != setting.word(&default).as_ref())?;
        let name = setting.name;
        Some(format!("sets {name} `{word}`, which is not stored in a baked scene; firmware chooses it"))
    };
    SETTINGS.iter().filter(is_of_firmware).filter_map(warning).collect()
}

/// The scene as Rust source; `path` names the scene in its first comment.
pub fn source(path: &Path, scene: &Scene<'_>, settings: &BakeSettings) -> String {
    rust::source(path, scene, settings)
}

/// Event counts of the picture, or of a smaller picture with the same aspect ratio if it has more than
/// 160 x 120 pixels.
pub fn count_events(
    description: &LoadedScene,
    settings: &BakeSettings,
) -> Result<CountedPixels, RenderError> {
    const MAX_COUNTED_PIXELS: u64 = 160 * 120;
    let (width, height) = (settings.size.width(), settings.size.height());
    let pixels = u64::from(width) * u64::from(height);
    let shrink =
        if pixels > MAX_COUNTED_PIXELS { (pixels as f64 / MAX_COUNTED_PIXELS as f64).sqrt() } else { 1.0 };
    let smaller = |side: u32| ((f64::from(side) / shrink) as u32).max(1);
    let size = Resolution::new(smaller(width), smaller(height)).unwrap_or(settings.size);
    let accelerator =
        AccelSettings { bounds: Bounds::None, ..AccelSettings::with_kind(settings.accelerator) };
    let settings = Settings { size, levels: settings.levels, cutoff: settings.cutoff, ..Settings::default() };
    let settings = settings.with_acceleration(accelerator);
    let output = strahl_session::render(description, &settings, &RenderOptions::COUNT_TESTS, &NoProgress)?;
    let pixels = u64::from(size.width()) * u64::from(size.height());
    Ok(CountedPixels { counts: output.counters, pixels })
}

/// Event counts of a picture.
#[derive(Clone, Copy, Debug)]
pub struct CountedPixels {
    /// Event counts.
    pub counts: Counters,
    /// Number of pixels.
    pub pixels: u64,
}

/// The bytes of a baked scene, or an error message.
pub fn bake(scene: &Scene<'_>, settings: &BakeSettings) -> Result<Vec<u8>, String> {
    let boxes: Vec<Aabb> = scene.descriptor().geometry.all_bounds().collect();
    let build_error = |error: strahl_core::accel::BuildError| error.to_string();
    let with = |accelerator: BakedAccelerator<'_>| {
        let BakeSettings { camera, size, levels, cutoff, .. } = *settings;
        let baking =
            BakedSceneWriter { scene: *scene, camera, resolution: size, levels, cutoff, accelerator };
        let mut bytes = Vec::with_capacity(baking.size_in_bytes().unwrap_or(0) as usize);
        if !baking.write_to(|piece| bytes.extend_from_slice(piece)) {
            return Err("a baked scene can have at most 4 GiB".into());
        }
        Ok(bytes)
    };
    let limited = |nodes: usize| settings.nodes.map_or(nodes, |max| nodes.min(max));
    match settings.accelerator {
        AccelKind::List => with(BakedAccelerator::ListWithoutBounds(ListWithoutBounds(boxes.len() as u32))),
        AccelKind::Grid => {
            let size = GridSize::recommended(&boxes);
            let (mut cells, mut items) = (vec![0; size.cells], vec![0; size.entries]);
            with(BakedAccelerator::Grid(Grid::build(&boxes, &mut cells, &mut items).map_err(build_error)?))
        }
        AccelKind::Octree => {
            let size = OctreeSize::recommended(boxes.len());
            let (mut nodes, mut items) =
                (vec![OctreeNode::EMPTY; limited(size.nodes)], vec![0; size.entries]);
            with(BakedAccelerator::Octree(
                Octree::build(&boxes, &mut nodes, &mut items).map_err(build_error)?,
            ))
        }
        AccelKind::Bvh => {
            let size = BvhSize::recommended(boxes.len());
            let (mut nodes, mut items) =
                (vec![BvhNode::EMPTY; limited(size.nodes)], vec![BvhEntry::EMPTY; size.entries]);
            with(BakedAccelerator::Bvh(Bvh::build(&boxes, &mut nodes, &mut items).map_err(build_error)?))
        }
    }
}

/// Flash, RAM, stack and time that the scene needs on a device, as text.
fn device_requirements(
    path: &Path,
    scene: &Scene<'_>,
    settings: &BakeSettings,
    bytes: usize,
    counted: &CountedPixels,
) -> String {
    const MAILBOX_SLOTS: usize = DEFAULT_MAILBOX_SLOTS;
    const STACK_ENTRIES: usize = 32;
    let tables = scene.descriptor().size_in_bytes();
    let accelerator = bytes.saturating_sub(tables).saturating_sub(BakedScene::MIN_SIZE_IN_BYTES);
    let task =
        Worker::<ListWithoutBounds, (), 2>::SIZE_IN_BYTES - Worker::<ListWithoutBounds, (), 1>::SIZE_IN_BYTES;
    let levels = usize::from(settings.levels);
    let (what, memory) = match settings.accelerator {
        AccelKind::List => ("the list", 0),
        AccelKind::Grid | AccelKind::Octree => ("a mailbox of 64 slots", size_of::<Mailbox<MAILBOX_SLOTS>>()),
        AccelKind::Bvh => ("a stack of 32 entries", size_of::<TraversalStack<STACK_ENTRIES>>()),
    };
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}: {}, accelerator {}",
        path.display(),
        quantity(scene.descriptor().material_ids.len(), "item"),
        settings.accelerator.name()
    );
    let _ = writeln!(
        text,
        "  flash   {bytes} bytes: scene {tables}, accelerator {accelerator}, header {}",
        BakedScene::MIN_SIZE_IN_BYTES
    );
    let _ = writeln!(
        text,
        "  worker  {} bytes of RAM: {} of {task}, {what} {memory}",
        levels * task + memory + size_of::<usize>(),
        quantity(levels, "level"),
    );
    let effects = scene.required_effects();
    let shapes: Vec<&str> = effects.shapes.iter().map(|shape| shape.name()).collect();
    let _ = writeln!(text, "  shapes  {}", shapes.join(", "));
    // The lens belongs to the camera, so the effects of the scene do not include it.
    let lens = matches!(settings.camera.projection, Projection::ThinLens { .. });
    if let Some(stack) = chip::stack_usage(&EffectSet { depth_of_field: lens, ..effects }) {
        let more = levels.saturating_sub(usize::from(stack.levels)) * task;
        let _ = writeln!(
            text,
            "  stack   {} bytes including the worker, measured on a Cortex-M4F for {}",
            stack.bytes + more,
            stack.name
        );
    }
    let per_pixel = chip::instructions(&counted.counts, settings.accelerator) / counted.pixels.max(1);
    let _ = writeln!(
        text,
        "  time    about {per_pixel} instructions per pixel there with one ray per pixel, estimated from counts (within a \
         factor of {})",
        chip::ESTIMATE_FACTOR
    );
    text
}
