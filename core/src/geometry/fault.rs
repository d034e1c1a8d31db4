//! Why a shape can be refused.

use core::fmt;

/// Why a shape cannot be part of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeFault {
    /// A coordinate is no number, or farther from zero than [`FARTHEST`](crate::FARTHEST).
    Place,
    /// A radius is no number, out of range, or leaves no shape.
    Radius,
    /// A length is no number, out of range, or leaves no shape.
    Size,
    /// A direction does not have length one.
    NotUnit,
    /// The axes of a turned box are not upright on each other.
    Axes,
    /// It refers to a place outside its table, or a polygon has fewer than three corners.
    Missing,
    /// The box of a polygon is not the one round its corners.
    Bounds,
    /// A plane does not stand in the table of planes under its own item.
    Plane,
    /// What moves is itself something that moves.
    Moving,
}

impl fmt::Display for ShapeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ShapeFault::Place => "a coordinate is not within 1e15 of zero",
            ShapeFault::Radius => "its radius leaves no shape, or is over 1e15",
            ShapeFault::Size => "its size leaves no shape, or is over 1e15",
            ShapeFault::NotUnit => "a direction does not have length one",
            ShapeFault::Axes => "its axes are not upright on each other",
            ShapeFault::Missing => "it refers to a place outside its table",
            ShapeFault::Bounds => "its box is not the one round its corners",
            ShapeFault::Plane => "its place in the table of planes names another item",
            ShapeFault::Moving => "what moves is itself something that moves",
        })
    }
}

impl core::error::Error for ShapeFault {}
