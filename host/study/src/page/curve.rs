//! Error against time and against work, for all settings.

use maud::{Markup, html};

use super::family::SettingFamily;
use super::numbers::{count, error, percent, seconds};
use super::pieces::{options, scrollable, words};
use super::scatter::{ScatterPlot, ScatterPoint, legend};
use crate::pareto::CostErrorPoint;
use crate::record::table::pareto_runs;
use crate::record::{RunRole, Study, StudyRun};
use crate::statistics::min_max;

fn dots(
    study: &Study,
    cost: fn(&StudyRun) -> f64,
    spread: fn(&StudyRun) -> Option<[f64; 2]>,
) -> Vec<ScatterPoint> {
    let numbers = numbered(study);
    let about = study.runs.iter().enumerate().filter(|(_, run)| run.measures_accuracy());
    about
        .map(|(place, run)| ScatterPoint {
            point: CostErrorPoint { cost: cost(run), error: run.error.rmse },
            spread: spread(run),
            family: SettingFamily::of(&run.setting.settings),
            number: numbers.iter().find(|(at, _)| *at == place).map(|(_, number)| *number),
            is_own: run.role == RunRole::Own,
            about: format!(
                "{}: {}, {} instructions, error {}",
                words(run),
                seconds(run.median_cpu_seconds()),
                count(run.work),
                error(run.error.rmse)
            ),
        })
        .collect()
}

pub fn section(study: &Study) -> Markup {
    let by_time = dots(study, StudyRun::median_cpu_seconds, |run| Some(min_max(&run.cpu_seconds)));
    let by_work = dots(study, |run| run.work, |_| None);
    let noise = Some(study.reference.noise).filter(|noise| *noise > 0.0);
    let alt = |cost: &str| {
        let numbers = numbered(study);
        let (first, last) = (numbers.first(), numbers.last());
        let text = |end: Option<&(usize, usize)>| {
            end.map(|(place, _)| {
                let run = &study.runs[*place];
                format!("{} with error {}", words(run), error(run.error.rmse))
            })
            .unwrap_or_default()
        };
        format!(
            "Scatter plot of {} settings, error against {cost}, both logarithmic. The Pareto front goes from {} to {}.",
            by_work.len(),
            text(first),
            text(last)
        )
    };
    html! {
        p {
            "Each mark is one setting; left is cheaper, down is more accurate. Numbered marks are the "
            strong { "Pareto front" } ": no measured setting is both cheaper and more accurate."
        }
        (legend(&by_work))
        div.pair {
            figure {
                figcaption { "Processor time" span.soft { " on this machine, with its range" } }
                (ScatterPlot { dots: &by_time, cost: "processor seconds", write: seconds, noise, alt: alt("processor time") }.draw())
            }
            figure {
                figcaption { "Work" span.soft { " in instructions, the same on every machine" } }
                (ScatterPlot { dots: &by_work, cost: "instructions", write: count, noise, alt: alt("work in instructions") }.draw())
            }
        }
        h3 { "Pareto front" }
        (scrollable(table(study, &numbered(study))))
        details {
            summary { "All " (by_work.len()) " settings of these plots" }
            (scrollable(table(study, &all(study))))
        }
    }
}

/// Indices of all runs of the plots with their numbers, cheapest first; 0 means without a number.
fn all(study: &Study) -> Vec<(usize, usize)> {
    let numbers = numbered(study);
    let of = |place: usize| numbers.iter().find(|(at, _)| *at == place).map_or(0, |(_, number)| *number);
    let about = study.runs.iter().enumerate().filter(|(_, run)| run.measures_accuracy());
    let mut places: Vec<usize> = about.map(|(place, _)| place).collect();
    places.sort_by(|a, b| study.runs[*a].work.total_cmp(&study.runs[*b].work));
    places.into_iter().map(|place| (place, of(place))).collect()
}

fn table(study: &Study, places: &[(usize, usize)]) -> Markup {
    html! {
        table.plain {
            thead { tr {
                th { "" } th { "setting" } th.number { "time" } th.number { "range" } th.number { "instructions" }
                th.number { "error" } th.number { "largest" } th.number { "beyond 1/255" } th.number { "SSIM" }
            } }
            tbody {
                @for (place, number) in places {
                    @let run = &study.runs[*place];
                    @let [least, most] = min_max(&run.cpu_seconds);
                    tr {
                        td.number { @if *number > 0 { strong { (number) } } }
                        td {
                            (options(&words(run)))
                            @if run.role == RunRole::Own { span.tag { "scene's settings" } }
                        }
                        td.number { (seconds(run.median_cpu_seconds())) }
                        td.number.soft { (seconds(least)) "–" (seconds(most)) }
                        td.number { (count(run.work)) }
                        td.number { (error(run.error.rmse)) }
                        td.number { (error(run.error.largest)) }
                        td.number { (percent(run.error.beyond)) }
                        td.number { (format!("{:.4}", run.error.ssim)) }
                    }
                }
            }
        }
    }
}

/// Indices of the numbered runs of the front by work, with their numbers from 1. A run that is hardly more accurate than the
/// one before is not numbered, except the last.
fn numbered(study: &Study) -> Vec<(usize, usize)> {
    const BETTER: f64 = 0.97;
    let all = pareto_runs(study, |run| run.work);
    let mut runs: Vec<usize> = Vec::new();
    for (index, place) in all.iter().enumerate() {
        let error = study.runs[*place].error.rmse;
        let is_last = index + 1 == all.len();
        let is_better = runs.last().is_none_or(|last| error <= BETTER * study.runs[*last].error.rmse);
        if is_better || is_last {
            runs.push(*place);
        }
    }
    runs.into_iter().enumerate().map(|(index, place)| (place, index + 1)).collect()
}
