//! The tracer: traces the ray tree of a camera sample.

use core::marker::PhantomData;

use super::task::{SecondaryRay, Task};
use super::{HitId, Limits, PixelSample, TracerError, Worker};
use crate::accel::Accelerator;
use crate::geometry::{Hit, Ray};
use crate::math::{Dimension, Real, Rgb, SobolSequence};
use crate::scene::{Camera, CameraSample, EffectSet, Effects, Material, World};
use crate::shade::{
    Crossing, MediumStack, ShadingContext, ShadingPoint, cross_surface, local_illumination,
    medium_transmittance,
};
use crate::tally::{CountedEvent, RayKind, Tally, TraceEvent};

/// Upper limit of the local illumination of a point, per channel. The weights of a tree sum to less than 2^64
/// (two rays of weight 1 at each of 64 levels), so no product and no sum overflows an `f32`.
const MAX_SURFACE_RADIANCE: Real = 1e15;

/// Upper limit of the radiance of a sample, per channel.
const MAX_SAMPLE_RADIANCE: Real = 1e30;

/// Traces camera samples of a world, as seen by one camera.
///
/// A tracer is immutable: threads share it, each with its own [`Worker`].
///
/// * `A`: accelerator of the world.
/// * `E`: effects that are compiled; everything else is optimized away.
/// * `LEVELS`: largest number of ray levels, 1 to 64 (the maximum depth plus one: camera rays have level
///   1). It determines the size of a worker. [`Limits::levels`] is the number that is traced, at most this;
///   [`Limits::DEFAULT`] has 5.
///
/// ```
/// use strahl_core::math::SobolSequence;
/// use strahl_core::scene::{CameraSample, FilmPoint};
/// use strahl_core::trace::HitId;
/// use strahl_core::*;
///
/// let background = Background::Color(Rgb::WHITE);
/// let world = World::new(Scene::new(SceneDescriptor { background, ..SceneDescriptor::EMPTY })?, ListWithoutBounds(0));
/// let camera = CameraDescriptor {
///     position: Vec3::ZERO,
///     target: vec3(0.0, 0.0, -1.0),
///     up: Vec3::Y,
///     projection: Projection::Perspective { field_of_view: 1.0 },
/// };
/// let camera = Camera::new(&camera, Resolution::new(4, 3).unwrap())?;
/// let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT)?;
///
/// let sequence = SobolSequence::new(0, 0, 0, 0);
/// let sample = CameraSample { point: FilmPoint { x: 0.5, y: 0.5 }, sequence };
/// let pixel = tracer.trace(sample, &mut Worker::new(()));
/// assert_eq!((pixel.color, pixel.hit), (Rgb::WHITE, HitId::Nothing));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Tracer<'w, 's, A, E, const LEVELS: usize> {
    pub(super) world: &'w World<'s, A>,
    camera: Camera,
    pub(super) limits: Limits,
    effects: PhantomData<E>,
}

impl<'w, 's, A: Accelerator, E: Effects, const LEVELS: usize> Tracer<'w, 's, A, E, LEVELS> {
    /// A tracer of `world` as seen by `camera`.
    ///
    /// # Errors
    ///
    /// * [`TracerError::MissingEffects`]: the scene or the camera needs effects that are not in `E`.
    /// * [`TracerError::Levels`]: `limits.levels` is not in `1..=LEVELS`.
    /// * [`TracerError::Cutoff`]: `limits.cutoff` is not in `0..=1`.
    pub fn new(world: &'w World<'s, A>, camera: Camera, limits: Limits) -> Result<Self, TracerError> {
        let needed =
            EffectSet { depth_of_field: camera.has_depth_of_field(), ..world.scene().required_effects() };
        if !E::SET.is_superset(&needed) {
            return Err(TracerError::MissingEffects { missing: needed.difference(&E::SET) });
        }
        if limits.levels == 0 || usize::from(limits.levels) > LEVELS {
            return Err(TracerError::Levels { requested: limits.levels, max: LEVELS });
        }
        if !(limits.cutoff >= 0.0 && limits.cutoff <= 1.0) {
            #[allow(clippy::unnecessary_cast)] // needed in double precision
            return Err(TracerError::Cutoff(limits.cutoff as f32));
        }
        Ok(Tracer { world, camera, limits, effects: PhantomData })
    }

    /// Traces one camera sample: its radiance, always finite, and the item that the camera ray hit.
    ///
    /// The result depends on `sample` alone, not on what the worker has traced before.
    ///
    /// Not inlined: samplers call it once per camera ray, and the loop should exist once per tracer, not once
    /// per sampler.
    #[inline(never)]
    pub fn trace<T: Tally, const SHADOW_CACHE_ENTRIES: usize>(
        &self,
        sample: CameraSample,
        worker: &mut Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>,
    ) -> PixelSample {
        // One time for all rays of the tree.
        let time = if E::SET.motion_blur && self.world.scene().required_effects().motion_blur {
            let [time, _] = sample.sequence.sample_2d(Dimension::SHUTTER);
            time
        } else {
            0.0
        };
        let ray = if E::SET.depth_of_field && self.camera.has_depth_of_field() {
            self.camera.thin_lens_ray(sample.point, sample.sequence.sample_2d(Dimension::LENS))
        } else {
            self.camera.ray(sample.point)
        };
        let Ray { origin, direction, .. } = ray;
        let mut sum = Rgb::BLACK;
        let mut camera_hit = HitId::Nothing;
        let (kind, media) = (RayKind::Camera, MediumStack::EMPTY);
        let mut task = Task { origin, direction, weight: Rgb::WHITE, level: 1, kind, media };
        loop {
            sum += self.trace_task(&mut task, sample.sequence, time, &mut camera_hit, worker);
            let Some(next) = worker.tasks.pop() else { break };
            if worker.tally.is_cancelled() {
                worker.tasks.clear();
                break;
            }
            task = next;
        }
        // One clamp at the end suffices: no contribution is negative.
        PixelSample { color: sum.clamp_max(MAX_SAMPLE_RADIANCE), hit: camera_hit }
    }

