//! Cost per pixel as a heat map or as float channels.
//!
//! The heat map has three panels, for rays, tests and levels, each with a legend. Its color map is perceptually
//! uniform. The scale of rays and tests is logarithmic, from the cheapest pixel to the most expensive; that of
//! levels is linear. A pixel that was not traced is black.

use std::convert::Infallible;

use embedded_graphics::Drawable;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size as Extent};
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_1::{FONT_7X13, FONT_7X13_BOLD};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::text::{Alignment, Text};
use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, Layer, LayerAttributes, WritableImage as _};
use strahl_core::tally::RayKind;
use strahl_core::{Resolution, Tile};
use strahl_engine::CostMap;
use strahl_engine::cost_map::{self, PixelCost};
use strahl_picture::color_map::inferno;
use strahl_picture::format::EXR_ENCODING;
use strahl_picture::{Picture, srgb};

/// Minimum width of a panel; pixels of small pictures become squares.
const MIN_PANEL_WIDTH: u32 = 280;
/// Wider panels are stacked.
const STACKED_WIDTH: u32 = 900;
/// Margin around the panels.
const MARGIN: u32 = 12;
/// Above a panel, for its title.
const TITLE: u32 = 22;
/// Below it, for its legend.
const LEGEND: u32 = 44;
/// Minimum distance of the numbers of a legend.
const MIN_TICK_DISTANCE: f64 = 46.0;
/// Position of the smallest positive value on the color map.
const MIN_BRIGHTNESS: f64 = 0.12;

const PAPER: [u8; 3] = [252, 252, 250];
const INK: Rgb888 = Rgb888::new(28, 28, 28);

/// The costs of the pixels of a region, row by row.
#[derive(Clone, Debug)]
pub struct CostRegion {
    area: Tile,
    pixels: Vec<PixelCost>,
}

impl CostRegion {
    /// The costs of a region of a picture.
    pub fn of(cost_map: &CostMap, area: Tile) -> Self {
        let (whole, all) = (Tile::full(cost_map.size()), cost_map.costs());
        let cost =
            |pixel| whole.index_of(pixel).and_then(|place| all.get(place)).copied().unwrap_or_default();
        CostRegion { area, pixels: area.pixels().map(cost).collect() }
    }
}

/// A panel of the heat map: one number for each pixel.
struct Panel {
    name: &'static str,
    values: Vec<u64>,
    scale: Scale,
}

/// Mapping of values to colors.
#[derive(Clone, Copy)]
enum Scale {
    /// Equal ratios have equal distances.
    Logarithmic { least: f64, most: f64 },
    /// Equal differences have equal distances.
    Linear { most: f64 },
}

impl Scale {
    /// The position on the color map, 0 to 1.
    fn normalize(self, value: f64) -> f64 {
        let share = match self {
            Scale::Logarithmic { least, most } if most > least => {
                libm::log(value.max(least) / least) / libm::log(most / least)
            }
            Scale::Logarithmic { .. } => 0.5,
            Scale::Linear { most } => value / most.max(1.0),
        };
        if value > 0.0 { MIN_BRIGHTNESS + (1.0 - MIN_BRIGHTNESS) * share } else { 0.0 }
    }

    /// Numbers for the legend, the ends among them.
    fn ticks(self, width: f64) -> Vec<f64> {
        let (ends, candidates): ([f64; 2], Vec<f64>) = match self {
            Scale::Logarithmic { least, most } => {
                let decades = (0..20).map(|power| libm::pow(10.0, f64::from(power)));
                ([least, most], decades.flat_map(|ten| [ten, 2.0 * ten, 5.0 * ten]).collect())
            }
            Scale::Linear { most } => ([1.0, most.max(1.0)], (2..64).map(f64::from).collect()),
        };
        let at = |value: f64| self.normalize(value) * width;
        let mut ticks = vec![ends[0]];
        if at(ends[1]) - at(ends[0]) >= MIN_TICK_DISTANCE {
            ticks.push(ends[1]);
        }
        for value in candidates.into_iter().filter(|value| *value > ends[0] && *value < ends[1]) {
            if ticks.iter().all(|tick| (at(*tick) - at(value)).abs() >= MIN_TICK_DISTANCE) {
                ticks.push(value);
            }
        }
        ticks
    }
}

