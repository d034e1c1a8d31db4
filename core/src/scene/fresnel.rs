//! Fresnel model of a transmitting surface.

/// Fraction of the transmitted light that the surface of a body reflects instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u8)]
pub enum FresnelModel {
    /// No Fresnel reflection: zero at all angles, except for total internal reflection (Whitted).
    None,
    /// The Fresnel reflectance of a dielectric for unpolarized light; it grows towards grazing incidence.
    Dielectric,
}
