//! The ray tree of a camera sample, reported step by step.
//!
//! Each ray reports [`TraceEvent::RayStart`] first and [`TraceEvent::RayEnd`] last. The secondary rays that
//! it sends are reported in between and traced later, last in, first out: a receiver rebuilds the tree with a
//! stack. The contributions of all [`TraceEvent::RayEnd`]s, added in this order, are the color of the camera
//! sample, bit for bit. Positions and directions are in world space.

use super::{RayKind, RayOutcome};
use crate::geometry::{Hit, ItemId};
use crate::math::{Real, Rgb, Vec3};

/// A step in the ray tree of one camera sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TraceEvent {
    /// A camera, reflected or transmitted ray starts.
    RayStart {
        /// Kind of the ray.
        kind: RayKind,
        /// Level in the ray tree; camera rays have level 1.
        level: u8,
        /// Origin.
        origin: Vec3,
        /// Direction, unit.
        direction: Vec3,
        /// Weight of its radiance in the camera sample: the product of the factors along its path.
        weight: Rgb,
    },
    /// The ray hits nothing.
    Miss {
        /// Background radiance, attenuated by the medium that the ray is in.
        radiance: Rgb,
    },
    /// The ray hits a surface.
    Hit {
        /// Item and `t`, in scene lengths.
        hit: Hit,
        /// Point on the surface.
        point: Vec3,
        /// Whether the ray arrives on the side that the geometric normal points to.
        front_face: bool,
        /// Index of the material whose body the ray came through; `None` is empty space.
        medium: Option<u16>,
        /// Transmittance of that medium between the origin and the point.
        transmittance: Rgb,
        /// Whether the surface is inside a body of higher priority: the ray goes on as if it did not exist.
        is_hidden: bool,
    },
    /// Reflected ambient light at the hit point.
    Ambient(Rgb),
    /// A shadow ray starts. A [`TraceEvent::LightContribution`] follows.
    ShadowRay {
        /// Origin.
        origin: Vec3,
        /// Direction to the light, approximately unit.
        direction: Vec3,
        /// Largest `t` of an occluder.
        t_max: Real,
    },
    /// The shadow ray passes a transmitting surface.
    ShadowTransmission {
        /// Item, and `t` measured from the previous surface.
        hit: Hit,
        /// Transmittance from the origin of the shadow ray to behind this surface.
        transmittance: Rgb,
    },
    /// An item occludes the light.
    Occluded {
        /// The occluder; not necessarily the nearest.
        item: ItemId,
        /// `t` measured from the previous surface; `None` if it was not computed, because any occluder
        /// suffices.
        t: Option<Real>,
    },
    /// A light was evaluated at the hit point.
    LightContribution {
        /// Index of the light in the scene.
        light: u16,
        /// Whether its light arrives, and what it contributes.
        outcome: LightOutcome,
    },
    /// Local illumination at the hit point: reflected ambient light plus the contributions of all lights,
    /// added in the order in which they were reported.
    LocalIllumination(Rgb),
    /// Total internal reflection at a transmitting surface: no ray is refracted.
    TotalInternalReflection,
    /// A secondary ray at the hit point.
    SecondaryRay {
        /// [`RayKind::Reflected`] or [`RayKind::Transmitted`].
        kind: RayKind,
        /// Fraction of the radiance along the secondary ray that the surface returns.
        factor: Rgb,
        /// Weight of the secondary ray in the camera sample: the weight at the hit point times `factor`.
        weight: Rgb,
        /// Whether it is sent.
        outcome: RayOutcome,
    },
    /// The ray ends. Its weighted contribution to the color of the camera sample, without that of its
    /// secondary rays, with the substitutes of those that were not sent.
    RayEnd(Rgb),
}

/// Result of evaluating a light at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightOutcome {
    /// The light emits nothing towards the point.
    NoEmission,
    /// The light is behind the surface.
    BackFacing,
    /// The surface has no diffuse reflection, and the highlight of the light is not visible from here.
    OutsideHighlight,
    /// The light is occluded.
    Occluded,
    /// Light arrives.
    Arrived {
        /// Direction to the light, unit.
        direction: Vec3,
        /// Distance to the light, in scene lengths; [`Real::MAX`] for directional lights.
        distance: Real,
        /// Light arriving at a surface that faces the light, after falloff and shadow transmittance.
        color: Rgb,
        /// Light reflected along the ray: diffuse and highlight.
        contribution: Rgb,
    },
}
