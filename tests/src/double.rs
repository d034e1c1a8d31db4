//! The stage of the twin, `strahl-core-double`.

use strahl_core_double as strahl;

// Built twice, as the core itself is: its types are another core's.
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "test_scene.rs"]
mod test_scene;
pub use test_scene::TestScene;

const NAME: &str = "double";
