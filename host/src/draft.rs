//! A quick coarse picture, to look at before the full one is there.

use strahl_core::{Resolution, Rgb};
use strahl_picture::Picture;
use strahl_settings::{Filter, SamplerSettings, Settings};

/// This many pixels of the full picture along one side are one of the draft.
const COARSE: u32 = 4;

/// A full picture of so few pixels is there at once.
const QUICK: u32 = 128 * 96;

/// The settings of a draft of a whole picture; none where it would save no time.
pub fn of(settings: &Settings) -> Option<Settings> {
    let (width, height) = (settings.size.width(), settings.size.height());
    // A part of a picture is small already.
    if width.saturating_mul(height) <= QUICK || settings.region.is_some() {
        return None;
    }
    let size = Resolution::new(width.div_ceil(COARSE), height.div_ceil(COARSE))?;
    let (sampler, filter) = (SamplerSettings::Single, Filter::Box);
    Some(Settings { size, sampler, filter, select: None, ..settings.clone() })
}

/// The draft in the size of the full picture, so that who looks at it sees it become sharp.
pub fn enlarged(draft: &Picture, size: Resolution) -> Picture {
    let (width, height) = (draft.size.width() as usize, draft.size.height() as usize);
    let colors = (0..size.height() as usize).flat_map(|y| {
        let row = (y / COARSE as usize).min(height - 1) * width;
        (0..size.width() as usize).map(move |x| row + (x / COARSE as usize).min(width - 1))
    });
    let colors = colors.map(|place| draft.colors.get(place).copied().unwrap_or(Rgb::BLACK)).collect();
    Picture { size, colors }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_draft_has_a_sixteenth_of_the_pixels_and_becomes_as_large_as_the_picture() {
        let size = Resolution::new(401, 302).unwrap();
        let draft = of(&Settings { size, ..Settings::default() }).unwrap();
        assert_eq!((draft.size.width(), draft.size.height()), (101, 76));
        let colors = (0..101 * 76).map(|place| Rgb::gray(place as f32)).collect();
        let whole = enlarged(&Picture { size: draft.size, colors }, size);
        assert_eq!((whole.size, whole.colors.len()), (size, 401 * 302));
        assert_eq!(whole.colors[..5], [0.0, 0.0, 0.0, 0.0, 1.0].map(Rgb::gray));
        assert_eq!(whole.colors[3 * 401], Rgb::gray(0.0));
        assert_eq!(whole.colors[4 * 401], Rgb::gray(101.0));
        assert_eq!(whole.colors.last(), Some(&Rgb::gray(101.0 * 76.0 - 1.0)));
    }

    #[test]
    fn a_small_picture_has_no_draft() {
        assert!(of(&Settings { size: Resolution::new(40, 30).unwrap(), ..Settings::default() }).is_none());
    }
}
