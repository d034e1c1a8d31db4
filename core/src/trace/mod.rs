//! The loop: take a task, find what it meets, light it, leave at most two tasks.
//!
//! Whitted's tree of rays is linear in colour: what a ray finds counts in the pixel with the
//! product of the shares on the way there. So every task carries that weight, the sum goes up
//! by itself, and no ray waits for another's answer ("An Improved Illumination Model for Shaded
//! Display", CACM 1980).

#[cfg(not(feature = "double"))]
mod error;
#[cfg(not(feature = "double"))]
mod hit_id;
mod limits;
mod pixel_sample;
mod ray_tracer;
mod task;
mod worker;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::trace::{self as error, self as hit_id};

pub use error::TracerError;
pub use hit_id::HitId;
pub use limits::Limits;
pub use pixel_sample::PixelSample;
pub use ray_tracer::RayTracer;
pub use worker::Worker;

use core::marker::PhantomData;

use crate::accel::Accelerator;
use crate::geometry::{Hit, Ray};
use crate::math::{Dimension, Real, Rgb, SobolSequence, Vec3, sample_visible_normal};
use crate::scene::{Camera, CameraSample, EffectSet, Effects, Interface, LastLevel, Material, World};
use crate::shade::{
    Crossing, MediumStack, ShadingContext, ShadingPoint, cross_surface, local_illumination,
    medium_transmittance, reflect, refract, refractive_index,
};
use crate::tally::{CountedEvent, RayKind, RayOutcome, Tally, TraceEvent};
use task::{Task, TaskStack};

/// The brightest that a surface is taken to be. With weights below `2^64` (two rays of weight
/// one at each of 64 levels) no product and no sum here leaves the range of `f32`.
const MAX_SURFACE_RADIANCE: Real = 1e15;

/// The brightest that a place in the picture can be.
const MAX_SAMPLE_RADIANCE: Real = 1e30;

/// Traces a world through a camera with the effects `E`, at most `LEVELS` levels deep.
#[derive(Debug)]
pub struct Tracer<'w, 's, A, E, const LEVELS: usize> {
    world: &'w World<'s, A>,
    camera: Camera,
    limits: Limits,
    effects: PhantomData<E>,
}

impl<'w, 's, A: Accelerator, E: Effects, const LEVELS: usize> Tracer<'w, 's, A, E, LEVELS> {
    /// A tracer, unless the scene asks for effects outside `E` or the limits are out of range.
    pub fn new(world: &'w World<'s, A>, camera: Camera, limits: Limits) -> Result<Self, TracerError> {
        let asks = EffectSet { lens: camera.has_lens(), ..world.scene().effects() };
        if !E::SET.contains(&asks) {
            return Err(TracerError::MissingEffects { missing: asks.difference(&E::SET) });
        }
        if limits.levels == 0 || usize::from(limits.levels) > LEVELS {
            return Err(TracerError::Levels { requested: limits.levels, max: LEVELS });
        }
        if !(limits.cutoff >= 0.0 && limits.cutoff <= 1.0) {
            #[allow(clippy::unnecessary_cast)] // in single precision
            return Err(TracerError::Cutoff(limits.cutoff as f32));
        }
        Ok(Tracer { world, camera, limits, effects: PhantomData })
    }

    /// The light that arrives from the scene along one camera ray, always finite, and what that
    /// ray met.
    ///
    /// Not inlined: samplers call it once for each camera ray, and the loop should exist once
    /// for each tracer, not for each sampler.
    #[inline(never)]
    pub fn trace<T: Tally, const SHADOW_CACHE_ENTRIES: usize>(
        &self,
        sample: CameraSample,
        worker: &mut Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>,
    ) -> PixelSample {
        // When all rays of this tree are sent.
        let time = if E::SET.motion && self.world.scene().effects().motion {
            let [time, _] = sample.stream.sample_2d(Dimension::SHUTTER);
            time
        } else {
            0.0
        };
        let ray = if E::SET.lens && self.camera.has_lens() {
            self.camera.lens_ray(sample.point, sample.stream.sample_2d(Dimension::LENS))
        } else {
            self.camera.ray(sample.point)
        };
        let Ray { origin, direction, .. } = ray;
        let mut sum = Rgb::BLACK;
        let mut hit = HitId::Nothing;
        let (kind, media) = (RayKind::Camera, MediumStack::EMPTY);
        let mut task = Task { origin, direction, weight: Rgb::WHITE, level: 1, kind, media };
        loop {
            sum += self.trace_task(&mut task, sample.stream, time, &mut hit, worker);
            let Some(next) = worker.tasks.pop() else { break };
            if worker.tally.is_cancelled() {
                worker.tasks.clear();
                break;
            }
            task = next;
        }
        // Once, here: no part is below zero, so that a sum that was too large stays so.
        PixelSample { color: sum.clamp_max(MAX_SAMPLE_RADIANCE), hit }
    }

