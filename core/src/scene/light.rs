//! Lights without extent: point, directional, spot.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use crate::math::{Real, Rgb, Vec3, is_in_range, is_unit, length, unit, within};
use crate::set::set_of;

/// A light.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Light {
    /// Where it is and where it shines.
    pub source: Source,
    /// Its radiance at a surface that faces it, before the falloff.
    pub color: Rgb,
    /// Whether things stand in its way.
    pub shadows: bool,
}

/// Where a light is and where it shines.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(u32)]
pub enum Source {
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
        toward: Vec3,
    },
    /// From one place into a cone.
    Spot {
        /// The place.
        position: Vec3,
        /// The middle of the cone, away from the light, of length one.
        direction: Vec3,
        /// The cosine of the angle from the middle up to which it is fully bright.
        cos_bright: Real,
        /// The cosine of the angle from the middle beyond which it is dark; at most
        /// `cos_bright`.
        cos_dark: Real,
        /// How it fades with the distance.
        falloff: Falloff,
    },
}

/// How a light fades with the distance `d`: it is divided by
/// `constant + linear d + quadratic d^2`.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
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
    pub const SQUARE: Falloff = Falloff { constant: 0.0, linear: 0.0, quadratic: 1.0 };

    fn is_valid(&self) -> bool {
        let parts = [self.constant, self.linear, self.quadratic];
        parts.iter().all(|x| *x >= 0.0 && *x <= 1e15) && parts.iter().any(|x| *x > 0.0)
    }

    fn at(&self, d: Real) -> Real {
        let divisor = self.constant + d * (self.linear + d * self.quadratic);
        // Close to a light that has no constant part this grows without bound; it is held.
        let share = 1.0 / divisor;
        if share < Rgb::BRIGHTEST { share } else { Rgb::BRIGHTEST }
    }
}

/// What kind of light it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // they name what `Source` describes
pub enum LightKind {
    Point,
    Directional,
    Spot,
}

impl LightKind {
    /// Every kind.
    pub const ALL: [LightKind; 3] = [LightKind::Point, LightKind::Directional, LightKind::Spot];
}

set_of! {
    /// Kinds of lights.
    LightSet of LightKind
}

/// Light that arrives at a point, if nothing stands in its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Beam {
    /// Towards the light, of length one.
    pub(crate) toward: Vec3,
    /// How far away the light is; [`Real::MAX`] when it has no place.
    pub(crate) distance: Real,
    /// What arrives on a surface that faces it.
    pub(crate) color: Rgb,
}

impl Light {
    /// What kind it is.
    pub const fn kind(&self) -> LightKind {
        match self.source {
            Source::Point { .. } => LightKind::Point,
            Source::Directional { .. } => LightKind::Directional,
            Source::Spot { .. } => LightKind::Spot,
        }
    }

    pub(super) fn is_valid(&self) -> bool {
        let source = match self.source {
            Source::Point { position, falloff } => is_in_range(position) && falloff.is_valid(),
            Source::Directional { toward } => is_unit(toward),
            Source::Spot { position, direction, cos_bright, cos_dark, falloff } => {
                is_in_range(position)
                    && is_unit(direction)
                    && cos_dark >= -1.0
                    && cos_dark <= cos_bright
                    && cos_bright <= 1.0
                    && falloff.is_valid()
            }
        };
        source && self.color.is_within(Rgb::BRIGHTEST)
    }

    /// The light that would arrive at `point`; none where it does not shine, and for a kind
    /// that is not among the `able` ones. Inlined, so that the arms outside a constant set are
    /// compiled away.
    #[inline(always)]
    pub(crate) fn beam(&self, point: Vec3, able: LightSet) -> Option<Beam> {
        let from = |position: Vec3, falloff: &Falloff| {
            let way = position - point;
            let distance = length(way);
            Some(Beam { toward: unit(way)?, distance, color: self.color * falloff.at(distance) })
        };
        match &self.source {
            Source::Point { position, falloff } if able.has(LightKind::Point) => from(*position, falloff),
            Source::Directional { toward } if able.has(LightKind::Directional) => {
                Some(Beam { toward: *toward, distance: Real::MAX, color: self.color })
            }
            Source::Spot { position, direction, cos_bright, cos_dark, falloff }
                if able.has(LightKind::Spot) =>
            {
                let mut beam = from(*position, falloff)?;
                let cos = -beam.toward.dot(*direction);
                if cos < *cos_dark {
                    return None;
                }
                // From dark to bright without a crease at either end (smoothstep).
                let s = within((cos - cos_dark) / (cos_bright - cos_dark), 0.0, 1.0);
                let s = if cos >= *cos_bright { 1.0 } else { s };
                beam.color = beam.color * (s * s * (3.0 - 2.0 * s));
                Some(beam)
            }
            _ => None,
        }
    }
}
