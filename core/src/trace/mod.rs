//! The tracing loop: from a camera sample to its radiance.
//!
//! A [`Tracer`] pops a task (a ray with its weight), finds the nearest hit, shades it, and pushes at most two
//! secondary rays. Radiance is linear in the ray tree: each task carries its weight, the product of the
//! factors along its path, and the contributions are added to one sum. So there is no recursion, and the
//! stack of tasks has a fixed size. All memory that changes is in a [`Worker`].
//!
//! Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 1980.
//! Difference: an explicit stack instead of recursion, and a cutoff by weight.

#[cfg(not(feature = "double"))]
mod error;
#[cfg(not(feature = "double"))]
mod hit_id;
mod limits;
mod pixel_sample;
mod ray_tracer;
mod secondary_rays;
mod task;
mod tracer;
mod worker;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::trace::{self as error, self as hit_id};

pub use error::TracerError;
pub use hit_id::HitId;
pub use limits::Limits;
pub use pixel_sample::PixelSample;
pub use ray_tracer::RayTracer;
pub use tracer::Tracer;
pub use worker::Worker;
