//! How items are found: options that `render`, `watch` and `cast` share.

use super::values::one_of;
use crate::failure::Failure;
use crate::finding::{Accel, Bounds, Finding, HEAPS, MAILBOXES, Walk};

/// How items are found.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct FindingArgs {
    /// How items are found, which changes the time and nothing else: `auto` takes what suits the
    /// scene [default: the scene's, or auto].
    #[arg(long, value_name = "KIND")]
    pub accel: Option<Accel>,

    /// How a hierarchy (bvh) is walked [default: the scene's, or stack].
    #[arg(long)]
    pub walk: Option<Walk>,

    /// Places in the heap of that walk: 0, 1, 4 or 64; with fewer it takes longer [default: the
    /// scene's, or 64].
    #[arg(long, value_name = "N", value_parser = heap, allow_negative_numbers = true)]
    pub heap: Option<usize>,

    /// What the list puts round items and groups of them [default: the scene's, or box].
    #[arg(long, value_name = "VOLUME")]
    pub bounds: Option<Bounds>,

    /// Slots of the mailbox, which remembers the items of grid and octree that a ray has met: 0, 8 or 64
    /// [default: the scene's, or 64].
    #[arg(long, value_name = "SLOTS", value_parser = mailbox, allow_negative_numbers = true)]
    pub mailbox: Option<usize>,
}

impl FindingArgs {
    /// What the command line asks for, where it fits together.
    pub fn asked(&self) -> Result<Finding, Failure> {
        let FindingArgs { accel, walk, heap, bounds, mailbox } = *self;
        let asked = Finding { accel, walk, heap, bounds, mailbox };
        match asked.misfit() {
            Some(misfit) => Err(Failure::Usage(misfit)),
            None => Ok(asked),
        }
    }

    /// What the command line asks for, else the scene.
    pub fn over(&self, scene: Finding) -> Result<Finding, Failure> {
        Ok(self.asked()?.or(scene))
    }
}

fn heap(text: &str) -> Result<usize, String> {
    one_of(&HEAPS, text)
}

fn mailbox(text: &str) -> Result<usize, String> {
    one_of(&MAILBOXES, text)
}
