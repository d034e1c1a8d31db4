//! What else a render is asked for beside its settings: none of it changes a pixel that is requested.

use strahl_core::image::Pixel;

use crate::cost_map::CostMap;
use crate::mask::Mask;

/// Pixels along one side of a tile. Small enough to keep all threads busy to the end.
const TILE_SIDE: u32 = 32;

/// What else a render is asked for beside its settings.
#[derive(Clone, Copy, Debug)]
pub struct RenderOptions<'o> {
    /// The pixels that are requested, if not all of them; of the same size as the picture. The others are black.
    pub mask: Option<&'o Mask>,
    /// Whether tests are counted, which takes its time; rays always are.
    pub count_tests: bool,
    /// Where the cost of each pixel goes; tests are counted then.
    pub cost_map: Option<&'o CostMap>,
    /// Pixels along one side of a tile.
    pub tile_side: u32,
}

impl RenderOptions<'_> {
    /// All pixels; tests are counted.
    pub const COUNT_TESTS: RenderOptions<'static> =
        RenderOptions { mask: None, count_tests: true, cost_map: None, tile_side: TILE_SIDE };

    /// Whether a pixel is requested.
    pub fn is_requested(&self, pixel: Pixel) -> bool {
        self.mask.is_none_or(|mask| mask.has(pixel))
    }

    /// Whether tests are counted.
    pub fn counts_tests(&self) -> bool {
        self.count_tests || self.cost_map.is_some()
    }
}

/// All pixels; tests are not counted.
impl Default for RenderOptions<'_> {
    fn default() -> Self {
        RenderOptions { count_tests: false, ..RenderOptions::COUNT_TESTS }
    }
}
