//! What a study does not know: a reference that is coarser than the errors it measures, and what was left out.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::numbers::percent;
use crate::pareto::ERROR_LIMITS;
use crate::record::{ParameterSweep, Study};

/// The smallest recommended or significant error.
fn smallest_resolved_error(study: &Study) -> f64 {
    let [.., least] = ERROR_LIMITS;
    if study.reference.noise > least { study.reference.noise } else { least }
}

/// A warning if the reference discards more light than the smallest resolved error.
pub fn reference_warning(study: &Study) -> Option<String> {
    let reference = &study.reference;
    (reference.cut > smallest_resolved_error(study)).then(|| {
        format!(
            "The reference discards {} of the light ({}). The errors do not include this: a setting that discards the same \
             light appears exact.{}",
            percent(reference.cut),
            reference.setting.options,
            if study.method.time_limit.is_some() { " A larger --time-limit gives a finer reference." } else { "" }
        )
    })
}

/// The warnings at the top of the page.
pub fn section(study: &Study) -> Markup {
    html! {
        @if let Some(warning) = reference_warning(study) { p.warning role="note" { strong { "Warning: " } (warning) } }
        @if let Some(skipped) = skipped(study) {
            p.warning role="note" { (skipped) " " a href="#method" { "Details" } }
        }
    }
}

/// Why settings were not measured.
pub fn why(study: &Study) -> &'static str {
    if study.method.time_limit.is_some() { "no time was left" } else { "it would have taken too long" }
}

/// The number of settings that were not measured, and the names of those without any measurement.
pub fn skipped(study: &Study) -> Option<String> {
    let count = study.left_out.len();
    let unknown: Vec<&str> =
        study.knobs.iter().filter(|sweep| is_unknown(sweep)).map(|sweep| sweep.name.as_str()).collect();
    let nothing = match &unknown[..] {
        [] => String::new(),
        names => format!("; {} was not measured", names.join(", ")),
    };
    let more = if study.method.time_limit.is_some() { "; a larger --time-limit measures more" } else { "" };
    (count > 0)
        .then(|| format!("{} not measured: {}{nothing}{more}.", quantity(count, "setting"), why(study)))
}

/// Whether a setting has an effect, but was not measured.
fn is_unknown(sweep: &ParameterSweep) -> bool {
    sweep.steps.len() < 2 && sweep.left_out > 0
}

/// Why a setting has no plot.
pub fn no_plot(study: &Study, sweep: &ParameterSweep) -> Markup {
    html! {
        p.soft {
            code { (sweep.name) }
            @if is_unknown(sweep) {
                ": not measured: " (why(study)) " (" (quantity(sweep.left_out, "setting")) ")."
            } @else {
                " has no effect in this scene."
            }
        }
    }
}
