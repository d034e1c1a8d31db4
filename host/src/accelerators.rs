//! The accelerators of this program, for either precision: what is asked for becomes a type.
//!
//! This is the one room that knows every accelerator. It lends each the memory that it needs,
//! builds it, and hands it to whoever has a use for one, so that whatever is done with it is
//! compiled for its type.

use std::time::Instant;

use super::strahl::{Aabb, Accelerator, BuildError, List, Scene, groups_of};
use crate::finding::{Bounds, Facts, Finding, Kind};

/// A use for an accelerator, whatever its type.
pub trait Purpose {
    /// What comes of it.
    type Answer;

    /// Uses it.
    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer;
}

/// Builds the accelerator that is asked for, or one that suits the scene, and uses it.
pub fn build<P: Purpose>(scene: &Scene<'_>, finding: &Finding, purpose: P) -> Result<P::Answer, BuildError> {
    let clock = Instant::now();
    let (kind, reason) = match finding.accelerator {
        Some(kind) => (kind, "as asked"),
        None => (Kind::List, "there is no other"),
    };
    let facts = |bytes, regions| Facts { kind, reason, bytes, regions, build: clock.elapsed() };
    let boxes: Vec<Aabb> = scene.parts().geometry.all_bounds().collect();
    match kind {
        Kind::List => match finding.bounds.unwrap_or(Bounds::Box) {
            Bounds::None => {
                let list = List::bare(boxes.len() as u32);
                Ok(purpose.with(list, facts(list.bytes(), 1)))
            }
            Bounds::Box => {
                let regions = groups_of(boxes.len());
                let mut groups = vec![Aabb::EMPTY; regions];
                let list = List::boxed(&boxes, &mut groups)?;
                Ok(purpose.with(list, facts(list.bytes(), regions)))
            }
        },
    }
}
