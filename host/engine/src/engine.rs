//! A scene to be rendered, whatever its precision.

use strahl_settings::Settings;

use crate::options::RenderOptions;
use crate::output::{AccelStats, RenderError, Rendered, SceneStats};
use crate::progress::Progress;
use crate::ray_query::RayCaster;
use crate::scheduler::Scheduler;

/// A scene with its accelerator, whatever it computes with.
///
/// Precision and accelerator are those for which it was made, whatever the settings of a picture ask for.
pub trait Engine: Sync {
    /// What is in the scene.
    fn scene(&self) -> &SceneStats;

    /// The accelerator.
    fn accelerator(&self) -> &AccelStats;

    /// Renders a picture.
    fn render(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
    ) -> Result<Rendered, RenderError>;

    /// Renders a picture that becomes better pass by pass, as `scheduler` decides; the last that was completed.
    fn refine(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<Rendered, RenderError>;

    /// Finds the nearest hits of rays, for one thread.
    fn ray_caster(&self) -> RayCaster<'_>;
}
