//! Report on the differences of two pictures.

use std::fmt::Write as _;

use serde::Serialize;
use strahl_core::Resolution;
use strahl_picture::difference::{Color, Limit, Pair, Peak};
use strahl_scene::quantity::quantity;

use crate::args::CompareArgs;

/// Differences of two pictures, with the fields of `--json`. Differences are of sRGB-encoded values, 0 to 1.
#[derive(Debug, Serialize)]
pub struct ComparisonReport {
    /// The first file.
    pub first: String,
    /// The second file.
    pub second: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Whether all pixels are equal, bit for bit.
    pub identical: bool,
    /// Whether the differences are within the limits: the exit status is 0.
    pub equal: bool,
    /// Largest allowed difference of a channel.
    pub limit: f64,
    /// Largest allowed share of pixels over the limit.
    pub limit_share: f64,
    /// The largest difference of a channel, and its pixel; null if there is none.
    pub largest: Option<PeakLocation>,
    /// The mean difference of all channels.
    pub mean_absolute: f64,
    /// Root mean square difference.
    pub rmse: f64,
    /// Peak signal-to-noise ratio in decibels; null if infinite.
    pub psnr: Option<f64>,
    /// Structural similarity; 1 is identical.
    pub ssim: f64,
    /// Pixels that differ at all.
    pub differing: PixelShare,
    /// Pixels that differ by more than 1/255.
    pub beyond: PixelShare,
    /// Pixels that differ by more than the limit.
    pub over_limit: PixelShare,
    /// The largest difference of linear light, and its pixel; null if there is none, or unless both files are EXR.
    pub largest_linear: Option<PeakLocation>,
}

/// A difference and its pixel.
#[derive(Debug, Serialize)]
pub struct PeakLocation {
    /// Null if infinite, or if one of the two values is NaN.
    pub difference: Option<f64>,
    /// Column, from 0 at the left.
    pub x: usize,
    /// Row, from 0 at the top.
    pub y: usize,
    /// `red`, `green` or `blue`.
    pub channel: Color,
}

/// A number of pixels.
#[derive(Debug, Serialize)]
pub struct PixelShare {
    /// Number of pixels.
    pub pixels: usize,
    /// Share of all pixels, 0 to 1.
    pub share: f64,
}

impl ComparisonReport {
    /// Measures the differences of a pair.
    pub fn new(args: &CompareArgs, size: Resolution, pair: &Pair) -> Self {
        let (width, pixels) = (size.width() as usize, size.width() as usize * size.height() as usize);
        let limit = if args.limit > 0.0 { Limit::Within(args.limit) } else { Limit::Identical };
        let measures = pair.measure(width, limit);
        let channels = 3.0 * pixels as f64;
        let rmse = (measures.squares / channels).sqrt();
        let share = |count: usize| PixelShare { pixels: count, share: count as f64 / pixels as f64 };
        let over_limit = share(measures.over_limit);
        ComparisonReport {
            first: args.first.display().to_string(),
            second: args.second.display().to_string(),
            width: size.width(),
            height: size.height(),
            identical: measures.differing == 0,
            equal: over_limit.share <= args.limit_share,
            limit: args.limit,
            limit_share: args.limit_share,
            largest: PeakLocation::of(measures.peak),
            mean_absolute: measures.absolute / channels,
            rmse,
            psnr: (rmse > 0.0).then(|| -20.0 * libm::log10(rmse)),
            ssim: pair.ssim(size),
            differing: share(measures.differing),
            beyond: share(measures.beyond),
            over_limit,
            largest_linear: pair.linear_peak(width).and_then(PeakLocation::of),
        }
    }

    /// The report as JSON.
    pub fn to_json(&self) -> String {
        let mut json = serde_json::to_string_pretty(self).unwrap_or_default();
        json.push('\n');
        json
    }

