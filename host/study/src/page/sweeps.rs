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
            @for sweep in study.knobs.iter().filter(|sweep| sweep.steps.len() > 1) { (card(study, sweep)) }
        }
        @for sweep in study.knobs.iter().filter(|sweep| sweep.steps.len() < 2) {
            (caveats::no_plot(study, sweep))
        }
    }
}

fn card(study: &Study, sweep: &ParameterSweep) -> Markup {
    let rows: Vec<SweepRow> = sweep
        .steps
        .iter()
        .map(|step| {
            let run = &study.runs[step.run];
            let is_sampler = sweep.name == "sampler";
            let family = if is_sampler {
                SettingFamily::named(&run.setting.settings.sampler.to_string())
            } else {
                SettingFamily::Regular
            };
            let (name, error, cost) = (step.value.clone(), step.alone.rmse, run.median_cpu_seconds());
            SweepRow { name, error, cost, spread: min_max(&run.cpu_seconds), family }
        })
        .collect();
    let order = match sweep.name.as_str() {
        "levels" | "cutoff" | "select" => RowOrder::Ascending,
        _ => RowOrder::None,
    };
    let texts: Vec<String> = rows
        .iter()
        .map(|row| format!("{}: error {}, {}", row.name, error(row.error), seconds(row.cost)))
        .collect();
    html! {
        figure.card {
            figcaption {
                h3 { code { (sweep.name) } }
                p { (sweep.about) }
            }
            (draw(&rows, order, &format!("Error and time for each value of {}. {}", sweep.name, texts.join("; "))))
            p.soft { "Fixed: " (options(&sweep.fixed)) ". Errors relative to " (sweep.against) "." }
            @if let Some(slope) = slope(study, sweep) {
                p.soft { "The error of " code { "stochastic:N" } " falls as N to the power of " (format!("{slope:.2}").replace('-', "−")) "; independent random samples would give −0.50." }
            }
            @if sweep.steps.iter().any(|step| step.value == "shadows") {
                p.soft {
                    "Work includes the shading of a light in its shadow ray. Without shadows there are no shadow rays, so that work is "
                    "underestimated; the time is correct."
                }
            }
            @if sweep.left_out > 0 {
                p.soft { (quantity(sweep.left_out, "setting")) " not measured: " (caveats::why(study)) "." }
            }
            (scrollable(steps(study, sweep)))
        }
    }
}

/// Cost and error of each value compared with the one before. Samplers and effects have no order: each is compared with the
/// first, or the last.
fn steps(study: &Study, sweep: &ParameterSweep) -> Markup {
    let pairs: Vec<(&SweepPoint, &SweepPoint)> = match sweep.name.as_str() {
        "sampler" => sweep
            .steps
            .first()
            .into_iter()
            .flat_map(|first| sweep.steps.iter().skip(1).map(move |it| (first, it)))
            .collect(),
        "without" => sweep
            .steps
            .last()
            .into_iter()
            .flat_map(|last| sweep.steps.iter().take(sweep.steps.len() - 1).map(move |it| (last, it)))
            .collect(),
        _ => sweep.steps.windows(2).map(|two| (&two[0], &two[1])).collect(),
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
pub fn slope(study: &Study, sweep: &ParameterSweep) -> Option<f64> {
    let noise = study.reference.noise;
    let point = |step: &SweepPoint| {
        let samples: f64 = step.value.strip_prefix("stochastic:")?.parse().ok()?;
        // Without the noise of the reference.
        let own = step.alone.rmse * step.alone.rmse - noise * noise;
        (own > 0.0).then(|| (libm::log(samples), 0.5 * libm::log(own)))
    };
    let points: Vec<(f64, f64)> = sweep.steps.iter().filter_map(point).collect();
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
