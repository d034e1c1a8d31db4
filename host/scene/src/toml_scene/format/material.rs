//! Materials.

use crate::toml_scene::table::tables;
use crate::toml_scene::value::{
    AttenuationLength, BoxSize, ColorValue, NonNegativeLength, PointValue, Priority, RefractiveIndex,
    Roughness, Shininess, Spanned, UnitColor,
};

tables! {
    /// What something is made of: matte and white, but for what is said here.
    struct MaterialTable as "Material" {
        /// What objects call it. A material that stands in an object has none.
        name: Option<Spanned<String>>,
        /// What is scattered, by colour. Default: white.
        color: Option<ColorValue>,
        /// A pattern of two colours, which `color` is multiplied with.
        checker: Option<Spanned<CheckerTable>>,
        /// From one colour to another, which `color` is multiplied with.
        gradient: Option<Spanned<GradientTable>>,
        /// Rings that become finer without end, which `color` is multiplied with.
        zone_plate: Option<Spanned<ZonePlateTable>>,
        /// How much of `color` a light lets shine. Default: what `mirror` and `transmission`
        /// leave of 1.
        diffuse: Option<ColorValue>,
        /// How much of `color` the ambient light lets shine. Default: as `diffuse`.
        ambient: Option<ColorValue>,
        /// How bright highlights are. Default: 0.5 if there is `shininess`, else 0.
        highlight: Option<ColorValue>,
        /// How narrow highlights are, 0 to 1000000. Default: 50 if there is a `highlight`.
        shininess: Option<Shininess>,
        /// The share of light from the mirrored direction. Default: 0.
        mirror: Option<UnitColor>,
        /// The share of light from behind; more than 0 makes a body, as of glass. Default: 0.
        transmission: Option<UnitColor>,
        /// How rough its mirror and its body are: 0 is polished, 1 is dull. Default: 0.
        roughness: Option<Spanned<Roughness>>,
        /// The index of refraction of the body. Default: 1.5, as glass.
        index: Option<Spanned<RefractiveIndex>>,
        /// Whether the angle decides how much of `transmission` is mirrored instead. Default:
        /// false.
        fresnel: Option<Spanned<bool>>,
        /// How far light travels in the body until 1/e of it is left, in scene lengths: one
        /// number or one for each of red, green and blue. Default: inf, which is clear.
        clarity: Option<Spanned<AttenuationLength>>,
        /// Which body fills the space where several overlap: the highest. Default: 0.
        priority: Option<Spanned<Priority>>,
        /// Whether a surface that is seen from behind is shaded as its front. Default: false.
        one_sided: Option<bool>,
    }

    /// Two colours in turn, in cells upright on the axes.
    struct CheckerTable as "Checker" {
        /// The colour of the cell that begins in `origin`. Default: white.
        even: Option<ColorValue>,
        /// The colour of its neighbours. Default: 0.1.
        odd: Option<ColorValue>,
        /// A corner of cells. Default: [0, 0, 0].
        origin: Option<PointValue>,
        /// The size of a cell, one number or one for each axis; 0 is a cell without end.
        /// Default: [1, 0, 1], for floors.
        size: Option<Spanned<BoxSize>>,
    }

    /// From one colour to another, and constant beyond both.
    struct GradientTable as "Gradient" {
        /// The colour at `start`. Default: black.
        from: Option<ColorValue>,
        /// The colour at `end`. Default: white.
        to: Option<ColorValue>,
        /// Where it begins.
        start: PointValue,
        /// Where it ends.
        end: Spanned<PointValue>,
    }

    /// Spheres round a point, from one colour to another and back, the finer the farther.
    struct ZonePlateTable as "ZonePlate" {
        /// The colour in the middle. Default: white.
        from: Option<ColorValue>,
        /// The other colour. Default: black.
        to: Option<ColorValue>,
        /// The middle. Default: [0, 0, 0].
        origin: Option<PointValue>,
        /// How often the first colour returns up to a distance of one.
        frequency: NonNegativeLength,
    }
}
