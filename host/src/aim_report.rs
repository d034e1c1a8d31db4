//! What was aimed at, for the report and for a person.

use std::path::Path;

use serde::Serialize;
use strahl_scene::quantity::quantity;
use strahl_settings::Resolved;
use strahl_study::aim::{AimResult, AimTarget};

use crate::args::RenderArgs;
use crate::settings;

/// What was aimed at, and the command that makes the same picture.
#[derive(Clone, Debug, Serialize)]
pub struct AimReport {
    /// What was aimed at, and what came of it.
    #[serde(flatten)]
    pub aimed: AimResult,
    /// The plain command that makes the same bytes, without search and clock.
    command: String,
}

impl AimReport {
    /// Of a picture that goes to `output`.
    pub fn new(args: &RenderArgs, resolved: &Resolved, aimed: AimResult, output: &Path) -> Self {
        let command = settings::changed(args, resolved, &aimed.settings, output);
        AimReport { aimed, command }
    }

    /// Lines for a person, each with its label.
    pub fn lines(&self) -> Vec<(&'static str, String)> {
        let AimReport { aimed, .. } = self;
        let mut lines = Vec::new();
        match &aimed.target {
            AimTarget::Error { asked, estimate, at_most, pixels, tried, truth, measured, seconds } => {
                let kept = match (aimed.kept, measured) {
                    (true, _) => "",
                    (false, Some(_)) => ": not kept",
                    (false, None) => ": no setting keeps it",
                };
                lines.push(("aim", format!("an error of at most {asked}{kept}")));
                lines.push((
                    "error",
                    format!(
                        "estimated {estimate:.5}, with 95 % confidence at most {at_most:.5}, on {pixels} \
                         pixels against {truth}"
                    ),
                ));
                if let Some(measured) = measured {
                    lines.push((
                        "",
                        format!("true {measured:.5}, on all pixels and with other random numbers"),
                    ));
                }
                lines.push(("taken", format!("{} ({tried} tried in {seconds:.2} s)", aimed.why)));
            }
            AimTarget::Time { asked, passes, given_up } => {
                lines.push(("aim", format!("a picture in {asked} s")));
                let more = if *given_up { ", and one that was given up" } else { "" };
                lines.push(("taken", format!("{}, after {}{more}", aimed.why, quantity(*passes, "pass"))));
            }
        }
        lines.push(("same as", self.command.clone()));
        lines
    }
}
