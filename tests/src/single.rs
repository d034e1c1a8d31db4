//! [`TestScene`] of `strahl-core`.

use strahl_core as strahl;

#[path = "test_scene.rs"]
mod test_scene;
pub use test_scene::TestScene;

const NAME: &str = "single";
