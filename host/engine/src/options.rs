//! Options of a render beside its settings. They do not change the color of a requested pixel.

use strahl_core::image::Pixel;

use crate::cost_map::CostMap;
use crate::mask::Mask;

/// The default tile size in pixels: small enough to keep all threads busy until the end.
const TILE_SIDE: u32 = 32;

/// Options of a render beside its settings.
#[derive(Clone, Copy, Debug)]
pub struct RenderOptions<'o> {
    /// The requested pixels, as a mask of the size of the picture; `None` for all. The others are black.
    pub mask: Option<&'o Mask>,
    /// Whether tests are counted, which is slower; rays are always counted.
    pub count_tests: bool,
    /// The cost map to add the cost of each pixel to; implies that tests are counted.
    pub cost_map: Option<&'o CostMap>,
    /// The width and height of a tile, in pixels.
    pub tile_side: u32,
}

impl RenderOptions<'_> {
    /// All pixels, with tests counted.
    pub const COUNT_TESTS: RenderOptions<'static> =
        RenderOptions { mask: None, count_tests: true, cost_map: None, tile_side: TILE_SIDE };

    /// Whether a pixel is requested.
    pub fn is_requested(&self, pixel: Pixel) -> bool {
        self.mask.is_none_or(|mask| mask.contains(pixel))
    }

    /// Whether tests are counted.
    pub fn counts_tests(&self) -> bool {
        self.count_tests || self.cost_map.is_some()
    }
}

/// All pixels, without counting tests.
impl Default for RenderOptions<'_> {
    fn default() -> Self {
        RenderOptions { count_tests: false, ..RenderOptions::COUNT_TESTS }
    }
}
