//! Sets of effects.

use core::fmt;

use super::{LightSet, TextureSet};
use crate::geometry::ShapeSet;

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EffectSet {
    /// Shapes.
    pub shapes: ShapeSet,
    /// Interpolated normals.
    pub smooth_shading: bool,
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
    pub depth_of_field: bool,
    /// Rough mirrors and rough glass.
    pub gloss: bool,
    /// Things that move while the shutter is open.
    pub motion_blur: bool,
}

impl EffectSet {
    /// Nothing: no shape, no light.
    pub const NONE: EffectSet = EffectSet {
        shapes: ShapeSet::NONE,
        smooth_shading: false,
        lights: LightSet::NONE,
        textures: TextureSet::NONE,
        highlight: false,
        shadows: false,
        reflection: false,
        transmission: false,
        absorption: false,
        colored_shadows: false,
        penumbra: false,
        depth_of_field: false,
        gloss: false,
        motion_blur: false,
    };

    /// Everything there is.
    pub const ALL: EffectSet = EffectSet {
        shapes: ShapeSet::ALL,
        smooth_shading: true,
        lights: LightSet::ALL,
        textures: TextureSet::ALL,
        highlight: true,
        shadows: true,
        reflection: true,
        transmission: true,
        absorption: true,
        colored_shadows: true,
        penumbra: true,
        depth_of_field: true,
        gloss: true,
        motion_blur: true,
    };

    /// What is in this set and not in `other`.
    pub const fn difference(&self, other: &EffectSet) -> EffectSet {
        EffectSet {
            shapes: self.shapes.difference(other.shapes),
            lights: self.lights.difference(other.lights),
            textures: self.textures.difference(other.textures),
            smooth_shading: self.smooth_shading && !other.smooth_shading,
            highlight: self.highlight && !other.highlight,
            shadows: self.shadows && !other.shadows,
            reflection: self.reflection && !other.reflection,
            transmission: self.transmission && !other.transmission,
            absorption: self.absorption && !other.absorption,
            colored_shadows: self.colored_shadows && !other.colored_shadows,
            penumbra: self.penumbra && !other.penumbra,
            depth_of_field: self.depth_of_field && !other.depth_of_field,
            gloss: self.gloss && !other.gloss,
            motion_blur: self.motion_blur && !other.motion_blur,
        }
    }

    /// Whether everything in `other` is in this set.
    pub const fn is_superset(&self, other: &EffectSet) -> bool {
        const fn implied(asked: bool, able: bool) -> bool {
            able || !asked
        }
        self.shapes.is_superset(other.shapes)
            && self.lights.is_superset(other.lights)
            && self.textures.is_superset(other.textures)
            && implied(other.smooth_shading, self.smooth_shading)
            && implied(other.highlight, self.highlight)
            && implied(other.shadows, self.shadows)
            && implied(other.reflection, self.reflection)
            && implied(other.transmission, self.transmission)
            && implied(other.absorption, self.absorption)
            && implied(other.colored_shadows, self.colored_shadows)
            && implied(other.penumbra, self.penumbra)
            && implied(other.depth_of_field, self.depth_of_field)
            && implied(other.gloss, self.gloss)
            && implied(other.motion_blur, self.motion_blur)
    }
}

/// The effects in words, with commas between them.
impl fmt::Display for EffectSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = |is_there: bool, name: &'static str| is_there.then_some([name, ""]);
        let shapes = self.shapes.iter().map(|kind| [kind.name(), " shapes"]);
        let lights = self.lights.iter().map(|kind| [kind.name(), " lights"]);
        let textures = self.textures.iter().map(|kind| [kind.name(), " textures"]);
        let others = [
            named(self.smooth_shading, "interpolated normals"),
            named(self.highlight, "highlights"),
            named(self.shadows, "shadows"),
            named(self.reflection, "reflection"),
            named(self.transmission, "transmission"),
            named(self.absorption, "absorption"),
            named(self.colored_shadows, "colored shadows"),
            named(self.penumbra, "penumbra"),
            named(self.depth_of_field, "a lens"),
            named(self.gloss, "gloss"),
            named(self.motion_blur, "motion"),
        ];
        let all = shapes.chain(lights).chain(textures).chain(others.into_iter().flatten());
        for ([name, suffix], index) in all.zip(0_u8..) {
            let separator = if index > 0 { ", " } else { "" };
            write!(f, "{separator}{name}{suffix}")?;
        }
        Ok(())
    }
}

/// What stands for a ray that is not sent because it would be below the last level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelLimitRadiance {
    /// Nothing: it brings no light.
    Black,
    /// The background in its direction, as if nothing stood in its way. A mirror that sees
    /// itself ends in the sky and not in a hole.
    Background,
}
