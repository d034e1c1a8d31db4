//! The ray tree of one pixel: what each ray hits, which lights are visible, and what contributes how much.
//!
//! | module | contents |
//! |---|---|
//! | [`tree`] | the explanation as data |
//! | [`pixel`] | one pixel is traced and recorded |
//! | `recorder` | trace events become a tree |
//! | `source_names` | items, materials and lights as the scene file names them |

use strahl_core::image::Pixel;
use strahl_engine::RenderError;
use strahl_scene::description::LoadedScene;
use strahl_settings::Settings;

use tree::{PixelExplanation, VERSION, rgb_array};

pub mod pixel;
mod recorder;
mod source_names;
pub mod tree;

/// Traces one pixel of the scene in the file `scene` and explains its color. The precision is single.
pub fn explain(
    scene: &str,
    description: &LoadedScene,
    settings: Settings,
    pixel: Pixel,
) -> Result<PixelExplanation, RenderError> {
    let traced = pixel::trace_pixel(description, &settings, pixel)?;
    Ok(PixelExplanation {
        version: VERSION,
        scene: scene.to_owned(),
        width: settings.size.width(),
        height: settings.size.height(),
        x: pixel.x,
        y: pixel.y,
        settings,
        color: rgb_array(traced.color),
        srgb: traced.color.to_srgb8(),
        sum: traced.sum,
        samples: traced.samples,
    })
}
