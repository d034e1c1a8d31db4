//! Lights: point, directional and spot lights, and area lights (sphere, rectangle).
//!
//! An area light is sampled at one random point for each camera sample, light and ray level, so that many
//! rays together show the penumbra. A sampler that draws the center of the unit square makes it a light without extent.
//!
//! Source: Cook, Porter and Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.

use super::check::FieldChecks;
use super::{Field, LightKind, LightKindSet};
use crate::math::{
    MAX_COORDINATE, Real, Rgb, Vec3, clamp, orthonormal_basis, sample_disc_concentric, sqrt, try_normalize,
    try_normalize_and_length,
};
use crate::tally::LightOutcome;

/// A light source, its color, and whether items occlude it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Light {
    /// Kind, position and shape of the light.
    pub source: LightSource,
    /// Light that arrives at a surface that faces it, linear RGB, before the falloff, each channel in
    /// `0..=1e6`.
    pub color: Rgb,
    /// Whether items occlude it. Without shadows it lights every surface that faces it.
    pub casts_shadows: bool,
}

/// Kind, position and shape of a light, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum LightSource {
    /// A point that emits in all directions.
    Point {
        /// Position, coordinates in `-1e15..=1e15`.
        position: Vec3,
        /// Distance falloff.
        falloff: Falloff,
    },
    /// A light at infinite distance, such as the sun.
    Directional {
        /// Direction towards the light, unit vector.
        to_light: Vec3,
    },
    /// A point that emits into a cone, with a smooth transition at its edge.
    Spot {
        /// Position, coordinates in `-1e15..=1e15`.
        position: Vec3,
        /// Axis of the cone, away from the light, unit vector.
        direction: Vec3,
        /// Cosine of the angle from the axis up to which the light has full intensity, in `cos_outer..=1`.
        cos_inner: Real,
        /// Cosine of the angle from the axis beyond which the light is black, in `-1..=1`.
        cos_outer: Real,
        /// Distance falloff.
        falloff: Falloff,
    },
    /// A sphere that emits as much light as a point at its center.
    ///
    /// It is sampled on the disc through its center that faces the shaded point. Items inside the sphere do
    /// not occlude it.
    Sphere {
        /// Center, coordinates in `-1e15..=1e15`.
        position: Vec3,
        /// Radius, in `0..=1e15`; 0 makes it a point.
        radius: Real,
        /// Falloff with the distance from the center.
        falloff: Falloff,
    },
    /// A rectangle that emits from its front, proportional to the cosine of the angle to its normal
    /// (Lambert).
    Rectangle {
        /// Center, coordinates in `-1e15..=1e15`.
        position: Vec3,
        /// Vectors from the center to the centers of two adjacent edges. The front is the side to which the
        /// cross product of the first and the second points; it must not be zero.
        half_edges: [Vec3; 2],
        /// Whether the whole rectangle emits, or only its center.
        soft_shadows: bool,
        /// Falloff with the distance from the sampled point.
        falloff: Falloff,
    },
}

/// Distance falloff: light at distance `d` is divided by `constant + linear d + quadratic d^2`.
///
/// All three are in `0..=1e15`, and their sum is more than 0. The quotient is at most 1e6.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Falloff {
    /// Constant term, without a unit.
    pub constant: Real,
    /// Linear term, in reciprocal scene lengths.
    pub linear: Real,
    /// Quadratic term, in reciprocal squared scene lengths.
    pub quadratic: Real,
}

impl Falloff {
    /// No falloff: the same light at every distance.
    pub const NONE: Falloff = Falloff { constant: 1.0, linear: 0.0, quadratic: 0.0 };
    /// Inverse square, the physical law: factor 1 at distance 1.
    pub const INVERSE_SQUARE: Falloff = Falloff { constant: 0.0, linear: 0.0, quadratic: 1.0 };

    fn validate(&self, fields: &mut FieldChecks) {
        fields.range(Field::Constant, self.constant, 0.0, 1e15);
        fields.range(Field::Linear, self.linear, 0.0, 1e15);
        fields.range(Field::Quadratic, self.quadratic, 0.0, 1e15);
        let sum = self.constant + self.linear + self.quadratic;
        fields.require(Field::Falloff, sum, sum > 0.0);
    }

