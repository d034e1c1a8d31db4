//! [`TestScene`] of `strahl-core-double`.

use strahl_core_double as strahl;

// Compiled twice, like the core: each copy has the types of its core.
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "test_scene.rs"]
mod test_scene;
pub use test_scene::TestScene;

const NAME: &str = "double";
