//! The contents of a scene: objects, required effects and their reasons, memory of each accelerator.

use std::collections::BTreeMap;

use serde::Serialize;
use strahl_core::Scene;
use strahl_core::geometry::Aabb;
use strahl_engine::{AccelStats, RenderError, accelerators};
use strahl_scene::description::LoadedScene;
use strahl_scene::effects::{PlannedEffect, plan};
use strahl_settings::{AccelKind, AccelSettings, OptionalEffect, ResolvedAccel};

use crate::tables::single::scene_tables;

/// The contents of a scene. Its fields are those of `info --json`, in this order.
#[derive(Clone, Debug, Serialize)]
pub struct SceneInfo {
    /// Number of items; every triangle of a mesh counts as one.
    pub objects: usize,
    /// Number of items of each kind of shape that occurs.
    pub by_shape: BTreeMap<&'static str, usize>,
    /// Number of lights.
    pub lights: usize,
    /// Number of materials.
    pub materials: usize,
    /// Number of textures.
    pub textures: usize,
    /// Least and largest coordinates of the bounded objects.
    pub bounds: Option<[[f32; 3]; 2]>,
    /// The required effects.
    pub plan: Vec<EffectInfo>,
    /// The effects that are not required.
    pub not_called_for: Vec<&'static str>,
    /// Memory.
    pub memory: MemoryInfo,
    /// The accelerator that `--accel auto` selects.
    pub auto: AutoAccelerator,
}

/// A required effect.
#[derive(Clone, Debug, Serialize)]
pub struct EffectInfo {
    /// The effect.
    pub effect: &'static str,
    /// Everything that requires it.
    #[serde(rename = "asked_by")]
    pub required_by: Vec<String>,
}

/// Memory in bytes.
#[derive(Clone, Debug, Serialize)]
pub struct MemoryInfo {
    /// The tables of the scene.
    pub scene: usize,
    /// Each accelerator, in addition to the tables.
    pub accelerators: Vec<AcceleratorInfo>,
}

/// An accelerator of a scene.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct AcceleratorInfo {
    /// Its kind.
    pub kind: &'static str,
    /// Memory, in bytes.
    pub bytes: usize,
    /// Groups, cells, or leaves with items.
    pub regions: usize,
    /// Mean number of items in a region; an item counts in every region that it overlaps.
    pub items_per_region: f64,
    /// Steps from the root to the deepest region, for trees.
    pub depth: Option<u32>,
    /// Wall-clock time of the build.
    pub build_seconds: f64,
}

/// The accelerator that `--accel auto` selects.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct AutoAccelerator {
    /// Its kind.
    pub kind: &'static str,
    /// The reason.
    pub reason: &'static str,
}

impl SceneInfo {
    /// Builds the tables of a scene and each accelerator. Returns an error if the core refuses the scene.
    pub fn new(description: &LoadedScene) -> Result<Self, RenderError> {
        let tables = scene_tables(description);
        let scene = tables.scene().map_err(RenderError::invalid)?;
        Ok(SceneInfo::of_scene(description, &scene))
    }

    fn of_scene(description: &LoadedScene, scene: &Scene<'_>) -> Self {
        let parts = scene.descriptor();
        let mut by_shape = BTreeMap::new();
        for kind in parts.geometry.shapes.iter().filter_map(|shape| parts.geometry.kind(shape)) {
            *by_shape.entry(kind.name()).or_insert(0) += 1;
        }
        let bounds: Vec<Aabb> = parts.geometry.all_bounds().collect();
        let all = bounds.iter().fold(Aabb::EMPTY, |all, item| all.union(*item));
        let bounded = bounds.iter().filter(|aabb| !aabb.is_empty()).count();
        let ResolvedAccel { kind, reason, .. } = AccelSettings::DEFAULT.resolve(bounded);
        let built = AccelKind::ALL.map(|kind| accelerators::stats(*scene, &AccelSettings::with_kind(kind)));

        let plan = plan(description);
        let missing =
            OptionalEffect::ALL.into_iter().filter(|effect| plan.iter().all(|it| it.effect != *effect));
        SceneInfo {
            objects: parts.geometry.shapes.len(),
            by_shape,
            lights: parts.lights.len(),
            materials: parts.materials.len(),
            textures: parts.textures.len(),
            bounds: (!all.is_empty()).then(|| [all.min.to_array(), all.max.to_array()]),
            plan: plan.iter().map(EffectInfo::new).collect(),
            not_called_for: missing.map(OptionalEffect::name).collect(),
            memory: MemoryInfo {
                scene: parts.size_in_bytes(),
                accelerators: built.iter().flatten().map(AcceleratorInfo::new).collect(),
            },
            auto: AutoAccelerator { kind: kind.name(), reason },
        }
    }
}

impl EffectInfo {
    fn new(effect: &PlannedEffect) -> Self {
        let required_by = effect.reasons.iter().map(|reason| reason.to_string()).collect();
        EffectInfo { effect: effect.effect.name(), required_by }
    }
}

impl AcceleratorInfo {
    fn new(stats: &AccelStats) -> Self {
        AcceleratorInfo {
            kind: stats.choice.kind.name(),
            bytes: stats.bytes,
            regions: stats.regions,
            items_per_region: stats.items_per_region(),
            depth: stats.depth,
            build_seconds: stats.build.as_secs_f64(),
        }
    }
}
