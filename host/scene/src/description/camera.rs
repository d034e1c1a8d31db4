//! The camera of a loaded scene.

use super::float3::{Float3, vec3_of};

/// A camera: its position, its orientation and its projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraDescription {
    /// Its position.
    pub from: Float3,
    /// The point at the center of the picture.
    pub at: Float3,
    /// The up direction, of any length.
    pub up: Float3,
    /// The projection.
    pub projection: ProjectionDescription,
}

/// A projection, as in [`strahl_core::Projection`], with angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProjectionDescription {
    /// Pinhole; the vertical field of view, full angle in degrees.
    Perspective(f32),
    /// Thin lens.
    Lens {
        /// The vertical field of view, full angle in degrees.
        angle: f32,
        /// The lens radius.
        radius: f32,
        /// The focus distance from the lens.
        focus: f32,
    },
    /// Parallel rays; the visible height in scene lengths.
    Orthographic(f32),
}

impl ProjectionDescription {
    /// Whether the camera has a lens.
    pub fn has_lens(&self) -> bool {
        matches!(self, ProjectionDescription::Lens { .. })
    }
}

impl CameraDescription {
    /// The camera of the core, in single precision.
    pub(crate) fn to_core(self) -> strahl_core::CameraDescriptor {
        let radians = |degrees: f32| degrees * (strahl_core::math::PI / 180.0);
        let projection = match self.projection {
            ProjectionDescription::Perspective(angle) => {
                strahl_core::Projection::Perspective { field_of_view: radians(angle) }
            }
            ProjectionDescription::Lens { angle, radius, focus } => strahl_core::Projection::ThinLens {
                field_of_view: radians(angle),
                lens_radius: radius,
                focus_distance: focus,
            },
            ProjectionDescription::Orthographic(height) => strahl_core::Projection::Orthographic { height },
        };
        strahl_core::CameraDescriptor {
            position: vec3_of(self.from),
            target: vec3_of(self.at),
            up: vec3_of(self.up),
            projection,
        }
    }
}