    /// Factor of the light at distance `d`, at most [`Rgb::MAX_CHANNEL`].
    fn factor_at(&self, d: Real) -> Real {
        let divisor = self.constant + d * (self.linear + d * self.quadratic);
        // Without a constant term it grows without bound near the light, so it is clamped.
        let factor = 1.0 / divisor;
        if factor < Rgb::MAX_CHANNEL { factor } else { Rgb::MAX_CHANNEL }
    }
}

/// Light that arrives at a surface unless the light is occluded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LightSample {
    /// Direction towards the sampled point of the light, unit vector.
    pub(crate) direction: Vec3,
    /// Cosine of the angle between `direction` and the normal of the surface; rounding can make it slightly
    /// negative.
    pub(crate) cos_theta: Real,
    /// Distance of the light; [`Real::MAX`] for a directional light.
    pub(crate) distance: Real,
    /// Light that arrives at a surface that faces it, after the falloff.
    pub(crate) color: Rgb,
}

impl Light {
    /// A point light without falloff that casts shadows.
    ///
    /// ```
    /// use strahl_core::{Light, Rgb, vec3};
    ///
    /// let lamp = Light::point(vec3(3.0, 4.0, 5.0), Rgb::WHITE);
    /// assert!(lamp.casts_shadows && !lamp.has_soft_shadows());
    /// ```
    pub const fn point(position: Vec3, color: Rgb) -> Self {
        Light { source: LightSource::Point { position, falloff: Falloff::NONE }, color, casts_shadows: true }
    }

    /// Kind of the light: the variant of its source.
    pub const fn kind(&self) -> LightKind {
        match self.source {
            LightSource::Point { .. } => LightKind::Point,
            LightSource::Directional { .. } => LightKind::Directional,
            LightSource::Spot { .. } => LightKind::Spot,
            LightSource::Sphere { .. } => LightKind::Sphere,
            LightSource::Rectangle { .. } => LightKind::Rectangle,
        }
    }

    /// Whether its shadows are soft: it is an area light.
    pub fn has_soft_shadows(&self) -> bool {
        match self.source {
            LightSource::Sphere { radius, .. } => radius > 0.0,
            LightSource::Rectangle { soft_shadows, .. } => soft_shadows,
            LightSource::Point { .. } | LightSource::Directional { .. } | LightSource::Spot { .. } => false,
        }
    }

    pub(super) fn validate(&self, fields: &mut FieldChecks) {
        match &self.source {
            LightSource::Point { position, falloff } => {
                fields.point(Field::Position, position);
                falloff.validate(fields);
            }
            LightSource::Directional { to_light } => fields.direction(Field::ToLight, to_light),
            LightSource::Spot { position, direction, cos_inner, cos_outer, falloff } => {
                fields.point(Field::Position, position);
                fields.direction(Field::Direction, direction);
                fields.range(Field::CosOuter, *cos_outer, -1.0, 1.0);
                fields.range(Field::CosInner, *cos_inner, *cos_outer, 1.0);
                falloff.validate(fields);
            }
            LightSource::Sphere { position, radius, falloff } => {
                fields.point(Field::Position, position);
                fields.range(Field::Radius, *radius, 0.0, MAX_COORDINATE);
                falloff.validate(fields);
            }
            LightSource::Rectangle { position, half_edges: [a, b], falloff, .. } => {
                fields.point(Field::Position, position);
                fields.point(Field::HalfEdges, a);
                fields.point(Field::HalfEdges, b);
                fields.require(Field::HalfEdgesArea, 0.0, try_normalize(a.cross(*b)).is_some());
                falloff.validate(fields);
            }
        }
        fields.color(Field::Color, &self.color, Rgb::MAX_CHANNEL);
    }

