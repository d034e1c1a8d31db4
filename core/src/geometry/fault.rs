//! Errors of shapes.

use core::fmt;

/// Why a shape is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeFault {
    /// A coordinate is NaN, or its absolute value is more than [`FARTHEST`](crate::FARTHEST).
    Place,
    /// A radius is NaN, negative, more than [`FARTHEST`](crate::FARTHEST), or zero where the shape would
    /// vanish; or the minor radius of a torus is more than its major radius.
    Radius,
    /// A length is NaN, more than [`FARTHEST`](crate::FARTHEST), or too small: the height of a cone must be
    /// positive, the size of a box must not be negative.
    Size,
    /// A normal or an axis is not a unit vector.
    NotUnit,
    /// The axes of an oriented box are not perpendicular to each other.
    Axes,
    /// An index is out of range, or a polygon has fewer than three vertices.
    Missing,
    /// The bounds of a polygon are not those of its vertices.
    Bounds,
    /// An entry in the table of planes names an item that is not this plane.
    Plane,
    /// A moving shape contains a moving shape.
    Moving,
}

impl fmt::Display for ShapeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ShapeFault::Place => "a coordinate is NaN, or its absolute value exceeds 1e15",
            ShapeFault::Radius => {
                "a radius is not positive or exceeds 1e15, or the minor radius of a torus exceeds the major one"
            }
            ShapeFault::Size => "a length is not positive or exceeds 1e15",
            ShapeFault::NotUnit => "a normal or an axis is not a unit vector",
            ShapeFault::Axes => "the axes are not orthogonal",
            ShapeFault::Missing => "an index is out of range",
            ShapeFault::Bounds => "bounds differ from those of the vertices",
            ShapeFault::Plane => "the entry in the table of planes names another item",
            ShapeFault::Moving => "a moving shape contains a moving shape",
        })
    }
}

impl core::error::Error for ShapeFault {}
