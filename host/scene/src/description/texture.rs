//! The textures of a loaded scene. Its materials are those of the core.

use strahl_core::Rgb;

use super::float3::Float3;

/// A texture: a color for each point in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TextureDescription {
    /// A checker of two colors, in axis-aligned cells.
    Checker {
        /// The color of the cell that starts at `origin`.
        even: Rgb,
        /// The color of its neighbors.
        odd: Rgb,
        /// A corner of a cell.
        origin: Float3,
        /// The size of a cell along each axis; 0 means unbounded.
        size: Float3,
    },
    /// A linear gradient between two points, constant outside.
    Gradient {
        /// The color at `start`.
        from: Rgb,
        /// The color at `end`.
        to: Rgb,
        /// The start point.
        start: Float3,
        /// The end point.
        end: Float3,
    },
    /// A zone plate: concentric spheres that become finer with distance.
    ZonePlate {
        /// The color at the center.
        from: Rgb,
        /// The color half a cycle from the center.
        to: Rgb,
        /// The center.
        origin: Float3,
        /// The number of cycles within a distance of 1; it grows with the square of the distance.
        frequency: f32,
    },
}
