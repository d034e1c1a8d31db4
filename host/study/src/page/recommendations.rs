//! What to take: the cheapest settings for some limits of the error.

use maud::{Markup, html};

use super::numbers::{change, error, seconds};
use super::pieces::{options, wide};
use crate::pareto::{CostErrorPoint, ERROR_LIMITS, cheapest_within, pareto_front};
use crate::record::{RunRole, Study, StudyRun};

/// Runs that tell what accuracy costs, by their work.
fn points(study: &Study) -> (Vec<&StudyRun>, Vec<CostErrorPoint>) {
    let about = study.runs.iter().filter(|run| run.measures_accuracy());
    about.map(|run| (run, CostErrorPoint { cost: run.work, error: run.error.rmse })).unzip()
}

/// For each limit the run that needs the least work and keeps it.
pub fn recommended(study: &Study) -> Vec<(f64, Option<&StudyRun>)> {
    let (runs, points) = points(study);
    let within = |limit: f64| Some(runs[cheapest_within(&points, limit)?]);
    ERROR_LIMITS.into_iter().map(|limit| (limit, within(limit))).collect()
}

pub fn part(study: &Study) -> Markup {
    let own = study.runs.iter().find(|run| run.role == RunRole::Own);
    html! {
        @match own {
            Some(own) => { p.lead { (against_own(study, own)) } }
            None => { p.lead { "The scene's own setting was not measured to the end: no time was left." } }
        }
        (wide(html! {
            table {
                thead { tr {
                    th { "error at most" } th { "cheapest setting" } th.number { "error" } th.number { "time" }
                    @if own.is_some() { th.number { "against the scene's own" } }
                } }
                tbody {
                    @for (limit, run) in recommended(study) {
                        tr {
                            th scope="row" { (limit) span.soft { " · " (format!("{:.1}", 255.0 * limit)) " of 255" } }
                            @match run {
                                Some(run) => {
                                    td { (options(&run.setting.options)) }
                                    td.number { (error(run.error.rmse)) }
                                    td.number { (seconds(run.median_cpu_seconds())) }
                                    @if let Some(own) = own { td.number { (change(own.median_cpu_seconds(), run.median_cpu_seconds())) } }
                                }
                                None => { td.soft colspan=(if own.is_some() { 4 } else { 3 }) {
                                    "no setting that was measured is as good"
                                    @if study.method.time_limit.is_some() { "; a larger --time-limit measures finer ones" }
                                } }
                            }
                        }
                    }
                }
            }
        }))
        p.soft {
            "Errors are the root of the mean square of differences from the reference, of sRGB-encoded values from 0 to 1. "
            "The cheapest is the one with the least work (see below), times are processor seconds of this picture, the "
            "median of all repetitions."
        }
    }
}

/// What could be had instead of the scene's own setting.
fn against_own(study: &Study, own: &StudyRun) -> Markup {
    let (runs, points) = points(study);
    let as_good = cheapest_within(&points, own.error.rmse).map(|place| runs[place]);
    let as_cheap = pareto_front(&points).into_iter().rfind(|place| points[*place].cost <= own.work);
    let as_cheap = as_cheap.map(|place| runs[place]);
    let (time, wrong) = (seconds(own.median_cpu_seconds()), error(own.error.rmse));
    html! {
        "The scene's own setting, " (options(&own.setting.options)) ", takes " strong { (time) } " and is " strong { (wrong) } " off. "
        @match as_good {
            Some(run) if run.work < 0.95 * own.work => {
                "As good a picture can be had for " strong { (seconds(run.median_cpu_seconds())) } " with " (options(&run.setting.options)) ". "
            }
            _ => { "No setting that was measured is as good for less. " }
        }
        @match as_cheap {
            Some(run) if run.error.rmse < 0.95 * own.error.rmse => {
                "For no more work " (options(&run.setting.options)) " is only " strong { (error(run.error.rmse)) } " off."
            }
            _ => {}
        }
    }
}
