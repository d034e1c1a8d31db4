//! Sets of effects: shapes, lights, textures and light transport that a scene needs or a tracer supports.

use core::fmt;

use super::{LightKindSet, TextureKindSet};
use crate::geometry::ShapeKindSet;

/// A set of effects: what a scene needs or what a tracer supports.
///
/// Displayed as a list: "sphere shapes, point lights, shadows".
///
/// ```
/// use strahl_core::scene::EffectSet;
///
/// let needed = EffectSet { shadows: true, reflection: true, ..EffectSet::NONE };
/// let supported = EffectSet { shadows: true, ..EffectSet::NONE };
/// assert!(!supported.is_superset(&needed));
/// assert_eq!(needed.difference(&supported).to_string(), "reflection");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EffectSet {
    /// Kinds of shapes.
    pub shapes: ShapeKindSet,
    /// Shading normals interpolated between the normals of vertices.
    pub smooth_shading: bool,
    /// Kinds of lights.
    pub lights: LightKindSet,
    /// Kinds of textures.
    pub textures: TextureKindSet,
    /// Phong highlights.
    pub highlight: bool,
    /// Shadows: items occlude lights.
    pub shadows: bool,
    /// Reflected rays, from mirrors. The rays that transmitting bodies reflect (Fresnel, total internal
    /// reflection) belong to `transmission`.
    pub reflection: bool,
    /// Refracted rays through transmitting bodies, with total internal reflection.
    pub transmission: bool,
    /// Attenuation of light inside transmitting bodies.
    pub absorption: bool,
    /// Shadow rays that pass through transmitting bodies and are colored by them.
    pub colored_shadows: bool,
    /// Soft shadows of area lights.
    pub soft_shadows: bool,
    /// Depth of field of a thin lens.
    pub depth_of_field: bool,
    /// Glossy reflection and transmission, of rough surfaces.
    pub gloss: bool,
    /// Motion blur of items that move while the shutter is open.
    pub motion_blur: bool,
}

impl EffectSet {
    /// The empty set: no shape, no light.
    pub const NONE: EffectSet = EffectSet {
        shapes: ShapeKindSet::NONE,
        smooth_shading: false,
        lights: LightKindSet::NONE,
        textures: TextureKindSet::NONE,
        highlight: false,
        shadows: false,
        reflection: false,
        transmission: false,
        absorption: false,
        colored_shadows: false,
        soft_shadows: false,
        depth_of_field: false,
        gloss: false,
        motion_blur: false,
    };

    /// The set of all effects.
    pub const ALL: EffectSet = EffectSet {
        shapes: ShapeKindSet::ALL,
        smooth_shading: true,
        lights: LightKindSet::ALL,
        textures: TextureKindSet::ALL,
        highlight: true,
        shadows: true,
        reflection: true,
        transmission: true,
        absorption: true,
        colored_shadows: true,
        soft_shadows: true,
        depth_of_field: true,
        gloss: true,
        motion_blur: true,
    };

    /// The effects that are in this set and not in `other`.
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
            soft_shadows: self.soft_shadows && !other.soft_shadows,
            depth_of_field: self.depth_of_field && !other.depth_of_field,
            gloss: self.gloss && !other.gloss,
            motion_blur: self.motion_blur && !other.motion_blur,
        }
    }

    /// Whether every effect in `other` is in this set.
    pub const fn is_superset(&self, other: &EffectSet) -> bool {
        const fn implied(required: bool, supported: bool) -> bool {
            supported || !required
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
            && implied(other.soft_shadows, self.soft_shadows)
            && implied(other.depth_of_field, self.depth_of_field)
            && implied(other.gloss, self.gloss)
            && implied(other.motion_blur, self.motion_blur)
    }
}

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
            named(self.soft_shadows, "penumbra"),
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

/// Radiance of a secondary ray that is not traced because it exceeds the level limit
/// ([`Limits::levels`](crate::Limits::levels)).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelLimitRadiance {
    /// Black: the ray contributes nothing.
    Black,
    /// The background in the direction of the ray, as if it hit nothing: repeated reflections between mirrors
    /// end in the background and not in black.
    Background,
}
