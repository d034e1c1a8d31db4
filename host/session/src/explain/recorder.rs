//! Somebody who is told the steps of a tracer, and puts the tree of rays together.

use strahl_core::geometry::ItemId;
use strahl_core::tally::{CountedEvent, LightOutcome, RayKind, RayOutcome, Tally, TraceEvent};
use strahl_core::{Real, Rgb, Vec3};

use super::source_names::Names;
use super::tree::{Blocker, Hit, Light, Passage, Ray, Sent, Triple, triple, xyz};

/// The most rays of one sample that are told, and can be waited for.
pub const MOST_RAYS: usize = 1 << 18;

/// The rays of one sample, as they are told.
pub struct Record<'n> {
    names: &'n Names<'n>,
    rays: Vec<Ray>,
    /// Who has sent each ray that waits, and which of those that he has sent it is.
    waiting: Vec<(usize, usize)>,
    asked: Asked,
}

/// What has been found on the way to a light.
#[derive(Default)]
struct Asked {
    way: Option<(Vec3, Vec3, Real)>,
    through: Vec<Passage>,
    /// How far away the last surface is that light has passed.
    gone: f32,
    blocker: Option<(ItemId, f32)>,
}

impl<'n> Record<'n> {
    /// Of nothing yet.
    pub fn new(names: &'n Names<'n>) -> Self {
        Record { names, rays: Vec::new(), waiting: Vec::new(), asked: Asked::default() }
    }

    /// The rays, in the order in which they were followed.
    pub fn into_rays(self) -> Vec<Ray> {
        self.rays
    }

    fn follows(&mut self, ray: Ray) {
        let number = self.rays.len() + 1;
        let sender = self.waiting.pop();
        if let Some((sender, place)) = sender
            && let Some(sent) = self.rays.get_mut(sender).and_then(|ray| ray.sends.get_mut(place))
        {
            sent.ray = Some(number);
        }
        self.rays.push(Ray { number, parent: sender.map(|(sender, _)| sender + 1), ..ray });
    }

    fn light(&mut self, number: u16, lit: LightOutcome) {
        let Asked { way, through, blocker, .. } = std::mem::take(&mut self.asked);
        let mut light = Light {
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
                light.toward = Some(xyz(toward));
                light.distance = (distance < Real::MAX).then_some(distance);
                light.arrives = Some(triple(color));
                light.adds = Some(triple(adds));
            }
            // The tracer is content with whatever stands in the way; a reader looks for the nearest.
            LightOutcome::Occluded if light.through.is_empty() => {
                let nearest =
                    way.and_then(|(origin, direction, reach)| self.names.nearest(origin, direction, reach));
                light.blocker = nearest.or(blocker).map(|it| self.blocker(it));
            }
            LightOutcome::Occluded => light.blocker = blocker.map(|it| self.blocker(it)),
            LightOutcome::NoEmission | LightOutcome::BackFacing | LightOutcome::OutsideHighlight => {}
        }
        self.with_last(|ray| ray.lights.push(light));
    }

    fn blocker(&self, (item, distance): (ItemId, f32)) -> Blocker {
        Blocker { thing: self.names.thing(item), distance }
    }

    /// Changes the ray that is followed.
    fn with_last(&mut self, change: impl FnOnce(&mut Ray)) {
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

impl Tally for Record<'_> {
    /// Nothing is counted.
    fn count(&mut self, _: CountedEvent) {}

    fn trace_event(&mut self, step: TraceEvent) {
        match step {
            TraceEvent::RayStart { kind, level, origin, direction, weight } => self.follows(Ray {
                kind: kind.name(),
                level,
                origin: xyz(origin),
                direction: xyz(direction),
                weight: triple(weight),
                weight_there: triple(weight),
                ..Ray::default()
            }),
            TraceEvent::Miss { radiance: light } => self.with_last(|ray| ray.light = triple(light)),
            TraceEvent::Hit {
                hit,
                point,
                front_face: outside,
                medium: within,
                transmittance: left,
                is_hidden: hidden,
            } => {
                let hit = Hit {
                    thing: self.names.thing(hit.item),
                    distance: hit.t,
                    point: xyz(point),
                    outside,
                    within: within.map(|material| self.names.material(material)),
                    left: triple(left),
                    hidden,
                };
                self.with_last(|ray| {
                    ray.weight_there = product(ray.weight, hit.left);
                    ray.hit = Some(hit);
                });
            }
            TraceEvent::Ambient(light) => self.with_last(|ray| ray.ambient = Some(triple(light))),
            TraceEvent::ShadowRay { origin, direction, t_max: reach } => {
                self.asked = Asked { way: Some((origin, direction, reach)), ..Asked::default() };
            }
            TraceEvent::ShadowTransmission { hit, transmittance: share } => {
                let Asked { through, gone, .. } = &mut self.asked;
                *gone += hit.t;
                let thing = self.names.thing(hit.item);
                through.push(Passage { thing, distance: *gone, share: triple(share) });
            }
            TraceEvent::Occluded { item, t: distance } => {
                let gone = self.asked.gone + distance.unwrap_or(0.0);
                self.asked.blocker = Some((item, gone));
            }
            TraceEvent::LightContribution { light: number, outcome: lit } => self.light(number, lit),
            TraceEvent::LocalIllumination(light) => self.with_last(|ray| ray.light = triple(light)),
            TraceEvent::TotalInternalReflection => self.with_last(|ray| ray.total_reflection = true),
            TraceEvent::SecondaryRay { kind, factor: share, weight, outcome: fate } => {
                self.sends(kind, share, weight, fate)
            }
            TraceEvent::RayEnd(light) => self.with_last(|ray| ray.adds = triple(light)),
            // Whatever else a later core tells.
            _ => {}
        }
    }

    fn is_cancelled(&mut self) -> bool {
        self.rays.len() >= MOST_RAYS
    }
}

impl Record<'_> {
    fn sends(&mut self, kind: RayKind, share: Rgb, weight: Rgb, fate: RayOutcome) {
        let cut = match fate {
            RayOutcome::Sent => None,
            RayOutcome::BelowCutoff => Some("cutoff"),
            RayOutcome::LevelLimit => Some("levels"),
        };
        let sent = Sent { kind: kind.name(), share: triple(share), weight: triple(weight), ray: None, cut };
        let sender = self.rays.len().saturating_sub(1);
        let place = self.rays.last().map_or(0, |ray| ray.sends.len());
        if cut.is_none() {
            self.waiting.push((sender, place));
        }
        self.with_last(|ray| ray.sends.push(sent));
    }
}
