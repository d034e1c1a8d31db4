//! What a tracer tells of the tree of rays, step by step.
//!
//! [`Event`](super::Event)s are for counting; steps are for showing how one colour comes about. A
//! ray begins with [`Step::Follows`] and ends with [`Step::Adds`]; what it sends on is told between
//! the two, and is followed later, the last one sent first. So the tree can be put together with a
//! stack, and the sum of all that is added, in this order, is the colour of the camera ray, bit for
//! bit.

use super::{Fate, RayKind};
use crate::geometry::{Hit, ItemId};
use crate::math::{Real, Rgb, Vec3};

/// One step through the tree of rays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Step {
    /// A ray is followed.
    Follows {
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
    Beyond {
        /// What it brings from there: the background, or what a medium without end leaves of it.
        light: Rgb,
    },
    /// It meets a surface.
    Meets {
        /// Which item, and how far away.
        hit: Hit,
        /// Where.
        point: Vec3,
        /// Whether on the side that its normal points to.
        outside: bool,
        /// The number of the material that fills space on the way there; none is empty space.
        within: Option<u16>,
        /// Which share the way there leaves of the ray's weight.
        left: Rgb,
        /// Whether the surface lies hidden inside another body, so that the ray goes on as if it
        /// were not there.
        hidden: bool,
    },
    /// Light from everywhere, which the surface sends back along the ray.
    Ambient(Rgb),
    /// It is asked what stands in the way of a light.
    Asks {
        /// Where the shadow ray starts.
        origin: Vec3,
        /// Where it goes, about of length one.
        direction: Vec3,
        /// How far something may be and still stand in the way.
        reach: Real,
    },
    /// Light passes through a surface on its way from the light.
    Passes {
        /// Which, and how far away from the surface before.
        hit: Hit,
        /// Which share has come through everything up to here.
        share: Rgb,
    },
    /// Something stands in the way of a light.
    Blocked {
        /// What.
        item: ItemId,
        /// How far away from the surface before, where that has been looked for: whatever stands in
        /// the way answers the question.
        distance: Option<Real>,
    },
    /// What comes of one light.
    Light {
        /// Its number.
        number: u16,
        /// What comes of it.
        lit: Lit,
    },
    /// All light that the surface itself sends back along the ray: ambient, and then what each
    /// light adds, in this order.
    Local(Rgb),
    /// All light is thrown back at a surface that would let it through.
    ThrownBack,
    /// A ray goes on from the surface.
    Sends {
        /// Why.
        kind: RayKind,
        /// Its share of the light that arrives along it.
        share: Rgb,
        /// How much of what it finds would count in the camera ray.
        weight: Rgb,
        /// Whether it is sent.
        fate: Fate,
    },
    /// What the ray adds to the colour of the camera ray by itself: what its weight leaves of its
    /// light, and of what stands for the rays that are not sent.
    Adds(Rgb),
}

/// What comes of a light at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lit {
    /// The light does not shine there.
    Dark,
    /// The surface faces away from it.
    Behind,
    /// The surface would only show it in a mirror, and not in this direction.
    Unseen,
    /// Something stands in its way.
    Shadowed,
    /// It arrives.
    Arrives {
        /// Towards the light, of length one.
        toward: Vec3,
        /// How far away the light is; [`Real::MAX`] when it has no place.
        distance: Real,
        /// What arrives on a surface that faces it.
        color: Rgb,
        /// What the surface sends of it along the ray.
        adds: Rgb,
    },
}
