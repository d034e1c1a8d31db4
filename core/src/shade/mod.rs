//! What light does at a surface: the local part of Whitted's model, and the optics and media
//! that the rays from there need.

mod medium_stack;
mod optics;
mod shading_point;
mod shadow;
mod shadow_cache;
mod transmission;

pub use medium_stack::{Crossing, MediumStack, refractive_index};
pub use optics::{Refraction, reflect, refract, transmittance};
pub(crate) use shading_point::ShadingPoint;
pub(crate) use shadow_cache::WorkerCaches;
pub(crate) use transmission::{cross_surface, medium_transmittance};

use crate::accel::Accelerator;
use crate::geometry::{ItemId, SurfaceInteraction, offset_origin};
use crate::math::{Dimension, Real, Rgb, SobolSequence, Vec3, max_abs_component, pow_positive};

use crate::scene::{Beam, Effects, Material, World};
use crate::tally::{LightOutcome, Tally, TraceEvent};
use shadow::{ShadowRay, ShadowRayOrigin};
use shadow_cache::ShadowCacheKey;

/// The circumstances under which a ray has arrived at a surface.
pub(crate) struct ShadingContext<'r> {
    /// What it has met.
    pub(crate) item: ItemId,
    /// The numbers that belong to the camera ray.
    pub(crate) stream: SobolSequence,
    /// When.
    pub(crate) time: Real,
    /// How far away from its own place the item is then; its texture moves with it.
    pub(crate) motion_offset: Vec3,
    /// The level of the ray.
    pub(crate) level: u8,
    /// The bodies on the side that it comes from.
    pub(crate) media_in_front: &'r MediumStack,
    /// The bodies behind the surface.
    pub(crate) media_behind: &'r MediumStack,
}

/// The light that the surface itself sends back along the ray: ambient, and from each light
/// that reaches it the diffuse part and the highlight (Phong).
///
/// A light is asked for only where the surface faces it and would show it.
pub(crate) fn local_illumination<A: Accelerator, E: Effects, T: Tally, const SHADOWS: usize>(
    world: &World<'_, A>,
    material: &Material,
    seen: &ShadingPoint,
    arrival: &ShadingContext<'_>,
    memory: &mut WorkerCaches<A, SHADOWS>,
    tally: &mut T,
) -> Rgb {
    let parts = world.scene().parts();
    let (mut diffuse, mut ambient) = (material.diffuse, material.ambient);
    if !E::SET.textures.is_empty()
        && let Some(texture) = parts.textures.get(usize::from(material.texture.0))
    {
        let paint = texture.at(seen.surface.point - arrival.motion_offset, E::SET.textures);
        diffuse *= paint;
        ambient *= paint;
    }
    let mut light = ambient * parts.ambient;
    tally.trace_event(TraceEvent::Ambient(light));
    if !material.is_lit() || parts.lights.is_empty() {
        tally.trace_event(TraceEvent::LocalIllumination(light));
        return light;
    }

    // A one-sided surface shades as its front does, from wherever it is seen.
    let (normal, side) = if material.two_sided {
        (seen.shading_normal, seen.geometric_normal)
    } else {
        (seen.surface.shading_normal, seen.surface.normal)
    };
    let shiny = E::SET.highlight && material.is_shiny();
    let mirrored = if shiny { 2.0 * normal.dot(seen.ray_direction) } else { 0.0 };
    let scatters = !diffuse.is_black();
    let from = offset_origin(seen.surface.point, seen.surface.point_error, side);
    let start = ShadowRayOrigin { point: seen.surface.point, offset_point: from, time: arrival.time };
    for (source, number) in parts.lights.iter().zip(0..) {
        let chance = || {
            if !E::SET.penumbra {
                return [0.5, 0.5];
            }
            arrival.stream.sample_2d(Dimension::light(arrival.level, number))
        };
        let mut skip = |lit| tally.trace_event(TraceEvent::LightContribution { light: number, outcome: lit });
        let beam = match source.beam(seen.surface.point, normal, E::SET.lights, chance) {
            Ok(beam) => beam,
            Err(lit) => {
                skip(lit);
                continue;
            }
        };
        if beam.color.is_black() {
            skip(LightOutcome::NoEmission);
            continue;
        }
        // How much of the highlight shows.
        let shine = || {
            // The mirrored light's share of the way to the eye.
            let toward_eye = beam.toward.dot(seen.ray_direction) - beam.cos * mirrored;
            if toward_eye > 0.0 { highlight_power(toward_eye, material.exponent) } else { 0.0 }
        };
        let mut color = beam.color;
        // A mirror shows a light only where the highlight is, which most of it is not: so ask
        // for the shadow last. What scatters light shows it wherever it stands in it.
        let mut share = 0.0;
        if !scatters {
            share = if shiny { shine() } else { 0.0 };
            if !(share > 0.0) {
                skip(LightOutcome::OutsideHighlight);
                continue;
            }
        }
        if E::SET.shadows && source.shadows {
            let media =
                if side == seen.geometric_normal { arrival.media_in_front } else { arrival.media_behind };
            let way = (ShadowCacheKey { light: usize::from(number), level: arrival.level }, media);
            let passes = if E::SET.smooth && side.dot(beam.toward) <= 0.0 {
                // Copies, so that the others can stay in registers.
                let place = BelowHorizon {
                    surface: seen.surface,
                    side,
                    item: arrival.item,
                    offset: arrival.motion_offset,
                };
                shadow_transmittance_below_horizon::<A, E, T, SHADOWS>(
                    world,
                    place,
                    arrival.time,
                    way,
                    beam,
                    memory,
                    tally,
                )
            } else {
                shadow_transmittance::<A, E, T, SHADOWS>(world, &start, way, &beam, memory, tally)
            };
            let Some(passed) = passes else {
                tally.trace_event(TraceEvent::LightContribution {
                    light: number,
                    outcome: LightOutcome::Occluded,
                });
                continue;
            };
            color *= passed;
        }
        let mut back = diffuse * beam.cos;
        if shiny {
            let share = if scatters { shine() } else { share };
            back += material.highlight * share;
        }
        let adds = back * color;
        let (toward, distance) = (beam.toward, beam.distance);
        tally.trace_event(TraceEvent::LightContribution {
            light: number,
            outcome: LightOutcome::Arrived { direction: toward, distance, color, contribution: adds },
        });
        light += adds;
    }
    tally.trace_event(TraceEvent::LocalIllumination(light));
    light
}

