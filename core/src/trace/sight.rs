//! What is seen somewhere in the picture.

use crate::geometry::ItemId;
use crate::math::Rgb;

/// What a camera ray met, or all the camera rays of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// Nothing.
    Nothing,
    /// This item.
    Item(ItemId),
    /// Not all of them the same.
    Several,
}

impl Met {
    /// What was met here and there.
    pub fn and(self, other: Met) -> Met {
        if self == other { self } else { Met::Several }
    }
}

/// The light from somewhere in the picture, and what is seen there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// The light.
    pub color: Rgb,
    /// What the camera rays met.
    pub met: Met,
}

impl Sight {
    /// No light from nowhere.
    pub const DARK: Sight = Sight { color: Rgb::BLACK, met: Met::Nothing };
}
