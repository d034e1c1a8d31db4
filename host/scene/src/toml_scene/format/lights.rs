//! Lights.

use crate::toml_scene::table::tables;
use crate::toml_scene::value::{
    BrightAngle, ColorValue, ConeAngle, DirectionValue, FalloffValue, Intensity, NonNegativeLength,
    PointValue, RectangleSize, Spanned,
};

tables! {
    /// Point light, equal in all directions.
    struct PointLightTable as "PointLight" {
        /// Name shown in reports.
        name: Option<String>,
        /// Position.
        position: PointValue,
        /// Color. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// Factor for `color`. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Distance falloff: "none", "linear" (1/d), "square" (1/d^2), or the constant, linear and quadratic
        /// coefficients of the divisor. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether the light casts shadows. Default: true.
        shadows: Option<bool>,
    }

    /// Directional light, infinitely far away, such as the sun.
    struct DirectionalLightTable as "DirectionalLight" {
        /// Name shown in reports.
        name: Option<String>,
        /// Direction of the light's rays; [0, -1, 0] shines down.
        direction: DirectionValue,
        /// Color. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// Factor for `color`. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Whether the light casts shadows. Default: true.
        shadows: Option<bool>,
    }

    /// Spot light. It needs `at` or `direction`.
    struct SpotLightTable as "SpotLight" {
        /// Name shown in reports.
        name: Option<String>,
        /// Position.
        position: PointValue,
        /// Point that the light is aimed at.
        at | look_at: Option<Spanned<PointValue>>,
        /// Axis of the cone.
        direction: Option<Spanned<DirectionValue>>,
        /// Full angle of the cone, in degrees. Default: 40.
        angle: Option<ConeAngle>,
        /// Full angle of the fully bright inner cone, in degrees, at most `angle`. Default: 4/5 of `angle`.
        bright_angle: Option<Spanned<BrightAngle>>,
        /// Color. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// Factor for `color`. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Distance falloff: "none", "linear" (1/d), "square" (1/d^2), or the constant, linear and quadratic
        /// coefficients of the divisor. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether the light casts shadows. Default: true.
        shadows: Option<bool>,
    }

    /// A spherical light with soft shadows; it emits as much as a point light at its center and is not visible itself.
    struct SphereLightTable as "SphereLight" {
        /// Name shown in reports.
        name: Option<String>,
        /// Center.
        position: PointValue,
        /// Radius; 0 makes it a point light.
        radius: NonNegativeLength,
        /// Color. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// Factor for `color`. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Distance falloff: "none", "linear" (1/d), "square" (1/d^2), or the constant, linear and quadratic
        /// coefficients of the divisor. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether the light casts shadows. Default: true.
        shadows: Option<bool>,
    }

    /// A one-sided rectangular light with cosine falloff. It needs `at` or `direction`, and is not visible itself.
    struct RectangleLightTable as "RectangleLight" {
        /// Name shown in reports.
        name: Option<String>,
        /// Center.
        position: PointValue,
        /// Point that its front faces.
        at | look_at: Option<Spanned<PointValue>>,
        /// Direction that its front faces.
        direction: Option<Spanned<DirectionValue>>,
        /// Up direction, along its height. Default: [0, 1, 0], or [0, 0, 1] if it faces up or down.
        up: Option<Spanned<DirectionValue>>,
        /// Width and height, or one number for both.
        size: RectangleSize,
        /// Color. Default: white.
        color: Option<Spanned<ColorValue>>,
        /// Factor for `color`. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Distance falloff: "none", "linear" (1/d), "square" (1/d^2), or the constant, linear and quadratic
        /// coefficients of the divisor. Default: "none".
        falloff: Option<FalloffValue>,
        /// Whether the light casts shadows. Default: true.
        shadows: Option<bool>,
    }

    /// Ambient light, scaled by the ambient reflectance of materials.
    struct AmbientLightTable as "AmbientLight" {
        /// Color. Default: a gray of 0.1.
        color: Option<Spanned<ColorValue>>,
        /// Factor for `color`. Default: 1.
        intensity: Option<Spanned<Intensity>>,
    }
}