    /// Samples the light that arrives at `point` on a surface with this `normal`, before occlusion.
    ///
    /// * `normal`: unit vector, on the side that is lit.
    /// * `supported`: kinds of lights that are compiled; others give [`LightOutcome::NoEmission`].
    /// * `u`: draws a point of the unit square that is mapped to the light, (0.5, 0.5) to its center.
    ///
    /// `Err` gives the reason: the light does not emit towards the point, or is behind the surface.
    // Inlined so that the arms of unsupported kinds are compiled away.
    #[inline(always)]
    pub(crate) fn sample(
        &self,
        point: Vec3,
        normal: Vec3,
        supported: LightKindSet,
        u: impl FnOnce() -> [Real; 2],
    ) -> Result<LightSample, LightOutcome> {
        let sample_point = |position: Vec3, falloff: &Falloff| {
            let to_light = position - point;
            // Tested before the square root.
            let unnormalized_cos = normal.dot(to_light);
            if !(unnormalized_cos > 0.0) {
                return Err(LightOutcome::BackFacing);
            }
            let (direction, distance) = try_normalize_and_length(to_light).ok_or(LightOutcome::NoEmission)?;
            let color = self.color * falloff.factor_at(distance);
            Ok(LightSample { direction, cos_theta: unnormalized_cos / distance, distance, color })
        };
        match &self.source {
            LightSource::Point { position, falloff } if supported.contains(LightKind::Point) => {
                sample_point(*position, falloff)
            }
            LightSource::Directional { to_light } if supported.contains(LightKind::Directional) => {
                let cos_theta = normal.dot(*to_light);
                let sample =
                    LightSample { direction: *to_light, cos_theta, distance: Real::MAX, color: self.color };
                if cos_theta > 0.0 { Ok(sample) } else { Err(LightOutcome::BackFacing) }
            }
            LightSource::Spot { position, direction, cos_inner, cos_outer, falloff }
                if supported.contains(LightKind::Spot) =>
            {
                let mut sample = sample_point(*position, falloff)?;
                let cos = -sample.direction.dot(*direction);
                if cos < *cos_outer {
                    return Err(LightOutcome::NoEmission);
                }
                // Smoothstep from the outer to the inner cone.
                let s = clamp((cos - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
                let s = if cos >= *cos_inner { 1.0 } else { s };
                sample.color = sample.color * (s * s * (3.0 - 2.0 * s));
                Ok(sample)
            }
            LightSource::Sphere { position, radius, falloff } if supported.contains(LightKind::Sphere) => {
                if !(*radius > 0.0) {
                    return sample_point(*position, falloff);
                }
                // A point on the disc through the center that faces `point`.
                let to_center = *position - point;
                let (axis, distance) = try_normalize_and_length(to_center).ok_or(LightOutcome::NoEmission)?;
                let [tangent, bitangent] = orthonormal_basis(axis);
                let [x, y] = sample_disc_concentric(u());
                let direction = try_normalize(to_center + (tangent * x + bitangent * y) * *radius)
                    .ok_or(LightOutcome::NoEmission)?;
                let cos_theta = normal.dot(direction);
                // The shadow ray ends where it enters the sphere: items inside do not occlude the light.
                let t_closest = to_center.dot(direction);
                let half_chord_squared =
                    *radius * *radius - (to_center.dot(to_center) - t_closest * t_closest);
                let t_entry =
                    t_closest - sqrt(if half_chord_squared > 0.0 { half_chord_squared } else { 0.0 });
                let sample = LightSample {
                    direction,
                    cos_theta,
                    // Zero if `point` is inside the sphere.
                    distance: if t_entry > 0.0 { t_entry } else { 0.0 },
                    color: self.color * falloff.factor_at(distance),
                };
                if cos_theta > 0.0 { Ok(sample) } else { Err(LightOutcome::BackFacing) }
            }
            LightSource::Rectangle { position, half_edges: [a, b], soft_shadows, falloff }
                if supported.contains(LightKind::Rectangle) =>
            {
                let [u, v] = if *soft_shadows { u() } else { [0.5, 0.5] };
                let position = *position + *a * (2.0 * u - 1.0) + *b * (2.0 * v - 1.0);
                let mut sample = sample_point(position, falloff)?;
                let cos = -sample.direction.dot(try_normalize(a.cross(*b)).ok_or(LightOutcome::NoEmission)?);
                sample.color = sample.color * cos;
                if cos > 0.0 { Ok(sample) } else { Err(LightOutcome::NoEmission) }
            }
            // Not supported. Listed, so that a new variant is a compile error here.
            LightSource::Point { .. }
            | LightSource::Directional { .. }
            | LightSource::Spot { .. }
            | LightSource::Sphere { .. }
            | LightSource::Rectangle { .. } => Err(LightOutcome::NoEmission),
        }
    }
}
