//! Lights: without extent (point, directional, spot), and with one (sphere, rectangle).
//!
//! A light with an extent is asked for at one place of it for each camera ray, another for
//! each: so shadows get soft rims that many rays fill ("Distributed Ray Tracing", Cook, Porter,
//! Carpenter, SIGGRAPH 1984). From its middle it is a light without extent.

use super::{Field, FieldError, LightKind, LightSet, check};
use crate::math::{
    MAX_COORDINATE, Real, Rgb, Vec3, clamp, orthonormal_basis, sample_disc_concentric, sqrt, try_normalize,
    try_normalize_and_length,
};
use crate::tally::LightOutcome;

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Light {
    /// Where it is and where it shines.
    pub source: LightSource,
    /// Its radiance at a surface that faces it, before the falloff.
    pub color: Rgb,
    /// Whether things stand in its way.
    pub casts_shadows: bool,
}

/// Where a light is and where it shines.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum LightSource {
    /// From one place in all directions.
    Point {
        /// The place.
        position: Vec3,
        /// How it fades with the distance.
        falloff: Falloff,
    },
    /// From infinitely far away.
    Directional {
        /// Towards the light, of length one.
        to_light: Vec3,
    },
    /// From one place into a cone.
    Spot {
        /// The place.
        position: Vec3,
        /// The middle of the cone, away from the light, of length one.
        direction: Vec3,
        /// The cosine of the angle from the middle up to which it is fully bright.
        cos_inner: Real,
        /// The cosine of the angle from the middle beyond which it is dark; at most
        /// `cos_inner`.
        cos_outer: Real,
        /// How it fades with the distance.
        falloff: Falloff,
    },
    /// From a sphere in all directions, as much as from a point in its middle: it is a disc from
    /// wherever it is seen. What is inside the sphere is not in its way.
    Sphere {
        /// Its middle.
        position: Vec3,
        /// Its radius; 0 makes it a point.
        radius: Real,
        /// How it fades with the distance from its middle.
        falloff: Falloff,
    },
    /// From the front of a rectangle, as from something white: less to the side, by the cosine.
    Rectangle {
        /// Its middle.
        position: Vec3,
        /// From the middle to the middles of two edges that meet. The front is where the cross
        /// product of the first and the second points to.
        half_edges: [Vec3; 2],
        /// Whether its light comes from everywhere in it, or all of it from the middle.
        soft_shadows: bool,
        /// How it fades with the distance.
        falloff: Falloff,
    },
}

/// How a light fades with the distance `d`: it is divided by
/// `constant + linear d + quadratic d^2`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Falloff {
    /// No unit.
    pub constant: Real,
    /// One over scene lengths.
    pub linear: Real,
    /// One over the square of scene lengths.
    pub quadratic: Real,
}

impl Falloff {
    /// As bright at every distance.
    pub const NONE: Falloff = Falloff { constant: 1.0, linear: 0.0, quadratic: 0.0 };
    /// As physics has it: the full brightness at a distance of one.
    pub const INVERSE_SQUARE: Falloff = Falloff { constant: 0.0, linear: 0.0, quadratic: 1.0 };

    fn validate(&self) -> Result<(), FieldError> {
        let coefficient = |field, x| check::range(field, x, 0.0, 1e15);
        coefficient(Field::Constant, self.constant)?;
        coefficient(Field::Linear, self.linear)?;
        coefficient(Field::Quadratic, self.quadratic)?;
        let sum = self.constant + self.linear + self.quadratic;
        if sum > 0.0 { Ok(()) } else { Err(check::error(Field::Falloff, sum)) }
    }

    fn factor_at(&self, d: Real) -> Real {
        let divisor = self.constant + d * (self.linear + d * self.quadratic);
        // Close to a light that has no constant part this grows without bound; it is held.
        let share = 1.0 / divisor;
        if share < Rgb::MAX_CHANNEL { share } else { Rgb::MAX_CHANNEL }
    }
}

/// Light that arrives at a surface, if nothing stands in its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LightSample {
    /// Towards the light, of length one.
    pub(crate) direction: Vec3,
    /// The cosine of the angle between that and the surface's normal, more than zero or very nearly.
    pub(crate) cos_theta: Real,
    /// How far away the light is; [`Real::MAX`] when it has no place.
    pub(crate) distance: Real,
    /// What arrives on a surface that faces it.
    pub(crate) color: Rgb,
}

impl Light {
    /// What kind it is.
    pub const fn kind(&self) -> LightKind {
        match self.source {
            LightSource::Point { .. } => LightKind::Point,
            LightSource::Directional { .. } => LightKind::Directional,
            LightSource::Spot { .. } => LightKind::Spot,
            LightSource::Sphere { .. } => LightKind::Sphere,
            LightSource::Rectangle { .. } => LightKind::Rectangle,
        }
    }

