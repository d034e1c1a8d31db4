//! Tables that add objects to the scene.

use std::ops::Range;

use super::builder::SceneBuilder;

/// A table that adds objects to the scene.
pub trait AddToScene {
    /// Adds the objects of the table at `span`, or reports its errors.
    fn add(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>);
}
