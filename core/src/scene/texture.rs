//! Colour that changes from place to place by a formula.

use super::{Field, FieldError, TextureKind, TextureSet, check};
use crate::math::{MAX_COORDINATE, PI, Real, Rgb, Vec3, clamp, cos, floor, max_abs_component};

/// A colour for each point of space, in the frame of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Texture {
    /// Two colours in turn, in cells upright on the axes.
    Checker {
        /// The colour of the cell that begins in `origin`.
        even: Rgb,
        /// The colour of its neighbours.
        odd: Rgb,
        /// A corner of cells.
        origin: Vec3,
        /// Cells per scene length along each axis. Zero: one cell without end, which is what
        /// the axis upright on a floor needs, lest rounding choose between two cells.
        frequency: Vec3,
    },
    /// From one colour to another along a direction, and constant beyond both.
    Gradient {
        /// The colour in `origin` and before it.
        start_color: Rgb,
        /// The colour one length of `along` away and beyond.
        end_color: Rgb,
        /// Where it begins.
        origin: Vec3,
        /// From its begin to its end, not zero.
        axis: Vec3,
    },
    /// Spheres round a point, from one colour to the other and back, the finer the farther: the
    /// zone plate, which shows what a raster cannot hold.
    ZonePlate {
        /// The colour in `origin`.
        start_color: Rgb,
        /// The colour halfway to the first return.
        end_color: Rgb,
        /// The middle.
        origin: Vec3,
        /// Returns per square of the distance; at least 0, at most 1e15.
        frequency: Real,
    },
}

impl Texture {
    /// What kind it is.
    pub const fn kind(&self) -> TextureKind {
        match self {
            Texture::Checker { .. } => TextureKind::Checker,
            Texture::Gradient { .. } => TextureKind::Gradient,
            Texture::ZonePlate { .. } => TextureKind::ZonePlate,
        }
    }

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let color = |field, color| check::color(field, color, Rgb::MAX_CHANNEL);
        match *self {
            Texture::Checker { even, odd, origin, frequency } => {
                color(Field::Even, even)?;
                color(Field::Odd, odd)?;
                check::point(Field::Origin, origin)?;
                check::point(Field::CellFrequency, frequency)
            }
            Texture::Gradient { start_color: from, end_color: to, origin, axis: along } => {
                color(Field::StartColor, from)?;
                color(Field::EndColor, to)?;
                check::point(Field::Origin, origin)?;
                let square = along.dot(along);
                let is_length = square > 0.0 && square <= Real::MAX;
                if is_length { Ok(()) } else { Err(check::error(Field::Axis, square)) }
            }
            Texture::ZonePlate { start_color: from, end_color: to, origin, frequency } => {
                color(Field::StartColor, from)?;
                color(Field::EndColor, to)?;
                check::point(Field::Origin, origin)?;
                check::range(Field::RingFrequency, frequency, 0.0, MAX_COORDINATE)
            }
        }
    }

    /// The colour at a point; white for a kind that is not among the `able` ones. Inlined, so
    /// that the arms outside a constant set are compiled away.
    #[inline(always)]
    pub(crate) fn evaluate(&self, point: Vec3, able: TextureSet) -> Rgb {
        match *self {
            Texture::Checker { even, odd, origin, frequency } if able.contains(TextureKind::Checker) => {
                let cell = (point - origin) * frequency;
                if is_even_cell(cell) { even } else { odd }
            }
            Texture::Gradient { start_color: from, end_color: to, origin, axis: along }
                if able.contains(TextureKind::Gradient) =>
            {
                let s = (point - origin).dot(along) / along.dot(along);
                from.lerp(to, clamp(s, 0.0, 1.0))
            }
            Texture::ZonePlate { start_color: from, end_color: to, origin, frequency }
                if able.contains(TextureKind::ZonePlate) =>
            {
                let way = point - origin;
                let turns = way.dot(way) * frequency;
                // The whole turns would cost the cosine its digits; what is not finite has none.
                let turn = clamp(turns - floor(turns), 0.0, 1.0);
                from.lerp(to, clamp(0.5 - 0.5 * cos(2.0 * PI * turn), 0.0, 1.0))
            }
            _ => Rgb::WHITE,
        }
    }
}

/// Whether the whole numbers next below the coordinates have an even sum.
#[inline(always)]
fn is_even_cell(cell: Vec3) -> bool {
    if max_abs_component(cell) < 1e9 {
        let below = |x: Real| x as i32 - i32::from((x as i32) as Real > x);
        return (below(cell.x) ^ below(cell.y) ^ below(cell.z)) & 1 == 0;
    }
    // Half of the sum keeps its parity where a machine's whole number would not hold it.
    let half = 0.5 * (floor(cell.x) + floor(cell.y) + floor(cell.z));
    half == floor(half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    #[test]
    fn a_checker_changes_at_every_wall_and_ignores_an_axis_without_frequency() {
        let checker = Texture::Checker {
            even: Rgb::WHITE,
            odd: Rgb::BLACK,
            origin: Vec3::ZERO,
            frequency: vec3(0.5, 0.0, 0.5),
        };
        let color = |x, y, z| checker.evaluate(vec3(x, y, z), TextureSet::ALL);
        assert_eq!(color(1.0, 0.0, 1.0), Rgb::WHITE);
        assert_eq!(color(3.0, 0.0, 1.0), Rgb::BLACK);
        assert_eq!(color(-1.0, 0.0, 1.0), Rgb::BLACK);
        assert_eq!(color(-1.0, 0.0, -1.0), Rgb::WHITE);
        for y in [-1e-6, 0.0, 1e-6, 7.0] {
            assert_eq!(color(1.0, y, 1.0), Rgb::WHITE);
        }
    }

    #[test]
    fn a_zone_plate_returns_at_every_whole_square_of_the_distance() {
        let plate = Texture::ZonePlate {
            start_color: Rgb::WHITE,
            end_color: Rgb::BLACK,
            origin: Vec3::ZERO,
            frequency: 2.0,
        };
        for (square, gray) in [(0.0, 1.0), (0.25, 0.0), (0.5, 1.0), (0.125, 0.5), (50.25, 0.0)] {
            let color = plate.evaluate(vec3(0.0, 0.0, crate::math::sqrt(square)), TextureSet::ALL);
            assert!((color.r - gray).abs() < 1e-3, "{square}: {}", color.r);
        }
        assert!(plate.evaluate(Vec3::splat(1e30), TextureSet::ALL).r.is_finite());
    }

    #[test]
    fn a_gradient_is_constant_beyond_its_ends() {
        let gradient = Texture::Gradient {
            start_color: Rgb::BLACK,
            end_color: Rgb::WHITE,
            origin: vec3(1.0, 0.0, 0.0),
            axis: vec3(2.0, 0.0, 0.0),
        };
        for (x, gray) in [(-5.0, 0.0), (1.0, 0.0), (2.0, 0.5), (3.0, 1.0), (9.0, 1.0)] {
            assert_eq!(gradient.evaluate(vec3(x, 4.0, -2.0), TextureSet::ALL), Rgb::gray(gray));
        }
    }
}
