//! The result of a target error or time limit, for the report and the summary.

use std::path::Path;

use serde::Serialize;
use strahl_scene::quantity::quantity;
use strahl_settings::Resolved;
use strahl_study::aim::{AimResult, AimTarget};

use crate::args::RenderArgs;
use crate::print_settings;

/// The result of a target, and the command that renders the same picture.
#[derive(Clone, Debug, Serialize)]
pub struct AimReport {
    /// The target and its result.
    #[serde(flatten)]
    pub result: AimResult,
    /// The command that renders the same bytes without search or clock.
    command: String,
}

impl AimReport {
    /// The report on a picture that is written to `output`.
    pub fn new(args: &RenderArgs, resolved: &Resolved, result: AimResult, output: &Path) -> Self {
        let command = print_settings::command_with(args, resolved, &result.settings, output);
        AimReport { result, command }
    }

    /// Lines of the summary, each with its label.
    pub fn lines(&self) -> Vec<(&'static str, String)> {
        let AimReport { result, .. } = self;
        let mut lines = Vec::new();
        match &result.target {
            AimTarget::Error {
                requested,
                estimate,
                at_most,
                pixels,
                tried,
                reference,
                measured,
                seconds,
            } => {
                let suffix = match (result.is_met, measured) {
                    (true, _) => "",
                    (false, Some(_)) => ": not reached",
                    (false, None) => ": no setting reaches it",
                };
                lines.push(("aim", format!("error at most {requested}{suffix}")));
                lines.push((
                    "error",
                    format!(
                        "estimated {estimate:.5}, at most {at_most:.5} with 95 % confidence, on {pixels} pixels \
                         compared with {reference}"
                    ),
                ));
                if let Some(measured) = measured {
                    lines.push((
                        "",
                        format!("measured {measured:.5}, on all pixels with other random numbers"),
                    ));
                }
                lines.push(("chosen", format!("{} ({tried} tried in {seconds:.2} s)", result.why)));
            }
            AimTarget::Time { requested, passes, aborted_a_pass } => {
                lines.push(("aim", format!("picture within {requested} s")));
                let more = if *aborted_a_pass { ", and one that was aborted" } else { "" };
                lines.push(("chosen", format!("{}, after {}{more}", result.why, quantity(*passes, "pass"))));
            }
        }
        lines.push(("command", self.command.clone()));
        lines
    }
}
