//! What is seen somewhere in the picture.

use super::Met;
use crate::math::Rgb;

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
