//! What picture is wanted, and how the work is done.

use std::sync::Arc;

pub use strahl_core::Limits;
use strahl_core::{Size, Tile};
use strahl_settings::Settings;
pub use strahl_settings::{Filter, LEVELS, PixelSelection as Selecting, Sampling};

use crate::cost_map::CostMap;
use crate::finding::Finding;
use crate::mask::Mask;
use crate::precision::Precision;

/// The size of a picture where neither the scene nor anybody else says one.
pub const DEFAULT_SIZE: Size = Size::new(640, 480).unwrap();

/// Pixels along one side of a tile. Small enough to keep all threads busy to the end.
const TILE: u32 = 32;

/// What picture is wanted, and how the work is done.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// Width and height.
    pub size: Size,
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel.
    pub sampling: Sampling,
    /// How much of its surroundings counts in a pixel.
    pub filter: Filter,
    /// Another seed: other numbers in place of chance.
    pub seed: u32,
    /// Which pixels are traced, where not all are.
    pub selecting: Option<Selecting>,
    /// The part of the picture that is wanted, if not all of it. It lies inside the size.
    pub region: Option<Tile>,
    /// The pixels that are wanted, if not all of them; of the same size.
    pub mask: Option<Arc<Mask>>,
    /// What is computed with.
    pub precision: Precision,
    /// How items are found.
    pub finding: Finding,
    /// Whether who stood last in the way of a light is asked first.
    pub shadow_cache: bool,
    /// Threads and tiles.
    pub cut: Cut,
    /// Whether tests are counted, which takes its time; rays always are.
    pub counted: bool,
    /// Where the costs of each pixel go, if they are asked for; tests are counted then.
    pub cost_map: Option<Arc<CostMap>>,
}

impl Wanted {
    /// A picture of `size` by the defaults of the command line, counted.
    pub fn of(size: Size) -> Self {
        Wanted {
            size,
            limits: Limits::DEFAULT,
            sampling: Sampling::Single,
            filter: Filter::Box,
            seed: 0,
            selecting: None,
            region: None,
            mask: None,
            precision: Precision::Single,
            finding: Finding::default(),
            shadow_cache: true,
            cut: Cut::threads(0),
            counted: true,
            cost_map: None,
        }
    }
}

impl Wanted {
    /// The picture that these settings are of.
    pub fn new(settings: &Settings) -> Self {
        Wanted {
            size: settings.size,
            limits: settings.limits(),
            sampling: settings.sampler,
            filter: settings.filter,
            seed: settings.seed,
            selecting: settings.select,
            region: settings.region,
            precision: settings.precision,
            finding: settings.acceleration(),
            shadow_cache: settings.shadow_cache,
            cut: Cut::threads(settings.threads),
            ..Wanted::of(settings.size)
        }
    }

    /// The settings of this picture, what it does not know being as in others.
    pub fn settings(&self, others: Settings) -> Settings {
        let (sampler, select) = (self.sampling, self.selecting);
        Settings { sampler, select, ..others.with_limits(self.limits) }
    }

    /// The size of the picture that is made.
    pub fn picture(&self) -> Size {
        let Tile { width, height, .. } = self.area();
        Size::new(width, height).unwrap_or(self.size)
    }

    /// The pixels of the picture that is made.
    pub fn area(&self) -> Tile {
        let whole = Tile::whole(self.size);
        self.region.map_or(whole, |tile| tile.within(whole))
    }
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
