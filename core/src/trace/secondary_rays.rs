//! Reflected and refracted rays of a hit.

use super::task::{SecondaryRay, Task, TaskStack};
use super::tracer::Tracer;
use crate::accel::Accelerator;
use crate::math::{Dimension, Rgb, SobolSequence, sample_visible_normal};
use crate::scene::{Effects, FresnelModel, LevelLimitRadiance, Material};
use crate::shade::{Crossing, ShadingPoint, reflect, refract, refractive_index};
use crate::tally::{CountedEvent, RayKind, RayOutcome, Tally, TraceEvent};

impl<A: Accelerator, E: Effects, const LEVELS: usize> Tracer<'_, '_, A, E, LEVELS> {
    /// Pushes a secondary ray of `task`, unless it is below the cutoff or exceeds the level limit. Returns
    /// the contribution that substitutes a ray that is not sent.
    ///
    /// Inlined, or the ray would be written to memory twice.
    #[inline(always)]
    pub(super) fn spawn_ray<T: Tally>(
        &self,
        task: &Task,
        ray: SecondaryRay,
        tasks: &mut TaskStack<LEVELS>,
        tally: &mut T,
    ) -> Rgb {
        let SecondaryRay { origin, direction, factor, kind, media } = ray;
        let weight = task.weight * factor;
        let mut report =
            |outcome| tally.trace_event(TraceEvent::SecondaryRay { kind, factor, weight, outcome });
        if !(weight.max_component() > self.limits.cutoff) {
            report(RayOutcome::BelowCutoff);
            tally.count(CountedEvent::Cutoff(weight));
        } else if task.level >= self.limits.levels {
            report(RayOutcome::LevelLimit);
            tally.count(CountedEvent::LevelLimit(weight));
            if E::LEVEL_LIMIT_RADIANCE == LevelLimitRadiance::Background {
                return weight * self.world.scene().descriptor().background.radiance(direction);
            }
        } else {
            report(RayOutcome::Sent);
            tasks.push(Task { origin, direction, weight, level: task.level + 1, kind, media });
        }
        Rgb::BLACK
    }

    /// Pushes the refracted and the reflected ray of a hit. Returns the contribution that substitutes rays
    /// that are not sent.
    #[allow(clippy::too_many_arguments)] // the state of the loop
    pub(super) fn spawn_secondary_rays<T: Tally>(
        &self,
        task: &Task,
        material: &Material,
        point: &ShadingPoint,
        crossing: Option<&Crossing>,
        sequence: SobolSequence,
        tasks: &mut TaskStack<LEVELS>,
        tally: &mut T,
    ) -> Rgb {
        let mut substitute = Rgb::BLACK;
        let mut reflection = if E::SET.reflection { material.reflection } else { Rgb::BLACK };
        let crossing = crossing.filter(|_| material.is_transmitting());
        if crossing.is_none() && reflection.is_black() {
            return substitute;
        }
        let mut normal = point.optical_normal();
        if E::SET.gloss && material.is_glossy() {
            // Rough surfaces: sample a microfacet that is visible from the ray.
            let alpha = material.roughness * material.roughness;
            let u = sequence.sample_2d(Dimension::microfacet(task.level));
            normal = point.normal_or_geometric(sample_visible_normal(normal, -task.direction, alpha, u));
        }

        // Refract, unless total internal reflection occurs.
        if let Some(crossing) = crossing {
            let materials = self.world.scene().descriptor().materials;
            let ratio = refractive_index(crossing.medium_before, materials)
                / refractive_index(crossing.medium_behind, materials);
            let refraction = refract(task.direction, normal, ratio)
                // With an interpolated normal, the refracted ray may stay on the side that it came from.
                .filter(|refraction| refraction.direction.dot(point.geometric_normal) < 0.0);
            match refraction {
                Some(refraction) => {
                    let reflectance = match material.fresnel {
                        FresnelModel::None => 0.0,
                        FresnelModel::Dielectric => refraction.reflectance,
                    };
                    reflection += material.transmission * reflectance;
                    let transmitted = SecondaryRay {
                        origin: point.origin_behind(),
                        direction: refraction.direction,
                        factor: material.transmission * (1.0 - reflectance),
                        kind: RayKind::Transmitted,
                        media: crossing.stack_behind,
                    };
                    substitute += self.spawn_ray(task, transmitted, tasks, tally);
                }
                None => {
                    tally.trace_event(TraceEvent::TotalInternalReflection);
                    reflection += material.transmission;
                }
            }
        }

        // Reflect; at the geometric normal where the shading normal would reflect into the surface.
        if (E::SET.reflection || E::SET.transmission) && !reflection.is_black() {
            let direction = reflect(task.direction, normal);
            let is_outward = direction.dot(point.geometric_normal) > 0.0;
            let direction = if is_outward {
                direction
            } else if E::SET.gloss && material.is_glossy() {
                // Light reflected inward by this microfacet hits another one, which reflects it outward.
                reflect(direction, point.geometric_normal)
            } else {
                reflect(task.direction, point.geometric_normal)
            };
            let kind = RayKind::Reflected;
            let reflected = SecondaryRay {
                origin: point.origin_in_front(),
                direction,
                factor: reflection,
                kind,
                media: task.media,
            };
            substitute += self.spawn_ray(task, reflected, tasks, tally);
        }
        substitute
    }
}
