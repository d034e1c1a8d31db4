//! Somebody who is told the steps of a tracer, and puts the tree of rays together.

use strahl_core::geometry::ItemId;
use strahl_core::tally::{CountedEvent, LightOutcome, RayKind, RayOutcome, Tally, TraceEvent};
use strahl_core::{Real, Rgb, Vec3};

use super::source_names::SourceNames;
use super::tree::{
    HitRecord, LightRecord, OccluderRecord, RayRecord, SecondaryRayRecord, TransmissionRecord, Triple,
    rgb_array, xyz_array,
};

/// The most rays of one sample that are told, and can be waited for.
pub const MAX_RAYS: usize = 1 << 18;

/// The rays of one sample, as they are told.
pub struct RayTreeRecorder<'n> {
    names: &'n SourceNames<'n>,
    rays: Vec<RayRecord>,
    /// Who has sent each ray that waits, and which of those that he has sent it is.
    pending: Vec<(usize, usize)>,
    shadow_ray: ShadowRayState,
}

/// What has been found on the way to a light.
#[derive(Default)]
struct ShadowRayState {
    ray: Option<(Vec3, Vec3, Real)>,
    transmitted: Vec<TransmissionRecord>,
    /// How far away the last surface is that light has passed.
    distance: f32,
    occluder: Option<(ItemId, f32)>,
}

impl<'n> RayTreeRecorder<'n> {
    /// Of nothing yet.
    pub fn new(names: &'n SourceNames<'n>) -> Self {
        RayTreeRecorder {
            names,
            rays: Vec::new(),
            pending: Vec::new(),
            shadow_ray: ShadowRayState::default(),
        }
    }

    /// The rays, in the order in which they were followed.
    pub fn into_rays(self) -> Vec<RayRecord> {
        self.rays
    }

    fn start_ray(&mut self, ray: RayRecord) {
        let number = self.rays.len() + 1;
        let sender = self.pending.pop();
        if let Some((sender, place)) = sender
            && let Some(sent) = self.rays.get_mut(sender).and_then(|ray| ray.sends.get_mut(place))
        {
            sent.ray = Some(number);
        }
        self.rays.push(RayRecord { number, parent: sender.map(|(sender, _)| sender + 1), ..ray });
    }

    fn record_light(&mut self, number: u16, lit: LightOutcome) {
        let ShadowRayState { ray: way, transmitted: through, occluder: blocker, .. } =
            std::mem::take(&mut self.shadow_ray);
        let mut light = LightRecord {
            number,
            named: self.names.light(number),
            outcome: outcome(lit),
            toward: None,
            distance: None,
            arrives: None,
            adds: None,
            through,
            blocker: None,
        };
        match lit {
            LightOutcome::Arrived { direction: toward, distance, color, contribution: adds } => {
                light.toward = Some(xyz_array(toward));
                light.distance = (distance < Real::MAX).then_some(distance);
                light.arrives = Some(rgb_array(color));
                light.adds = Some(rgb_array(adds));
            }
            // The tracer is content with whatever stands in the way; a reader looks for the nearest.
            LightOutcome::Occluded if light.through.is_empty() => {
                let nearest = way.and_then(|(origin, direction, reach)| {
                    self.names.nearest_occluder(origin, direction, reach)
                });
                light.blocker = nearest.or(blocker).map(|it| self.occluder_record(it));
            }
            LightOutcome::Occluded => light.blocker = blocker.map(|it| self.occluder_record(it)),
            LightOutcome::NoEmission | LightOutcome::BackFacing | LightOutcome::OutsideHighlight => {}
        }
        self.with_current_ray(|ray| ray.lights.push(light));
    }

    fn occluder_record(&self, (item, distance): (ItemId, f32)) -> OccluderRecord {
        OccluderRecord { thing: self.names.item(item), distance }
    }

    /// Changes the ray that is followed.
    fn with_current_ray(&mut self, change: impl FnOnce(&mut RayRecord)) {
        if let Some(ray) = self.rays.last_mut() {
            change(ray);
        }
    }
}

