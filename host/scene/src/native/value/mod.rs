//! What keys of the format can hold.

mod colors;
mod names;
mod numbers;
mod places;
mod reader;
mod schema_like;
mod similar;

pub use colors::{Clarity, Color, Share, is_color};
pub use names::MaterialNames;
pub use numbers::{
    BrightAngle, ConeAngle, Index, Intensity, Length, Priority, Range, Roughness, Shininess, Size, ViewAngle,
    number_in, whole_in,
};
pub use places::{Direction, Directions, Falloff, Pair, Point, Points, Scale, Shutter, Sizes, Turn};
pub use reader::{Found, Read, Reader, Spanned, Value};
pub(super) use schema_like::schema_like;
pub use similar::meant;
