//! Limits of the ray tree.

use crate::math::Real;

/// Limits of the ray tree of a camera sample.
///
/// ```
/// use strahl_core::Limits;
///
/// let local_illumination_only = Limits { levels: 1, ..Limits::DEFAULT };
/// # assert_eq!(local_illumination_only.cutoff, 1.0 / 512.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Largest level of a ray, in `1..=LEVELS` of the tracer. Camera rays have level 1, their secondary rays
    /// level 2. Five levels show a glass ball with errors of a few percent at
    /// its edge, eight without visible errors.
    #[doc(alias = "depth")]
    #[doc(alias = "bounces")]
    pub levels: u8,
    /// A secondary ray is sent only if the largest channel of its weight is above this, in `0..=1`.
    pub cutoff: Real,
}

impl Limits {
    /// Five levels; a cutoff of half a step of an 8-bit picture.
    pub const DEFAULT: Limits = Limits { levels: 5, cutoff: 1.0 / 512.0 };
}
