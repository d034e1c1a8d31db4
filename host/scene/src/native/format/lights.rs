//! Lights.

use crate::native::table::tables;
use crate::native::value::{
    BrightAngle, Color, ConeAngle, Direction, Falloff, Intensity, Pair, Point, Size, Spanned,
};

tables! {
    /// A light that shines from one place in all directions.
    struct PointLight {
        /// What reports call it.
        name: Option<String>,
        /// The place.
        position: Point,
        /// Its colour. Default: white.
        color: Option<Spanned<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is infinitely far away, as the sun.
    struct DirectionalLight {
        /// What reports call it.
        name: Option<String>,
        /// Where its light goes: down is [0, -1, 0].
        direction: Direction,
        /// Its colour. Default: white.
        color: Option<Spanned<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that shines from one place into a cone. It needs `at` or `direction`.
    struct SpotLight {
        /// What reports call it.
        name: Option<String>,
        /// The place.
        position: Point,
        /// What is in the middle of its cone.
        at: Option<Spanned<Point>>,
        /// The middle of its cone, as a direction.
        direction: Option<Spanned<Direction>>,
        /// The full angle of its cone, in degrees. Default: 40.
        angle: Option<ConeAngle>,
        /// The full angle within which it is fully bright, in degrees, at most `angle`.
        /// Default: 4/5 of `angle`.
        bright_angle: Option<Spanned<BrightAngle>>,
        /// Its colour. Default: white.
        color: Option<Spanned<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is a sphere: as bright as one in its middle, with soft shadows. It is not seen.
    struct SphereLight {
        /// What reports call it.
        name: Option<String>,
        /// Its middle.
        position: Point,
        /// Its radius; 0 makes it a point.
        radius: Size,
        /// Its colour. Default: white.
        color: Option<Spanned<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is a rectangle and shines to its front, less to the side. It needs `at` or
    /// `direction`. It is not seen.
    struct RectangleLight {
        /// What reports call it.
        name: Option<String>,
        /// Its middle.
        position: Point,
        /// What is in front of its middle.
        at: Option<Spanned<Point>>,
        /// Where its front looks to.
        direction: Option<Spanned<Direction>>,
        /// What is up for its height. Default: [0, 1, 0], or [0, 0, 1] if it looks up or down.
        up: Option<Spanned<Direction>>,
        /// Its width and its height.
        size: Pair,
        /// Its colour. Default: white.
        color: Option<Spanned<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// Light from everywhere, for the ambient share of materials.
    struct AmbientLight {
        /// Its colour. Default: a gray of 0.1.
        color: Option<Spanned<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<Spanned<Intensity>>,
    }
}
