//! What ray tracers are made of, before their types have been chosen.

use super::ray_tracer::{RayTracerFactory, Tracing};
use super::strahl::{Accelerator, Camera, Counters, EffectSet, Effects, RayCounters, TracerError, World};
use crate::render_request::RenderRequest;

/// Chooses the effect set and the tally of the ray tracers for a world with this accelerator.
pub type ChooseRayTracers<A> = for<'w, 's> fn(&Request<'w, 's, A>) -> Chosen<'w>;

/// Ray tracers whose types have been chosen.
pub type Chosen<'w> = Result<Box<dyn RayTracerFactory + 'w>, TracerError>;

/// What ray tracers are made of.
pub struct Request<'w, 's, A> {
    /// The scene and its accelerator.
    pub world: &'w World<'s, A>,
    /// The camera.
    pub camera: Camera,
    /// Levels, cutoff, and what is counted.
    pub render: &'w RenderRequest,
}

impl<'w, A: Accelerator + Sync> Request<'w, '_, A> {
    /// What the scene and the camera ask for.
    pub fn asks(&self) -> EffectSet {
        EffectSet { lens: self.camera.has_lens(), ..self.world.scene().effects() }
    }

    /// Whether every test is to be counted, and not only rays.
    pub fn is_counted(&self) -> bool {
        self.render.counted || self.render.cost_map.is_some()
    }

    /// Ray tracers that count rays.
    pub fn counting_rays<E: Effects + Sync + 'w>(&self) -> Chosen<'w> {
        Tracing::<A, E, RayCounters>::boxed(self)
    }

    /// Ray tracers that count every test, too.
    pub fn counting_tests<E: Effects + Sync + 'w>(&self) -> Chosen<'w> {
        Tracing::<A, E, Counters>::boxed(self)
    }
}
