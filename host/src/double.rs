//! The engine, compiled again for the twin in double precision.
//!
//! What it calls `strahl` is the core, and `tables` the scene tables for it.

use strahl_core_double as strahl;

use crate::stock::double as tables;

// The types in it are another core's.
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "engine/mod.rs"]
pub mod engine;

mod effects {
    //! One effect set for every scene: double precision is not chosen to save time.

    use super::engine::request::{Chosen, Request};
    use super::strahl::{Accelerator, Everything};

    pub fn usual<'w, A: Accelerator + Sync>(request: &Request<'w, '_, A>) -> Chosen<'w> {
        request.counting_tests::<Everything>()
    }

    pub use usual as by_name;
    pub use usual as rarely_used;
}
