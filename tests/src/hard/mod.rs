//! Cases in which single precision is known to go wrong, and what three ways make of them: the
//! textbook's formula, the core, and its twin with double precision inside.
//!
//! What counts as right is the same for all three. A ray that passes a silhouette, an edge or a
//! rim within the oracle's band may be answered either way; every other ray has one answer, and
//! its distance may be off by some units in the last place times the *conditioning*: the largest
//! difference that has to be formed, over the cosine between ray and normal, and the way itself.

mod bounds;
mod case;
mod curved;
mod flat;
mod lattice;
mod limits;
mod mesh;
mod optics;
pub mod panels;
mod ray_offset;
pub mod table;
mod terminator;
mod traversal;

pub use case::{HardCase, HardCaseTally, Solver, ULP};
pub use mesh::{ClosedMesh, escapes, odd_crossings};

/// All cases.
pub fn cases() -> Vec<HardCase> {
    let families: [&[HardCase]; 9] = [
        &curved::CASES,
        &flat::CASES,
        &mesh::CASES,
        &bounds::CASES,
        &traversal::CASES,
        &ray_offset::CASES,
        &terminator::CASES,
        &optics::CASES,
        &limits::CASES,
    ];
    families.into_iter().flatten().copied().collect()
}
