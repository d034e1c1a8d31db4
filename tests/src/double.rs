//! The stage of the twin, `strahl-core-double`.

use strahl_core_double as strahl;

// Built twice, as the core itself is: its types are another core's.
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "stage.rs"]
mod stage;
pub use stage::Stage;

const NAME: &str = "double";
