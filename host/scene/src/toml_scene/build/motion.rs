//! The shutter, and velocities of objects.

use strahl_core::math::MAX_COORDINATE;

use super::builder::SceneBuilder;
use crate::description::Float3;
use crate::diagnostics::Diagnostic;
use crate::toml_scene::format;
use crate::toml_scene::table::SingleTable;
use crate::toml_scene::value::{PointValue, Spanned};

impl SceneBuilder<'_> {
    /// Sets the shutter times, before objects that move are added.
    pub fn shutter(&mut self, camera: &SingleTable<format::CameraTable>) {
        if let Some(shutter) = camera.0.as_ref().and_then(|camera| camera.value.shutter.as_ref()) {
            self.scene.shutter = shutter.value.0;
        }
    }

    /// The velocity of an object; `None` if it would exceed the coordinate range while the shutter is open.
    pub fn checked_velocity(&mut self, velocity: &Option<Spanned<PointValue>>) -> Option<Float3> {
        let Some(Spanned { value: PointValue(velocity), span }) = velocity else { return Some([0.0; 3]) };
        let ways = velocity.iter().flat_map(|v| self.scene.shutter.map(|time| v * time));
        if ways.into_iter().all(|way| way.abs() <= MAX_COORDINATE) {
            return Some(*velocity);
        }
        let message = format!("it moves farther than {MAX_COORDINATE:e} while the shutter is open");
        self.reader.report(Diagnostic::new(span.clone(), message))
    }
}
