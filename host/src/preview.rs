//! A coarse preview that is written before the full picture.

use strahl_core::{Resolution, Rgb};
use strahl_picture::Picture;
use strahl_settings::{Filter, SamplerSettings, Settings};

/// Ratio of the sides of the full picture and of the preview.
const DOWNSCALE: u32 = 4;

/// A picture of at most this many pixels has no preview.
const MIN_PIXELS: u32 = 128 * 96;

/// The settings of a preview; `None` for small pictures and regions.
pub fn preview_settings(settings: &Settings) -> Option<Settings> {
    let (width, height) = (settings.size.width(), settings.size.height());
    if width.saturating_mul(height) <= MIN_PIXELS || settings.region.is_some() {
        return None;
    }
    let size = Resolution::new(width.div_ceil(DOWNSCALE), height.div_ceil(DOWNSCALE))?;
    let (sampler, filter) = (SamplerSettings::Single, Filter::Box);
    Some(Settings { size, sampler, filter, select: None, ..settings.clone() })
}

/// The preview, scaled to the size of the full picture.
pub fn upscaled(preview: &Picture, size: Resolution) -> Picture {
    let (width, height) = (preview.size.width() as usize, preview.size.height() as usize);
    let colors = (0..size.height() as usize).flat_map(|y| {
        let row = (y / DOWNSCALE as usize).min(height - 1) * width;
        (0..size.width() as usize).map(move |x| row + (x / DOWNSCALE as usize).min(width - 1))
    });
    let colors = colors.map(|place| preview.colors.get(place).copied().unwrap_or(Rgb::BLACK)).collect();
    Picture { size, colors }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preview_has_a_sixteenth_of_the_pixels_and_becomes_as_large_as_the_picture() {
        let size = Resolution::new(401, 302).unwrap();
        let preview = preview_settings(&Settings { size, ..Settings::default() }).unwrap();
        assert_eq!((preview.size.width(), preview.size.height()), (101, 76));
        let colors = (0..101 * 76).map(|place| Rgb::gray(place as f32)).collect();
        let whole = upscaled(&Picture { size: preview.size, colors }, size);
        assert_eq!((whole.size, whole.colors.len()), (size, 401 * 302));
        assert_eq!(whole.colors[..5], [0.0, 0.0, 0.0, 0.0, 1.0].map(Rgb::gray));
        assert_eq!(whole.colors[3 * 401], Rgb::gray(0.0));
        assert_eq!(whole.colors[4 * 401], Rgb::gray(101.0));
        assert_eq!(whole.colors.last(), Some(&Rgb::gray(101.0 * 76.0 - 1.0)));
    }

    #[test]
    fn a_small_picture_has_no_preview() {
        assert!(
            preview_settings(&Settings { size: Resolution::new(40, 30).unwrap(), ..Settings::default() })
                .is_none()
        );
    }
}
