//! Shadow rays: occlusion of a light, and transmittance towards it.
//!
//! By default any item between point and light occludes the light, whatever its material ([`is_occluded`]).
//! With colored shadows, transmitting surfaces attenuate the light instead ([`colored_transmittance`]).
//! Shadow rays are never refracted, so none has to search for the light.

use super::medium_stack::{Crossing, MediumStack, refractive_index};
use super::optics::refract;
use super::shading_point::ShadingPoint;
use super::shadow_cache::{ShadowCacheKey, WorkerCaches};
use super::transmission::{cross_surface, medium_transmittance};
use crate::accel::Accelerator;
use crate::geometry::Ray;
use crate::math::{ROUNDOFF, Real, Rgb, Vec3, max_abs_component};
use crate::scene::{Effects, FresnelModel, LightKind, LightSample, Material, World};
use crate::tally::{CountedEvent, RayKind, Tally, TraceEvent};

/// Fraction of the distance to a light in which items occlude it: 16 unit roundoffs less than 1, so that a
/// surface that contains the light does not occlude it.
const T_MAX_FACTOR: Real = 1.0 - 16.0 * ROUNDOFF;

/// Most surfaces that a shadow ray passes; behind more the light is occluded.
const MAX_SURFACES: u32 = 64;

/// Origin of the shadow rays of one shaded point, common to all lights.
pub(super) struct ShadowRayOrigin {
    /// Point on the surface, where the light was sampled.
    pub(super) point: Vec3,
    /// Origin of the rays: the point, offset to the lit side.
    pub(super) offset_point: Vec3,
    /// Time in `0..=1` between shutter open and close.
    pub(super) time: Real,
}

/// A shadow ray from a surface point to a light.
pub(super) struct ShadowRay<'b> {
    /// Origin.
    pub(super) origin: &'b ShadowRayOrigin,
    /// Direction and distance of the light, and its color if it is not occluded.
    pub(super) light_sample: &'b LightSample,
    /// Light and ray level.
    pub(super) cache_key: ShadowCacheKey,
}

impl ShadowRay<'_> {
    /// Direction to the light, approximately unit; `None` if the light is so near that nothing can be in
    /// between.
    fn direction<E: Effects>(&self) -> Option<Vec3> {
        let (origin, light) = (self.origin, self.light_sample);
        if E::SET.lights.contains(LightKind::Directional) && light.distance == Real::MAX {
            return Some(light.direction);
        }
        // The light was sampled from the point; correct the direction for the offset of the origin.
        let offset = origin.point - origin.offset_point;
        (max_abs_component(offset) < light.distance).then(|| light.direction + offset / light.distance)
    }

    /// Largest `t` of an occluder.
    fn t_max(&self) -> Real {
        self.light_sample.distance * T_MAX_FACTOR
    }
}

/// Whether an item between the point and the light occludes the light. Transmitting items count as opaque.
#[inline(always)]
pub(super) fn is_occluded<A: Accelerator, E: Effects, T: Tally, const ENTRIES: usize>(
    world: &World<'_, A>,
    shadow_ray: &ShadowRay<'_>,
    caches: &mut WorkerCaches<A, ENTRIES>,
    tally: &mut T,
) -> bool {
    tally.count(CountedEvent::Ray(RayKind::Shadow));
    let Some(direction) = shadow_ray.direction::<E>() else { return false };
    tally.trace_event(TraceEvent::ShadowRay {
        origin: shadow_ray.origin.offset_point,
        direction,
        t_max: shadow_ray.t_max(),
    });
    let ray =
        Ray::with_near_unit_direction(shadow_ray.origin.offset_point, direction, shadow_ray.origin.time);
    if let Some(occluder) = caches.shadow_cache.last_occluder(shadow_ray.cache_key) {
        let occluded =
            world.is_occluded_by::<E, T>(occluder, &ray, shadow_ray.t_max(), RayKind::Shadow, tally);
        tally.count(CountedEvent::ShadowCacheTest { occluded });
        if occluded {
            tally.trace_event(TraceEvent::Occluded { item: occluder, t: None });
            return true;
        }
    }
    match world.occluder_unchecked::<E, T>(
        &ray,
        shadow_ray.t_max(),
        RayKind::Shadow,
        &mut caches.scratch,
        tally,
    ) {
        Some(item) => {
            tally.trace_event(TraceEvent::Occluded { item, t: None });
            caches.shadow_cache.insert(shadow_ray.cache_key, item);
            true
        }
        None => {
            caches.shadow_cache.remove(shadow_ray.cache_key);
            false
        }
    }
}

