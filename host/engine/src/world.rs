//! A scene with an accelerator of any type.

use strahl_core::accel::Accelerator;
use strahl_core::{Camera, World};

use crate::effects::{ChooseRayTracers, ChosenRayTracers, TracerRequest};
use crate::hits::nearest;
use crate::ray_query::RayCaster;

/// A scene with an accelerator of any type.
pub trait AnyWorld: Sync {
    /// Ray tracers whose effect set suits the scene and the request.
    fn ray_tracers(&self, camera: Camera, request: TracerRequest) -> ChosenRayTracers<'_>;

    /// Finds the nearest hits of rays.
    fn ray_caster(&self) -> RayCaster<'_>;
}

/// A scene with an accelerator of this type.
pub struct TypedWorld<'s, A> {
    /// Both.
    pub world: World<'s, A>,
    /// Chooses the effect set of its ray tracers.
    pub choose: ChooseRayTracers<A>,
}

impl<A: Accelerator + Sync> AnyWorld for TypedWorld<'_, A> {
    fn ray_tracers(&self, camera: Camera, request: TracerRequest) -> ChosenRayTracers<'_> {
        (self.choose)(&self.world, camera, request)
    }

    fn ray_caster(&self) -> RayCaster<'_> {
        let mut scratch = A::Scratch::default();
        Box::new(move |query| nearest(&self.world, query, &mut scratch))
    }
}
