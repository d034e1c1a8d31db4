//! Rays that are known to go wrong in single precision, answered by three solvers: the textbook's formula,
//! the core, and the core with double precision inside.
//!
//! The same answers are correct for all three. For a ray that passes a silhouette or an edge within the
//! oracle's band, hit and miss are both correct. Every other ray has one answer. The error of its distance is
//! measured in units in the last place times the *conditioning*: the largest difference that has to be formed
//! over the cosine between ray and normal, plus the distance itself.

mod bounds;
mod box_scenes;
mod case;
mod curved;
mod flat;
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
