//! The command `bake`: a scene with its accelerator, ready to be traced from flash.

mod rust;

use std::fmt::Write as _;
use std::path::Path;

use strahl_core::{
    Aabb, Baking, Bare, Bvh, BvhRoom, Finder, Grid, GridRoom, LastFirst, Limits, Mailbox, Node, Octree,
    OctreeNode, OctreeRoom, Pack, Scene, Size, Slot, View, Worker,
};

use crate::args::BakeArgs;
use crate::failure::Failure;
use crate::finding::Kind;
use crate::load::{DEFAULT_SIZE, load_for};
use crate::output::{Output, say, tell};
use crate::stock::single::{self, Stock};

/// What is baked beside the scene.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// How items are found.
    pub accelerator: Kind,
    /// The most nodes of a hierarchy or an octree: less flash for larger leaves.
    pub nodes: Option<usize>,
    /// How it is looked at.
    pub view: View,
    /// The size of the picture.
    pub size: Size,
    /// Levels of rays.
    pub levels: u8,
    /// A ray is sent when more than this of it counts.
    pub cutoff: f32,
}

/// Bakes one scene.
pub fn run(args: &BakeArgs) -> Result<(), Failure> {
    let description = load_for(&args.scene, args.size.unwrap_or(DEFAULT_SIZE))?;
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        say(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let output = Output::prepare(&args.output)?;
    if output.replaces(&args.scene) {
        return Err(Failure::Usage("the baked scene would replace the scene".into()));
    }
    let wrong = |reason: String| Failure::Input { path: args.scene.clone(), line: None, reason };
    let stock = Stock::new(&description);
    let scene = stock.scene().map_err(|error| wrong(error.to_string()))?;
    let settings = &description.settings;
    let asked = Asked {
        accelerator: args.accel.kind().unwrap_or(Kind::Bvh),
        nodes: args.nodes.map(|nodes| nodes as usize),
        view: single::view(&description.view),
        size: args.size.or(settings.size).unwrap_or(DEFAULT_SIZE),
        levels: args.levels.or(settings.levels).unwrap_or(Limits::DEFAULT.levels),
        cutoff: args.cutoff.or(settings.cutoff).unwrap_or(Limits::DEFAULT.cutoff),
    };

    if args.output.extension().is_some_and(|extension| extension == "rs") {
        return output.commit(rust::source(&args.scene, &scene, &asked).as_bytes());
    }
    let bytes = bake(&scene, &asked).map_err(wrong)?;
    output.commit(&bytes)?;
    if !args.quiet {
        tell(needs(&args.output, &scene, &asked, bytes.len()));
    }
    Ok(())
}

/// The bytes of a scene and the accelerator that is asked for.
pub fn bake(scene: &Scene<'_>, asked: &Asked) -> Result<Vec<u8>, String> {
    let boxes: Vec<Aabb> = scene.parts().geometry.all_bounds().collect();
    let fault = |error: strahl_core::BuildError| error.to_string();
    let with = |finder: Finder<'_>| {
        let Asked { view, size, levels, cutoff, .. } = *asked;
        let baking = Baking { scene: *scene, view, size, levels, cutoff, finder };
        let mut bytes = Vec::with_capacity(baking.bytes().unwrap_or(0) as usize);
        if !baking.pour(|piece| bytes.extend_from_slice(piece)) {
            return Err("a baked scene has at most 4 GiB".into());
        }
        Ok(bytes)
    };
    let most = |wanted: usize| asked.nodes.map_or(wanted, |most| wanted.min(most));
    match asked.accelerator {
        Kind::List => with(Finder::Bare(Bare(boxes.len() as u32))),
        Kind::Grid => {
            let room = GridRoom::comfortable(&boxes);
            let (mut cells, mut items) = (vec![0; room.cells], vec![0; room.items]);
            with(Finder::Grid(Grid::build(&boxes, &mut cells, &mut items).map_err(fault)?))
        }
        Kind::Octree => {
            let room = OctreeRoom::comfortable(boxes.len());
            let (mut nodes, mut items) = (vec![OctreeNode::EMPTY; most(room.nodes)], vec![0; room.items]);
            with(Finder::Octree(Octree::build(&boxes, &mut nodes, &mut items).map_err(fault)?))
        }
        Kind::Bvh => {
            let room = BvhRoom::comfortable(boxes.len());
            let (mut nodes, mut items) = (vec![Node::EMPTY; most(room.nodes)], vec![Slot::EMPTY; room.items]);
            with(Finder::Bvh(Bvh::build(&boxes, &mut nodes, &mut items).map_err(fault)?))
        }
    }
}

/// What a device must have for it.
fn needs(path: &Path, scene: &Scene<'_>, asked: &Asked, bytes: usize) -> String {
    const SLOTS: usize = 64;
    const PLACES: usize = 32;
    let tables = scene.parts().bytes();
    let frame = bytes.saturating_sub(tables).saturating_sub(Pack::HEADER);
    let task = Worker::<Bare, (), 2>::BYTES - Worker::<Bare, (), 1>::BYTES;
    let levels = usize::from(asked.levels);
    let (what, memory) = match asked.accelerator {
        Kind::List => ("the bare list", 0),
        Kind::Grid | Kind::Octree => ("a mailbox of 64 slots", size_of::<Mailbox<SLOTS>>()),
        Kind::Bvh => ("a stack of 32 places", size_of::<LastFirst<PLACES>>()),
    };
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}: {} items, walked by {}",
        path.display(),
        scene.parts().made_of.len(),
        asked.accelerator.name()
    );
    let _ = writeln!(
        text,
        "  flash   {bytes} bytes: scene {tables}, accelerator {frame}, header {}",
        Pack::HEADER
    );
    let _ = writeln!(
        text,
        "  worker  {} bytes of RAM: {levels} levels of {task}, {what} {memory}",
        levels * task + memory + size_of::<usize>(),
    );
    let asks = scene.effects();
    let shapes: Vec<&str> = asks.shapes.iter().map(|shape| shape.name()).collect();
    let _ = writeln!(text, "  shapes  {}", shapes.join(", "));
    text.push_str("  stack   tests/firmware/check measures it, and instructions, on the chip\n");
    text
}
