//! Measurements of a study: which settings are measured, in which order, and what comes of them.
//!
//! | module | contents |
//! |---|---|
//! | [`plan`] | what is measured, and the share of the time for each part |
//! | [`benchmark`] | one setting is measured |
//! | [`measurements`] | everything that has been measured |
//! | `resolution` | the size of the pictures, from the time limit |
//! | [`experiment`] | a study from its beginning to its end |
//! | `sweeps` | settings varied one at a time |
//! | `combination_search` | combinations worth a measurement |
//! | `combinations` | combinations, measured |
//! | `techniques` | techniques on and off |
//! | `images` | pictures for the report |

pub mod benchmark;
mod combination_search;
mod combinations;
pub mod experiment;
pub(crate) mod images;
pub mod measurements;
pub mod plan;
pub(crate) mod resolution;
mod sweeps;
mod techniques;
