//! Shading: local illumination at a hit point, and the optics and media of secondary rays.
//!
//! Local illumination is the ambient, diffuse (Lambert) and highlight (Phong) part of Whitted's model, with
//! shadow rays to all lights. Reflection, refraction, absorption and nested dielectrics serve the secondary
//! rays, which the tracer sends.
//!
//! Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 1980.

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
use crate::scene::{Effects, LightSample, Material, World};
use crate::tally::{LightOutcome, Tally, TraceEvent};
use shadow::{ShadowRay, ShadowRayOrigin};
use shadow_cache::ShadowCacheKey;

/// The ray that hit a surface, as far as local illumination depends on it.
pub(crate) struct ShadingContext<'r> {
    /// Item that was hit.
    pub(crate) item: ItemId,
    /// Sample sequence of the camera ray.
    pub(crate) sequence: SobolSequence,
    /// Time in `0..=1` between shutter open and close.
    pub(crate) time: Real,
    /// Displacement of the item at that time; its texture moves with it.
    pub(crate) motion_offset: Vec3,
    /// Level of the ray.
    pub(crate) level: u8,
    /// Bodies on the side that the ray comes from.
    pub(crate) media_in_front: &'r MediumStack,
    /// Bodies on the far side of the surface.
    pub(crate) media_behind: &'r MediumStack,
}

/// Radiance that the surface reflects along the ray: ambient light, and diffuse reflection and highlight of
/// each light that is not occluded.
///
/// Shadow rays are traced only to lights that would contribute. Inlined into the loop, which is its only caller.
#[inline(always)]
pub(crate) fn local_illumination<A: Accelerator, E: Effects, T: Tally, const ENTRIES: usize>(
    world: &World<'_, A>,
    material: &Material,
    point: &ShadingPoint,
    context: &ShadingContext<'_>,
    caches: &mut WorkerCaches<A, ENTRIES>,
    tally: &mut T,
) -> Rgb {
    let scene = world.scene().descriptor();

    // Texture.
    let (mut diffuse, mut ambient) = (material.diffuse, material.ambient);
    if !E::SET.textures.is_empty()
        && let Some(texture) = scene.textures.get(usize::from(material.texture.0))
    {
        let texture_color = texture.evaluate(point.surface.point - context.motion_offset, E::SET.textures);
        diffuse *= texture_color;
        ambient *= texture_color;
    }

    // Ambient light.
    let mut radiance = ambient * scene.ambient;
    tally.trace_event(TraceEvent::Ambient(radiance));
    if !material.is_lit() || scene.lights.is_empty() {
        tally.trace_event(TraceEvent::LocalIllumination(radiance));
        return radiance;
    }

    // A one-sided surface is shaded as its front, on both sides.
    let (normal, side) = if material.two_sided {
        (point.shading_normal, point.geometric_normal)
    } else {
        (point.surface.shading_normal, point.surface.normal)
    };
    let has_highlight = E::SET.highlight && material.has_highlight();
    let twice_cos_ray = if has_highlight { 2.0 * normal.dot(point.ray_direction) } else { 0.0 };
    let has_diffuse = !diffuse.is_black();
    let offset_point = offset_origin(point.surface.point, point.surface.point_error, side);
    let origin = ShadowRayOrigin { point: point.surface.point, offset_point, time: context.time };

    for (light, index) in scene.lights.iter().zip(0..) {
        // Sample the light.
        let u = || {
            if !E::SET.soft_shadows {
                return [0.5, 0.5];
            }
            context.sequence.sample_2d(Dimension::light(context.level, index))
        };
        let mut report = |outcome| tally.trace_event(TraceEvent::LightContribution { light: index, outcome });
        let sample = match light.sample(point.surface.point, normal, E::SET.lights, u) {
            Ok(sample) => sample,
            Err(outcome) => {
                report(outcome);
                continue;
            }
        };
        if sample.color.is_black() {
            report(LightOutcome::NoEmission);
            continue;
        }

        // Highlight. Without diffuse reflection most of the surface is outside of it, so it is evaluated
        // before the shadow ray; with diffuse reflection the light contributes anyway, so it is evaluated
        // after.
        let highlight_factor = || {
            // Cosine of the angle between the viewer and the mirrored direction of the light.
            let cos = sample.direction.dot(point.ray_direction) - sample.cos_theta * twice_cos_ray;
            if cos > 0.0 { highlight_power(cos, material.highlight_exponent) } else { 0.0 }
        };
        let mut color = sample.color;
        let mut highlight = 0.0;
        if !has_diffuse {
            highlight = if has_highlight { highlight_factor() } else { 0.0 };
            if !(highlight > 0.0) {
                report(LightOutcome::OutsideHighlight);
                continue;
            }
        }

        // Shadow ray.
        if E::SET.shadows && light.casts_shadows {
            let media =
                if side == point.geometric_normal { context.media_in_front } else { context.media_behind };
            let shadow_key = (ShadowCacheKey { light: usize::from(index), level: context.level }, media);
            let transmittance = if E::SET.smooth_shading && side.dot(sample.direction) <= 0.0 {
                // Passed by value, so that the originals can stay in registers.
                let below = BelowHorizon {
                    surface: point.surface,
                    side,
                    item: context.item,
                    motion_offset: context.motion_offset,
                    time: context.time,
                };
                shadow_transmittance_below_horizon::<A, E, T, ENTRIES>(
                    world, below, shadow_key, sample, caches, tally,
                )
            } else {
                shadow_transmittance::<A, E, T, ENTRIES>(world, &origin, shadow_key, &sample, caches, tally)
            };
            let Some(transmittance) = transmittance else {
                let outcome = LightOutcome::Occluded;
                tally.trace_event(TraceEvent::LightContribution { light: index, outcome });
                continue;
            };
            color *= transmittance;
        }

        // Diffuse reflection and highlight.
        let mut reflectance = diffuse * sample.cos_theta;
        if has_highlight {
            let highlight = if has_diffuse { highlight_factor() } else { highlight };
            reflectance += material.highlight * highlight;
        }
        let contribution = reflectance * color;
        let (direction, distance) = (sample.direction, sample.distance);
        let outcome = LightOutcome::Arrived { direction, distance, color, contribution };
        tally.trace_event(TraceEvent::LightContribution { light: index, outcome });
        radiance += contribution;
    }
    tally.trace_event(TraceEvent::LocalIllumination(radiance));
    radiance
}

