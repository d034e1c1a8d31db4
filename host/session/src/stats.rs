//! Statistics of a rendered picture: scene, effects, rays, tests, accelerator.

use std::collections::BTreeMap;

use serde::Serialize;
use strahl_core::geometry::ShapeKind;
use strahl_core::tally::RayKind;
use strahl_scene::effects::PlannedEffect;
use strahl_settings::OptionalEffect;

use crate::session::RenderOutput;

/// What was counted for one picture. Its fields are those of `--stats json`, in this order.
#[derive(Clone, Debug, Serialize)]
pub struct RenderStats {
    /// The scene.
    pub scene: SceneStats,
    /// The effects of the scene, one row for each reason.
    pub plan: Vec<EffectRow>,
    /// The size of the picture.
    pub picture: PictureStats,
    /// `single` or `double`.
    pub precision: &'static str,
    /// Rays by kind.
    pub rays: RayStats,
    /// Intersection tests.
    pub tests: TestStats,
    /// Levels of rays.
    pub levels: LevelStats,
    /// The accelerator.
    pub accelerator: AcceleratorStats,
    /// The shadow cache.
    pub shadow_cache: ShadowCacheStats,
    /// Nested media.
    pub media: MediumStackStats,
    /// Rays that were not traced.
    pub cut: CutStats,
}

/// The contents of a scene.
#[derive(Clone, Debug, Serialize)]
#[allow(missing_docs)] // Each is a count of what it names.
pub struct SceneStats {
    pub objects: usize,
    pub triangles: usize,
    pub lights: usize,
    /// The effects that the scene requires.
    pub effects: Vec<&'static str>,
}

/// One reason for an effect.
#[derive(Clone, Debug, Serialize)]
pub struct EffectRow {
    /// The effect.
    pub effect: &'static str,
    /// What requires it.
    #[serde(rename = "asked_by")]
    pub required_by: String,
    /// Its line in the scene file; 0 if it has none.
    pub line: usize,
    /// The number of objects with it.
    pub objects: Option<usize>,
    /// Whether it is simulated; `false` if it is disabled.
    pub simulated: bool,
}

/// The size of a picture, in pixels.
#[derive(Clone, Copy, Debug, Serialize)]
#[allow(missing_docs)]
pub struct PictureStats {
    pub width: u32,
    pub height: u32,
}

/// Number of rays.
#[derive(Clone, Copy, Debug, Serialize)]
#[allow(missing_docs)] // Each is a count of what it names.
pub struct RayStats {
    pub camera: u64,
    pub camera_hits: u64,
    pub reflected: u64,
    pub transmitted: u64,
    /// Including those that a shadow cache answers.
    pub shadow: u64,
}

/// Levels of rays.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LevelStats {
    /// The level of the deepest ray; the camera ray has level 1.
    pub deepest: u8,
}

/// Number of intersection tests.
#[derive(Clone, Debug, Serialize)]
#[allow(missing_docs)] // Each is a count of what it names.
pub struct TestStats {
    pub boxes: u64,
    pub shapes: u64,
    pub by_shape: BTreeMap<&'static str, u64>,
    pub by_ray: BTreeMap<&'static str, TestsByRay>,
}

/// Number of tests of one kind of ray.
#[derive(Clone, Copy, Debug, Serialize)]
#[allow(missing_docs)] // Each is a count of what it names.
pub struct TestsByRay {
    pub boxes: u64,
    pub shapes: u64,
    pub regions: u64,
    /// Tests that mailboxes avoided.
    pub mailbox_skips: u64,
}

/// The accelerator.
#[derive(Clone, Debug, Serialize)]
pub struct AcceleratorStats {
    /// Its kind.
    pub kind: &'static str,
    /// Its kind and settings.
    pub choice: String,
    /// Why it was chosen.
    pub reason: &'static str,
    /// Memory, in bytes.
    pub bytes: usize,
    /// Groups, cells, or leaves with items.
    pub regions: usize,
    /// Mean number of items in a region.
    pub items_per_region: f64,
    /// Steps from the root to the deepest region, for trees.
    pub depth: Option<u32>,
    /// Tests that mailboxes avoided, for all kinds of rays.
    pub mailbox_skips: u64,
}

/// Queries of the shadow cache.
#[derive(Clone, Copy, Debug, Serialize)]
#[allow(missing_docs)]
pub struct ShadowCacheStats {
    pub asked: u64,
    pub hits: u64,
}

/// Nested media.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct MediumStackStats {
    /// Entries into a fifth nested body, which are ignored.
    pub overfull: u64,
}

/// Rays that were not traced.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct CutStats {
    /// Number of rays beyond the last level.
    pub by_levels: u64,
    /// Number of rays below the cutoff.
    pub by_cutoff: u64,
    /// Their weight, as a share of that of all camera rays.
    pub share_by_levels: f64,
    /// The same for the cutoff.
    pub share_by_cutoff: f64,
}

/// The rows of an effect.
fn effect_rows(effect: &PlannedEffect) -> impl Iterator<Item = EffectRow> + '_ {
    effect.reasons.iter().map(|reason| EffectRow {
        effect: effect.effect.name(),
        required_by: reason.source.clone(),
        line: reason.line,
        objects: reason.objects,
        simulated: effect.enabled,
    })
}

impl RenderStats {
    /// The statistics of a picture whose tests were counted, and of the effects of its scene.
    pub fn new(plan: &[PlannedEffect], output: &RenderOutput) -> Self {
        let RenderOutput { scene, accelerator, counters, picture, .. } = output;
        let by_ray = |kind| TestsByRay {
            boxes: counters.box_tests[kind],
            shapes: counters.shape_tests[kind],
            regions: counters.leaf_visits[kind],
            mailbox_skips: counters.mailbox_hits[kind],
        };
        let by_shape = ShapeKind::ALL.map(|kind| (kind.name(), counters.shape_tests_by_kind[kind]));
        let effects = OptionalEffect::ALL.into_iter().filter(|effect| effect.is_in(&scene.effects));
        let [share_by_levels, share_by_cutoff] = counters.cut_fractions();
        RenderStats {
            scene: SceneStats {
                objects: scene.objects,
                triangles: scene.triangles,
                lights: scene.lights,
                effects: effects.map(OptionalEffect::name).collect(),
            },
            plan: plan.iter().flat_map(effect_rows).collect(),
            picture: PictureStats { width: picture.size.width(), height: picture.size.height() },
            precision: output.precision.name(),
            rays: RayStats {
                camera: counters.rays[RayKind::Camera],
                camera_hits: counters.camera_hits,
                reflected: counters.rays[RayKind::Reflected],
                transmitted: counters.rays[RayKind::Transmitted],
                shadow: counters.rays[RayKind::Shadow],
            },
            tests: TestStats {
                boxes: counters.box_tests.sum(),
                shapes: counters.shape_tests.sum(),
                by_shape: by_shape.into_iter().filter(|(_, count)| *count > 0).collect(),
                by_ray: RayKind::ALL.map(|kind| (kind.name(), by_ray(kind))).into(),
            },
            levels: LevelStats { deepest: counters.max_level },
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
            shadow_cache: ShadowCacheStats {
                asked: counters.shadow_cache_tests,
                hits: counters.shadow_cache_hits,
            },
            media: MediumStackStats { overfull: counters.medium_stack_full },
            cut: CutStats {
                by_levels: counters.level_limit.rays,
                by_cutoff: counters.cutoff.rays,
                share_by_levels,
                share_by_cutoff,
            },
        }
    }
}
