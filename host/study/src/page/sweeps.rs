//! One plot for each knob: what each notch costs, and what it makes wrong.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::caveats;
use super::family::SettingFamily;
use super::numbers::{change, error, seconds};
use super::pieces::{options, wide};
use super::row_chart::{RowOrder, SweepRow, draw};
use crate::record::{ParameterSweep, Study, SweepPoint};
use crate::statistics::min_max;

pub fn part(study: &Study) -> Markup {
    html! {
        p {
            "One knob is turned at a time, everything else being as good as it gets. Dots are the error that it makes alone, bars "
            "the processor time of the picture."
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
            p.soft { "At " (options(&knob.fixed)) "; errors against " (knob.against) "." }
            @if let Some(slope) = slope(study, knob) {
                p.soft { "The error of " code { "stochastic:N" } " falls as N to the power of " (format!("{slope:.2}").replace('-', "−")) "; chance alone would give −0.50." }
            }
            @if knob.steps.iter().any(|step| step.value == "shadows") {
                p.soft {
                    "Work counts what a light's colour takes together with the shadow ray to it. Without shadows there are no such rays, "
                    "so the work told for that is too small; the time is right."
                }
            }
            @if knob.left_out > 0 {
                p.soft { (quantity(knob.left_out, "setting")) " not measured: " (caveats::why(study)) "." }
            }
            (wide(steps(study, knob)))
        }
    }
}

/// What each notch costs over the one before. Samplers and effects have no order of their own: each is
/// held against the first, or the last.
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

/// How the error of `stochastic:N` falls: the exponent of N, by least squares of the logarithms.
pub fn slope(study: &Study, knob: &ParameterSweep) -> Option<f64> {
    let noise = study.reference.noise;
    let point = |step: &SweepPoint| {
        let samples: f64 = step.value.strip_prefix("stochastic:")?.parse().ok()?;
        // Without the part that is the reference's.
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
