//! What picture is wanted, and how the work is done.

use std::sync::Arc;

pub use strahl_core::Limits;
use strahl_core::{Size, Tile};

use crate::cost_map::CostMap;
use crate::description::Settings;
use crate::finding::Finding;
use crate::mask::Mask;
use crate::precision::Precision;
pub use crate::sampling::{Filter, Sampling, Selecting};

/// The size of a picture where neither the scene nor anybody else says one.
pub const DEFAULT_SIZE: Size = Size::new(640, 480).unwrap();

/// The most levels of rays.
pub const LEVELS: usize = 64;

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
    /// The picture that is asked for, of what nobody asks for that of the scene, and else the
    /// defaults of the command line; or why there is none.
    pub fn asked(asked: &Settings, scene: &Settings) -> Result<Self, String> {
        let default = Wanted::of(asked.size.or(scene.size).unwrap_or(DEFAULT_SIZE));
        let sampling = asked.sampling.or(scene.sampling).unwrap_or(default.sampling);
        let filter = asked.filter.or(scene.filter).unwrap_or(default.filter);
        if filter != Filter::Box && !sampling.takes_filter() {
            return Err(format!("`{sampling}` fills the pixel by itself: no filter but box goes with it"));
        }
        Ok(Wanted {
            limits: Limits {
                levels: asked.levels.or(scene.levels).unwrap_or(default.limits.levels),
                cutoff: asked.cutoff.or(scene.cutoff).unwrap_or(default.limits.cutoff),
            },
            sampling,
            filter,
            seed: asked.seed.or(scene.seed).unwrap_or(default.seed),
            precision: asked.precision.or(scene.precision).unwrap_or(default.precision),
            finding: asked.finding.or(scene.finding),
            shadow_cache: asked.shadow_cache.or(scene.shadow_cache).unwrap_or(default.shadow_cache),
            ..default
        })
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
