//! The engine: a scene with its acceleration structure, for pictures and ray queries.

use std::time::{Duration, Instant};

use strahl_core::scene::EffectSet;
use strahl_core::{Camera, CameraDescriptor, Projection, Rgb, Scene, Shape};
use strahl_settings::{AccelSettings, Settings};

use crate::accelerators::{self, AccelMemory};
use crate::cost_counting::CostCounting;
use crate::effects::TracerRequest;
use crate::engine::Engine;
use crate::options::RenderOptions;
use crate::output::{AccelStats, RenderError, Rendered, SceneStats};
use crate::passes;
use crate::progress::{Interrupt, Progress};
use crate::ray_query::RayCaster;
use crate::ray_tracer::RayTracerFactory;
use crate::scheduler::Scheduler;
use crate::tiles::{self, Traced, single_precision};
use crate::world::AnyWorld;

/// A scene with its acceleration structure, from which any number of pictures can be rendered.
pub struct SceneEngine<'s> {
    world: Box<dyn AnyWorld + 's>,
    camera: CameraDescriptor,
    scene: SceneStats,
    accelerator: AccelStats,
}

impl<'s> SceneEngine<'s> {
    /// Builds the requested acceleration structure in `memory`, which is provided by the caller, like the scene tables.
    pub fn new(
        scene: Scene<'s>,
        camera: CameraDescriptor,
        accelerator: &AccelSettings,
        memory: &'s mut AccelMemory,
    ) -> Result<Self, RenderError> {
        let stats = scene_stats(&scene, &camera);
        let (world, accelerator) =
            accelerators::build(scene, accelerator, memory).map_err(RenderError::invalid)?;
        Ok(SceneEngine { world, camera, scene: stats, accelerator })
    }

    /// Renders a picture whose pixels are traced by `trace`.
    fn rendered(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        trace: impl FnOnce(&dyn RayTracerFactory) -> Result<Traced<Rgb>, Interrupt>,
    ) -> Result<Rendered, RenderError> {
        let (start, cpu_start) = (Instant::now(), cpu_time());
        let camera = Camera::new(&self.camera, settings.size).map_err(RenderError::invalid)?;
        let Settings { levels, cutoff, shadow_cache, .. } = *settings;
        let request = TracerRequest { levels, cutoff, shadow_cache, count_tests: options.counts_tests() };
        let ray_tracers = self.world.ray_tracers(camera, request).map_err(RenderError::invalid)?;
        let (colors, counters) = match options.cost_map {
            Some(cost_map) => trace(&CostCounting { ray_tracers: &*ray_tracers, cost_map })?,
            None => trace(&*ray_tracers)?,
        };
        Ok(Rendered {
            colors: single_precision(colors),
            counters,
            trace: start.elapsed(),
            trace_cpu: cpu_time().saturating_sub(cpu_start),
        })
    }
}

impl Engine for SceneEngine<'_> {
    fn scene(&self) -> &SceneStats {
        &self.scene
    }

    fn accelerator(&self) -> &AccelStats {
        &self.accelerator
    }

    fn render(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
    ) -> Result<Rendered, RenderError> {
        let trace =
            |ray_tracers: &dyn RayTracerFactory| tiles::trace(ray_tracers, settings, options, progress);
        self.rendered(settings, options, trace)
    }

    fn refine(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<Rendered, RenderError> {
        self.rendered(settings, options, |ray_tracers| {
            passes::trace(ray_tracers, settings, options, progress, scheduler)
        })
    }

    fn ray_caster(&self) -> RayCaster<'_> {
        self.world.ray_caster()
    }
}

/// The statistics of a scene, with the effects that it requires, including those of the camera.
pub fn scene_stats(scene: &Scene<'_>, camera: &CameraDescriptor) -> SceneStats {
    let parts = scene.descriptor();
    let is_triangle = |shape: &&Shape| matches!(shape, Shape::Triangle(_) | Shape::SmoothTriangle(_));
    SceneStats {
        objects: parts.geometry.shapes.len(),
        triangles: parts.geometry.shapes.iter().filter(is_triangle).count(),
        lights: parts.lights.len(),
        effects: EffectSet {
            depth_of_field: matches!(camera.projection, Projection::ThinLens { .. }),
            ..scene.required_effects()
        },
    }
}

/// The processor time of this process, summed over all threads.
#[cfg(unix)]
fn cpu_time() -> Duration {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(now.tv_sec.unsigned_abs(), now.tv_nsec.unsigned_abs() as u32)
}

/// The processor time is not available on this platform: 0.
#[cfg(not(unix))]
fn cpu_time() -> Duration {
    Duration::ZERO
}
