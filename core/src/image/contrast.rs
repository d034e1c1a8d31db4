//! When neighbours in the picture are taken to look the same.

use crate::math::{Real, Rgb};
use crate::trace::{HitId, PixelSample};

/// How much neighbours may differ and still agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContrastThreshold {
    threshold: Real,
    items: bool,
}

impl ContrastThreshold {
    /// Colours whose sRGB-encoded channels differ by at most `threshold`; none when it is not in
    /// `0..=1`.
    pub fn new(threshold: Real) -> Option<Self> {
        (threshold >= 0.0 && threshold <= 1.0).then_some(ContrastThreshold { threshold, items: false })
    }

    /// The same, and only where all rays hit the same item.
    pub fn with_items(self) -> Self {
        ContrastThreshold { items: true, ..self }
    }

    /// Whether the corners of a square agree.
    pub(super) fn is_met(&self, corners: &[PixelSample; 4]) -> bool {
        let same_item = || {
            let [first, rest @ ..] = corners;
            rest.iter().fold(first.hit, |hit, corner| hit.merged(corner.hit)) != HitId::Mixed
        };
        (!self.items || same_item())
            && Rgb::contrast(corners.iter().map(|corner| corner.color)) <= self.threshold
    }
}
