//! Summary of a render, as text.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Duration;

use anstyle::{AnsiColor, Effects, Style};
use indicatif::{HumanBytes, HumanCount};
use strahl_core::tally::RayKind;
use strahl_scene::effects::PlannedEffect;
use strahl_scene::quantity::quantity;
use strahl_session::RenderOutput;
use strahl_settings::{OptionalEffect, Precision, SamplerSettings};

/// Column of the text of a line, after its label.
pub const INDENT: usize = 12;

/// Style of the labels.
const LABEL: Style = Style::new().effects(Effects::DIMMED);
/// Style of the picture's name.
const TITLE: Style = AnsiColor::Green.on_default().effects(Effects::BOLD);

/// The lines about a picture at `path`, styled for a terminal.
pub fn summary(
    path: &Path,
    frame: &RenderOutput,
    plan: &[PlannedEffect],
    sampling: SamplerSettings,
    load: Duration,
    write: Duration,
) -> String {
    let (size, counters) = (frame.picture.size, &frame.counters);
    let mut text = format!("{TITLE}{}{TITLE:#}  {} x {}\n", path.display(), size.width(), size.height());
    let mut line = |label: &str, says: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {LABEL}{label:<10}{LABEL:#}{says}");
    };

    let count = |number: u64| HumanCount(number).to_string();
    let s = |time: Duration| format!("{:.2} s", time.as_secs_f64());
    line(
        "time",
        format!(
            "load {}, build {}, trace {} ({} on all threads), write {}",
            s(load),
            s(frame.build),
            s(frame.trace),
            s(frame.trace_cpu),
            s(write)
        ),
    );
    let rays = |kind| count(counters.rays[kind]);
    line(
        "rays",
        format!(
            "{} camera, {} reflected, {} transmitted, {} shadow",
            rays(RayKind::Camera),
            rays(RayKind::Reflected),
            rays(RayKind::Transmitted),
            rays(RayKind::Shadow)
        ),
    );
    let found = &frame.accelerator;
    let regions = quantity(found.regions, "region");
    let precision = match frame.precision {
        Precision::Single => "",
        Precision::Double => "; double precision",
    };
    line(
        "accel",
        format!(
            "{}, {}: {regions}, {}{precision}",
            found.choice,
            found.choice.reason,
            HumanBytes(found.bytes as u64)
        ),
    );
    for (place, step) in plan.iter().filter(|step| step.enabled).enumerate() {
        line(if place == 0 { "effects" } else { "" }, reasons(step));
    }
    for step in plan.iter().filter(|step| !step.enabled) {
        line("disabled", reasons(step));
    }
    let unused: Vec<_> = OptionalEffect::ALL
        .into_iter()
        .filter(|effect| plan.iter().all(|step| step.effect != *effect))
        .map(OptionalEffect::name)
        .collect();
    if !unused.is_empty() {
        line("unused", unused.join(", "));
    }
    let (levels, cutoff) = (counters.level_limit.rays, counters.cutoff.rays);
    if levels + cutoff > 0 {
        let [by_levels, by_cutoff] = counters.cut_fractions();
        let rays =
            format!("{} beyond the last level, {} below the cutoff", quantity(levels, "ray"), count(cutoff));
        line("discarded", format!("{} of the light: {rays}", percent(by_levels + by_cutoff)));
    }
    if counters.medium_stack_full > 0 {
        line(
            "note",
            format!(
                "{} into a fifth nested body were ignored",
                quantity(counters.medium_stack_full, "entry")
            ),
        );
    }
    if counters.camera_hits == 0 && frame.scene.objects > 0 {
        line("note", "no camera ray hits anything".into());
    }
    let noisy: Vec<_> = plan
        .iter()
        .filter(|step| step.enabled && OptionalEffect::DISTRIBUTED.contains(&step.effect))
        .map(|step| step.effect.name())
        .collect();
    if sampling == SamplerSettings::Single && !noisy.is_empty() {
        let (noisy, is) = (noisy.join(", "), if noisy.len() == 1 { "is" } else { "are" });
        line("note", format!("{noisy} {is} noisy with one ray per pixel; use --sampler stochastic:64"));
    }
    text
}

/// Lines with a label each.
pub fn lines(lines: &[(&str, String)]) -> String {
    let line = |(label, says): &(&str, String)| format!("  {LABEL}{label:<10}{LABEL:#}{says}\n");
    lines.iter().map(line).collect()
}

/// A share in percent, rounded, but 0 only if it is 0.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent == 0.0 {
        "0 %".into()
    } else if percent < 0.001 {
        "less than 0.001 %".into()
    } else {
        let digits = if percent < 0.01 {
            3
        } else if percent < 0.1 {
            2
        } else {
            1
        };
        format!("{percent:.digits$} %")
    }
}

/// An effect and the first reason for it.
fn reasons(step: &PlannedEffect) -> String {
    let first = step.reasons.first().map(|reason| format!(": {reason}")).unwrap_or_default();
    match step.reasons.len() {
        0 | 1 => format!("{}{first}", step.effect),
        more => format!("{}{first} and {} more", step.effect, more - 1),
    }
}