    /// What a task adds to the pixel by itself; its children go onto the stack.
    fn trace_task<T: Tally, const SHADOW_CACHE_ENTRIES: usize>(
        &self,
        task: &mut Task,
        stream: SobolSequence,
        time: Real,
        first: &mut HitId,
        worker: &mut Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>,
    ) -> Rgb {
        let Worker { caches: memory, tasks, tally } = worker;
        tally.count(CountedEvent::Ray(task.kind));
        tally.count(CountedEvent::Level(task.level));
        tally.trace_event(task.start_event());
        let ray = Ray::with_near_unit_direction(task.origin, task.direction, time);
        let found = self.world.nearest_sound::<E, T>(&ray, E::SIGHT, task.kind, &mut memory.scratch, tally);
        let met = found.and_then(|hit| Some((hit, self.world.surface::<E>(&ray, hit)?)));
        let Some((hit, surface)) = met else {
            return self.miss_radiance(task, tally);
        };
        if task.kind == RayKind::Camera {
            tally.count(CountedEvent::CameraHit);
            *first = HitId::Item(hit.item);
        }

        let seen = ShadingPoint::new(surface, task.direction);
        let material = self.world.scene().material(hit.item).unwrap_or(&Material::MATTE);
        let crossing = self.cross_surface(task, hit, material, &seen);
        let materials = self.world.scene().parts().materials;
        let within = match &crossing {
            Some(crossing) => crossing.medium_before,
            None => task.media.current(materials),
        };
        let left = if self.has_absorption() {
            medium_transmittance::<E>(materials, within, hit.t)
        } else {
            Rgb::WHITE
        };
        let hidden = crossing.as_ref().is_some_and(|crossing| crossing.is_hidden);
        let (point, outside) = (seen.surface.point, seen.front_face);
        let number = within.map(|material| material.0);
        tally.trace_event(TraceEvent::Hit {
            hit,
            point,
            front_face: outside,
            medium: number,
            transmittance: left,
            is_hidden: hidden,
        });
        if let Some(crossing) = &crossing {
            if crossing.is_stack_full {
                tally.count(CountedEvent::MediumStackFull);
            }
            if self.has_absorption() {
                task.weight *= left;
            }
            if crossing.is_hidden {
                // The surface is hidden inside another body: straight on.
                let child = SecondaryRay {
                    origin: seen.origin_behind(),
                    direction: task.direction,
                    factor: Rgb::WHITE,
                    kind: RayKind::Transmitted,
                    media: crossing.stack_behind,
                };
                let unsent = self.spawn_ray(task, child, tasks, tally);
                tally.trace_event(TraceEvent::RayEnd(unsent));
                return unsent;
            }
        }

        let behind = crossing.as_ref().map_or(&task.media, |crossing| &crossing.stack_behind);
        let offset = self.world.offset::<E>(hit.item, time);
        let arrival = ShadingContext {
            item: hit.item,
            stream,
            time,
            motion_offset: offset,
            level: task.level,
            media_in_front: &task.media,
            media_behind: behind,
        };
        let light = local_illumination::<A, E, T, SHADOW_CACHE_ENTRIES>(
            self.world, material, &seen, &arrival, memory, tally,
        );
        let unsent =
            self.spawn_secondary_rays(task, material, &seen, crossing.as_ref(), stream, tasks, tally);
        let adds = task.weight * light.clamp_max(MAX_SURFACE_RADIANCE) + unsent;
        tally.trace_event(TraceEvent::RayEnd(adds));
        adds
    }

    /// What a ray brings that meets nothing: the background, or nothing through a medium that
    /// takes light away, which then never ends.
    fn miss_radiance<T: Tally>(&self, task: &Task, tally: &mut T) -> Rgb {
        let parts = self.world.scene().parts();
        let mut light = parts.background.toward(task.direction);
        if self.has_absorption() {
            let medium = task.media.current(parts.materials);
            light *= medium_transmittance::<E>(parts.materials, medium, Real::INFINITY);
        }
        tally.trace_event(TraceEvent::Miss { radiance: light });
        let adds = task.weight * light;
        tally.trace_event(TraceEvent::RayEnd(adds));
        adds
    }

    /// Whether anything in the scene takes light away as it passes.
    fn has_absorption(&self) -> bool {
        E::SET.absorption && self.world.scene().effects().absorption
    }

    /// What happens to the media at the hit, where there may be any.
    fn cross_surface(
        &self,
        task: &Task,
        hit: Hit,
        material: &Material,
        seen: &ShadingPoint,
    ) -> Option<Crossing> {
        // Whoever asks for the medium before something opaque asks what it absorbs.
        if !E::SET.transmission {
            return None;
        }
        if !self.has_absorption() && !material.is_transmitting() {
            return None;
        }
        cross_surface(self.world.scene().parts(), hit.item, material, task.media, seen.front_face)
    }

