//! Fresnel model of a transmitting surface.

/// Fraction of the transmitted light that a surface reflects instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u8)]
pub enum FresnelModel {
    /// None at any angle, except for total internal reflection (Whitted).
    Constant,
    /// The Fresnel reflectance of a dielectric for unpolarized light; it grows towards grazing incidence.
    Dielectric,
}
