//! How it was measured, so that others can do it again and know what to believe.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::numbers::{error, percent, seconds};
use super::pieces::options;
use crate::record::{Study, StudyRun};
use crate::statistics::{median, relative_range};

pub fn part(study: &Study) -> Markup {
    let method = &study.method;
    let repetitions: Vec<f64> = study.runs.iter().map(|run| run.cpu.len() as f64).collect();
    let repeated: Vec<&StudyRun> = study.runs.iter().filter(|run| run.cpu.len() > 2).collect();
    let mut spreads: Vec<f64> = repeated.iter().map(|run| relative_range(&run.cpu)).collect();
    spreads.sort_by(f64::total_cmp);
    // Nine of ten are no wider than this one.
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
            dt { "again" } dd { code { (command) @if let Some(limit) = method.time_limit { " --time-limit " (limit) "s" } } }
            dt { "program" } dd { (method.program) ", " (method.system) }
            dt { "machine" } dd {
                (method.processor) ", " (method.cores) " threads at once"
                @if let Some(load) = method.load { "; load before it began " (load) }
            }
            dt { "when" } dd { (method.date) ", " (seconds(method.seconds)) " for all of it" }
            dt { "plan" } dd {
                @let about = study.runs.iter().filter(|run| run.measures_accuracy()).count();
                (method.plan) ": " (study.runs.len()) " settings measured, of which " (about) " tell what accuracy costs and "
                (study.runs.len() - about) " what techniques and threads save; " (method.beaten)
                " more were not, because one that was measured would beat them even if they were a good deal better than foretold"
                @if !study.left_out.is_empty() { "; " (study.left_out.len()) " for want of time" }
            }
            dt { "reference" } dd {
                "the mean of two pictures of " (options(&reference.setting.options)) " with seeds of their own. What is left of chance in it is "
                (error(reference.noise)) " (half the difference of the two); the levels and the cutoff cut " (percent(reference.cut)) " of the light"
            }
            dt { "times" } dd {
                "processor seconds of tracing, the sum over all threads, without loading and building. Each setting "
                (format!("{:.0}", repetitions.iter().copied().fold(f64::INFINITY, f64::min))) " to "
                (format!("{:.0}", repetitions.iter().copied().fold(0.0, f64::max)))
                " times (the median is " (median(&repetitions)) "), in rounds over all settings, so that what disturbs the machine disturbs all alike; "
                "medians are told. "
                @if let Some(most) = most {
                    "From the least to the most it is " (percent(median(&spreads))) " of the median in the middle of the " (quantity(spreads.len(), "setting"))
                    " that were measured more than twice, and at most " (percent(most)) " for nine of ten of them."
                }
            }
            dt { "work" } dd {
                "instructions, from counts that are the same on every machine: "
                @let it = &method.weights;
                (it.camera) " for a camera ray, " (it.secondary) " for one that is reflected or transmitted, " (it.shadow) " for a question to a light with the light that comes of it, "
                (it.shape) " for a test of a shape; and in the hierarchy " (it.bvh.boxes) " for a test of a box and " (it.bvh.region)
                " for a region entered (list " (it.list.boxes) " and " (it.list.region) ", grid " (it.grid.boxes) " and " (it.grid.region) ", octree "
                (it.octree.boxes) " and " (it.octree.region) "). They were measured with callgrind. "
                "Here one takes " (format!("{:.2}", rate * 1e9)) " ns; the times of half of all settings are within " (percent(median(&off))) " of that"
            }
            dt { "errors" } dd {
                "of sRGB-encoded values from 0 to 1: the root of the mean square, the largest, the share of pixels with a channel more than 1/255 off, "
                "and the structural similarity (SSIM), in which 1 is equal"
            }
        }
        @if !study.left_out.is_empty() {
            details {
                summary { "Left out for want of time: " (study.left_out.len()) }
                ul { @for it in &study.left_out { li { code { (it.setting) } ": " (it.why) } } }
            }
        }
        p.soft { "The numbers of this page are in " code { "study.csv" } " and " code { "study.json" } " beside it; " code { "strahl study --from study.json" } " makes it again." }
    }
}
