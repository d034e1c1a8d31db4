//! Procedural textures: colors as a function of the point.

use super::check::FieldChecks;
use super::{Field, TextureKind, TextureKindSet};
use crate::math::{MAX_COORDINATE, PI, Real, Rgb, Vec3, clamp, cos, floor, max_abs_component};

/// A procedural solid texture: a color for each point of space.
///
/// Points are in world space; the texture of a moving item moves with it. Channels of colors are in
/// `0..=1e6`, coordinates in `-1e15..=1e15`.
///
/// ```
/// use strahl_core::scene::{Texture, TextureId};
/// use strahl_core::{Material, Rgb, SceneDescriptor, Vec3, vec3};
///
/// let checker = Texture::Checker {
///     even: Rgb::WHITE,
///     odd: Rgb::gray(0.1),
///     origin: Vec3::ZERO,
///     frequency: vec3(0.5, 0.0, 0.5), // cells of 2 by 2 on a floor
/// };
/// let textures = [checker];
/// let materials = [Material { texture: TextureId(0), ..Material::matte(Rgb::WHITE) }];
/// let descriptor = SceneDescriptor { textures: &textures, materials: &materials, ..SceneDescriptor::EMPTY };
/// assert!(strahl_core::Scene::new(descriptor).is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Texture {
    /// Axis-aligned cells of two alternating colors.
    #[doc(alias = "checkerboard")]
    Checker {
        /// Color of the cell whose lowest corner is `origin`.
        even: Rgb,
        /// Color of its neighbors.
        odd: Rgb,
        /// A corner of cells, where eight of them meet.
        origin: Vec3,
        /// Number of cells per scene length along each axis. Zero means one infinite cell, which the axis
        /// perpendicular to a floor needs, so that rounding does not choose between two cells.
        frequency: Vec3,
    },
    /// Linear gradient between two points, constant beyond them.
    Gradient {
        /// Color at `origin` and before it.
        start_color: Rgb,
        /// Color at `origin + axis` and beyond it.
        end_color: Rgb,
        /// Start point.
        origin: Vec3,
        /// Vector from the start to the end point, not zero.
        axis: Vec3,
    },
    /// Zone plate: concentric rings whose frequency grows with the distance. It shows aliasing.
    ZonePlate {
        /// Color at `origin`.
        start_color: Rgb,
        /// Color halfway to the first ring.
        end_color: Rgb,
        /// Center.
        origin: Vec3,
        /// Number of rings per squared scene length, in `0..=1e15`.
        frequency: Real,
    },
}

impl Texture {
    /// Kind of the texture: its variant without fields.
    pub const fn kind(&self) -> TextureKind {
        match self {
            Texture::Checker { .. } => TextureKind::Checker,
            Texture::Gradient { .. } => TextureKind::Gradient,
            Texture::ZonePlate { .. } => TextureKind::ZonePlate,
        }
    }

    /// Checks that all fields are in range.
    pub(super) fn validate(&self, fields: &mut FieldChecks) {
        match self {
            Texture::Checker { even, odd, origin, frequency } => {
                fields.color(Field::Even, even, Rgb::MAX_CHANNEL);
                fields.color(Field::Odd, odd, Rgb::MAX_CHANNEL);
                fields.point(Field::Origin, origin);
                fields.point(Field::CellFrequency, frequency);
            }
            Texture::Gradient { start_color, end_color, origin, axis } => {
                fields.color(Field::StartColor, start_color, Rgb::MAX_CHANNEL);
                fields.color(Field::EndColor, end_color, Rgb::MAX_CHANNEL);
                fields.point(Field::Origin, origin);
                let square = axis.dot(*axis);
                fields.require(Field::Axis, square, square > 0.0 && square <= Real::MAX);
            }
            Texture::ZonePlate { start_color, end_color, origin, frequency } => {
                fields.color(Field::StartColor, start_color, Rgb::MAX_CHANNEL);
                fields.color(Field::EndColor, end_color, Rgb::MAX_CHANNEL);
                fields.point(Field::Origin, origin);
                fields.range(Field::RingFrequency, *frequency, 0.0, MAX_COORDINATE);
            }
        }
    }

