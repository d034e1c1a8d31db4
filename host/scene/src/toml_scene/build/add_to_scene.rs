//! Things of the file that add objects to the description.

use std::ops::Range;

use super::builder::SceneBuilder;

/// Something that a scene has in it.
pub trait AddToScene {
    /// Adds the objects of the thing that stands at `span`, or says what is wrong with it.
    fn add(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>);
}