/// The share of the light that passes on its way to a start; none when nothing does.
#[inline(always)]
fn shadow_transmittance<A: Accelerator, E: Effects, T: Tally, const SHADOWS: usize>(
    world: &World<'_, A>,
    start: &ShadowRayOrigin,
    (toward, media): (ShadowCacheKey, &MediumStack),
    beam: &Beam,
    memory: &mut WorkerCaches<A, SHADOWS>,
    tally: &mut T,
) -> Option<Rgb> {
    let way = ShadowRay { start, light_sample: beam, cache_key: toward };
    if E::SET.colored_shadows && world.scene().parts().colored_shadows {
        let share = shadow::colored_transmittance::<A, E, T>(world, &way, media, &mut memory.scratch, tally);
        (!share.is_black()).then_some(share)
    } else {
        (!shadow::is_occluded::<A, E, T, SHADOWS>(world, &way, memory, tally)).then_some(Rgb::WHITE)
    }
}

/// A place from which a light stands under the horizon of its smooth shape.
struct BelowHorizon {
    surface: SurfaceInteraction,
    /// The geometric normal, on the side that is lit.
    side: Vec3,
    item: ItemId,
    offset: Vec3,
}

/// As [`passes`], for such a place: rays start farther out, from the round surface that is meant.
/// Not as far as to come near the light.
#[cold]
#[inline(never)]
fn shadow_transmittance_below_horizon<A: Accelerator, E: Effects, T: Tally, const SHADOWS: usize>(
    world: &World<'_, A>,
    BelowHorizon { surface, side, item, offset }: BelowHorizon,
    time: Real,
    way: (ShadowCacheKey, &MediumStack),
    beam: Beam,
    memory: &mut WorkerCaches<A, SHADOWS>,
    tally: &mut T,
) -> Option<Rgb> {
    let lift = world.lift::<E>(item, surface.point - offset, side.dot(surface.normal) > 0.0);
    let lift = lift.filter(|lift| max_abs_component(*lift) < 0.25 * beam.distance).unwrap_or(Vec3::ZERO);
    let from = offset_origin(surface.point, surface.point_error, side) + lift;
    let start = ShadowRayOrigin { point: surface.point, offset_point: from, time };
    shadow_transmittance::<A, E, T, SHADOWS>(world, &start, way, &beam, memory, tally)
}

/// The cosine, which rounding may have put a little above one, to a power.
fn highlight_power(cos: Real, exponent: Real) -> Real {
    // The logarithm of a cosine is at most what it lacks to one, and below this one a power is
    // nearer to zero than to the smallest number. Nearly everywhere on a mirror that is so.
    const NOTHING: Real = 0.6932 * (Real::MANTISSA_DIGITS as i32 - Real::MIN_EXP + 1) as Real;
    let lack = 1.0 - cos;
    if lack * exponent > NOTHING {
        0.0
    } else if lack > 0.0 {
        pow_positive(cos, exponent)
    } else {
        1.0
    }
}
