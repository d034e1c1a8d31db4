//! How the study was measured, so that it can be repeated and judged.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::numbers::{error, percent, seconds};
use super::pieces::options;
use crate::record::{Study, StudyRun};
use crate::statistics::{median, relative_range};

pub fn section(study: &Study) -> Markup {
    let method = &study.method;
    let repetitions: Vec<f64> = study.runs.iter().map(|run| run.cpu_seconds.len() as f64).collect();
    let repeated: Vec<&StudyRun> = study.runs.iter().filter(|run| run.cpu_seconds.len() > 2).collect();
    let mut spreads: Vec<f64> = repeated.iter().map(|run| relative_range(&run.cpu_seconds)).collect();
    spreads.sort_by(f64::total_cmp);
    // The 90 % quantile.
    let most = spreads.get((9 * spreads.len()).div_ceil(10).saturating_sub(1)).copied();
    let rates: Vec<f64> = study
        .runs
        .iter()
        .filter(|run| run.measures_accuracy())
        .map(|run| run.median_cpu_seconds() / run.work.max(1.0))
        .collect();
    let rate = median(&rates);
    let off = rates
        .iter()
        .map(|it| if *it > rate { it / rate } else { rate / it.max(1e-300) } - 1.0)
        .collect::<Vec<_>>();
    let command = format!(
        "strahl study {} --size {}x{}{}",
        study.scene.file,
        study.scene.width,
        study.scene.height,
        if method.plan == "full" { " --full" } else { "" }
    );
    let reference = &study.reference;
    html! {
        dl {
            dt { "command" } dd { code { (command) @if let Some(limit) = method.time_limit { " --time-limit " (limit) "s" } } }
            dt { "program" } dd { (method.program) ", " (method.system) }
            dt { "machine" } dd {
                (method.processor) ", " (method.cores) " hardware threads"
                @if let Some(load) = method.load { "; load average before " (load) }
            }
            dt { "date" } dd { (method.date) ", " (seconds(method.seconds)) " in total" }
            dt { "plan" } dd {
                @let about = study.runs.iter().filter(|run| run.measures_accuracy()).count();
                (method.plan) ": " (study.runs.len()) " settings measured: " (about) " for accuracy, "
                (study.runs.len() - about) " for techniques and threads. " (method.beaten)
                " combinations were skipped because a measured setting would dominate them even if they were much better than predicted"
                @if !study.left_out.is_empty() { "; " (study.left_out.len()) " were skipped for lack of time" }
            }
            dt { "reference" } dd {
                "mean of two pictures of " (options(&reference.setting.options)) " with different seeds. Remaining noise: "
                (error(reference.noise)) " (half the difference of the two). Levels and cutoff discard " (percent(reference.cut)) " of the light"
            }
            dt { "times" } dd {
                "processor seconds of tracing, the sum over all threads, without loading and building. Each setting "
                (format!("{:.0}", repetitions.iter().copied().fold(f64::INFINITY, f64::min))) " to "
                (format!("{:.0}", repetitions.iter().copied().fold(0.0, f64::max)))
                " times (the median is " (median(&repetitions)) "), in rounds over all settings, so that other load affects all alike; "
                "medians are shown. "
                @if let Some(most) = most {
                    "For the " (quantity(spreads.len(), "setting")) " measured more than twice, the range is " (percent(median(&spreads)))
                    " of the median at the median setting, and at most " (percent(most)) " for 90 % of them."
                }
            }
            dt { "work" } dd {
                "instructions, from counts that are the same on every machine: "
                @let it = &method.weights;
                (it.camera) " for a camera ray, " (it.secondary) " for a reflected or transmitted ray, " (it.shadow) " for a shadow ray including the lighting, "
                (it.shape) " for a shape test; in the BVH " (it.bvh.boxes) " for a box test and " (it.bvh.region)
                " for a visited leaf (list " (it.list.boxes) " and " (it.list.region) ", grid " (it.grid.boxes) " and " (it.grid.region) ", octree "
                (it.octree.boxes) " and " (it.octree.region) "). They were measured with callgrind. "
                "On this machine one instruction takes " (format!("{:.2}", rate * 1e9)) " ns; half of the settings are within " (percent(median(&off))) " of this"
            }
            dt { "errors" } dd {
                "of sRGB-encoded values from 0 to 1: root mean square, maximum, share of pixels with a channel that differs by more than 1/255, "
                "and structural similarity (SSIM), where 1 means equal"
            }
        }
        @if !study.left_out.is_empty() {
            details {
                summary { "Skipped for lack of time: " (study.left_out.len()) }
                ul { @for it in &study.left_out { li { code { (it.setting) } ": " (it.why) } } }
            }
        }
        p.soft { "The numbers of this page are in " code { "study.csv" } " and " code { "study.json" } " in the same folder; " code { "strahl study --from study.json" } " recreates it." }
    }
}
