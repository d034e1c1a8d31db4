//! `report.html`: one page that holds everything it shows.
//!
//! It asks for nothing from outside, reads without scripts (there are none), follows light and dark,
//! and fits a phone. Whatever follows from the measurements (the front, steps, recommendations) is
//! found here, from the numbers of the study.
//!
//! | room | what it does |
//! |---|---|
//! | [`numbers`] | numbers as people read them |
//! | `scale` | from values to places along an axis |
//! | `family` | what kinds of settings look like |
//! | `scatter`, `rows` | the two kinds of plots |
//! | `brief` | what to take, in a few lines |
//! | `curve` | error against time and work |
//! | `looks` | pictures side by side |
//! | `knobs` | one plot for each knob |
//! | `missing` | what is not known, and why |
//! | `places` | where the time goes |
//! | `techniques` | techniques on and off |
//! | `chip` | what firmware has measured |
//! | `method` | how it was measured |

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

/// Where the text of the summary's lines begins.
pub const INDENT: usize = 12;

const STYLE: &str = include_str!("style.css");

/// The page.
pub fn page(study: &Study, device: Option<&DeviceMeasurements>) -> String {
    let scene = &study.scene;
    let parts: Vec<(&str, &str, Markup)> = [
        ("take", "What to take", recommendations::part(study)),
        ("curve", "Error against time", curve::part(study)),
        ("looks", "What it looks like", gallery::part(study)),
        ("knobs", "Knob by knob", sweeps::part(study)),
        ("places", "Where the time goes", breakdown::part(study)),
        ("techniques", "Technique by technique", techniques::part(study)),
    ]
    .into_iter()
    .chain(device.map(|device| ("chip", "On the chip", device::part(study, device))))
    .chain([("method", "How it was measured", method::part(study))])
    .collect();
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content=(study.method.program);
                title { "What accuracy costs: " (scene.name) }
                link rel="icon" href="data:,";
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    p.kicker { "strahl study" }
                    h1 { "What accuracy costs: " (scene.name) }
                    p.facts {
                        (scene.width) " × " (scene.height) " pixels"
                        @if let Some([width, height]) = study.method.size_with_more_time {
                            " (" (width) " × " (height) " with more time)"
                        }
                        " · "
                        (quantity(scene.objects, "object")) " · " (quantity(scene.lights, "light")) " · "
                        @if scene.effects.is_empty() { "no effects" } @else { (scene.effects.join(", ")) }
                    }
                    nav aria-label="Parts of this page" {
                        @for (id, title, _) in &parts { a href=(format!("#{id}")) { (title) } }
                    }
                }
                main {
                    (caveats::part(study))
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

/// What a person is told at the end.
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
    if let Some(doubt) = caveats::doubt(study) {
        line("beware", doubt);
    }
    let (runs, beaten) = (study.runs.len(), study.method.beaten);
    line(
        "measured",
        format!(
            "{runs} settings of {} x {} pixels in {}; {beaten} more would be beaten",
            study.scene.width,
            study.scene.height,
            numbers::seconds(study.method.seconds)
        ),
    );
    if let Some(left_out) = caveats::left_out(study) {
        line("left out", left_out);
    }
    text
}
