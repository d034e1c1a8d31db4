//! What was counted and measured, for programs and for people.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::Serialize;
use strahl_core::geometry::ShapeKind;
use strahl_core::tally::RayKind;
use strahl_scene::effects;
use strahl_scene::quantity::quantity;
use strahl_settings::Effect;

use crate::aim_report::AimReport;
use crate::session::RenderOutput;
use crate::summary::percent;

/// A report on one picture. Field by field as the command line promises it.
#[derive(Debug, Serialize)]
pub struct Stats {
    scene: SceneStats,
    plan: Vec<Step>,
    picture: PictureStats,
    precision: &'static str,
    rays: Rays,
    tests: Tests,
    levels: Levels,
    accelerator: AcceleratorStats,
    shadow_cache: ShadowCache,
    media: Media,
    cut: Cut,
    /// What was aimed at, if anything was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub aim: Option<AimReport>,
    /// How long everything took.
    pub seconds: Seconds,
    digest: String,
}

#[derive(Debug, Serialize)]
struct SceneStats {
    objects: usize,
    triangles: usize,
    lights: usize,
    effects: Vec<&'static str>,
}

/// One thing that asks for an effect.
#[derive(Debug, Serialize)]
struct Step {
    effect: &'static str,
    asked_by: String,
    line: usize,
    objects: Option<usize>,
    simulated: bool,
}

#[derive(Debug, Serialize)]
struct PictureStats {
    width: u32,
    height: u32,
}

#[derive(Debug, Serialize)]
struct Rays {
    camera: u64,
    camera_hits: u64,
    reflected: u64,
    transmitted: u64,
    shadow: u64,
}

#[derive(Debug, Serialize)]
struct Levels {
    /// That of the deepest ray; the camera ray has level 1.
    deepest: u8,
}

#[derive(Debug, Serialize)]
struct Tests {
    boxes: u64,
    shapes: u64,
    by_shape: BTreeMap<&'static str, u64>,
    by_ray: BTreeMap<&'static str, TestsByRay>,
}

#[derive(Debug, Serialize)]
struct TestsByRay {
    boxes: u64,
    shapes: u64,
    regions: u64,
    mailbox_skips: u64,
}

#[derive(Debug, Serialize)]
struct AcceleratorStats {
    kind: &'static str,
    /// The kind with what else was chosen.
    choice: String,
    /// Why it was taken.
    reason: &'static str,
    bytes: usize,
    regions: usize,
    items_per_region: f64,
    depth: Option<u32>,
    /// By all kinds of rays together.
    mailbox_skips: u64,
}

#[derive(Debug, Serialize)]
struct ShadowCache {
    asked: u64,
    hits: u64,
}

#[derive(Debug, Serialize)]
struct Media {
    overfull: u64,
}

/// Rays that were not sent.
#[derive(Debug, Serialize)]
struct Cut {
    by_levels: u64,
    by_cutoff: u64,
    /// The weight of these rays, as a share of that of all camera rays.
    share_by_levels: f64,
    share_by_cutoff: f64,
}

/// Wall-clock seconds; `trace_cpu` is the sum over the threads.
#[derive(Clone, Copy, Debug, Default, Serialize)]
#[allow(missing_docs)] // each is the step it names
pub struct Seconds {
    pub load: f64,
    pub build: f64,
    pub trace: f64,
    pub trace_cpu: f64,
    pub write: f64,
}

/// A step of the plan, reason by reason.
fn steps(step: &effects::PlannedEffect) -> impl Iterator<Item = Step> + '_ {
    step.reasons.iter().map(|reason| Step {
        effect: step.effect.name(),
        asked_by: reason.source.clone(),
        line: reason.line,
        objects: reason.objects,
        simulated: step.enabled,
    })
}

