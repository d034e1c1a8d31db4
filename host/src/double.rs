//! The rooms that compute with the core, compiled again for its twin in double precision.
//!
//! What they call `strahl` is the core, and `tables` the stock for it.

use strahl_core_double as strahl;

use crate::stock::double as tables;

// The types in them are another core's.
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "accelerators.rs"]
pub mod accelerators;
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "draw.rs"]
pub mod draw;
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "hits.rs"]
pub mod hits;
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "job.rs"]
pub mod job;
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "passes.rs"]
pub mod passes;
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "samplers.rs"]
pub mod samplers;
#[expect(clippy::duplicate_mod, reason = "each core has types of its own")]
#[path = "workers.rs"]
pub mod workers;

mod choose {
    //! One tracer for every scene: nobody asks for the twin to save time.

    use super::job::{Job, Traced};
    use super::strahl::{Accelerator, Everything};
    use crate::studio::NoFrame;

    pub fn trace<A: Accelerator + Sync>(job: &Job<'_, '_, A>) -> Result<Traced, NoFrame> {
        job.counting_all::<Everything>()
    }

    pub use trace as trace_as_asked;
}
