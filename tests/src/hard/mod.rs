//! Cases in which single precision is known to go wrong, and what three ways make of them: the
//! textbook's formula, the core, and its twin with double precision inside.
//!
//! What counts as right is the same for all three. A ray that passes a silhouette, an edge or a
//! rim within the oracle's band may be answered either way; every other ray has one answer, and
//! its distance may be off by some units in the last place times the *conditioning*: the largest
//! difference that has to be formed, over the cosine between ray and normal, and the way itself.

mod bounds;
mod case;
mod flat;
mod lattice;
mod leave;
mod limits;
mod mesh;
mod optics;
pub mod panels;
mod round;
pub mod table;
mod terminator;
mod walks;

pub use case::{Case, Solver, Tally, ULP};
pub use mesh::{Mesh, escapes, odd_crossings};

/// All cases.
pub fn cases() -> Vec<Case> {
    let families: [&[Case]; 9] = [
        &round::CASES,
        &flat::CASES,
        &mesh::CASES,
        &bounds::CASES,
        &walks::CASES,
        &leave::CASES,
        &terminator::CASES,
        &optics::CASES,
        &limits::CASES,
    ];
    families.into_iter().flatten().copied().collect()
}