impl Stats {
    /// The report on a picture whose tests were counted.
    pub fn new(plan: &[effects::PlannedEffect], frame: &RenderOutput) -> Self {
        let RenderOutput { scene: facts, accelerator, counters, .. } = frame;
        let by_ray = |kind| TestsByRay {
            boxes: counters.box_tests[kind],
            shapes: counters.shape_tests[kind],
            regions: counters.leaf_visits[kind],
            mailbox_skips: counters.mailbox_hits[kind],
        };
        let tested = ShapeKind::ALL.map(|kind| (kind.name(), counters.shape_tests_by_kind[kind]));
        Stats {
            scene: SceneStats {
                objects: facts.objects,
                triangles: facts.triangles,
                lights: facts.lights,
                effects: Effect::ALL
                    .into_iter()
                    .filter(|e| e.is_in(&facts.effects))
                    .map(Effect::name)
                    .collect(),
            },
            plan: plan.iter().flat_map(steps).collect(),
            picture: PictureStats { width: frame.picture.size.width(), height: frame.picture.size.height() },
            precision: frame.precision.name(),
            rays: Rays {
                camera: counters.rays[RayKind::Camera],
                camera_hits: counters.camera_hits,
                reflected: counters.rays[RayKind::Reflected],
                transmitted: counters.rays[RayKind::Transmitted],
                shadow: counters.rays[RayKind::Shadow],
            },
            tests: Tests {
                boxes: counters.box_tests.sum(),
                shapes: counters.shape_tests.sum(),
                by_shape: tested.into_iter().filter(|(_, count)| *count > 0).collect(),
                by_ray: RayKind::ALL.map(|kind| (kind.name(), by_ray(kind))).into(),
            },
            levels: Levels { deepest: counters.max_level },
            accelerator: AcceleratorStats {
                kind: accelerator.choice.kind.name(),
                choice: accelerator.choice.to_string(),
                reason: accelerator.choice.reason,
                bytes: accelerator.bytes,
                regions: accelerator.regions,
                items_per_region: accelerator.items_per_region(),
                depth: accelerator.depth,
                mailbox_skips: counters.mailbox_hits.sum(),
            },
            shadow_cache: ShadowCache {
                asked: counters.shadow_cache_lookups,
                hits: counters.shadow_cache_hits,
            },
            media: Media { overfull: counters.medium_stack_full },
            cut: Cut {
                by_levels: counters.level_limit.rays,
                by_cutoff: counters.cutoff.rays,
                share_by_levels: counters.cut_fractions()[0],
                share_by_cutoff: counters.cut_fractions()[1],
            },
            aim: None,
            seconds: Seconds {
                build: frame.build.as_secs_f64(),
                trace: frame.trace.as_secs_f64(),
                trace_cpu: frame.trace_cpu.as_secs_f64(),
                ..Seconds::default()
            },
            digest: frame.picture.digest().to_hex().to_string(),
        }
    }

    /// For programs.
    pub fn to_json(&self) -> String {
        let mut json = serde_json::to_string_pretty(self).unwrap_or_default();
        json.push('\n');
        json
    }

    /// For people.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        let mut line = |what: &str, says: String| {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{what:<14}{says}");
        };
        let (scene, rays, tests, seconds) = (&self.scene, &self.rays, &self.tests, &self.seconds);
        line(
            "picture",
            format!("{} x {}, in {} precision", self.picture.width, self.picture.height, self.precision),
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
        for steps in self.plan.chunk_by(|a, b| a.effect == b.effect) {
            let first = &steps[0];
            let more = match steps.len() - 1 {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            line(
                "effect",
                format!(
                    "{}, asked for by {} in line {}{more}{}",
                    first.effect,
                    first.asked_by,
                    first.line,
                    if first.simulated { "" } else { ", left out on request" }
                ),
            );
        }
        line("camera rays", format!("{}, {} of them hit", rays.camera, rays.camera_hits));
        line("reflected", rays.reflected.to_string());
        line("transmitted", rays.transmitted.to_string());
        line("shadow rays", rays.shadow.to_string());
        line(
            "not sent",
            format!(
                "{} at the last level, {} below the cutoff: {} and {} of the light",
                self.cut.by_levels,
                self.cut.by_cutoff,
                percent(self.cut.share_by_levels),
                percent(self.cut.share_by_cutoff)
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
                    skips => format!(", {skips} left out by mailboxes"),
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
        let AcceleratorStats { choice, reason, bytes, regions, items_per_region, .. } = &self.accelerator;
        line("accelerator", format!("{choice} ({reason})"));
        line(
            "",
            format!(
                "{}, {items_per_region:.2} items in each, {}",
                quantity(*regions, "region"),
                quantity(*bytes, "byte")
            ),
        );
        if self.media.overfull > 0 {
            line(
                "media",
                format!(
                    "{} entered a fifth body at once and ignored it",
                    quantity(self.media.overfull, "ray")
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