fn outcome(lit: LightOutcome) -> &'static str {
    match lit {
        LightOutcome::NoEmission => "dark",
        LightOutcome::BackFacing => "behind",
        LightOutcome::OutsideHighlight => "unseen",
        LightOutcome::Occluded => "blocked",
        LightOutcome::Arrived { .. } => "seen",
    }
}

/// Channel by channel, as the core multiplies.
fn product(a: Triple, b: Triple) -> Triple {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

impl Tally for RayTreeRecorder<'_> {
    /// Nothing is counted.
    fn count(&mut self, _: CountedEvent) {}

    fn trace_event(&mut self, step: TraceEvent) {
        match step {
            TraceEvent::RayStart { kind, level, origin, direction, weight } => self.start_ray(RayRecord {
                kind: kind.name(),
                level,
                origin: xyz_array(origin),
                direction: xyz_array(direction),
                weight: rgb_array(weight),
                weight_there: rgb_array(weight),
                ..RayRecord::default()
            }),
            TraceEvent::Miss { radiance: light } => self.with_current_ray(|ray| ray.light = rgb_array(light)),
            TraceEvent::Hit {
                hit,
                point,
                front_face: outside,
                medium: within,
                transmittance: left,
                is_hidden: hidden,
            } => {
                let hit = HitRecord {
                    thing: self.names.item(hit.item),
                    distance: hit.t,
                    point: xyz_array(point),
                    outside,
                    within: within.map(|material| self.names.material(material)),
                    left: rgb_array(left),
                    hidden,
                };
                self.with_current_ray(|ray| {
                    ray.weight_there = product(ray.weight, hit.left);
                    ray.hit = Some(hit);
                });
            }
            TraceEvent::Ambient(light) => self.with_current_ray(|ray| ray.ambient = Some(rgb_array(light))),
            TraceEvent::ShadowRay { origin, direction, t_max: reach } => {
                self.shadow_ray =
                    ShadowRayState { ray: Some((origin, direction, reach)), ..ShadowRayState::default() };
            }
            TraceEvent::ShadowTransmission { hit, transmittance: share } => {
                let ShadowRayState { transmitted: through, distance: gone, .. } = &mut self.shadow_ray;
                *gone += hit.t;
                let thing = self.names.item(hit.item);
                through.push(TransmissionRecord { thing, distance: *gone, share: rgb_array(share) });
            }
            TraceEvent::Occluded { item, t: distance } => {
                let gone = self.shadow_ray.distance + distance.unwrap_or(0.0);
                self.shadow_ray.occluder = Some((item, gone));
            }
            TraceEvent::LightContribution { light: number, outcome: lit } => self.record_light(number, lit),
            TraceEvent::LocalIllumination(light) => self.with_current_ray(|ray| ray.light = rgb_array(light)),
            TraceEvent::TotalInternalReflection => self.with_current_ray(|ray| ray.total_reflection = true),
            TraceEvent::SecondaryRay { kind, factor: share, weight, outcome: fate } => {
                self.record_secondary_ray(kind, share, weight, fate)
            }
            TraceEvent::RayEnd(light) => self.with_current_ray(|ray| ray.adds = rgb_array(light)),
            // Whatever else a later core tells.
            _ => {}
        }
    }

    fn is_cancelled(&mut self) -> bool {
        self.rays.len() >= MAX_RAYS
    }
}

impl RayTreeRecorder<'_> {
    fn record_secondary_ray(&mut self, kind: RayKind, share: Rgb, weight: Rgb, fate: RayOutcome) {
        let cut = match fate {
            RayOutcome::Sent => None,
            RayOutcome::BelowCutoff => Some("cutoff"),
            RayOutcome::LevelLimit => Some("levels"),
        };
        let sent = SecondaryRayRecord {
            kind: kind.name(),
            share: rgb_array(share),
            weight: rgb_array(weight),
            ray: None,
            cut,
        };
        let sender = self.rays.len().saturating_sub(1);
        let place = self.rays.last().map_or(0, |ray| ray.sends.len());
        if cut.is_none() {
            self.pending.push((sender, place));
        }
        self.with_current_ray(|ray| ray.sends.push(sent));
    }
}
