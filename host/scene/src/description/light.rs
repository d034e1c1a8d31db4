//! The lights and the background of a loaded scene.

use strahl_core::Rgb;

use super::float3::Float3;

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDescription {
    /// Its shape and position.
    pub source: LightSourceDescription,
    /// Light that arrives at a surface that faces it, before the falloff; independent of the area of the light.
    pub color: Rgb,
    /// Whether it casts shadows.
    pub shadows: bool,
}

/// The kind, the position and the direction of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSourceDescription {
    /// A point light.
    Point {
        /// The position.
        position: Float3,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
    /// A directional light, infinitely far away.
    Directional {
        /// The direction to the light, of any length.
        to_light: Float3,
    },
    /// A spot light.
    Spot {
        /// The position.
        position: Float3,
        /// The axis of the cone, away from the light, of any length.
        direction: Float3,
        /// The half angle of the fully bright inner cone, in degrees.
        inner_angle: f32,
        /// The half angle of the cone, in degrees; outside it is dark.
        outer_angle: f32,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
    /// A spherical area light.
    Sphere {
        /// The center.
        position: Float3,
        /// The radius, at least 0.
        radius: f32,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
    /// A rectangular area light that emits from its front.
    Rectangle {
        /// The center.
        position: Float3,
        /// The vectors from the center to the midpoints of two adjacent edges; their cross product points to the
        /// front.
        half_edges: [Float3; 2],
        /// Whether light is sampled from the whole rectangle; otherwise it all comes from the center.
        soft_shadows: bool,
        /// The constant, linear and quadratic coefficients of the divisor, in powers of the distance.
        falloff: Float3,
    },
}

/// The background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BackgroundDescription {
    /// A single color.
    Color(Rgb),
    /// A gradient over the angle between the ray and the up direction.
    Gradient {
        /// The up direction, of any length.
        up: Float3,
        /// The color straight down.
        below: Rgb,
        /// The color straight up.
        above: Rgb,
    },
}