    /// Traces the ray of a task: returns its own contribution to the sample, and pushes its secondary rays.
    #[inline(always)]
    fn trace_task<T: Tally, const SHADOW_CACHE_ENTRIES: usize>(
        &self,
        task: &mut Task,
        sequence: SobolSequence,
        time: Real,
        camera_hit: &mut HitId,
        worker: &mut Worker<A, T, LEVELS, SHADOW_CACHE_ENTRIES>,
    ) -> Rgb {
        let Worker { caches, tasks, tally } = worker;
        // Find the nearest hit.
        tally.count(CountedEvent::Ray(task.kind));
        tally.count(CountedEvent::Level(task.level));
        tally.trace_event(task.start_event());
        let ray = Ray::with_near_unit_direction(task.origin, task.direction, time);
        let nearest = self.world.nearest_hit_unchecked::<E, T>(
            &ray,
            E::MAX_DISTANCE,
            task.kind,
            &mut caches.scratch,
            tally,
        );
        let nearest = nearest.and_then(|hit| Some((hit, self.world.surface_interaction::<E>(&ray, hit)?)));
        let Some((hit, surface)) = nearest else {
            return self.miss_radiance(task, tally);
        };
        if task.kind == RayKind::Camera {
            tally.count(CountedEvent::CameraHit);
            *camera_hit = HitId::Item(hit.item);
        }

        // Attenuate by the medium that the ray came through.
        let point = ShadingPoint::new(surface, task.direction);
        let material = self.world.scene().material(hit.item).unwrap_or(&Material::MATTE);
        let crossing = self.cross_surface(task, hit, material, &point);
        let materials = self.world.scene().descriptor().materials;
        let medium = match &crossing {
            Some(crossing) => crossing.medium_before,
            None => task.media.current(materials),
        };
        let transmittance = if self.has_absorption() {
            medium_transmittance::<E>(materials, medium, hit.t)
        } else {
            Rgb::WHITE
        };
        tally.trace_event(TraceEvent::Hit {
            hit,
            point: point.surface.point,
            front_face: point.front_face,
            medium: medium.map(|material| material.0),
            transmittance,
            is_hidden: crossing.as_ref().is_some_and(|crossing| crossing.is_hidden),
        });
        if let Some(crossing) = &crossing {
            if crossing.is_stack_full {
                tally.count(CountedEvent::MediumStackFull);
            }
            if self.has_absorption() {
                task.weight *= transmittance;
            }
            if crossing.is_hidden {
                // A surface inside a body of higher priority does not exist: go straight on.
                let ray = SecondaryRay {
                    origin: point.origin_behind(),
                    direction: task.direction,
                    factor: Rgb::WHITE,
                    kind: RayKind::Transmitted,
                    media: crossing.stack_behind,
                };
                let substitute = self.spawn_ray(task, ray, tasks, tally);
                tally.trace_event(TraceEvent::RayEnd(substitute));
                return substitute;
            }
        }

        // Shade the hit, and send secondary rays.
        let media_behind = crossing.as_ref().map_or(&task.media, |crossing| &crossing.stack_behind);
        let context = ShadingContext {
            item: hit.item,
            sequence,
            time,
            motion_offset: self.world.motion_offset::<E>(hit.item, time),
            level: task.level,
            media_in_front: &task.media,
            media_behind,
        };
        let radiance = local_illumination::<A, E, T, SHADOW_CACHE_ENTRIES>(
            self.world, material, &point, &context, caches, tally,
        );
        let substitute =
            self.spawn_secondary_rays(task, material, &point, crossing.as_ref(), sequence, tasks, tally);
        let contribution = task.weight * radiance.clamp_max(MAX_SURFACE_RADIANCE) + substitute;
        tally.trace_event(TraceEvent::RayEnd(contribution));
        contribution
    }

    /// Contribution of a ray that hits nothing: the background, or black if the ray is inside an absorbing
    /// medium, which then is infinite.
    fn miss_radiance<T: Tally>(&self, task: &Task, tally: &mut T) -> Rgb {
        let scene = self.world.scene().descriptor();
        let mut radiance = scene.background.radiance(task.direction);
        if self.has_absorption() {
            let medium = task.media.current(scene.materials);
            radiance *= medium_transmittance::<E>(scene.materials, medium, Real::INFINITY);
        }
        tally.trace_event(TraceEvent::Miss { radiance });
        let contribution = task.weight * radiance;
        tally.trace_event(TraceEvent::RayEnd(contribution));
        contribution
    }

    /// Whether any medium of the scene absorbs light, and absorption is compiled.
    fn has_absorption(&self) -> bool {
        E::SET.absorption && self.world.scene().required_effects().absorption
    }

    /// The media on both sides of the hit; `None` if they cannot matter.
    fn cross_surface(
        &self,
        task: &Task,
        hit: Hit,
        material: &Material,
        point: &ShadingPoint,
    ) -> Option<Crossing> {
        if !E::SET.transmission {
            return None;
        }
        // The medium in front of an opaque surface matters only if it absorbs.
        if !self.has_absorption() && !material.is_transmitting() {
            return None;
        }
        cross_surface(self.world.scene().descriptor(), hit.item, material, task.media, point.front_face)
    }
}
