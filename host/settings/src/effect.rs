//! The effects that a scene can require and that can be disabled.

use strahl_core::scene::EffectSet;

use crate::choices;

choices! {
    /// An effect that a scene can require and that can be disabled.
    pub enum Effect {
        /// Shadows.
        Shadows = "shadows",
        /// Mirror reflection.
        Reflection = "reflection",
        /// Transmission and refraction.
        Transmission = "transmission",
        /// Colored shadows of transparent objects.
        ColoredShadows = "colored-shadows",
        /// Area lights: soft shadows.
        Penumbra = "penumbra",
        /// Depth of field.
        Lens = "lens",
        /// Glossy reflection and transmission.
        Gloss = "gloss",
        /// Motion blur.
        Motion = "motion",
    }
}

impl Effect {
    /// The effects of distributed ray tracing, which are noisy with one ray per pixel.
    pub const DISTRIBUTED: [Effect; 4] = [Effect::Penumbra, Effect::Lens, Effect::Gloss, Effect::Motion];

    /// Whether a set contains it.
    pub fn is_in(self, set: &EffectSet) -> bool {
        match self {
            Effect::Shadows => set.shadows,
            Effect::Reflection => set.reflection,
            Effect::Transmission => set.transmission,
            Effect::ColoredShadows => set.colored_shadows,
            Effect::Penumbra => set.penumbra,
            Effect::Lens => set.depth_of_field,
            Effect::Gloss => set.gloss,
            Effect::Motion => set.motion_blur,
        }
    }
}
