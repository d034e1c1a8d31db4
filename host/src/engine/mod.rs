//! One scene in one precision: its accelerator, its ray tracers, tiles and threads. Compiled once for each core.
//!
//! `strahl` is the core and `tables` are the scene tables for it; both come from the module above.
//!
//! | module | what it does |
//! |---|---|
//! | [`session`] | a scene with its accelerator: pictures and ray queries |
//! | [`accelerators`] | builds the accelerator that the settings ask for |
//! | [`request`] | what ray tracers are made of, before their types are chosen |
//! | [`ray_tracer`] | one ray tracer for each tile |
//! | [`cost_counting`] | charges every camera ray to its pixel |
//! | [`samplers`] | the sampler that the settings ask for |
//! | [`tiles`] | tiles and threads |
//! | [`passes`] | a picture that becomes better pass by pass |
//! | [`hits`] | the nearest hit along single rays |

use super::{effects, strahl, tables};

pub mod accelerators;
pub mod cost_counting;
pub mod hits;
pub mod passes;
pub mod ray_tracer;
pub mod request;
pub mod samplers;
pub mod session;
pub mod tiles;
