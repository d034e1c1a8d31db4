//! `report.html`: a self-contained page.
//!
//! It loads nothing, has no scripts, supports light and dark mode, and fits a phone. Derived values (the Pareto front,
//! recommendations) are computed here, from the numbers of the study.
//!
//! | module | contents |
//! |---|---|
//! | [`numbers`] | numbers as text |
//! | `axis` | from values to positions along an axis |
//! | `family` | color and shape of kinds of settings |
//! | `scatter`, `row_chart` | the two kinds of plots |
//! | `pieces` | shared pieces of HTML |
//! | `caveats` | warnings, and settings that were not measured |
//! | `recommendations` | the cheapest settings for some errors |
//! | `curve` | error against time and work |
//! | `gallery` | pictures side by side |
//! | `sweeps` | one plot for each setting |
//! | `breakdown` | time by ray kind and pixel |
//! | `techniques` | techniques, on and off |
//! | `device` | measurements made by firmware |
//! | `method` | how the study was measured |

use std::fmt::Write as _;
use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};
use strahl_scene::quantity::quantity;

use crate::device::DeviceMeasurements;
use crate::record::Study;

mod axis;
mod breakdown;
mod caveats;
mod curve;
mod device;
mod family;
mod gallery;
mod method;
pub mod numbers;
mod pieces;
mod recommendations;
mod row_chart;
mod scatter;
mod sweeps;
mod techniques;

/// Column of the text in the lines of the summary.
pub const INDENT: usize = 12;

const STYLE: &str = include_str!("style.css");

/// The HTML of the report.
pub fn page(study: &Study, device: Option<&DeviceMeasurements>) -> String {
    let scene = &study.scene;
    let parts: Vec<(&str, &str, Markup)> = [
        ("take", "Recommendations", recommendations::section(study)),
        ("curve", "Error against time", curve::section(study)),
        ("looks", "Pictures", gallery::section(study)),
        ("knobs", "Effect of each setting", sweeps::section(study)),
        ("places", "Where the time goes", breakdown::section(study)),
        ("techniques", "Effect of each technique", techniques::section(study)),
    ]
    .into_iter()
    .chain(device.map(|device| ("chip", "On the device", device::section(study, device))))
    .chain([("method", "Method", method::section(study))])
    .collect();
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content=(study.method.program);
                title { "Cost of accuracy: " (scene.name) }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    p.kicker { "strahl study" }
                    h1 { "Cost of accuracy: " (scene.name) }
                    p.facts {
                        (scene.width) " × " (scene.height) " pixels"
                        @if let Some([width, height]) = study.method.size_with_more_time {
                            " (" (width) " × " (height) " with more time)"
                        }
                        " · "
                        (quantity(scene.objects, "object")) " · " (quantity(scene.lights, "light")) " · "
                        @if scene.effects.is_empty() { "no effects" } @else { (scene.effects.join(", ")) }
                    }
                    nav aria-label="Sections" {
                        @for (id, title, _) in &parts { a href=(format!("#{id}")) { (title) } }
                    }
                }
                main {
                    (caveats::section(study))
                    @for (id, title, part) in &parts {
                        section id=(id) { h2 { (title) } (part) }
                    }
                }
                footer {
                    p { (study.method.program) " · " (study.method.date) " · " (study.method.processor) }
                }
            }
        }
    };
    page.into_string() + "\n"
}

/// The summary that the program prints after a study.
pub fn summary(study: &Study, page: &Path) -> String {
    let mut text = format!("{}\n", page.display());
    let mut line = |label: &str, says: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {label:<10}{says}");
    };
    for (limit, run) in recommendations::recommended(study) {
        match run {
            Some(run) => line(
                &format!("≤ {limit}"),
                format!(
                    "{} in {}: {}",
                    numbers::error(run.error.rmse),
                    numbers::seconds(run.median_cpu_seconds()),
                    run.setting.options
                ),
            ),
            None => line(&format!("≤ {limit}"), "none of the settings measured".into()),
        }
    }
    if let Some(warning) = caveats::reference_warning(study) {
        line("warning", warning);
    }
    let (runs, dominated) = (study.runs.len(), study.method.beaten);
    line(
        "measured",
        format!(
            "{runs} settings at {} x {} pixels in {}; {dominated} combinations skipped as dominated",
            study.scene.width,
            study.scene.height,
            numbers::seconds(study.method.seconds)
        ),
    );
    if let Some(skipped) = caveats::skipped(study) {
        line("skipped", skipped);
    }
    text
}