    /// The report as text.
    pub fn to_text(&self) -> String {
        let answer = match (self.identical, self.equal) {
            (true, _) => "identical",
            (_, true) => "equal within the limit",
            _ => "different",
        };
        let mut text =
            format!("{} and {}  {} x {}, {answer}\n", self.first, self.second, self.width, self.height);
        let mut line = |label: &str, value: String| {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {label:<11}{value}");
        };
        if self.identical {
            return text;
        }
        line("differing", format!("{}, {} by more than 1/255", self.differing, self.beyond));
        if self.limit > 0.0 || self.limit_share > 0.0 {
            let allowed = if self.limit_share > 0.0 {
                format!(" ({} % allowed)", percent(self.limit_share))
            } else {
                String::new()
            };
            line(
                "limit",
                format!("{} by more than {}{allowed}", self.over_limit, three_significant_digits(self.limit)),
            );
        }
        if let Some(largest) = &self.largest {
            let difference = largest.difference.unwrap_or(1.0);
            let steps = three_significant_digits(difference * 255.0);
            line(
                "largest",
                format!("{} ({steps} of 255) {}", three_significant_digits(difference), largest.location()),
            );
        }
        if let Some(largest) = &self.largest_linear {
            let difference = largest.difference.map_or("infinite".into(), three_significant_digits);
            line("linear", format!("at most {difference}, {}", largest.location()));
        }
        line("mean", three_significant_digits(self.mean_absolute));
        let psnr = self.psnr.map_or(String::new(), |psnr| format!(" (PSNR {psnr:.1} dB)"));
        line("RMSE", format!("{}{psnr}", three_significant_digits(self.rmse)));
        // Not rounded up to 1, which is identical.
        line("SSIM", format!("{:.6}", (self.ssim * 1e6).floor() / 1e6));
        text
    }
}

impl PeakLocation {
    fn of(peak: Peak) -> Option<Self> {
        let Peak { difference, x, y, channel } = peak;
        let finite = difference.is_finite().then_some(difference);
        (difference > 0.0).then_some(PeakLocation { difference: finite, x, y, channel })
    }

    fn location(&self) -> String {
        format!("at {},{} in {}", self.x, self.y, self.channel.name())
    }
}

impl std::fmt::Display for PixelShare {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({} %)", quantity(self.pixels, "pixel"), percent(self.share))
    }
}

/// A share in percent with three significant digits, but 100 only for exactly 1.
fn percent(share: f64) -> String {
    let text = three_significant_digits(share * 100.0);
    if text != "100" || share == 1.0 {
        return text;
    }
    let mut longer = (2..=15).map(|digits| format!("{:.digits$}", share * 100.0));
    longer.find(|text| !text.starts_with("100")).unwrap_or(text)
}

/// Column of the text of a line, after its label.
pub const INDENT: usize = 13;

/// A number with three significant digits.
fn three_significant_digits(number: f64) -> String {
    if number == 0.0 {
        return "0".into();
    }
    let magnitude = libm::floor(libm::log10(number.abs())) as i32;
    if magnitude < -6 {
        return format!("{number:.2e}");
    }
    let text = format!("{number:.*}", (2 - magnitude).max(0) as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::{percent, three_significant_digits};

    #[test]
    fn only_exactly_one_is_100_percent_and_tiny_shares_are_not_0() {
        let shares = [0.0, 1.0, 307_197.0 / 307_200.0, 0.9996, 0.99949, 1.0 - 1e-9, 1e-9, 0.5];
        let texts = ["0", "100", "99.999", "99.96", "99.9", "99.9999999", "1.00e-7", "50"];
        assert_eq!(shares.map(percent), texts);
    }

    #[test]
    fn numbers_have_three_significant_digits() {
        let numbers = [0.0, 1.0, 0.5, 1.0 / 3.0, 12.345, 254.7, 98765.0, 0.000_123_456, 1.0e-9];
        let texts = ["0", "1", "0.5", "0.333", "12.3", "255", "98765", "0.000123", "1.00e-9"];
        assert_eq!(numbers.map(three_significant_digits), texts);
    }
}
