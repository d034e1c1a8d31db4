//! The command `info`: what is in a scene, what it asks for and why, and what it takes.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use indicatif::{HumanBytes, HumanCount};
use serde::Serialize;
use strahl_core::Scene;
use strahl_core::geometry::{Aabb, ShapeKind};
use strahl_engine::AccelStats;
use strahl_engine::accelerators;
use strahl_scene::description::LoadedScene;
use strahl_scene::effects::{PlannedEffect, plan};
use strahl_scene::load;
use strahl_scene::quantity::{self, quantity};
use strahl_settings::Effect;
use strahl_settings::{AccelKind, AccelSettings, ResolvedAccel};

use crate::args::InfoArgs;
use crate::failure::Failure;
use crate::output::{Output, say};
use crate::stock::single::scene_tables;
use crate::wrap::{width_of_stdout, wrapped};

/// Tells what is in one scene.
pub fn run(args: &InfoArgs) -> Result<(), Failure> {
    let description = load(&args.scene)?;
    for warning in &description.warnings {
        say(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let stock = scene_tables(&description);
    let scene = stock.scene().map_err(|error| Failure::input(&args.scene, error.to_string()))?;
    let info = Info::new(&description, &scene);
    let text = if args.json {
        info.to_json()
    } else {
        wrapped(&info.to_text(&args.scene), width_of_stdout(), INDENT)
    };
    Output::Stdout.commit(text.as_bytes())
}

/// What is in a scene. Field by field as `--json` prints it.
#[derive(Debug, Serialize)]
struct Info {
    objects: usize,
    /// Items by kind of shape; kinds that are not there are left out.
    by_shape: BTreeMap<&'static str, usize>,
    lights: usize,
    materials: usize,
    textures: usize,
    /// The smallest and the largest coordinates of what has an end.
    bounds: Option<[[f32; 3]; 2]>,
    plan: Vec<PlanStep>,
    not_called_for: Vec<&'static str>,
    memory: Memory,
    auto: Auto,
}

/// An effect that the scene asks for.
#[derive(Debug, Serialize)]
struct PlanStep {
    effect: &'static str,
    asked_by: Vec<String>,
}

/// Bytes.
#[derive(Debug, Serialize)]
struct Memory {
    /// The tables of the scene.
    scene: usize,
    /// Each accelerator beside them.
    accelerators: Vec<AcceleratorFacts>,
}

#[derive(Debug, Serialize)]
struct AcceleratorFacts {
    kind: &'static str,
    bytes: usize,
    regions: usize,
    /// Each item is counted in every region that it lies in.
    items_per_region: f64,
    /// Steps from the root to the deepest region; only trees have one.
    depth: Option<u32>,
    build_seconds: f64,
}

impl AcceleratorFacts {
    fn of(facts: &AccelStats) -> Self {
        AcceleratorFacts {
            kind: facts.choice.kind.name(),
            bytes: facts.bytes,
            regions: facts.regions,
            items_per_region: facts.items_per_region(),
            depth: facts.depth,
            build_seconds: facts.build.as_secs_f64(),
        }
    }
}

/// What `--accel auto` takes.
#[derive(Debug, Serialize)]
struct Auto {
    kind: &'static str,
    reason: &'static str,
}

impl Info {
    fn new(description: &LoadedScene, scene: &Scene<'_>) -> Self {
        let parts = scene.parts();
        let mut by_shape = BTreeMap::new();
        for shape in parts.geometry.shapes {
            if let Some(kind) = parts.geometry.kind(shape) {
                *by_shape.entry(kind.name()).or_insert(0) += 1;
            }
        }
        debug_assert!(by_shape.len() <= ShapeKind::ALL.len());

        let boxes: Vec<Aabb> = parts.geometry.all_bounds().collect();
        let all = boxes.iter().fold(Aabb::EMPTY, |all, item| all.union(*item));
        let bounded = boxes.iter().filter(|aabb| !aabb.is_empty()).count();
        let ResolvedAccel { kind, reason, .. } = AccelSettings::DEFAULT.resolve(bounded);
        let auto = Auto { kind: kind.name(), reason };
        let built = AccelKind::ALL.map(|kind| accelerators::stats(*scene, &AccelSettings::with_kind(kind)));
        let accelerators = built.iter().flatten().map(AcceleratorFacts::of).collect();

        let plan = plan(description);
        let missing = Effect::ALL.into_iter().filter(|effect| plan.iter().all(|it| it.effect != *effect));
        let not_called_for = missing.map(Effect::name).collect();
        Info {
            objects: parts.geometry.shapes.len(),
            by_shape,
            lights: parts.lights.len(),
            materials: parts.materials.len(),
            textures: parts.textures.len(),
            bounds: (!all.is_empty()).then(|| [all.min.to_array(), all.max.to_array()]),
            plan: plan.iter().map(PlanStep::of).collect(),
            not_called_for,
            memory: Memory { scene: parts.bytes(), accelerators },
            auto,
        }
    }

    fn to_json(&self) -> String {
        let mut json = serde_json::to_string_pretty(self).unwrap_or_default();
        json.push('\n');
        json
    }

    fn to_text(&self, path: &Path) -> String {
        let mut text = format!("{}\n", path.display());
        let mut line = |label: &str, says: String| {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {label:<15}{says}");
        };
        let count = |number: usize| HumanCount(number as u64).to_string();
        line("objects", count(self.objects));
        for (kind, number) in &self.by_shape {
            line("", quantity(*number, kind));
        }
        line("lights", count(self.lights));
        line("materials", count(self.materials));
        line("textures", count(self.textures));
        if let Some(bounds @ [[x0, y0, z0], [x1, y1, z1]]) = self.bounds {
            let largest = bounds
                .as_flattened()
                .iter()
                .fold(0.0, |most: f32, x| if x.abs() > most { x.abs() } else { most });
            let [x0, y0, z0, x1, y1, z1] = [x0, y0, z0, x1, y1, z1].map(|x| rounded(x, largest));
            line("bounds", format!("{x0} {y0} {z0} to {x1} {y1} {z1}"));
        }
        for (place, step) in self.plan.iter().enumerate() {
            line(if place == 0 { "asks for" } else { "" }, step.effect.into());
            // All of them are in the JSON.
            for reason in step.asked_by.iter().take(REASONS) {
                line("", format!("  {reason}"));
            }
            if step.asked_by.len() > REASONS {
                line("", format!("  and {} more", step.asked_by.len() - REASONS));
            }
        }
        if !self.not_called_for.is_empty() {
            line("not called for", self.not_called_for.join(", "));
        }
        line("memory", format!("{} for the scene", HumanBytes(self.memory.scene as u64)));
        for (place, it) in self.memory.accelerators.iter().enumerate() {
            let AcceleratorFacts { kind, bytes, regions, items_per_region, depth, build_seconds } = it;
            let (bytes, noun) =
                (HumanBytes(*bytes as u64).to_string(), quantity::plural(*regions as u64, "region"));
            let regions = count(*regions);
            let depth = depth.map(|depth| format!(", depth {depth}")).unwrap_or_default();
            let says = format!(
                "{kind:<7}{bytes:>11}{:>9.1} ms {regions:>11} {noun:<7} of {items_per_region:.1} items{depth}",
                1e3 * build_seconds
            );
            line(if place == 0 { "finding by" } else { "" }, says);
        }
        line("", format!("auto takes the {}: {}", self.auto.kind, self.auto.reason));
        text
    }
}

/// A coordinate to a hundred thousandth of the largest: what is behind that is rounding.
fn rounded(x: f32, largest: f32) -> f32 {
    let step = libm::pow(10.0, libm::floor(libm::log10(f64::from(largest))) - 5.0);
    let rounded = if step.is_normal() { (libm::round(f64::from(x) / step) * step) as f32 } else { x };
    // Never -0.
    rounded + 0.0
}

/// Where a line goes on that is broken: to the right of all that begins one.
const INDENT: usize = 19;

/// How many reasons for an effect are told to a person.
const REASONS: usize = 4;

impl PlanStep {
    fn of(step: &PlannedEffect) -> Self {
        let asked_by = step.reasons.iter().map(|reason| reason.to_string()).collect();
        PlanStep { effect: step.effect.name(), asked_by }
    }
}
