//! Sets of effects.

use super::{LightSet, TextureSet};
use crate::geometry::ShapeSet;

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EffectSet {
    /// Shapes.
    pub shapes: ShapeSet,
    /// Interpolated normals.
    pub smooth: bool,
    /// Lights.
    pub lights: LightSet,
    /// Textures.
    pub textures: TextureSet,
    /// Highlights.
    pub highlight: bool,
    /// Things that stand in the way of light.
    pub shadows: bool,
    /// Mirrors.
    pub reflection: bool,
    /// Bodies that light passes through. It throws light back where none can pass.
    pub transmission: bool,
    /// Bodies that take light away as it passes.
    pub absorption: bool,
    /// Light that passes through bodies on its way from a light.
    pub colored_shadows: bool,
    /// Lights with an extent, so that shadows have soft rims.
    pub penumbra: bool,
    /// A lens, so that only what is in focus is sharp.
    pub lens: bool,
    /// Rough mirrors and rough glass.
    pub gloss: bool,
    /// Things that move while the shutter is open.
    pub motion: bool,
}

impl EffectSet {
    /// Nothing: no shape, no light.
    pub const NONE: EffectSet = EffectSet {
        shapes: ShapeSet::NONE,
        smooth: false,
        lights: LightSet::NONE,
        textures: TextureSet::NONE,
        highlight: false,
        shadows: false,
        reflection: false,
        transmission: false,
        absorption: false,
        colored_shadows: false,
        penumbra: false,
        lens: false,
        gloss: false,
        motion: false,
    };

    /// Everything there is.
    pub const ALL: EffectSet = EffectSet {
        shapes: ShapeSet::ALL,
        smooth: true,
        lights: LightSet::ALL,
        textures: TextureSet::ALL,
        highlight: true,
        shadows: true,
        reflection: true,
        transmission: true,
        absorption: true,
        colored_shadows: true,
        penumbra: true,
        lens: true,
        gloss: true,
        motion: true,
    };

    /// Whether everything in `other` is in this set.
    pub const fn contains(&self, other: &EffectSet) -> bool {
        const fn implied(asked: bool, able: bool) -> bool {
            able || !asked
        }
        self.shapes.is_superset(other.shapes)
            && self.lights.is_superset(other.lights)
            && self.textures.is_superset(other.textures)
            && implied(other.smooth, self.smooth)
            && implied(other.highlight, self.highlight)
            && implied(other.shadows, self.shadows)
            && implied(other.reflection, self.reflection)
            && implied(other.transmission, self.transmission)
            && implied(other.absorption, self.absorption)
            && implied(other.colored_shadows, self.colored_shadows)
            && implied(other.penumbra, self.penumbra)
            && implied(other.lens, self.lens)
            && implied(other.gloss, self.gloss)
            && implied(other.motion, self.motion)
    }
}

/// What stands for a ray that is not sent because it would be below the last level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LastLevel {
    /// Nothing: it brings no light.
    Nothing,
    /// The background in its direction, as if nothing stood in its way. A mirror that sees
    /// itself ends in the sky and not in a hole.
    Background,
}
