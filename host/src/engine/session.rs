//! A scene with its accelerator: pictures and ray queries.

use std::time::{Duration, Instant};

use super::accelerators::{AccelMemory, open};
use super::cost_counting::CostCounting;
use super::hits::nearest;
use super::passes;
use super::ray_tracer::RayTracerFactory;
use super::request::{ChooseRayTracers, Chosen, Request};
use super::strahl::{Accelerator, Camera, EffectSet, Rgb, Scene, SceneTables, Shape, View, World};
use super::tables::view;
use super::tiles::{self, Traced};
use crate::description::Description;
use crate::finding::Finding;
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::ray_query::RayCaster;
use crate::render_output::{AccelStats, RenderError, Rendered, SceneStats};
use crate::render_request::RenderRequest;
use crate::scheduler::Scheduler;
use crate::session::Engine;

/// A scene with an accelerator, of which pictures are rendered one after another.
pub struct Session<'s> {
    world: Box<dyn AnyWorld + 's>,
    view: View,
    scene: SceneStats,
    accelerator: AccelStats,
}

impl<'s> Session<'s> {
    /// Builds the accelerator that is asked for in `memory`.
    pub fn new(
        description: &Description,
        tables: &'s SceneTables,
        finding: &Finding,
        memory: &'s mut AccelMemory,
    ) -> Result<Self, RenderError> {
        let scene = tables.scene().map_err(RenderError::invalid)?;
        let stats = scene_stats(description, &scene);
        let (world, accelerator) = open(scene, finding, memory).map_err(RenderError::invalid)?;
        Ok(Session { world, view: view(&description.view), scene: stats, accelerator })
    }

    /// Renders a picture, all pixels of which `trace` traces.
    fn rendered(
        &self,
        request: &RenderRequest,
        trace: impl FnOnce(&dyn RayTracerFactory) -> Result<Traced<Rgb>, Interrupt>,
    ) -> Result<Rendered, RenderError> {
        let (clock, cpu) = (Instant::now(), cpu_time());
        let camera = Camera::new(&self.view, request.settings.size).map_err(RenderError::invalid)?;
        let ray_tracers = self.world.ray_tracers(camera, request).map_err(RenderError::invalid)?;
        let (colors, counters) = match &request.cost_map {
            Some(cost_map) => trace(&CostCounting { ray_tracers: &*ray_tracers, cost_map })?,
            None => trace(&*ray_tracers)?,
        };
        Ok(Rendered {
            colors: rounded(colors),
            counters,
            trace: clock.elapsed(),
            trace_cpu: cpu_time().saturating_sub(cpu),
        })
    }
}

impl Engine for Session<'_> {
    fn scene(&self) -> &SceneStats {
        &self.scene
    }

    fn accelerator(&self) -> &AccelStats {
        &self.accelerator
    }

    fn render(&self, request: &RenderRequest, progress: &dyn Progress) -> Result<Rendered, RenderError> {
        self.rendered(request, |ray_tracers| tiles::trace(ray_tracers, request, progress))
    }

    fn refine(
        &self,
        request: &RenderRequest,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<Rendered, RenderError> {
        self.rendered(request, |ray_tracers| passes::trace(ray_tracers, request, progress, scheduler))
    }

    fn ray_caster(&self) -> RayCaster<'_> {
        self.world.ray_caster()
    }
}

/// What is in a scene, and what it asks for, the camera included.
pub fn scene_stats(description: &Description, scene: &Scene<'_>) -> SceneStats {
    let parts = scene.parts();
    let is_triangle = |shape: &&Shape| matches!(shape, Shape::Triangle(_) | Shape::SmoothTriangle(_));
    SceneStats {
        objects: parts.geometry.shapes.len(),
        triangles: parts.geometry.shapes.iter().filter(is_triangle).count(),
        lights: parts.lights.len(),
        asks: EffectSet { lens: description.view.projection.has_lens(), ..scene.effects() },
    }
}

/// A scene with an accelerator of any type.
pub trait AnyWorld: Sync {
    /// Ray tracers whose effect set suits the scene and the settings.
    fn ray_tracers<'w>(&'w self, camera: Camera, request: &'w RenderRequest) -> Chosen<'w>;

    /// Finds the nearest hits of rays.
    fn ray_caster(&self) -> RayCaster<'_>;
}

/// A scene with an accelerator of this type.
pub struct OpenWorld<'s, A> {
    /// Both.
    pub world: World<'s, A>,
    /// Chooses the effect set of its ray tracers.
    pub choose: ChooseRayTracers<A>,
}

impl<A: Accelerator + Sync> AnyWorld for OpenWorld<'_, A> {
    fn ray_tracers<'w>(&'w self, camera: Camera, request: &'w RenderRequest) -> Chosen<'w> {
        (self.choose)(&Request { world: &self.world, camera, render: request })
    }

    fn ray_caster(&self) -> RayCaster<'_> {
        let mut scratch = A::Scratch::default();
        Box::new(move |query| nearest(&self.world, query, &mut scratch))
    }
}

/// Colours in single precision; those of single precision stay where they are.
pub(super) fn rounded(colors: Vec<Rgb>) -> Vec<strahl_core::Rgb> {
    #[allow(clippy::unnecessary_cast)] // in single precision
    let narrow = |c: Rgb| strahl_core::Rgb::new(c.r as f32, c.g as f32, c.b as f32);
    colors.into_iter().map(narrow).collect()
}

/// The processor time that this process has used on all threads.
#[cfg(unix)]
fn cpu_time() -> Duration {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(now.tv_sec.unsigned_abs(), now.tv_nsec.unsigned_abs() as u32)
}

/// Not known here.
#[cfg(not(unix))]
fn cpu_time() -> Duration {
    Duration::ZERO
}
