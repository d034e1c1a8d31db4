//! Settings of a baked scene.

use strahl_core::{CameraDescriptor, Resolution};
use strahl_settings::AccelKind;

/// Contents of a baked scene besides the tables of the scene.
#[derive(Clone, Copy, Debug)]
pub struct BakeSettings {
    /// The accelerator.
    pub accelerator: AccelKind,
    /// Maximum number of nodes of a BVH or an octree; fewer nodes take less flash and have larger leaves.
    pub nodes: Option<usize>,
    /// The camera.
    pub camera: CameraDescriptor,
    /// The size of the picture.
    pub size: Resolution,
    /// Maximum ray level; 1 for camera rays only.
    pub levels: u8,
    /// The cutoff: a secondary ray is traced only if its weight is greater.
    pub cutoff: f32,
}