    /// Whether its shadows have soft rims.
    pub fn has_penumbra(&self) -> bool {
        match self.source {
            LightSource::Sphere { radius, .. } => radius > 0.0,
            LightSource::Rectangle { soft_shadows: soft, .. } => soft,
            _ => false,
        }
    }

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        match self.source {
            LightSource::Point { position, falloff } => {
                check::point(Field::Position, position)?;
                falloff.validate()?;
            }
            LightSource::Directional { to_light: toward } => check::direction(Field::ToLight, toward)?,
            LightSource::Spot { position, direction, cos_inner, cos_outer, falloff } => {
                check::point(Field::Position, position)?;
                check::direction(Field::Direction, direction)?;
                check::range(Field::CosOuter, cos_outer, -1.0, 1.0)?;
                check::range(Field::CosInner, cos_inner, cos_outer, 1.0)?;
                falloff.validate()?;
            }
            LightSource::Sphere { position, radius, falloff } => {
                check::point(Field::Position, position)?;
                check::range(Field::Radius, radius, 0.0, MAX_COORDINATE)?;
                falloff.validate()?;
            }
            LightSource::Rectangle { position, half_edges: [a, b], falloff, .. } => {
                check::point(Field::Position, position)?;
                check::point(Field::HalfEdges, a)?;
                check::point(Field::HalfEdges, b)?;
                if try_normalize(a.cross(b)).is_none() {
                    return Err(check::error(Field::HalfEdgesArea, 0.0));
                }
                falloff.validate()?;
            }
        }
        check::color(Field::Color, self.color, Rgb::MAX_CHANNEL)
    }

    /// The light that would arrive at `point`, on a surface upright on `normal`, from the place of
    /// the light that `chance` says, a point of the unit square, whose middle stands for that of the
    /// light; else why there is none: where it does not shine or lies behind the surface, and for a
    /// kind that is not among the `able` ones. Inlined, so that the arms outside a constant set are compiled away.
    #[inline(always)]
    pub(crate) fn sample(
        &self,
        point: Vec3,
        normal: Vec3,
        able: LightSet,
        chance: impl FnOnce() -> [Real; 2],
    ) -> Result<LightSample, LightOutcome> {
        let from = |position: Vec3, falloff: &Falloff| {
            let way = position - point;
            // Asked before any root is taken.
            let facing = normal.dot(way);
            if !(facing > 0.0) {
                return Err(LightOutcome::BackFacing);
            }
            let (toward, distance) = try_normalize_and_length(way).ok_or(LightOutcome::NoEmission)?;
            Ok(LightSample {
                direction: toward,
                cos_theta: facing / distance,
                distance,
                color: self.color * falloff.factor_at(distance),
            })
        };
        match &self.source {
            LightSource::Point { position, falloff } if able.contains(LightKind::Point) => {
                from(*position, falloff)
            }
            LightSource::Directional { to_light: toward } if able.contains(LightKind::Directional) => {
                let cos = normal.dot(*toward);
                let beam = LightSample {
                    direction: *toward,
                    cos_theta: cos,
                    distance: Real::MAX,
                    color: self.color,
                };
                if cos > 0.0 { Ok(beam) } else { Err(LightOutcome::BackFacing) }
            }
            LightSource::Spot { position, direction, cos_inner, cos_outer, falloff }
                if able.contains(LightKind::Spot) =>
            {
                let mut beam = from(*position, falloff)?;
                let cos = -beam.direction.dot(*direction);
                if cos < *cos_outer {
                    return Err(LightOutcome::NoEmission);
                }
                // From dark to bright without a crease at either end (smoothstep).
                let s = clamp((cos - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
                let s = if cos >= *cos_inner { 1.0 } else { s };
                beam.color = beam.color * (s * s * (3.0 - 2.0 * s));
                Ok(beam)
            }
            LightSource::Sphere { position, radius, falloff } if able.contains(LightKind::Sphere) => {
                if !(*radius > 0.0) {
                    return from(*position, falloff);
                }
                // A place on the disc that faces the point.
                let middle = *position - point;
                let (toward, distance) = try_normalize_and_length(middle).ok_or(LightOutcome::NoEmission)?;
                let [first, second] = orthonormal_basis(toward);
                let [x, y] = sample_disc_concentric(chance());
                let toward = try_normalize(middle + (first * x + second * y) * *radius)
                    .ok_or(LightOutcome::NoEmission)?;
                let cos = normal.dot(toward);
                // The way ends where it enters the sphere: what is inside does not count.
                let along = middle.dot(toward);
                let inside = *radius * *radius - (middle.dot(middle) - along * along);
                let entry = along - sqrt(if inside > 0.0 { inside } else { 0.0 });
                // Zero where the point is inside the light.
                let beam = LightSample {
                    direction: toward,
                    cos_theta: cos,
                    distance: if entry > 0.0 { entry } else { 0.0 },
                    color: self.color * falloff.factor_at(distance),
                };
                if cos > 0.0 { Ok(beam) } else { Err(LightOutcome::BackFacing) }
            }
            LightSource::Rectangle { position, half_edges: [a, b], soft_shadows: soft, falloff }
                if able.contains(LightKind::Rectangle) =>
            {
                let [u, v] = if *soft { chance() } else { [0.5, 0.5] };
                let place = *position + *a * (2.0 * u - 1.0) + *b * (2.0 * v - 1.0);
                let mut beam = from(place, falloff)?;
                let cos = -beam.direction.dot(try_normalize(a.cross(*b)).ok_or(LightOutcome::NoEmission)?);
                beam.color = beam.color * cos;
                if cos > 0.0 { Ok(beam) } else { Err(LightOutcome::NoEmission) }
            }
            _ => Err(LightOutcome::NoEmission),
        }
    }
}
