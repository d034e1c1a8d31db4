//! The effects that a scene can require and that can be disabled.

use strahl_core::scene::EffectSet;

use crate::choices;

choices! {
    /// An effect that a scene can require and that can be disabled.
    pub enum OptionalEffect {
        /// Shadows.
        Shadows = "shadows",
        /// Mirror reflection.
        Reflection = "reflection",
        /// Transmission and refraction.
        Transmission = "transmission",
        /// Colored shadows of transparent objects.
        ColoredShadows = "colored-shadows",
        /// Area lights: soft shadows.
        SoftShadows = "penumbra",
        /// Depth of field.
        Lens = "lens",
        /// Glossy reflection and transmission.
        Gloss = "gloss",
        /// Motion blur.
        Motion = "motion",
    }
}

impl OptionalEffect {
    /// The effects of distributed ray tracing, which are noisy with one ray per pixel.
    pub const DISTRIBUTED: [OptionalEffect; 4] =
        [OptionalEffect::SoftShadows, OptionalEffect::Lens, OptionalEffect::Gloss, OptionalEffect::Motion];

    /// Whether a set contains it.
    pub fn is_in(self, set: &EffectSet) -> bool {
        match self {
            OptionalEffect::Shadows => set.shadows,
            OptionalEffect::Reflection => set.reflection,
            OptionalEffect::Transmission => set.transmission,
            OptionalEffect::ColoredShadows => set.colored_shadows,
            OptionalEffect::SoftShadows => set.soft_shadows,
            OptionalEffect::Lens => set.depth_of_field,
            OptionalEffect::Gloss => set.gloss,
            OptionalEffect::Motion => set.motion_blur,
        }
    }
}
