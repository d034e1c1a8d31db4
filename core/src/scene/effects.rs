//! The effects that a tracer supports, as constants of a type.
//!
//! The effects that a scene requires follow from its items, materials and lights
//! ([`Scene::required_effects`](super::Scene::required_effects)). The effects that a tracer supports are
//! constants of its type, so that the code of all others is compiled away.
//! [`Tracer::new`](crate::Tracer::new) returns an error for a scene that requires more.

use super::{EffectSet, LevelLimitRadiance};
use crate::geometry::{ShapeFeatures, ShapeKindSet};
use crate::math::Real;

/// The shapes, lights, textures and effects that a tracer is compiled for, and two constants of its rays.
///
/// Implemented by a type of the program for exactly what its scenes require; printing
/// [`Scene::required_effects`](super::Scene::required_effects) shows it. [`AllEffects`] supports every scene.
///
/// ```
/// use strahl_core::geometry::{ShapeKind, ShapeKindSet};
/// use strahl_core::scene::{EffectSet, Effects, LightKind, LightKindSet};
///
/// /// Spheres, point lights and shadows.
/// struct Spheres;
///
/// impl Effects for Spheres {
///     const SET: EffectSet = EffectSet {
///         shapes: ShapeKindSet::of(&[ShapeKind::Sphere]),
///         lights: LightKindSet::of(&[LightKind::Point]),
///         shadows: true,
///         ..EffectSet::NONE
///     };
/// }
/// ```
pub trait Effects {
    /// Effects that the tracer supports.
    const SET: EffectSet;

    /// Largest distance at which camera, reflected and refracted rays hit an item, in scene lengths, more
    /// than zero; by default unlimited ([`Real::MAX`]).
    const MAX_DISTANCE: Real = Real::MAX;

    /// Radiance of secondary rays that are not traced because of the level limit; black by default.
    const LEVEL_LIMIT_RADIANCE: LevelLimitRadiance = LevelLimitRadiance::Black;
}

impl<E: Effects> ShapeFeatures for E {
    const SHAPES: ShapeKindSet = E::SET.shapes;
    const SMOOTH_SHADING: bool = E::SET.smooth_shading;
    const MOTION_BLUR: bool = E::SET.motion_blur;
}

/// Implements [`Effects`] with all effects: a tracer with it traces every scene, with the largest and
/// slowest code.
///
/// It is not a default: a tracer names it, or a type with fewer effects.
#[derive(Clone, Copy, Debug)]
pub struct AllEffects;

impl Effects for AllEffects {
    const SET: EffectSet = EffectSet::ALL;
}
