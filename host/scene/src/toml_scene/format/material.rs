//! Materials.

use crate::toml_scene::table::tables;
use crate::toml_scene::value::{
    AttenuationLength, BoxSize, ColorValue, NonNegativeLength, PointValue, Priority, RefractiveIndex,
    Roughness, Shininess, Spanned, UnitColor,
};

tables! {
    /// Material; white and diffuse unless set here.
    struct MaterialTable as "Material" {
        /// Name that objects refer to; inline materials have none.
        name: Option<Spanned<String>>,
        /// Diffuse color. Default: white.
        color: Option<ColorValue>,
        /// Checker texture, multiplied with `color`.
        checker: Option<Spanned<CheckerTable>>,
        /// Gradient texture, multiplied with `color`.
        gradient: Option<Spanned<GradientTable>>,
        /// Zone plate texture, multiplied with `color`.
        zone_plate: Option<Spanned<ZonePlateTable>>,
        /// Diffuse reflectance, as a factor of `color`. Default: 1 - `mirror` - `transmission`.
        diffuse: Option<ColorValue>,
        /// Ambient reflectance, as a factor of `color`. Default: as `diffuse`.
        ambient: Option<ColorValue>,
        /// Specular highlight (Phong). Default: 0.5 with `shininess`, otherwise 0.
        highlight: Option<ColorValue>,
        /// Phong exponent, 0 to 1000000. Default: 50 with `highlight`.
        shininess: Option<Shininess>,
        /// Mirror reflectance. Default: 0.
        mirror | reflection | reflectivity: Option<UnitColor>,
        /// Transmittance; more than 0 makes a transparent body. Default: 0.
        transmission: Option<UnitColor>,
        /// Roughness of reflection and transmission, 0 (polished) to 1. Default: 0.
        roughness: Option<Spanned<Roughness>>,
        /// Index of refraction. Default: 1.5 (glass).
        index | ior: Option<Spanned<RefractiveIndex>>,
        /// Whether the Fresnel equations split `transmission` into reflection and refraction. Default: false.
        fresnel: Option<Spanned<bool>>,
        /// Attenuation length: distance in the body after which 1/e of the light is left, in scene lengths, one number or
        /// one per channel. Default: inf (clear).
        clarity | attenuation_distance: Option<Spanned<AttenuationLength>>,
        /// Priority where bodies overlap: the highest wins. Default: 0.
        priority: Option<Spanned<Priority>>,
        /// Whether a back side is shaded like the front, instead of with the normal turned towards the viewer. Default:
        /// false.
        one_sided: Option<bool>,
    }

    /// Checker of two colors, in axis-aligned cells.
    struct CheckerTable as "Checker" {
        /// Color of the cell that starts at `origin`. Default: white.
        even: Option<ColorValue>,
        /// Color of its neighbors. Default: 0.1.
        odd: Option<ColorValue>,
        /// Corner of a cell. Default: [0, 0, 0].
        origin: Option<PointValue>,
        /// Size of a cell, one number or one per axis; 0 means unbounded. Default: [1, 0, 1], for floors.
        size: Option<Spanned<BoxSize>>,
    }

    /// Linear gradient between two points, constant outside.
    struct GradientTable as "Gradient" {
        /// Color at `start`. Default: black.
        from: Option<ColorValue>,
        /// Color at `end`. Default: white.
        to: Option<ColorValue>,
        /// Start point.
        start: PointValue,
        /// End point.
        end: Spanned<PointValue>,
    }

    /// Zone plate: concentric spheres that become finer with distance.
    struct ZonePlateTable as "ZonePlate" {
        /// Color at the center. Default: white.
        from: Option<ColorValue>,
        /// The other color. Default: black.
        to: Option<ColorValue>,
        /// Center. Default: [0, 0, 0].
        origin: Option<PointValue>,
        /// Number of cycles within a distance of 1.
        frequency: NonNegativeLength,
    }
}
