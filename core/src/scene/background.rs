//! Background of a scene.

use super::check::FieldChecks;
use super::field::Field;
use crate::math::{Rgb, Vec3, clamp};

/// Radiance of rays that hit no item.
///
/// ```
/// use strahl_core::{Background, Rgb, Vec3};
///
/// let sky = Background::Gradient { up: Vec3::Y, below: Rgb::BLACK, above: Rgb::WHITE };
/// assert_eq!(sky.radiance(Vec3::X), Rgb::gray(0.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Background {
    /// One color, each channel in `0..=1e6`.
    Color(Rgb),
    /// A gradient from one color to another, linear in the component of the direction along `up`.
    Gradient {
        /// Up direction, unit vector.
        up: Vec3,
        /// Color in the direction `-up`.
        below: Rgb,
        /// Color in the direction `up`.
        above: Rgb,
    },
}

impl Background {
    pub(super) fn validate(&self, fields: &mut FieldChecks) {
        match self {
            Background::Color(color) => fields.color(Field::Color, color, Rgb::MAX_CHANNEL),
            Background::Gradient { up, below, above } => {
                fields.direction(Field::Up, up);
                fields.color(Field::Below, below, Rgb::MAX_CHANNEL);
                fields.color(Field::Above, above, Rgb::MAX_CHANNEL);
            }
        }
    }

    /// Radiance in a direction. `direction`: unit vector, away from the scene.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        match *self {
            Background::Color(color) => color,
            Background::Gradient { up, below, above } => {
                below.lerp(above, clamp(0.5 + 0.5 * direction.dot(up), 0.0, 1.0))
            }
        }
    }
}
