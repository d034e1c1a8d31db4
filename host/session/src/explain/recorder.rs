//! A [`Tally`] that builds the ray tree of one sample from trace events.

use strahl_core::geometry::ItemId;
use strahl_core::tally::{CountedEvent, LightOutcome, RayKind, RayOutcome, Tally, TraceEvent};
use strahl_core::{Real, Rgb, Vec3};
use strahl_scene::description::Float3;

use super::source_names::SourceNames;
use super::tree::{
    HitRecord, LightRecord, OccluderRecord, RayRecord, SecondaryRayRecord, TransmissionRecord, rgb_array,
    xyz_array,
};

/// The largest number of rays of one sample; tracing is cancelled when it is reached.
pub const MAX_RAYS: usize = 1 << 18;

/// The rays of one sample, recorded during tracing.
pub struct RayTreeRecorder<'n> {
    names: &'n SourceNames<'n>,
    rays: Vec<RayRecord>,
    /// Secondary rays that are still to be traced: the index of the parent, and of the ray in its `sends`.
    pending: Vec<(usize, usize)>,
    shadow_ray: ShadowRayState,
}

/// The shadow ray that is being traced.
#[derive(Default)]
struct ShadowRayState {
    ray: Option<(Vec3, Vec3, Real)>,
    transmitted: Vec<TransmissionRecord>,
    /// The distance of the last surface that transmits light.
    distance: f32,
    occluder: Option<(ItemId, f32)>,
}

impl<'n> RayTreeRecorder<'n> {
    /// A recorder without rays.
    pub fn new(names: &'n SourceNames<'n>) -> Self {
        RayTreeRecorder {
            names,
            rays: Vec::new(),
            pending: Vec::new(),
            shadow_ray: ShadowRayState::default(),
        }
    }

    /// The rays, in the order in which they were traced.
    pub fn into_rays(self) -> Vec<RayRecord> {
        self.rays
    }

    fn start_ray(&mut self, ray: RayRecord) {
        let number = self.rays.len() + 1;
        let parent = self.pending.pop();
        if let Some((parent, index)) = parent
            && let Some(sent) = self.rays.get_mut(parent).and_then(|ray| ray.sends.get_mut(index))
        {
            sent.ray = Some(number);
        }
        self.rays.push(RayRecord { number, parent: parent.map(|(parent, _)| parent + 1), ..ray });
    }

    fn record_light(&mut self, number: u16, outcome: LightOutcome) {
        let ShadowRayState { ray, transmitted, occluder, .. } = std::mem::take(&mut self.shadow_ray);
        let mut light = LightRecord {
            number,
            named: self.names.light(number),
            outcome: outcome_name(outcome),
            toward: None,
            distance: None,
            arrives: None,
            adds: None,
            through: transmitted,
            occluder: None,
        };
        match outcome {
            LightOutcome::Arrived { direction, distance, color, contribution } => {
                light.toward = Some(xyz_array(direction));
                light.distance = (distance < Real::MAX).then_some(distance);
                light.arrives = Some(rgb_array(color));
                light.adds = Some(rgb_array(contribution));
            }
            // The tracer stops at any occluder; the report shows the nearest one.
            LightOutcome::Occluded if light.through.is_empty() => {
                let nearest = ray.and_then(|(origin, direction, t_max)| {
                    self.names.nearest_occluder(origin, direction, t_max)
                });
                light.occluder = nearest.or(occluder).map(|it| self.occluder_record(it));
            }
            LightOutcome::Occluded => light.occluder = occluder.map(|it| self.occluder_record(it)),
            LightOutcome::NoEmission | LightOutcome::BackFacing | LightOutcome::OutsideHighlight => {}
        }
        self.with_current_ray(|ray| ray.lights.push(light));
    }

    fn occluder_record(&self, (item, distance): (ItemId, f32)) -> OccluderRecord {
        OccluderRecord { item: self.names.item(item), distance }
    }

    /// Changes the ray that is being traced.
    fn with_current_ray(&mut self, change: impl FnOnce(&mut RayRecord)) {
        if let Some(ray) = self.rays.last_mut() {
            change(ray);
        }
    }
}

