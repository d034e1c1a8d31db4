//! The contrast up to which neighboring samples are interpolated.

use crate::math::{Real, Rgb};
use crate::trace::{HitId, PixelSample};

/// The contrast of neighboring samples up to which the picture between them is interpolated instead of
/// subdivided.
///
/// ```
/// use strahl_core::image::ContrastThreshold;
///
/// assert!(ContrastThreshold::new(0.1).is_some() && ContrastThreshold::new(1.5).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContrastThreshold {
    threshold: Real,
    items: bool,
}

impl ContrastThreshold {
    /// Allows sRGB-encoded channels to differ by at most `threshold`; `None` if it is not in `0..=1`.
    pub fn new(threshold: Real) -> Option<Self> {
        (threshold >= 0.0 && threshold <= 1.0).then_some(ContrastThreshold { threshold, items: false })
    }

    /// The same threshold, which also requires that all samples hit the same item.
    pub fn with_items(self) -> Self {
        ContrastThreshold { items: true, ..self }
    }

    /// Whether the corners of a square differ by at most the threshold, and hit the same item if that is required.
    pub(super) fn accepts(&self, corners: &[PixelSample; 4]) -> bool {
        let same_item = || {
            let [first, rest @ ..] = corners;
            rest.iter().fold(first.hit, |hit, corner| hit.same_or_mixed(corner.hit)) != HitId::Mixed
        };
        (!self.items || same_item())
            && Rgb::contrast(corners.iter().map(|corner| corner.color)) <= self.threshold
    }
}
