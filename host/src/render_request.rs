//! What a session renders.

use std::sync::Arc;

use strahl_settings::Settings;

use crate::cost_map::CostMap;
use crate::mask::Mask;

/// Pixels along one side of a tile. Small enough to keep all threads busy to the end.
const TILE: u32 = 32;

/// What a session renders: the settings, and what goes into the work and comes of it beside the picture.
#[derive(Clone, Debug)]
pub struct RenderRequest {
    /// The settings.
    pub settings: Settings,
    /// The pixels that are traced, if not all of them; of the size of the settings.
    pub mask: Option<Arc<Mask>>,
    /// Pixels along one side of a tile.
    pub tile: u32,
    /// Whether tests are counted, which takes time; rays always are.
    pub counted: bool,
    /// Where the costs of each pixel go, if they are asked for; tests are counted then.
    pub cost_map: Option<Arc<CostMap>>,
}

impl RenderRequest {
    /// A picture with these settings, counted.
    pub fn new(settings: Settings) -> Self {
        RenderRequest { settings, mask: None, tile: TILE, counted: true, cost_map: None }
    }

    /// The same with other settings.
    pub fn with(&self, settings: Settings) -> Self {
        RenderRequest { settings, ..self.clone() }
    }
}
