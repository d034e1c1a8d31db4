//! Lights.

use crate::toml_scene::table::tables;
use crate::toml_scene::value::{
    BrightAngle, ColorValue, ConeAngle, DirectionValue, FalloffValue, Intensity, NonNegativeLength,
    PointValue, RectangleSize, Spanned,
};

tables! {
    /// A light that shines from one place in all directions.
    struct PointLightTable as "PointLight" {
        /// What reports call it.
        name: Option<String>,
        /// The place.
        position: PointValue,
        /// Its colour. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is infinitely far away, as the sun.
    struct DirectionalLightTable as "DirectionalLight" {
        /// What reports call it.
        name: Option<String>,
        /// Where its light goes: down is [0, -1, 0].
        direction: DirectionValue,
        /// Its colour. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that shines from one place into a cone. It needs `at` or `direction`.
    struct SpotLightTable as "SpotLight" {
        /// What reports call it.
        name: Option<String>,
        /// The place.
        position: PointValue,
        /// What is in the middle of its cone.
        at: Option<Spanned<PointValue>>,
        /// The middle of its cone, as a direction.
        direction: Option<Spanned<DirectionValue>>,
        /// The full angle of its cone, in degrees. Default: 40.
        angle: Option<ConeAngle>,
        /// The full angle within which it is fully bright, in degrees, at most `angle`.
        /// Default: 4/5 of `angle`.
        bright_angle: Option<Spanned<BrightAngle>>,
        /// Its colour. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is a sphere: as bright as one in its middle, with soft shadows. It is not seen.
    struct SphereLightTable as "SphereLight" {
        /// What reports call it.
        name: Option<String>,
        /// Its middle.
        position: PointValue,
        /// Its radius; 0 makes it a point.
        radius: NonNegativeLength,
        /// Its colour. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is a rectangle and shines to its front, less to the side. It needs `at` or
    /// `direction`. It is not seen.
    struct RectangleLightTable as "RectangleLight" {
        /// What reports call it.
        name: Option<String>,
        /// Its middle.
        position: PointValue,
        /// What is in front of its middle.
        at: Option<Spanned<PointValue>>,
        /// Where its front looks to.
        direction: Option<Spanned<DirectionValue>>,
        /// What is up for its height. Default: [0, 1, 0], or [0, 0, 1] if it looks up or down.
        up: Option<Spanned<DirectionValue>>,
        /// Its width and its height.
        size: RectangleSize,
        /// Its colour. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// Light from everywhere, for the ambient share of materials.
    struct AmbientLightTable as "AmbientLight" {
        /// Its colour. Default: a gray of 0.1.
        color: Option<Spanned<ColorValue>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
    }
}
