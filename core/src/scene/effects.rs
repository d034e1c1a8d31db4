//! What a scene asks for, and what a tracer can do.
//!
//! Both are an [`EffectSet`]. What a scene asks for is found by looking at it; what a tracer
//! can do is a constant of its type, so that everything outside it is compiled away. A tracer
//! refuses a scene that asks for more than it can do.

use super::{EffectSet, LevelLimitRadiance};
use crate::geometry::{ShapeFeatures, ShapeSet};
use crate::math::Real;

/// What a tracer can do, as a constant of a type of its own.
///
/// ```
/// use strahl_core::geometry::{ShapeKind, ShapeSet};
/// use strahl_core::scene::{EffectSet, Effects, LightKind, LightSet};
///
/// /// Spheres under point lights, and their shadows.
/// struct Mine;
///
/// impl Effects for Mine {
///     const SET: EffectSet = EffectSet {
///         shapes: ShapeSet::of(&[ShapeKind::Sphere]),
///         lights: LightSet::of(&[LightKind::Point]),
///         shadows: true,
///         ..EffectSet::NONE
///     };
/// }
/// ```
pub trait Effects {
    /// Everything that the tracer can do.
    const SET: EffectSet;

    /// How far a ray from the eye, a mirror or glass sees, in scene lengths: what lies farther
    /// away is not there. More than zero.
    const MAX_DISTANCE: Real = Real::MAX;

    /// What stands for the rays that the levels end.
    const LEVEL_LIMIT_RADIANCE: LevelLimitRadiance = LevelLimitRadiance::Black;
}

impl<E: Effects> ShapeFeatures for E {
    const SHAPES: ShapeSet = E::SET.shapes;
    const SMOOTH_SHADING: bool = E::SET.smooth_shading;
    const MOTION_BLUR: bool = E::SET.motion_blur;
}

/// Everything that strahl can do.
#[derive(Clone, Copy, Debug)]
pub struct AllEffects;

impl Effects for AllEffects {
    const SET: EffectSet = EffectSet::ALL;
}