impl Panel {
    fn of(name: &'static str, costs: &CostRegion, value: fn(&PixelCost) -> u64) -> Self {
        let values: Vec<u64> = costs.pixels.iter().map(value).collect();
        let most = values.iter().copied().max().unwrap_or(0) as f64;
        let least = values.iter().copied().filter(|value| *value > 0).min().unwrap_or(1) as f64;
        let scale = if name == "levels" {
            Scale::Linear { most }
        } else {
            Scale::Logarithmic { least, most: most.max(least) }
        };
        Panel { name, values, scale }
    }

    fn title(&self) -> String {
        let traced = self.values.iter().filter(|value| **value > 0).count().max(1) as f64;
        let mean = self.values.iter().sum::<u64>() as f64 / traced;
        let most = self.values.iter().copied().max().unwrap_or(0);
        format!("{} per pixel: mean {mean:.1}, maximum {most}", self.name)
    }
}

/// The heat map; `None` if it is too large for one picture.
pub fn picture(costs: &CostRegion) -> Option<Picture> {
    let panels = [
        Panel::of("rays", costs, PixelCost::total_rays),
        Panel::of("tests", costs, PixelCost::tests),
        Panel::of("levels", costs, |cost| cost.level.into()),
    ];
    let (width, height) = (costs.area.width, costs.area.height);
    let zoom = MIN_PANEL_WIDTH.div_ceil(width.max(1)).max(1);
    let (wide, high) = (width * zoom, height * zoom);
    let step = if wide > STACKED_WIDTH { (0, TITLE + high + LEGEND) } else { (wide + 2 * MARGIN, 0) };
    let size = (wide + 2 * step.0 + 2 * MARGIN, TITLE + high + LEGEND + 2 * step.1 + 2 * MARGIN);
    let mut canvas = Canvas::of(Resolution::new(size.0, size.1)?);
    let colors = inferno();
    for (panel, place) in panels.iter().zip(0..) {
        let (left, top) = (MARGIN + place * step.0, MARGIN + place * step.1);
        canvas.write(left, top + 13, &panel.title(), Alignment::Left, FontWeight::Bold);
        let color = |value: f64| colors[(255.0 * panel.scale.normalize(value) + 0.5) as usize & 255];
        for (value, at) in panel.values.iter().zip(0..) {
            let (x, y) = (left + at % width * zoom, top + TITLE + at / width * zoom);
            canvas.fill([x, y, zoom, zoom], color(*value as f64));
        }
        // The legend.
        let bar = top + TITLE + high + 8;
        for x in 0..wide {
            let step = (255 * x / wide.max(2).saturating_sub(1)).min(255);
            canvas.fill([left + x, bar, 1, 12], colors[step as usize]);
        }
        for tick in panel.scale.ticks(f64::from(wide)) {
            let place = (panel.scale.normalize(tick) * f64::from(wide - 1) + 0.5) as u32;
            canvas.fill([left + place, bar + 12, 1, 4], [28, 28, 28]);
            // The last stays inside of the panel.
            let side = if place + 24 > wide { Alignment::Right } else { Alignment::Center };
            canvas.write(left + place, bar + 28, &format!("{tick}"), side, FontWeight::Regular);
        }
    }
    Some(canvas.into_picture())
}

/// The numbers as channels of an EXR file: `rays`, `rays.camera` and so on, `tests.boxes`,
/// `tests.shapes`, `levels`.
pub fn exr(costs: &CostRegion) -> Result<Vec<u8>, exr::error::Error> {
    let channel = |name: &str, value: &dyn Fn(&PixelCost) -> u64| {
        // Exact up to 16 million.
        let values = costs.pixels.iter().map(|cost| value(cost) as f32).collect();
        AnyChannel::new(name, FlatSamples::F32(values))
    };
    let mut channels = vec![
        channel("rays", &PixelCost::total_rays),
        channel("tests.boxes", &|cost| cost_map::sum(cost.boxes)),
        channel("tests.shapes", &|cost| cost_map::sum(cost.shapes)),
        channel("levels", &|cost| cost.level.into()),
    ];
    for kind in RayKind::ALL {
        channels.push(channel(&format!("rays.{}", kind.name()), &|cost| cost.rays[kind as usize].into()));
    }
    let size = (costs.area.width as usize, costs.area.height as usize);
    let channels = AnyChannels::sort(channels.into_iter().collect());
    let layer = Layer::new(size, LayerAttributes::named("cost"), EXR_ENCODING, channels);
    let mut file = std::io::Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut file)?;
    Ok(file.into_inner())
}

