//! The report of `--stats`, as JSON and as text.

use std::fmt::Write as _;

use serde::Serialize;
use strahl_scene::effects::PlannedEffect;
use strahl_scene::quantity::quantity;
use strahl_session::RenderOutput;
use strahl_session::stats::{AcceleratorStats, RenderStats, TestsByRay};

use crate::aim_report::AimReport;
use crate::summary::percent;

/// A report on one picture. Its fields are the keys of the JSON, in this order.
#[derive(Debug, Serialize)]
pub struct StatsReport {
    #[serde(flatten)]
    stats: RenderStats,
    /// The target error or time limit, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub aim: Option<AimReport>,
    /// Times.
    pub seconds: StageSeconds,
    digest: String,
}

/// Wall-clock seconds of each stage; `trace_cpu` is the sum over all threads.
#[derive(Clone, Copy, Debug, Default, Serialize)]
#[allow(missing_docs)] // Each is the stage that it names.
pub struct StageSeconds {
    pub load: f64,
    pub build: f64,
    pub trace: f64,
    pub trace_cpu: f64,
    pub write: f64,
}

impl StatsReport {
    /// The report on a picture whose tests were counted.
    pub fn new(plan: &[PlannedEffect], output: &RenderOutput) -> Self {
        StatsReport {
            stats: RenderStats::new(plan, output),
            aim: None,
            seconds: StageSeconds {
                build: output.build.as_secs_f64(),
                trace: output.trace.as_secs_f64(),
                trace_cpu: output.trace_cpu.as_secs_f64(),
                ..StageSeconds::default()
            },
            digest: output.picture.digest().to_hex().to_string(),
        }
    }

    /// The report as JSON.
    pub fn to_json(&self) -> String {
        let mut json = serde_json::to_string_pretty(self).unwrap_or_default();
        json.push('\n');
        json
    }

    /// The report as text.
    pub fn to_text(&self) -> String {
        let stats = &self.stats;
        let mut text = String::new();
        let mut line = |what: &str, says: String| {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{what:<14}{says}");
        };
        let (scene, rays, tests, seconds) = (&stats.scene, &stats.rays, &stats.tests, &self.seconds);
        line(
            "picture",
            format!("{} x {}, in {} precision", stats.picture.width, stats.picture.height, stats.precision),
        );
        line(
            "scene",
            format!(
                "{} ({}), {}",
                quantity(scene.objects, "object"),
                quantity(scene.triangles, "triangle"),
                quantity(scene.lights, "light")
            ),
        );
        for steps in stats.plan.chunk_by(|a, b| a.effect == b.effect) {
            let first = &steps[0];
            let more = match steps.len() - 1 {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            line(
                "effect",
                format!(
                    "{}, required by {} in line {}{more}{}",
                    first.effect,
                    first.required_by,
                    first.line,
                    if first.simulated { "" } else { ", disabled" }
                ),
            );
        }
        line("camera rays", format!("{}, {} of them hit", rays.camera, rays.camera_hits));
        line("reflected", rays.reflected.to_string());
        line("transmitted", rays.transmitted.to_string());
        line("shadow rays", rays.shadow.to_string());
        line(
            "discarded",
            format!(
                "{} at the last level, {} below the cutoff: {} and {} of the light",
                stats.cut.by_levels,
                stats.cut.by_cutoff,
                percent(stats.cut.share_by_levels),
                percent(stats.cut.share_by_cutoff)
            ),
        );
        line("tests", format!("{} of boxes, {} of shapes", tests.boxes, tests.shapes));
        for (kind, count) in &tests.by_shape {
            line("", quantity(*count, kind));
        }
        for (kind, by) in &tests.by_ray {
            let TestsByRay { boxes, shapes, regions, mailbox_skips } = by;
            if boxes + shapes + regions > 0 {
                let skips = match mailbox_skips {
                    0 => String::new(),
                    skips => format!(", {skips} avoided by mailboxes"),
                };
                line(
                    "",
                    format!(
                        "{kind}: {}, {}, {}{skips}",
                        quantity(*boxes, "box"),
                        quantity(*shapes, "shape"),
                        quantity(*regions, "region")
                    ),
                );
            }
        }
        let AcceleratorStats { choice, reason, bytes, regions, items_per_region, .. } = &stats.accelerator;
        line("accelerator", format!("{choice} ({reason})"));
        line(
            "",
            format!(
                "{}, {items_per_region:.2} items in each, {}",
                quantity(*regions, "region"),
                quantity(*bytes, "byte")
            ),
        );
        if stats.media.overfull > 0 {
            line(
                "media",
                format!(
                    "{} entered a fifth nested body, which was ignored",
                    quantity(stats.media.overfull, "ray")
                ),
            );
        }
        line(
            "seconds",
            format!(
                "load {:.3}, build {:.3}, trace {:.3} ({:.3} on all threads), write {:.3}",
                seconds.load, seconds.build, seconds.trace, seconds.trace_cpu, seconds.write
            ),
        );
        line("digest", self.digest.clone());
        text
    }
}
