//! What picture is wanted, and how the work is done.

use strahl_core::{Limits, Size};

use crate::finding::Finding;

/// The most levels of rays.
pub const LEVELS: usize = 64;

/// Pixels along one side of a tile. Small enough to keep all threads busy to the end.
const TILE: u32 = 32;

/// What picture is wanted, and how the work is done.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Width and height.
    pub size: Size,
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel.
    pub sampling: Sampling,
    /// What is computed with.
    pub precision: Precision,
    /// How items are found.
    pub finding: Finding,
    /// Threads and tiles.
    pub cut: Cut,
    /// Whether the work is counted.
    pub counted: bool,
}

impl Wanted {
    /// A picture of `size` by the defaults of the command line, counted.
    pub fn of(size: Size) -> Self {
        Wanted {
            size,
            limits: Limits::DEFAULT,
            sampling: Sampling::Single,
            precision: Precision::Single,
            finding: Finding::default(),
            cut: Cut::threads(0),
            counted: true,
        }
    }
}

/// What is computed with. Numbers of scenes are single precision in either case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Precision {
    /// Single precision, 32 bits.
    #[default]
    Single,
    /// Double precision, 64 bits: slower, and a yardstick for the other.
    Double,
}

/// Which rays make a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// One through the middle.
    Single,
    /// n times n.
    Regular(u16),
    /// Through the corners, which neighbours share.
    Corners,
}

/// How the work is cut.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// Threads; 0 is one for each core.
    pub threads: usize,
    /// Pixels along one side of a tile.
    pub tile: u32,
}

impl Cut {
    /// Tiles as the program takes them.
    pub fn threads(threads: usize) -> Self {
        Cut { threads, tile: TILE }
    }
}