    /// Color at a point, world space. White for a kind that is not in `supported`.
    // Inlined so that the arms of unsupported kinds are compiled away.
    #[inline(always)]
    pub(crate) fn evaluate(&self, point: Vec3, supported: TextureKindSet) -> Rgb {
        match *self {
            Texture::Checker { even, odd, origin, frequency } if supported.contains(TextureKind::Checker) => {
                let cell = (point - origin) * frequency;
                if is_even_cell(cell) { even } else { odd }
            }
            Texture::Gradient { start_color, end_color, origin, axis }
                if supported.contains(TextureKind::Gradient) =>
            {
                let s = (point - origin).dot(axis) / axis.dot(axis);
                start_color.lerp(end_color, clamp(s, 0.0, 1.0))
            }
            Texture::ZonePlate { start_color, end_color, origin, frequency }
                if supported.contains(TextureKind::ZonePlate) =>
            {
                let offset = point - origin;
                let cycles = offset.dot(offset) * frequency;
                // Only the fraction, because the cosine of large numbers is inaccurate; clamping removes NaN.
                let phase = clamp(cycles - floor(cycles), 0.0, 1.0);
                start_color.lerp(end_color, clamp(0.5 - 0.5 * cos(2.0 * PI * phase), 0.0, 1.0))
            }
            // Not supported. Listed, so that a new variant is a compile error here.
            Texture::Checker { .. } | Texture::Gradient { .. } | Texture::ZonePlate { .. } => Rgb::WHITE,
        }
    }
}

/// Whether the sum of the coordinates, each rounded down, is even.
#[inline(always)]
fn is_even_cell(cell: Vec3) -> bool {
    if max_abs_component(cell) < 1e9 {
        let below = |x: Real| x as i32 - i32::from((x as i32) as Real > x);
        return (below(cell.x) ^ below(cell.y) ^ below(cell.z)) & 1 == 0;
    }
    // The sum is even if its half is an integer; an `i32` would overflow.
    let half = 0.5 * (floor(cell.x) + floor(cell.y) + floor(cell.z));
    half == floor(half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    #[test]
    fn a_checker_alternates_at_cell_planes_and_ignores_zero_frequencies() {
        let checker = Texture::Checker {
            even: Rgb::WHITE,
            odd: Rgb::BLACK,
            origin: Vec3::ZERO,
            frequency: vec3(0.5, 0.0, 0.5),
        };
        let color = |x, y, z| checker.evaluate(vec3(x, y, z), TextureKindSet::ALL);
        assert_eq!(color(1.0, 0.0, 1.0), Rgb::WHITE);
        assert_eq!(color(3.0, 0.0, 1.0), Rgb::BLACK);
        assert_eq!(color(-1.0, 0.0, 1.0), Rgb::BLACK);
        assert_eq!(color(-1.0, 0.0, -1.0), Rgb::WHITE);
        for y in [-1e-6, 0.0, 1e-6, 7.0] {
            assert_eq!(color(1.0, y, 1.0), Rgb::WHITE);
        }
    }

    #[test]
    fn a_zone_plate_repeats_with_the_squared_distance() {
        let plate = Texture::ZonePlate {
            start_color: Rgb::WHITE,
            end_color: Rgb::BLACK,
            origin: Vec3::ZERO,
            frequency: 2.0,
        };
        for (square, gray) in [(0.0, 1.0), (0.25, 0.0), (0.5, 1.0), (0.125, 0.5), (50.25, 0.0)] {
            let color = plate.evaluate(vec3(0.0, 0.0, crate::math::sqrt(square)), TextureKindSet::ALL);
            assert!((color.r - gray).abs() < 1e-3, "{square}: {}", color.r);
        }
        assert!(plate.evaluate(Vec3::splat(1e30), TextureKindSet::ALL).r.is_finite());
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
            assert_eq!(gradient.evaluate(vec3(x, 4.0, -2.0), TextureKindSet::ALL), Rgb::gray(gray));
        }
    }
}
