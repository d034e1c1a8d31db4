//! A scene with an acceleration structure of any type.

use strahl_core::accel::Accelerator;
use strahl_core::{Camera, World};

use crate::effects::{SelectRayTracers, SelectedRayTracers, TracerRequest};
use crate::hits::nearest;
use crate::ray_query::RayCaster;

/// A scene with an acceleration structure, as a trait object.
pub trait AnyWorld: Sync {
    /// Ray tracers with an effect set for the scene, the camera and the request.
    fn ray_tracers(&self, camera: Camera, request: TracerRequest) -> SelectedRayTracers<'_>;

    /// A ray caster, which finds the nearest hits of rays.
    fn ray_caster(&self) -> RayCaster<'_>;
}

/// A scene with an acceleration structure of type `A`.
pub struct TypedWorld<'s, A> {
    /// The scene and the acceleration structure.
    pub world: World<'s, A>,
    /// Selects the effect set of ray tracers.
    pub select: SelectRayTracers<A>,
}

impl<A: Accelerator + Sync> AnyWorld for TypedWorld<'_, A> {
    fn ray_tracers(&self, camera: Camera, request: TracerRequest) -> SelectedRayTracers<'_> {
        (self.select)(&self.world, camera, request)
    }

    fn ray_caster(&self) -> RayCaster<'_> {
        let mut scratch = A::Scratch::default();
        Box::new(move |query| nearest(&self.world, query, &mut scratch))
    }
}