/// Transmittance between a point inside `media` and the light, along a straight line; black if occluded.
///
/// Surfaces multiply it by what they transmit, less the Fresnel reflectance of light that arrives on the side
/// of the lower refractive index; bodies multiply it by their transmittance. Opaque surfaces occlude the
/// light.
///
/// Not inlined: few scenes have colored shadows, and inlined into the loop it would slow down all others.
#[inline(never)]
pub(super) fn colored_transmittance<A: Accelerator, E: Effects, T: Tally>(
    world: &World<'_, A>,
    shadow_ray: &ShadowRay<'_>,
    media: &MediumStack,
    scratch: &mut A::Scratch,
    tally: &mut T,
) -> Rgb {
    tally.count(CountedEvent::Ray(RayKind::Shadow));
    let scene = world.scene().descriptor();
    let (mut transmittance, mut media) = (Rgb::WHITE, *media);
    let Some(direction) = shadow_ray.direction::<E>() else { return transmittance };
    let (mut origin, mut t_max) = (shadow_ray.origin.offset_point, shadow_ray.t_max());
    tally.trace_event(TraceEvent::ShadowRay { origin, direction, t_max });
    for _ in 0..MAX_SURFACES {
        let ray = Ray::with_near_unit_direction(origin, direction, shadow_ray.origin.time);
        let hit = world.nearest_hit::<E, T>(&ray, t_max, RayKind::Shadow, scratch, tally);
        let hit = hit.and_then(|hit| Some((hit, world.surface_interaction::<E>(&ray, hit)?)));
        let Some((hit, surface)) = hit else {
            let medium = media.current(scene.materials);
            return transmittance * medium_transmittance::<E>(scene.materials, medium, t_max);
        };
        let material = world.scene().material(hit.item).unwrap_or(&Material::MATTE);
        let point = ShadingPoint::new(surface, direction);
        let Some(crossing) = cross_surface(scene, hit.item, material, media, point.front_face) else { break };
        transmittance *= medium_transmittance::<E>(scene.materials, crossing.medium_before, hit.t);
        if !crossing.is_hidden {
            transmittance *=
                material.transmission * (1.0 - reflectance(&crossing, material, &point, scene.materials));
        }
        if transmittance.is_black() {
            tally.trace_event(TraceEvent::Occluded { item: hit.item, t: Some(hit.t) });
            break;
        }
        tally.trace_event(TraceEvent::ShadowTransmission { hit, transmittance });
        (media, origin, t_max) = (crossing.stack_behind, point.origin_behind(), t_max - hit.t);
    }
    Rgb::BLACK
}

/// Fresnel reflectance for light that arrives on the side of the lower refractive index, where no total
/// internal reflection occurs; 0 for surfaces with a constant transmittance.
fn reflectance(
    crossing: &Crossing,
    material: &Material,
    point: &ShadingPoint,
    materials: &[Material],
) -> Real {
    if material.fresnel == FresnelModel::None {
        return 0.0;
    }
    let (before, behind) = (
        refractive_index(crossing.medium_before, materials),
        refractive_index(crossing.medium_behind, materials),
    );
    let ratio = if before < behind { before / behind } else { behind / before };
    refract(point.ray_direction, point.shading_normal, ratio).map_or(1.0, |refraction| refraction.reflectance)
}
