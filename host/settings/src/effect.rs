//! The effects that a scene can call for and that can be switched off.

use strahl_core::scene::EffectSet;

use crate::choices;

choices! {
    /// An effect that a scene can call for and that can be switched off.
    pub enum Effect {
        /// Things stand in the way of light.
        Shadows = "shadows",
        /// Mirrors.
        Reflection = "reflection",
        /// Light passes through bodies.
        Transmission = "transmission",
        /// Light passes through bodies on its way from a light.
        ColoredShadows = "colored-shadows",
        /// Lights with an extent: shadows with soft edges.
        Penumbra = "penumbra",
        /// A lens: only what is in focus is sharp.
        Lens = "lens",
        /// Rough mirrors and rough glass.
        Gloss = "gloss",
        /// Things that move while the shutter is open.
        Motion = "motion",
    }
}

impl Effect {
    /// Those of which one ray shows a part by chance, so that a pixel needs many.
    pub const DISTRIBUTED: [Effect; 4] = [Effect::Penumbra, Effect::Lens, Effect::Gloss, Effect::Motion];

    /// Whether it is in a set.
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
