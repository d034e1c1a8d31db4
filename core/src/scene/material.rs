//! What surfaces and bodies are made of.

use super::{Field, FieldError, FresnelModel, TextureId, check};
use crate::math::{Real, Rgb};

/// How a surface answers light, and what light meets behind it.
///
/// A scene starts from [`Material::MATTE`] and names what is different.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Material {
    /// The share of the scene's ambient light that is given back.
    pub ambient: Rgb,
    /// The share of a light that is scattered in all directions, at upright incidence
    /// (Lambert).
    pub diffuse: Rgb,
    /// Multiplies `ambient` and `diffuse` from place to place.
    pub texture: TextureId,
    /// The share of a light that the highlight gives back at its middle (Phong).
    pub highlight: Rgb,
    /// How narrow the highlight is: the power of the cosine. Zero: no highlight.
    pub highlight_exponent: Real,
    /// The share of light from the mirrored direction, each channel in `0..=1`.
    pub reflection: Rgb,
    /// The share of light from behind, each channel in `0..=1`. More than zero makes the
    /// surface the boundary of a body of this material, which the normal leaves.
    pub transmission: Rgb,
    /// How rough the surface is, from 0, where all light is mirrored in one direction and passes
    /// in one, to 1: the square root of the tangent of the typical slope of its facets.
    pub roughness: Real,
    /// The index of refraction of that body, in `0.01..=100`; that of empty space is one.
    pub refractive_index: Real,
    /// How the transmitted share is parted.
    pub fresnel: FresnelModel,
    /// How far light travels in that body until 1/e of it is left, for each channel. Unit:
    /// scene lengths. Infinite is clear.
    pub attenuation_length: Rgb,
    /// Which body fills space where several overlap: the highest, and of equals the one that
    /// was entered last.
    pub priority: u8,
    /// Whether the shading normal is turned towards the viewer. Every surface is hit from both
    /// sides either way; a one-sided surface seen from behind shades as its front does.
    pub two_sided: bool,
}

/// As single precision has it: a scene is in range for both precisions or for none.
#[allow(clippy::unnecessary_cast)] // it is one in the twin
const MIN_REFRACTIVE_INDEX: Real = 0.01_f32 as Real;

impl Material {
    /// White, matte, opaque, two-sided.
    pub const MATTE: Material = Material {
        ambient: Rgb::WHITE,
        diffuse: Rgb::WHITE,
        texture: TextureId::NONE,
        highlight: Rgb::BLACK,
        highlight_exponent: 0.0,
        reflection: Rgb::BLACK,
        transmission: Rgb::BLACK,
        roughness: 0.0,
        refractive_index: 1.0,
        fresnel: FresnelModel::Constant,
        attenuation_length: Rgb::gray(Real::INFINITY),
        priority: 0,
        two_sided: true,
    };

    /// Whether light passes through its surface.
    pub fn is_transmitting(&self) -> bool {
        !self.transmission.is_black()
    }

    /// Whether it has a highlight.
    pub fn has_highlight(&self) -> bool {
        self.highlight_exponent > 0.0 && !self.highlight.is_black()
    }

    /// Whether it mirrors light or lets it pass in more than one direction.
    pub fn is_glossy(&self) -> bool {
        self.roughness > 0.0 && !(self.reflection.is_black() && self.transmission.is_black())
    }

    /// Whether its body takes something away from light.
    pub fn is_absorbing(&self) -> bool {
        let clear = |c: Real| c == Real::INFINITY;
        self.is_transmitting()
            && !(clear(self.attenuation_length.r)
                && clear(self.attenuation_length.g)
                && clear(self.attenuation_length.b))
    }

    /// Whether lights change how it looks.
    pub fn is_lit(&self) -> bool {
        !self.diffuse.is_black() || self.has_highlight()
    }

    /// `textures`: how many there are.
    pub(super) fn validate(&self, textures: usize) -> Result<(), FieldError> {
        check::color(Field::Ambient, self.ambient, Rgb::MAX_CHANNEL)?;
        check::color(Field::Diffuse, self.diffuse, Rgb::MAX_CHANNEL)?;
        check::color(Field::Highlight, self.highlight, Rgb::MAX_CHANNEL)?;
        check::color(Field::Reflection, self.reflection, 1.0)?;
        check::color(Field::Transmission, self.transmission, 1.0)?;
        check::range(Field::HighlightExponent, self.highlight_exponent, 0.0, 1e6)?;
        check::range(Field::Roughness, self.roughness, 0.0, 1.0)?;
        if self.is_transmitting() {
            check::range(Field::RefractiveIndex, self.refractive_index, MIN_REFRACTIVE_INDEX, 100.0)?;
        }
        for clarity in [self.attenuation_length.r, self.attenuation_length.g, self.attenuation_length.b] {
            if !(clarity > 0.0) {
                return Err(check::error(Field::AttenuationLength, clarity));
            }
        }
        if self.texture != TextureId::NONE && usize::from(self.texture.0) >= textures {
            return Err(check::error(Field::Texture, Real::from(self.texture.0)));
        }
        Ok(())
    }
}