/// The picture of the heat map, in 8-bit sRGB.
struct Canvas {
    size: Resolution,
    pixels: Vec<[u8; 3]>,
}

enum FontWeight {
    Regular,
    Bold,
}

impl Canvas {
    fn of(size: Resolution) -> Self {
        Canvas { size, pixels: vec![PAPER; size.width() as usize * size.height() as usize] }
    }

    fn fill(&mut self, [x, y, width, height]: [u32; 4], color: [u8; 3]) {
        for row in y..(y + height).min(self.size.height()) {
            let start = row as usize * self.size.width() as usize;
            let end = (x + width).min(self.size.width()) as usize;
            if let Some(pixels) = self.pixels.get_mut(start + x as usize..start + end) {
                pixels.fill(color);
            }
        }
    }

    fn write(&mut self, x: u32, y: u32, text: &str, side: Alignment, weight: FontWeight) {
        let font = match weight {
            FontWeight::Regular => &FONT_7X13,
            FontWeight::Bold => &FONT_7X13_BOLD,
        };
        let style = MonoTextStyle::new(font, INK);
        let Ok(_) = Text::with_alignment(text, Point::new(x as i32, y as i32), style, side).draw(self);
    }

    fn into_picture(self) -> Picture {
        let table = srgb::decode8();
        let colors = self.pixels.into_iter().map(|color| srgb::decode(&table, color)).collect();
        Picture { size: self.size, colors }
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Extent {
        Extent::new(self.size.width(), self.size.height())
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(Point { x, y }, color) in pixels {
            if let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y)) {
                self.fill([x, y, 1, 1], [color.r(), color.g(), color.b()]);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use strahl_core::image::Pixel;

    fn costs() -> CostRegion {
        let cost = |number| PixelCost {
            rays: [1, 0, 0, number],
            boxes: [9 * number; 4],
            level: 1,
            ..PixelCost::default()
        };
        let area = Tile { top_left: Pixel { x: 0, y: 0 }, width: 3, height: 2 };
        let pixels = (0..6).map(|place| if place == 5 { PixelCost::default() } else { cost(place) });
        CostRegion { area, pixels: pixels.collect() }
    }

    #[test]
    fn expensive_pixels_are_brighter_and_one_that_was_not_traced_is_black() {
        let picture = picture(&costs()).unwrap();
        let zoom = MIN_PANEL_WIDTH.div_ceil(3);
        let at = |x: u32, y: u32| {
            let place =
                (MARGIN + TITLE + y * zoom + zoom / 2) * picture.size.width() + MARGIN + x * zoom + zoom / 2;
            let c = picture.colors[place as usize];
            c.r + c.g + c.b
        };
        let row = [at(0, 0), at(1, 0), at(2, 0), at(0, 1), at(1, 1)];
        assert!(row.is_sorted_by(|a, b| a < b), "{row:?}");
        let table = srgb::decode8();
        let black = srgb::decode(&table, inferno()[0]);
        assert_eq!(at(2, 1), black.r + black.g + black.b);
    }

    #[test]
    fn a_legend_has_the_ends_and_its_numbers_do_not_touch() {
        for scale in [Scale::Logarithmic { least: 3.0, most: 40_000.0 }, Scale::Linear { most: 12.0 }] {
            let ticks = scale.ticks(300.0);
            assert!(ticks.len() > 3, "{ticks:?}");
            for (place, a) in ticks.iter().enumerate() {
                for b in &ticks[..place] {
                    assert!(
                        (scale.normalize(*a) - scale.normalize(*b)).abs() * 300.0 >= MIN_TICK_DISTANCE,
                        "{ticks:?}"
                    );
                }
            }
        }
        assert_eq!(Scale::Logarithmic { least: 4.0, most: 4.0 }.ticks(300.0), [4.0]);
    }
}
