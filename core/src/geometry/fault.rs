//! Errors of shapes.

use core::fmt;

/// Why a shape is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeError {
    /// A coordinate is NaN, or its absolute value is more than [`MAX_COORDINATE`](crate::FARTHEST).
    Coordinate,
    /// A radius is NaN, negative, more than [`MAX_COORDINATE`](crate::FARTHEST), or zero where the shape would
    /// vanish; or the minor radius of a torus is more than its major radius.
    Radius,
    /// A length is NaN, more than [`MAX_COORDINATE`](crate::FARTHEST), or too small: the height of a cone must be
    /// positive, the size of a box must not be negative.
    Size,
    /// A normal or an axis is not a unit vector.
    NotNormalized,
    /// The axes of an oriented box are not perpendicular to each other.
    NotOrthogonal,
    /// An index is out of range, or a polygon has fewer than three vertices.
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
                "a radius is not positive or exceeds 1e15, or the minor radius of a torus exceeds the major one"
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
