//! One plot for each setting: cost and error of each value.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::caveats;
use super::family::SettingFamily;
use super::numbers::{change, error, seconds};
use super::pieces::{options, scrollable};
use super::row_chart::{RowOrder, SweepRow, draw};
use crate::record::{ParameterSweep, Study, SweepPoint};
use crate::statistics::min_max;

pub fn section(study: &Study) -> Markup {
    html! {
        p {
            "One setting is varied at a time; all others are at their most accurate value. Dots show the error it causes alone, bars "
            "the processor time."
        }
        div.cards {
            @for knob in study.knobs.iter().filter(|knob| knob.steps.len() > 1) { (card(study, knob)) }
        }
        @for knob in study.knobs.iter().filter(|knob| knob.steps.len() < 2) {
            (caveats::knob(study, knob))
        }
    }
}

fn card(study: &Study, knob: &ParameterSweep) -> Markup {
    let rows: Vec<SweepRow> = knob
        .steps
        .iter()
        .map(|step| {
            let run = &study.runs[step.run];
            let is_sampler = knob.name == "sampler";
            let family = if is_sampler {
                SettingFamily::named(&run.setting.settings.sampler.to_string())
            } else {
                SettingFamily::Regular
            };
            let (name, error, cost) = (step.value.clone(), step.alone.rmse, run.median_cpu_seconds());
            SweepRow { name, error, cost, spread: min_max(&run.cpu), family }
        })
        .collect();
    let order = match knob.name.as_str() {
        "levels" | "cutoff" | "select" => RowOrder::Ascending,
        _ => RowOrder::None,
    };
    let told: Vec<String> = rows
        .iter()
        .map(|row| format!("{}: error {}, {}", row.name, error(row.error), seconds(row.cost)))
        .collect();
    html! {
        figure.card {
            figcaption {
                h3 { code { (knob.name) } }
                p { (knob.about) }
            }
            (draw(&rows, order, &format!("Error and time for each value of {}. {}", knob.name, told.join("; "))))
            p.soft { "Fixed: " (options(&knob.fixed)) ". Errors relative to " (knob.against) "." }
            @if let Some(slope) = slope(study, knob) {
                p.soft { "The error of " code { "stochastic:N" } " falls as N to the power of " (format!("{slope:.2}").replace('-', "−")) "; independent random samples would give −0.50." }
            }
            @if knob.steps.iter().any(|step| step.value == "shadows") {
                p.soft {
                    "Work includes the shading of a light in its shadow ray. Without shadows there are no shadow rays, so that work is "
                    "underestimated; the time is correct."
                }
            }
            @if knob.left_out > 0 {
                p.soft { (quantity(knob.left_out, "setting")) " not measured: " (caveats::why(study)) "." }
            }
            (scrollable(steps(study, knob)))
        }
    }
}

/// Cost and error of each value compared with the one before. Samplers and effects have no order: each is compared with the
/// first, or the last.
fn steps(study: &Study, knob: &ParameterSweep) -> Markup {
    let pairs: Vec<(&SweepPoint, &SweepPoint)> = match knob.name.as_str() {
        "sampler" => knob
            .steps
            .first()
            .into_iter()
            .flat_map(|first| knob.steps.iter().skip(1).map(move |it| (first, it)))
            .collect(),
        "without" => knob
            .steps
            .last()
            .into_iter()
            .flat_map(|last| knob.steps.iter().take(knob.steps.len() - 1).map(move |it| (last, it)))
            .collect(),
        _ => knob.steps.windows(2).map(|two| (&two[0], &two[1])).collect(),
    };
    html! {
        table.plain {
            thead { tr { th { "from" } th { "to" } th.number { "time" } th.number { "work" } th.number { "error" } } }
            tbody {
                @for (from, to) in pairs {
                    @let (before, after) = (&study.runs[from.run], &study.runs[to.run]);
                    tr {
                        td { (from.value) } td { (to.value) }
                        td.number { (change(before.median_cpu_seconds(), after.median_cpu_seconds())) }
                        td.number { (change(before.work, after.work)) }
                        td.number { (error(from.alone.rmse)) " → " (error(to.alone.rmse)) }
                    }
                }
            }
        }
    }
}

/// The convergence of `stochastic:N`: the exponent of N, by least squares of the logarithms.
pub fn slope(study: &Study, knob: &ParameterSweep) -> Option<f64> {
    let noise = study.reference.noise;
    let point = |step: &SweepPoint| {
        let samples: f64 = step.value.strip_prefix("stochastic:")?.parse().ok()?;
        // Without the noise of the reference.
        let own = step.alone.rmse * step.alone.rmse - noise * noise;
        (own > 0.0).then(|| (libm::log(samples), 0.5 * libm::log(own)))
    };
    let points: Vec<(f64, f64)> = knob.steps.iter().filter_map(point).collect();
    if points.len() < 3 {
        return None;
    }
    let count = points.len() as f64;
    let (x, y) =
        (points.iter().map(|p| p.0).sum::<f64>() / count, points.iter().map(|p| p.1).sum::<f64>() / count);
    let (up, across) = points
        .iter()
        .fold((0.0, 0.0), |(up, across), p| (up + (p.0 - x) * (p.1 - y), across + (p.0 - x) * (p.0 - x)));
    Some(up / across)
}
