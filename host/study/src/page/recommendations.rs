//! The cheapest settings for some maximum errors.

use maud::{Markup, html};

use super::numbers::{change, error, seconds};
use super::pieces::{options, scrollable};
use crate::pareto::{CostErrorPoint, ERROR_LIMITS, cheapest_within, pareto_front};
use crate::record::{RunRole, Study, StudyRun};

/// Runs that measure accuracy, with their work.
fn points(study: &Study) -> (Vec<&StudyRun>, Vec<CostErrorPoint>) {
    let about = study.runs.iter().filter(|run| run.measures_accuracy());
    about.map(|run| (run, CostErrorPoint { cost: run.work, error: run.error.rmse })).unzip()
}

/// For each maximum error, the run with the least work that reaches it.
pub fn recommended(study: &Study) -> Vec<(f64, Option<&StudyRun>)> {
    let (runs, points) = points(study);
    let within = |limit: f64| Some(runs[cheapest_within(&points, limit)?]);
    ERROR_LIMITS.into_iter().map(|limit| (limit, within(limit))).collect()
}

pub fn section(study: &Study) -> Markup {
    let own = study.runs.iter().find(|run| run.role == RunRole::Own);
    html! {
        @match own {
            Some(own) => { p.lead { (against_own(study, own)) } }
            None => { p.lead { "The scene's settings were not measured: no time was left." } }
        }
        (scrollable(html! {
            table {
                thead { tr {
                    th { "error at most" } th { "cheapest setting" } th.number { "error" } th.number { "time" }
                    @if own.is_some() { th.number { "compared with the scene's settings" } }
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
                                    "no measured setting is as accurate"
                                    @if study.method.time_limit.is_some() { "; a larger --time-limit measures finer ones" }
                                } }
                            }
                        }
                    }
                }
            }
        }))
        p.soft {
            "Errors are RMSE against the reference, in sRGB-encoded values from 0 to 1. Cheapest means least work (see below). "
            "Times are processor seconds, the median of all repetitions."
        }
    }
}

/// Alternatives to the settings of the scene.
fn against_own(study: &Study, own: &StudyRun) -> Markup {
    let (runs, points) = points(study);
    let as_good = cheapest_within(&points, own.error.rmse).map(|place| runs[place]);
    let as_cheap = pareto_front(&points).into_iter().rfind(|place| points[*place].cost <= own.work);
    let as_cheap = as_cheap.map(|place| runs[place]);
    let (time, rmse) = (seconds(own.median_cpu_seconds()), error(own.error.rmse));
    html! {
        "The scene's settings, " (options(&own.setting.options)) ", take " strong { (time) } " with an error of " strong { (rmse) } ". "
        @match as_good {
            Some(run) if run.work < 0.95 * own.work => {
                "The same accuracy takes " strong { (seconds(run.median_cpu_seconds())) } " with " (options(&run.setting.options)) ". "
            }
            _ => { "No measured setting is as accurate and cheaper. " }
        }
        @match as_cheap {
            Some(run) if run.error.rmse < 0.95 * own.error.rmse => {
                "With no more work, " (options(&run.setting.options)) " has an error of " strong { (error(run.error.rmse)) } "."
            }
            _ => {}
        }
    }
}