    /// Sends a ray from where `task` has arrived, unless the levels end or too little of it counts:
    /// then what stands for it. Inlined, or the child would be put into memory twice.
    #[inline(always)]
    fn spawn_ray<T: Tally>(
        &self,
        task: &Task,
        child: SecondaryRay,
        tasks: &mut TaskStack<LEVELS>,
        tally: &mut T,
    ) -> Rgb {
        let SecondaryRay { origin, direction, factor: share, kind, media } = child;
        let weight = task.weight * share;
        let mut tell =
            |fate| tally.trace_event(TraceEvent::SecondaryRay { kind, factor: share, weight, outcome: fate });
        if !(weight.max_component() > self.limits.cutoff) {
            tell(RayOutcome::BelowCutoff);
            tally.count(CountedEvent::Cutoff(weight));
        } else if task.level >= self.limits.levels {
            tell(RayOutcome::LevelLimit);
            tally.count(CountedEvent::LevelLimit(weight));
            if E::LAST == LastLevel::Background {
                return weight * self.world.scene().parts().background.toward(direction);
            }
        } else {
            tell(RayOutcome::Sent);
            tasks.push(Task { origin, direction, weight, level: task.level + 1, kind, media });
        }
        Rgb::BLACK
    }

    /// The rays that go on from a surface: through it, and back from it. What stands for those
    /// that are not sent.
    #[allow(clippy::too_many_arguments)] // what the loop has at hand
    fn spawn_secondary_rays<T: Tally>(
        &self,
        task: &Task,
        material: &Material,
        seen: &ShadingPoint,
        crossing: Option<&Crossing>,
        stream: SobolSequence,
        tasks: &mut TaskStack<LEVELS>,
        tally: &mut T,
    ) -> Rgb {
        let mut unsent = Rgb::BLACK;
        let mut mirrored = if E::SET.reflection { material.mirror } else { Rgb::BLACK };
        let crossing = crossing.filter(|_| material.is_transmitting());
        if crossing.is_none() && mirrored.is_black() {
            return unsent;
        }
        let mut optical = seen.optical_normal();
        if E::SET.gloss && material.is_rough() {
            // Mirrors and glass see one of the facets that make up the surface.
            let slope = material.roughness * material.roughness;
            let chance = stream.sample_2d(Dimension::microfacet(task.level));
            optical =
                seen.normal_or_geometric(sample_visible_normal(optical, -task.direction, slope, chance));
        }

        // Refract, unless all light stays on this side.
        if let Some(crossing) = crossing {
            let materials = self.world.scene().parts().materials;
            let ratio = refractive_index(crossing.medium_before, materials)
                / refractive_index(crossing.medium_behind, materials);
            let refraction = refract(task.direction, optical, ratio)
                // An interpolated normal may break light back to the side that it came from.
                .filter(|refraction| refraction.direction.dot(seen.geometric_normal) < 0.0);
            match refraction {
                Some(refraction) => {
                    let kept = match material.interface {
                        Interface::Constant => 0.0,
                        Interface::Fresnel => refraction.reflectance,
                    };
                    mirrored += material.transmitted * kept;
                    let through = SecondaryRay {
                        origin: seen.origin_behind(),
                        direction: refraction.direction,
                        factor: material.transmitted * (1.0 - kept),
                        kind: RayKind::Transmitted,
                        media: crossing.stack_behind,
                    };
                    unsent += self.spawn_ray(task, through, tasks, tally);
                }
                None => {
                    tally.trace_event(TraceEvent::TotalInternalReflection);
                    mirrored += material.transmitted;
                }
            }
        }

        // Reflect, on the geometric normal where the interpolated one points into the surface.
        if (E::SET.reflection || E::SET.transmission) && !mirrored.is_black() {
            let direction = reflect(task.direction, optical);
            let outward = direction.dot(seen.geometric_normal) > 0.0;
            let direction = if outward {
                direction
            } else if E::SET.gloss && material.is_rough() {
                // From this facet light meets another, which turns it out again.
                reflect(direction, seen.geometric_normal)
            } else {
                reflect(task.direction, seen.geometric_normal)
            };
            let kind = RayKind::Reflected;
            let back = SecondaryRay {
                origin: seen.origin_in_front(),
                direction,
                factor: mirrored,
                kind,
                media: task.media,
            };
            unsent += self.spawn_ray(task, back, tasks, tally);
        }
        unsent
    }
}

/// A ray that goes on from a surface.
struct SecondaryRay {
    origin: Vec3,
    direction: Vec3,
    /// Of the light that arrives along it.
    factor: Rgb,
    kind: RayKind,
    media: MediumStack,
}
