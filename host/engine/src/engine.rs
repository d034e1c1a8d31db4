//! The interface of engines, independent of the precision.

use strahl_settings::Settings;

use crate::options::RenderOptions;
use crate::output::{AccelStats, RenderError, Rendered, SceneStats};
use crate::progress::Progress;
use crate::ray_query::RayCaster;
use crate::scheduler::Scheduler;

/// A scene with its acceleration structure, in any precision.
///
/// Precision and acceleration structure are fixed at construction; those in the settings of a picture are ignored.
pub trait Engine: Sync {
    /// The statistics of the scene.
    fn scene(&self) -> &SceneStats;

    /// The statistics of the acceleration structure.
    fn accelerator(&self) -> &AccelStats;

    /// Renders a picture.
    fn render(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
    ) -> Result<Rendered, RenderError>;

    /// Renders progressively, in the passes that `scheduler` selects; returns the picture of the last completed pass.
    fn refine(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<Rendered, RenderError>;

    /// A ray caster for one thread, which finds the nearest hits of rays.
    fn ray_caster(&self) -> RayCaster<'_>;
}