fn outcome_name(outcome: LightOutcome) -> &'static str {
    match outcome {
        LightOutcome::NoEmission => "dark",
        LightOutcome::BackFacing => "behind",
        LightOutcome::OutsideHighlight => "unseen",
        LightOutcome::Occluded => "blocked",
        LightOutcome::Arrived { .. } => "seen",
    }
}

/// The product of each channel, as the core computes it.
fn product(a: Float3, b: Float3) -> Float3 {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

impl Tally for RayTreeRecorder<'_> {
    /// Counters are not needed.
    fn count(&mut self, _: CountedEvent) {}

    fn trace_event(&mut self, event: TraceEvent) {
        match event {
            TraceEvent::RayStart { kind, level, origin, direction, weight } => self.start_ray(RayRecord {
                kind: kind.name(),
                level,
                origin: xyz_array(origin),
                direction: xyz_array(direction),
                weight: rgb_array(weight),
                weight_there: rgb_array(weight),
                ..RayRecord::default()
            }),
            TraceEvent::Miss { radiance } => self.with_current_ray(|ray| ray.light = rgb_array(radiance)),
            TraceEvent::Hit { hit, point, front_face, medium, transmittance, is_hidden } => {
                let hit = HitRecord {
                    item: self.names.item(hit.item),
                    distance: hit.t,
                    point: xyz_array(point),
                    outside: front_face,
                    within: medium.map(|material| self.names.material(material)),
                    left: rgb_array(transmittance),
                    hidden: is_hidden,
                };
                self.with_current_ray(|ray| {
                    ray.weight_there = product(ray.weight, hit.left);
                    ray.hit = Some(hit);
                });
            }
            TraceEvent::Ambient(light) => self.with_current_ray(|ray| ray.ambient = Some(rgb_array(light))),
            TraceEvent::ShadowRay { origin, direction, t_max } => {
                self.shadow_ray =
                    ShadowRayState { ray: Some((origin, direction, t_max)), ..ShadowRayState::default() };
            }
            TraceEvent::ShadowTransmission { hit, transmittance } => {
                let ShadowRayState { transmitted, distance, .. } = &mut self.shadow_ray;
                *distance += hit.t;
                let item = self.names.item(hit.item);
                transmitted.push(TransmissionRecord {
                    item,
                    distance: *distance,
                    share: rgb_array(transmittance),
                });
            }
            TraceEvent::Occluded { item, t } => {
                let distance = self.shadow_ray.distance + t.unwrap_or(0.0);
                self.shadow_ray.occluder = Some((item, distance));
            }
            TraceEvent::LightContribution { light, outcome } => self.record_light(light, outcome),
            TraceEvent::LocalIllumination(light) => self.with_current_ray(|ray| ray.light = rgb_array(light)),
            TraceEvent::TotalInternalReflection => self.with_current_ray(|ray| ray.total_reflection = true),
            TraceEvent::SecondaryRay { kind, factor, weight, outcome } => {
                self.record_secondary_ray(kind, factor, weight, outcome)
            }
            TraceEvent::RayEnd(light) => self.with_current_ray(|ray| ray.adds = rgb_array(light)),
            // The enum is non-exhaustive.
            _ => {}
        }
    }

    fn is_cancelled(&mut self) -> bool {
        self.rays.len() >= MAX_RAYS
    }
}

impl RayTreeRecorder<'_> {
    fn record_secondary_ray(&mut self, kind: RayKind, factor: Rgb, weight: Rgb, outcome: RayOutcome) {
        let cut = match outcome {
            RayOutcome::Sent => None,
            RayOutcome::BelowCutoff => Some("cutoff"),
            RayOutcome::LevelLimit => Some("levels"),
        };
        let record = SecondaryRayRecord {
            kind: kind.name(),
            share: rgb_array(factor),
            weight: rgb_array(weight),
            ray: None,
            cut,
        };
        let parent = self.rays.len().saturating_sub(1);
        let index = self.rays.last().map_or(0, |ray| ray.sends.len());
        if cut.is_none() {
            self.pending.push((parent, index));
        }
        self.with_current_ray(|ray| ray.sends.push(record));
    }
}
