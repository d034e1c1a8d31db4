//! What a tracer tells of the tree of rays, step by step.
//!
//! [`CountedEvent`](super::CountedEvent)s are for counting; steps are for showing how one colour comes about. A
//! ray begins with [`TraceEvent::RayStart`] and ends with [`TraceEvent::RayEnd`]; what it sends on is told between
//! the two, and is followed later, the last one sent first. So the tree can be put together with a
//! stack, and the sum of all that is added, in this order, is the colour of the camera ray, bit for
//! bit.

use super::{RayKind, RayOutcome};
use crate::geometry::{Hit, ItemId};
use crate::math::{Real, Rgb, Vec3};

/// One step through the tree of rays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TraceEvent {
    /// A ray is followed.
    RayStart {
        /// Why it was sent.
        kind: RayKind,
        /// The camera ray has level 1.
        level: u8,
        /// Where it starts.
        origin: Vec3,
        /// Where it goes, of length one.
        direction: Vec3,
        /// How much of what it finds counts in the camera ray.
        weight: Rgb,
    },
    /// It meets nothing.
    Miss {
        /// What it brings from there: the background, or what a medium without end leaves of it.
        radiance: Rgb,
    },
    /// It meets a surface.
    Hit {
        /// Which item, and how far away.
        hit: Hit,
        /// Where.
        point: Vec3,
        /// Whether on the side that its normal points to.
        front_face: bool,
        /// The number of the material that fills space on the way there; none is empty space.
        medium: Option<u16>,
        /// Which share the way there leaves of the ray's weight.
        transmittance: Rgb,
        /// Whether the surface lies hidden inside another body, so that the ray goes on as if it
        /// were not there.
        is_hidden: bool,
    },
    /// Light from everywhere, which the surface sends back along the ray.
    Ambient(Rgb),
    /// It is asked what stands in the way of a light.
    ShadowRay {
        /// Where the shadow ray starts.
        origin: Vec3,
        /// Where it goes, about of length one.
        direction: Vec3,
        /// How far something may be and still stand in the way.
        t_max: Real,
    },
    /// Light passes through a surface on its way from the light.
    ShadowTransmission {
        /// Which, and how far away from the surface before.
        hit: Hit,
        /// Which share has come through everything up to here.
        transmittance: Rgb,
    },
    /// Something stands in the way of a light.
    Occluded {
        /// What.
        item: ItemId,
        /// How far away from the surface before, where that has been looked for: whatever stands in
        /// the way answers the question.
        t: Option<Real>,
    },
    /// What comes of one light.
    LightContribution {
        /// Its number.
        light: u16,
        /// What comes of it.
        outcome: LightOutcome,
    },
    /// All light that the surface itself sends back along the ray: ambient, and then what each
    /// light adds, in this order.
    LocalIllumination(Rgb),
    /// All light is thrown back at a surface that would let it through.
    TotalInternalReflection,
    /// A ray goes on from the surface.
    SecondaryRay {
        /// Why.
        kind: RayKind,
        /// Its share of the light that arrives along it.
        factor: Rgb,
        /// How much of what it finds would count in the camera ray.
        weight: Rgb,
        /// Whether it is sent.
        outcome: RayOutcome,
    },
    /// What the ray adds to the colour of the camera ray by itself: what its weight leaves of its
    /// light, and of what stands for the rays that are not sent.
    RayEnd(Rgb),
}

/// What comes of a light at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightOutcome {
    /// The light does not shine there.
    NoEmission,
    /// The surface faces away from it.
    BackFacing,
    /// The surface would only show it in a mirror, and not in this direction.
    OutsideHighlight,
    /// Something stands in its way.
    Occluded,
    /// It arrives.
    Arrived {
        /// Towards the light, of length one.
        direction: Vec3,
        /// How far away the light is; [`Real::MAX`] when it has no place.
        distance: Real,
        /// What arrives on a surface that faces it.
        color: Rgb,
        /// What the surface sends of it along the ray.
        contribution: Rgb,
    },
}
