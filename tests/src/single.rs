//! The stage of `strahl-core`.

use strahl_core as strahl;

#[path = "stage.rs"]
mod stage;
pub use stage::Stage;

const NAME: &str = "single";
