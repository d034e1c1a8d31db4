//! Materials: how a surface reflects and transmits light, and the medium of the body behind it.

use super::check::FieldChecks;
use super::{Field, FresnelModel, TextureId};
use crate::math::{Real, Rgb};

/// How a surface reflects and transmits light, and the medium of the body behind it.
///
/// The radiance of a surface is the sum of its ambient, diffuse and highlight light, and of the light of the
/// reflected and the transmitted ray (Whitted). [`Material::matte`] is the material of one color; glass and
/// mirrors start from [`Material::MATTE`] with struct update syntax. In other programs, `highlight` is called
/// specular, `highlight_exponent` shininess, `transmission` transparency.
///
/// ```
/// use strahl_core::scene::FresnelModel;
/// use strahl_core::{Material, Rgb};
///
/// let red = Material::matte(Rgb::new(0.8, 0.1, 0.1));
/// let mirror = Material { diffuse: Rgb::BLACK, reflection: Rgb::gray(0.9), ..Material::MATTE };
/// let glass = Material {
///     diffuse: Rgb::BLACK,
///     transmission: Rgb::WHITE,
///     refractive_index: 1.5,
///     fresnel: FresnelModel::Dielectric,
///     two_sided: false,
///     ..Material::MATTE
/// };
/// assert!(glass.is_transmitting() && !mirror.is_transmitting() && red.ambient == red.diffuse);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Material {
    /// Fraction of the scene's ambient light that is reflected, each channel in `0..=1e6`.
    ///
    /// Independent of `diffuse`; physically plausible if equal to it, as in [`Material::matte`].
    pub ambient: Rgb,
    /// Color: fraction of the light of a light source that is reflected diffusely (Lambert), at perpendicular
    /// incidence. Each channel in `0..=1e6`.
    pub diffuse: Rgb,
    /// Texture whose color multiplies `ambient` and `diffuse`.
    pub texture: TextureId,
    /// Fraction of the light of a light source that the highlight reflects at its center (Phong), each
    /// channel in `0..=1e6`.
    #[doc(alias = "specular")]
    pub highlight: Rgb,
    /// Exponent of the highlight's cosine, in `0..=1e6`: the larger, the narrower. Zero means no highlight.
    #[doc(alias = "shininess")]
    pub highlight_exponent: Real,
    /// Fraction of the light from the mirror direction that is reflected, each channel in `0..=1`.
    pub reflection: Rgb,
    /// Fraction of the light from behind the surface that is transmitted, each channel in `0..=1`. It applies at
    /// each surface, so twice on the way through a ball.
    ///
    /// If it is not black, the surface is the boundary of a body of this material; its normal points out of
    /// the body. The body casts an opaque shadow, unless
    /// [`SceneDescriptor::colored_shadows`](super::SceneDescriptor::colored_shadows) is set.
    #[doc(alias = "transparency")]
    pub transmission: Rgb,
    /// Roughness of reflection and transmission, in `0..=1`: the square root of the tangent of the typical
    /// slope of the surface's microfacets. Zero means a perfect mirror and clear glass.
    pub roughness: Real,
    /// Refractive index of the body, in `0.01..=100`. Empty space has 1.
    pub refractive_index: Real,
    /// Fraction of the transmitted light that is reflected instead.
    pub fresnel: FresnelModel,
    /// Distance in the body after which a fraction 1/e of the light is left, per channel.
    ///
    /// Unit: scene lengths, in `(0, inf]`; infinite means clear.
    pub attenuation_length: Rgb,
    /// Priority of the body where bodies overlap: the highest is the medium, of equal ones the last one
    /// entered.
    pub priority: u8,
    /// Whether the shading normal points to the side of the ray. If not, the back of the surface is shaded
    /// like its front. Rays hit both sides in both cases.
    ///
    /// Usually false for glass: `true` also gives a body highlights of lights behind it, on the inside of its
    /// far surface.
    pub two_sided: bool,
}

