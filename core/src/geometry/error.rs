//! Errors of shapes.

use core::fmt;

/// Why a shape is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeError {
    /// A coordinate is NaN, or its absolute value is more than [`MAX_COORDINATE`](crate::math::MAX_COORDINATE).
    Coordinate,
    /// A radius is NaN, negative or more than [`MAX_COORDINATE`](crate::math::MAX_COORDINATE); or the radius of a
    /// sphere or disc, or both radii of a cone are zero; or the minor radius of a torus is zero or more than
    /// its major radius.
    Radius,
    /// The height of a cone is NaN, not positive or more than [`MAX_COORDINATE`](crate::math::MAX_COORDINATE), or
    /// the size of a box is negative.
    Size,
    /// A normal or an axis is not a unit vector.
    NotNormalized,
    /// The axes of an oriented box are not perpendicular to each other.
    NotOrthogonal,
    /// An index is out of range, or a polygon has fewer than three vertices or no area.
    IndexOutOfRange,
    /// The bounds of a polygon are not those of its vertices.
    Bounds,
    /// An entry in the table of planes names an item that is not this plane.
    PlaneItem,
    /// A moving shape contains a moving shape.
    NestedMotion,
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ShapeError::Coordinate => "a coordinate is NaN, or its absolute value exceeds 1e15",
            ShapeError::Radius => {
                "a radius is not positive or exceeds 1e15, or a torus has a larger minor than major radius"
            }
            ShapeError::Size => "a length is not positive or exceeds 1e15",
            ShapeError::NotNormalized => "a normal or an axis is not a unit vector",
            ShapeError::NotOrthogonal => "the axes are not orthogonal",
            ShapeError::IndexOutOfRange => "an index is out of range",
            ShapeError::Bounds => "bounds differ from those of the vertices",
            ShapeError::PlaneItem => "the entry in the table of planes names another item",
            ShapeError::NestedMotion => "a moving shape contains a moving shape",
        })
    }
}

impl core::error::Error for ShapeError {}
