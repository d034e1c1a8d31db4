//! How a surface parts the light that it transmits.

/// What happens to the transmitted share of light at a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u8)]
pub enum FresnelModel {
    /// All of it passes, unless all of it is thrown back (Whitted).
    Constant,
    /// Fresnel's formulas for unpolarised light say how much of it passes; the rest is
    /// mirrored.
    Dielectric,
}