/// Fraction of the sampled light that arrives at the point; `None` if the light is occluded.
///
/// The key also holds the bodies that the shadow ray starts in.
#[inline(always)]
fn shadow_transmittance<A: Accelerator, E: Effects, T: Tally, const ENTRIES: usize>(
    world: &World<'_, A>,
    origin: &ShadowRayOrigin,
    (cache_key, media): (ShadowCacheKey, &MediumStack),
    light_sample: &LightSample,
    caches: &mut WorkerCaches<A, ENTRIES>,
    tally: &mut T,
) -> Option<Rgb> {
    let shadow_ray = ShadowRay { origin, light_sample, cache_key };
    if E::SET.colored_shadows && world.scene().descriptor().colored_shadows {
        let scratch = &mut caches.scratch;
        let transmittance =
            shadow::colored_transmittance::<A, E, T>(world, &shadow_ray, media, scratch, tally);
        (!transmittance.is_black()).then_some(transmittance)
    } else {
        let is_occluded = shadow::is_occluded::<A, E, T, ENTRIES>(world, &shadow_ray, caches, tally);
        (!is_occluded).then_some(Rgb::WHITE)
    }
}

/// A point of a smooth shape whose shading normal faces a light that is below the horizon of the geometric
/// face.
struct BelowHorizon {
    surface: SurfaceInteraction,
    /// Geometric normal on the lit side.
    side: Vec3,
    item: ItemId,
    motion_offset: Vec3,
    time: Real,
}

/// As [`shadow_transmittance`], with the shadow terminator offset: the shadow ray starts from the smooth
/// surface that the normals approximate, unless that is a quarter of the distance to the light away or more.
#[cold]
#[inline(never)]
fn shadow_transmittance_below_horizon<A: Accelerator, E: Effects, T: Tally, const ENTRIES: usize>(
    world: &World<'_, A>,
    BelowHorizon { surface, side, item, motion_offset, time }: BelowHorizon,
    shadow_key: (ShadowCacheKey, &MediumStack),
    light_sample: LightSample,
    caches: &mut WorkerCaches<A, ENTRIES>,
    tally: &mut T,
) -> Option<Rgb> {
    let offset =
        world.terminator_offset::<E>(item, surface.point - motion_offset, side.dot(surface.normal) > 0.0);
    let is_short = |offset: &Vec3| max_abs_component(*offset) < 0.25 * light_sample.distance;
    let offset = offset.filter(is_short).unwrap_or(Vec3::ZERO);
    let offset_point = offset_origin(surface.point, surface.point_error, side) + offset;
    let origin = ShadowRayOrigin { point: surface.point, offset_point, time };
    shadow_transmittance::<A, E, T, ENTRIES>(world, &origin, shadow_key, &light_sample, caches, tally)
}

/// `cos` to the power `exponent`. `cos` is positive, and above 1 only by rounding.
fn highlight_power(cos: Real, exponent: Real) -> Real {
    // ln(cos) <= cos - 1, so beyond this exponent the power is less than half of the smallest positive number
    // and rounds to zero. For narrow highlights this is the common case.
    const UNDERFLOW: Real = 0.6932 * (Real::MANTISSA_DIGITS as i32 - Real::MIN_EXP + 1) as Real;
    let one_minus_cos = 1.0 - cos;
    if one_minus_cos * exponent > UNDERFLOW {
        0.0
    } else if one_minus_cos > 0.0 {
        pow_positive(cos, exponent)
    } else {
        1.0
    }
}
