//! The command `info`: the contents of a scene, the effects that it requires, and its memory.

use std::fmt::Write as _;
use std::path::Path;

use indicatif::{HumanBytes, HumanCount};
use strahl_scene::load;
use strahl_scene::quantity::{self, quantity};
use strahl_session::scene_info::{AcceleratorInfo, SceneInfo};

use crate::args::InfoArgs;
use crate::error::CommandError;
use crate::output::{Output, print_message};
use crate::word_wrap::{stdout_width, wrapped};

/// Prints the contents of one scene.
pub fn run(args: &InfoArgs) -> Result<(), CommandError> {
    let description = load(&args.scene)?;
    for warning in &description.warnings {
        print_message(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let info = SceneInfo::new(&description);
    let info = info.map_err(|error| CommandError::input(&args.scene, error.to_string()))?;
    let text = if args.json {
        to_json(&info)
    } else {
        wrapped(&to_text(&info, &args.scene), stdout_width(), INDENT)
    };
    Output::Stdout.commit(text.as_bytes())
}

fn to_json(info: &SceneInfo) -> String {
    let mut json = serde_json::to_string_pretty(info).unwrap_or_default();
    json.push('\n');
    json
}

fn to_text(info: &SceneInfo, path: &Path) -> String {
    let mut text = format!("{}\n", path.display());
    let mut line = |label: &str, says: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {label:<15}{says}");
    };
    let count = |number: usize| HumanCount(number as u64).to_string();
    line("objects", count(info.objects));
    for (kind, number) in &info.by_shape {
        line("", quantity(*number, kind));
    }
    line("lights", count(info.lights));
    line("materials", count(info.materials));
    line("textures", count(info.textures));
    if let Some(bounds @ [[x0, y0, z0], [x1, y1, z1]]) = info.bounds {
        let largest = bounds
            .as_flattened()
            .iter()
            .fold(0.0, |most: f32, x| if x.abs() > most { x.abs() } else { most });
        let [x0, y0, z0, x1, y1, z1] = [x0, y0, z0, x1, y1, z1].map(|x| rounded(x, largest));
        line("bounds", format!("{x0} {y0} {z0} to {x1} {y1} {z1}"));
    }
    for (place, step) in info.plan.iter().enumerate() {
        line(if place == 0 { "requires" } else { "" }, step.effect.into());
        // All of them are in the JSON.
        for reason in step.required_by.iter().take(MAX_REASONS) {
            line("", format!("  {reason}"));
        }
        if step.required_by.len() > MAX_REASONS {
            line("", format!("  and {} more", step.required_by.len() - MAX_REASONS));
        }
    }
    if !info.not_called_for.is_empty() {
        line("not required", info.not_called_for.join(", "));
    }
    line("memory", format!("{} for the scene", HumanBytes(info.memory.scene as u64)));
    for (place, it) in info.memory.accelerators.iter().enumerate() {
        let AcceleratorInfo { kind, bytes, regions, items_per_region, depth, build_seconds } = it;
        let (bytes, noun) =
            (HumanBytes(*bytes as u64).to_string(), quantity::plural(*regions as u64, "region"));
        let regions = count(*regions);
        let depth = depth.map(|depth| format!(", depth {depth}")).unwrap_or_default();
        let says = format!(
            "{kind:<7}{bytes:>11}{:>9.1} ms {regions:>11} {noun:<7} of {items_per_region:.1} items{depth}",
            1e3 * build_seconds
        );
        line(if place == 0 { "accelerators" } else { "" }, says);
    }
    line("", format!("auto selects {}: {}", info.auto.kind, info.auto.reason));
    text
}

/// A coordinate to a hundred thousandth of the largest: the rest is rounding.
fn rounded(x: f32, largest: f32) -> f32 {
    let step = libm::pow(10.0, libm::floor(libm::log10(f64::from(largest))) - 5.0);
    let rounded = if step.is_normal() { (libm::round(f64::from(x) / step) * step) as f32 } else { x };
    // Never -0.
    rounded + 0.0
}

/// Column at which a broken line continues.
const INDENT: usize = 19;

/// Maximum number of printed reasons for an effect.
const MAX_REASONS: usize = 4;
