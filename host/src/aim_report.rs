//! The result of a target error or time limit, for the report and the summary.

use std::path::Path;

use serde::Serialize;
use strahl_scene::quantity::quantity;
use strahl_settings::Resolved;
use strahl_study::aim::{AimResult, AimTarget};

use crate::args::RenderArgs;
use crate::settings;

/// The result of a target, and the command that renders the same picture.
#[derive(Clone, Debug, Serialize)]
pub struct AimReport {
    /// The target and its result.
    #[serde(flatten)]
    pub aimed: AimResult,
    /// The command that renders the same bytes without search or clock.
    command: String,
}

impl AimReport {
    /// The report on a picture that is written to `output`.
    pub fn new(args: &RenderArgs, resolved: &Resolved, aimed: AimResult, output: &Path) -> Self {
        let command = settings::changed(args, resolved, &aimed.settings, output);
        AimReport { aimed, command }
    }

    /// Lines of the summary, each with its label.
    pub fn lines(&self) -> Vec<(&'static str, String)> {
        let AimReport { aimed, .. } = self;
        let mut lines = Vec::new();
        match &aimed.target {
            AimTarget::Error { asked, estimate, at_most, pixels, tried, truth, measured, seconds } => {
                let suffix = match (aimed.kept, measured) {
                    (true, _) => "",
                    (false, Some(_)) => ": not reached",
                    (false, None) => ": no setting reaches it",
                };
                lines.push(("aim", format!("error at most {asked}{suffix}")));
                lines.push((
                    "error",
                    format!(
                        "estimated {estimate:.5}, at most {at_most:.5} with 95 % confidence, on {pixels} pixels \
                         compared with {truth}"
                    ),
                ));
                if let Some(measured) = measured {
                    lines.push((
                        "",
                        format!("measured {measured:.5}, on all pixels with other random numbers"),
                    ));
                }
                lines.push(("chosen", format!("{} ({tried} tried in {seconds:.2} s)", aimed.why)));
            }
            AimTarget::Time { asked, passes, given_up } => {
                lines.push(("aim", format!("picture within {asked} s")));
                let more = if *given_up { ", and one that was aborted" } else { "" };
                lines.push(("chosen", format!("{}, after {}{more}", aimed.why, quantity(*passes, "pass"))));
            }
        }
        lines.push(("command", self.command.clone()));
        lines
    }
}