/// Smallest refractive index, rounded to single precision, so that a scene is valid in both precisions or in
/// none.
#[allow(clippy::unnecessary_cast)] // needed in double precision
const MIN_REFRACTIVE_INDEX: Real = 0.01_f32 as Real;

impl Material {
    /// White, diffuse, opaque and two-sided, without ambient reflection: the defaults of the other fields.
    ///
    /// `ambient` is black so that `diffuse` alone determines the color. No texture; no highlight (color and
    /// exponent are 0); no reflection, no transmission, no roughness; a refractive index of 1 without Fresnel
    /// reflection; no attenuation; priority 0. [`Material::matte`] sets `ambient` as well.
    pub const MATTE: Material = Material {
        ambient: Rgb::BLACK,
        diffuse: Rgb::WHITE,
        texture: TextureId::NONE,
        highlight: Rgb::BLACK,
        highlight_exponent: 0.0,
        reflection: Rgb::BLACK,
        transmission: Rgb::BLACK,
        roughness: 0.0,
        refractive_index: 1.0,
        fresnel: FresnelModel::None,
        attenuation_length: Rgb::gray(Real::INFINITY),
        priority: 0,
        two_sided: true,
    };

    /// A diffuse, opaque, two-sided material that reflects ambient light and the light of light sources with
    /// this color: [`Material::MATTE`] with `ambient` and `diffuse` set.
    pub const fn matte(color: Rgb) -> Self {
        Material { ambient: color, diffuse: color, ..Self::MATTE }
    }

    /// Whether `transmission` is not black: the surface is the boundary of a body.
    pub fn is_transmitting(&self) -> bool {
        !self.transmission.is_black()
    }

    /// Whether it has a highlight: neither its color nor its exponent is zero.
    pub fn has_highlight(&self) -> bool {
        self.highlight_exponent > 0.0 && !self.highlight.is_black()
    }

    /// Whether it is rough and reflects or transmits rays, so that their directions are random.
    pub fn is_glossy(&self) -> bool {
        self.roughness > 0.0 && !(self.reflection.is_black() && self.transmission.is_black())
    }

    /// Whether its body attenuates light.
    pub fn is_absorbing(&self) -> bool {
        let clear = |c: Real| c == Real::INFINITY;
        self.is_transmitting()
            && !(clear(self.attenuation_length.r)
                && clear(self.attenuation_length.g)
                && clear(self.attenuation_length.b))
    }

    /// Whether it reflects the light of light sources: it has a diffuse color or a highlight.
    pub fn is_lit(&self) -> bool {
        !self.diffuse.is_black() || self.has_highlight()
    }

    /// Checks that all fields are in range. `textures`: number of entries in the table of textures.
    pub(super) fn validate(&self, textures: usize, fields: &mut FieldChecks) {
        fields.color(Field::Ambient, &self.ambient, Rgb::MAX_CHANNEL);
        fields.color(Field::Diffuse, &self.diffuse, Rgb::MAX_CHANNEL);
        fields.color(Field::Highlight, &self.highlight, Rgb::MAX_CHANNEL);
        fields.color(Field::Reflection, &self.reflection, 1.0);
        fields.color(Field::Transmission, &self.transmission, 1.0);
        fields.range(Field::HighlightExponent, self.highlight_exponent, 0.0, 1e6);
        fields.range(Field::Roughness, self.roughness, 0.0, 1.0);
        if self.is_transmitting() {
            fields.range(Field::RefractiveIndex, self.refractive_index, MIN_REFRACTIVE_INDEX, 100.0);
        }
        for length in [self.attenuation_length.r, self.attenuation_length.g, self.attenuation_length.b] {
            fields.require(Field::AttenuationLength, length, length > 0.0);
        }
        let is_index = self.texture == TextureId::NONE || usize::from(self.texture.0) < textures;
        fields.require(Field::Texture, Real::from(self.texture.0), is_index);
    }
}
