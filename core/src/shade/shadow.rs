//! Whether light arrives.

use super::medium_stack::{Crossing, MediumStack, refractive_index};
use super::optics::refract;
use super::shading_point::ShadingPoint;
use super::shadow_cache::{ShadowCacheKey, WorkerCaches};
use super::transmission::{cross_surface, medium_transmittance};
use crate::accel::Accelerator;
use crate::geometry::Ray;
use crate::math::{ROUNDOFF, Real, Rgb, Vec3, max_abs_component};
use crate::scene::{Beam, Effects, Interface, LightKind, Material, World};
use crate::tally::{CountedEvent, RayKind, Tally, TraceEvent};

/// How much of the way to a light is asked for: not the last few roundoffs, so that a surface
/// in which the light lies does not stand in its own light.
const T_MAX_FACTOR: Real = 1.0 - 16.0 * ROUNDOFF;

/// The most surfaces that light passes on its way; behind more it is dark.
const MAX_SURFACES: u32 = 64;

/// Where the ways to all lights start.
pub(super) struct ShadowRayOrigin {
    /// On the surface.
    pub(super) point: Vec3,
    /// Beside it, where rays leave it.
    pub(super) offset_point: Vec3,
    /// When.
    pub(super) time: Real,
}

/// The way from a point to a light.
pub(super) struct ShadowRay<'b> {
    /// Where it starts.
    pub(super) start: &'b ShadowRayOrigin,
    /// What would arrive.
    pub(super) light_sample: &'b Beam,
    /// From which level to which light.
    pub(super) cache_key: ShadowCacheKey,
}

impl ShadowRay<'_> {
    /// The direction of the ray towards the light; none when the light is too near for anything
    /// to stand between.
    fn direction<E: Effects>(&self) -> Option<Vec3> {
        let (start, beam) = (self.start, self.light_sample);
        if E::SET.lights.contains(LightKind::Directional) && beam.distance == Real::MAX {
            return Some(beam.toward); // of a light without a place, whose rays are parallel
        }
        // Started beside the point, the ray must not end beside the light.
        let aside = start.point - start.offset_point;
        (max_abs_component(aside) < beam.distance).then(|| beam.toward + aside / beam.distance)
    }

    /// How far something may be and still stand in the way.
    fn t_max(&self) -> Real {
        self.light_sample.distance * T_MAX_FACTOR
    }
}

/// Whether anything stands in the way. What lies behind the light does not count; glass counts
/// as if it were opaque.
#[inline(always)]
pub(super) fn is_occluded<A: Accelerator, E: Effects, T: Tally, const SHADOWS: usize>(
    world: &World<'_, A>,
    way: &ShadowRay<'_>,
    memory: &mut WorkerCaches<A, SHADOWS>,
    tally: &mut T,
) -> bool {
    tally.count(CountedEvent::Ray(RayKind::Shadow));
    let Some(direction) = way.direction::<E>() else { return false };
    tally.trace_event(TraceEvent::ShadowRay {
        origin: way.start.offset_point,
        direction,
        t_max: way.t_max(),
    });
    let ray = Ray::with_near_unit_direction(way.start.offset_point, direction, way.start.time);
    if let Some(last) = memory.shadow_cache.last_occluder(way.cache_key) {
        let still = world.blocks::<E, T>(last, &ray, way.t_max(), RayKind::Shadow, tally);
        tally.count(CountedEvent::ShadowCacheLookup { hit: still });
        if still {
            tally.trace_event(TraceEvent::Occluded { item: last, t: None });
            return true;
        }
    }
    match world.blocker_sound::<E, T>(&ray, way.t_max(), RayKind::Shadow, &mut memory.scratch, tally) {
        Some(item) => {
            tally.trace_event(TraceEvent::Occluded { item, t: None });
            memory.shadow_cache.insert(way.cache_key, item);
            true
        }
        None => {
            memory.shadow_cache.remove(way.cache_key);
            false
        }
    }
}

/// The share of light that comes through, from a point inside of `media`: straight on through
/// everything that transmits, surface by surface up to the light, and nothing through the rest.
///
/// Each surface takes what it does not transmit, with Fresnel's formulas also what light that
/// comes in from the thinner side loses by mirroring; each body takes what it absorbs. Light is
/// not bent, so that no ray has to look for the light.
///
/// Not inlined: few scenes ask for it, and where it stands in the loop the others pay for it.
#[inline(never)]
pub(super) fn colored_transmittance<A: Accelerator, E: Effects, T: Tally>(
    world: &World<'_, A>,
    way: &ShadowRay<'_>,
    media: &MediumStack,
    scratch: &mut A::Scratch,
    tally: &mut T,
) -> Rgb {
    tally.count(CountedEvent::Ray(RayKind::Shadow));
    let parts = world.scene().parts();
    let (mut share, mut media) = (Rgb::WHITE, *media);
    let Some(direction) = way.direction::<E>() else { return share };
    let (mut from, mut reach) = (way.start.offset_point, way.t_max());
    tally.trace_event(TraceEvent::ShadowRay { origin: from, direction, t_max: reach });
    for _ in 0..MAX_SURFACES {
        let ray = Ray::with_near_unit_direction(from, direction, way.start.time);
        let hit = world.nearest::<E, T>(&ray, reach, RayKind::Shadow, scratch, tally);
        let met = hit.and_then(|hit| Some((hit, world.surface::<E>(&ray, hit)?)));
        let Some((hit, surface)) = met else {
            return share * medium_transmittance::<E>(parts.materials, media.current(parts.materials), reach);
        };
        let material = world.scene().material(hit.item).unwrap_or(&Material::MATTE);
        let seen = ShadingPoint::new(surface, direction);
        let Some(crossing) = cross_surface(parts, hit.item, material, media, seen.front_face) else { break };
        share *= medium_transmittance::<E>(parts.materials, crossing.medium_before, hit.t);
        if !crossing.is_hidden {
            share *= material.transmitted * (1.0 - reflectance(&crossing, material, &seen, parts.materials));
        }
        if share.is_black() {
            tally.trace_event(TraceEvent::Occluded { item: hit.item, t: Some(hit.t) });
            break;
        }
        tally.trace_event(TraceEvent::ShadowTransmission { hit, transmittance: share });
        (media, from, reach) = (crossing.stack_behind, seen.origin_behind(), reach - hit.t);
    }
    Rgb::BLACK
}

/// The share that is mirrored of light that comes in from the thinner of both sides.
fn reflectance(
    crossing: &Crossing,
    material: &Material,
    seen: &ShadingPoint,
    materials: &[Material],
) -> Real {
    if material.interface == Interface::Constant {
        return 0.0;
    }
    let (before, behind) = (
        refractive_index(crossing.medium_before, materials),
        refractive_index(crossing.medium_behind, materials),
    );
    let ratio = if before < behind { before / behind } else { behind / before };
    refract(seen.ray_direction, seen.shading_normal, ratio).map_or(1.0, |refraction| refraction.reflectance)
}
