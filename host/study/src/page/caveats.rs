//! What a study does not know: a reference that is coarser than the errors it measures, and what was left out.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::numbers::percent;
use crate::pareto::ERROR_LIMITS;
use crate::record::{ParameterSweep, Study};

/// The smallest error that a setting is recommended for, or that can be told from chance.
fn resolved(study: &Study) -> f64 {
    let [.., least] = ERROR_LIMITS;
    if study.reference.noise > least { study.reference.noise } else { least }
}

/// What a user should know before anything else: that the reference itself cuts more light than the errors that
/// are told; none where it does not.
pub fn doubt(study: &Study) -> Option<String> {
    let reference = &study.reference;
    (reference.cut > resolved(study)).then(|| {
        format!(
            "The reference itself cuts {} of the light ({}). No error that is told here includes that: a setting that cuts \
             the same light seems right.{}",
            percent(reference.cut),
            reference.setting.options,
            if study.method.time_limit.is_some() { " A larger --time-limit makes a finer one." } else { "" }
        )
    })
}

/// The same at the top of the page, with what else is not as it would be with more time.
pub fn part(study: &Study) -> Markup {
    html! {
        @if let Some(doubt) = doubt(study) { p.warning role="note" { strong { "Beware. " } (doubt) } }
        @if let Some(left_out) = left_out(study) {
            p.warning role="note" { (left_out) " " a href="#method" { "Which?" } }
        }
    }
}

/// Why something was not measured.
pub fn why(study: &Study) -> &'static str {
    if study.method.time_limit.is_some() { "no time was left" } else { "it would have taken too long" }
}

/// How many settings are missing, and of which knobs nothing is known at all.
pub fn left_out(study: &Study) -> Option<String> {
    let count = study.left_out.len();
    let unknown: Vec<&str> =
        study.knobs.iter().filter(|knob| is_unknown(knob)).map(|knob| knob.name.as_str()).collect();
    let nothing = match &unknown[..] {
        [] => String::new(),
        names => format!("; nothing is known of {}", names.join(", ")),
    };
    let more = if study.method.time_limit.is_some() { "; a larger --time-limit measures more" } else { "" };
    (count > 0)
        .then(|| format!("{} not measured: {}{nothing}{more}.", quantity(count, "setting"), why(study)))
}

/// Whether a knob could be turned, but nothing of it was measured.
fn is_unknown(knob: &ParameterSweep) -> bool {
    knob.steps.len() < 2 && knob.left_out > 0
}

/// Why a knob has no plot.
pub fn knob(study: &Study, knob: &ParameterSweep) -> Markup {
    html! {
        p.soft {
            code { (knob.name) }
            @if is_unknown(knob) {
                ": not measured: " (why(study)) " (" (quantity(knob.left_out, "setting")) ")."
            } @else {
                " has nothing to turn here: nothing in the scene calls for it."
            }
        }
    }
}
