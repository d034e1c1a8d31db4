//! Settings of the sampling of pixels, and of the selection of pixels.

use std::fmt;
use std::str::FromStr;

use strahl_core::image::{PixelSelection, RegularSampler, StochasticSampler, Subdivision};

use crate::choices;

/// The sampling pattern of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SamplerSettings {
    /// One ray through the center.
    Single,
    /// A grid of n x n rays.
    Regular(u16),
    /// The four corners, with recursive subdivision where they differ.
    Adaptive {
        /// The maximum number of subdivisions.
        max_depth: u8,
        /// The contrast above which a pixel is subdivided.
        contrast: ContrastSettings,
    },
    /// Quasi-random samples.
    Stochastic {
        /// The minimum number of samples.
        min_samples: u32,
        /// The maximum number of samples.
        max_samples: u32,
        /// When sampling stops before the maximum.
        confidence: ConfidenceSettings,
    },
}

/// A contrast threshold: when neighboring samples count as equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContrastSettings {
    /// The largest difference of sRGB-encoded channels, in `[0, 1]`.
    pub threshold: f32,
    /// Whether they must also hit the same item.
    pub items: bool,
}

/// When the mean of a pixel's samples is accurate enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConfidenceSettings {
    /// The confidence level, in `(0, 1)`.
    pub confidence: f64,
    /// The largest error of the mean, sRGB-encoded, in `[0, 1]`.
    pub tolerance: f32,
}

/// The selection of pixels that are traced; the others are interpolated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelectionSettings {
    /// The distance of pixels that are traced first: 2, 4, 8, 16, 32 or 64.
    pub step: u32,
    /// The contrast up to which the pixels between are interpolated.
    pub contrast: ContrastSettings,
}

choices! {
    /// The reconstruction filter of a pixel.
    pub enum Filter {
        /// The pixel itself.
        Box = "box",
        /// Tent with a radius of one pixel.
        Tent = "tent",
        /// Gaussian with a deviation of 0.5 pixels, cut off at 1.5.
        Gaussian = "gaussian",
    }
}

/// The default tolerance of the mean: two 8-bit steps.
const DEFAULT_TOLERANCE: f32 = 1.0 / 128.0;

impl SamplerSettings {
    /// The four corners only, which neighboring pixels share.
    pub const CORNERS: SamplerSettings = SamplerSettings::Adaptive {
        max_depth: 0,
        contrast: ContrastSettings { threshold: 0.0, items: false },
    };

    /// Exactly `n` samples.
    pub const fn stochastic(n: u32) -> Self {
        let confidence = ConfidenceSettings { confidence: 0.5, tolerance: 0.0 };
        SamplerSettings::Stochastic { min_samples: n, max_samples: n, confidence }
    }

    /// Whether filters other than box can be used: adaptive supersampling supports only box.
    pub fn allows_filter(&self) -> bool {
        !matches!(self, SamplerSettings::Adaptive { .. })
    }
}

impl ConfidenceSettings {
    /// The half width, in standard errors, of the confidence interval of a normal distribution.
    pub fn standard_errors(&self) -> f64 {
        // The probability inside grows with the width: bisection.
        let (mut low, mut high) = (0.0, 10.0);
        for _ in 0..60 {
            let mid = 0.5 * (low + high);
            let inside = libm::erf(mid * std::f64::consts::FRAC_1_SQRT_2);
            if inside < self.confidence { low = mid } else { high = mid }
        }
        high
    }
}

fn threshold(text: &str) -> Option<f32> {
    let value = match text.split_once('/') {
        Some((part, whole)) => part.parse::<f32>().ok()? / whole.parse::<f32>().ok()?,
        None => text.parse().ok()?,
    };
    (value >= 0.0 && value <= 1.0).then_some(value)
}

/// `THRESHOLD` or `THRESHOLD:items`.
fn contrast_settings(words: &[&str]) -> Result<ContrastSettings, String> {
    let (text, items) = match words {
        [text] => (text, false),
        [text, "items"] => (text, true),
        [_, other, ..] => return Err(format!("only `items` may follow the threshold, not `{other}`")),
        [] => return Err("the threshold is missing".into()),
    };
    match threshold(text) {
        Some(threshold) => Ok(ContrastSettings { threshold, items }),
        None => Err("THRESHOLD must be 0 to 1, as in 0.05 or 1/32".into()),
    }
}

fn stochastic(words: &[&str]) -> Result<SamplerSettings, String> {
    let count = |text: &str| text.parse::<u32>().ok().filter(|n| StochasticSampler::new(*n).is_some());
    let most = StochasticSampler::MAX_SAMPLES;
    if let [n] = words
        && !n.contains("..")
    {
        let out_of_range = || format!("in stochastic:N, N must be 1 to {most}");
        return count(n).map(SamplerSettings::stochastic).ok_or_else(out_of_range);
    }
    let (range, level, tolerance) = match *words {
        [range, level] => (range, level, Some(DEFAULT_TOLERANCE)),
        [range, level, tolerance] => (range, level, threshold(tolerance)),
        _ => return Err("must be stochastic:N or stochastic:MIN..MAX:CONFIDENCE".into()),
    };
    let (least, most) = range
        .split_once("..")
        .and_then(|(least, most)| Some((count(least)?, count(most)?)))
        .filter(|(least, most)| least <= most)
        .ok_or_else(|| {
            format!("in stochastic:MIN..MAX, MIN and MAX must be 1 to {most}, and MIN at most MAX")
        })?;
    let level = level.parse::<f64>().ok().filter(|level| *level > 0.0 && *level < 1.0);
    let level = level.ok_or("CONFIDENCE must be more than 0 and less than 1, as in 0.95")?;
    let tolerance = tolerance.ok_or("the tolerance must be 0 to 1, as in 1/128")?;
    Ok(SamplerSettings::Stochastic {
        min_samples: least,
        max_samples: most,
        confidence: ConfidenceSettings { confidence: level, tolerance },
    })
}

impl FromStr for SamplerSettings {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut words = text.split(':');
        let (kind, rest): (_, Vec<_>) = (words.next().unwrap_or_default(), words.collect());
        match (kind, rest.as_slice()) {
            ("single", []) => Ok(SamplerSettings::Single),
            ("regular", [n]) => match n.parse::<u16>() {
                Ok(n) if RegularSampler::new(n).is_some() => Ok(SamplerSettings::Regular(n)),
                _ => Err(format!("in regular:N, N must be 1 to {}", RegularSampler::MAX_CELLS_PER_SIDE)),
            },
            ("adaptive", [depth, rest @ ..]) => match depth.parse::<u8>() {
                Ok(depth) if depth <= Subdivision::MAX_DEPTH => {
                    Ok(SamplerSettings::Adaptive { max_depth: depth, contrast: contrast_settings(rest)? })
                }
                _ => {
                    Err(format!("in adaptive:DEPTH:THRESHOLD, DEPTH must be 0 to {}", Subdivision::MAX_DEPTH))
                }
            },
            ("stochastic", rest) => stochastic(rest),
            _ => Err("must be single, regular:N, adaptive:DEPTH:THRESHOLD[:items], stochastic:N or \
                 stochastic:MIN..MAX:CONFIDENCE[:TOLERANCE]"
                .into()),
        }
    }
}

impl FromStr for SelectionSettings {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut words = text.split(':');
        let step = words.next().and_then(|step| step.parse::<u32>().ok());
        let is_step = |step: &u32| step.is_power_of_two() && *step >= 2 && *step <= PixelSelection::MAX_STEP;
        let step = step.filter(is_step).ok_or("in STEP:THRESHOLD, STEP must be 2, 4, 8, 16, 32 or 64")?;
        Ok(SelectionSettings { step, contrast: contrast_settings(&words.collect::<Vec<_>>())? })
    }
}

impl fmt::Display for ContrastSettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.threshold, if self.items { ":items" } else { "" })
    }
}

/// Formats the option value.
impl fmt::Display for SamplerSettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SamplerSettings::Single => f.write_str("single"),
            SamplerSettings::Regular(n) => write!(f, "regular:{n}"),
            SamplerSettings::Adaptive { max_depth: depth, contrast } => {
                write!(f, "adaptive:{depth}:{contrast}")
            }
            SamplerSettings::Stochastic { min_samples: least, max_samples: most, .. } if least == most => {
                write!(f, "stochastic:{most}")
            }
            SamplerSettings::Stochastic {
                min_samples: least,
                max_samples: most,
                confidence: ConfidenceSettings { confidence: level, tolerance },
            } => {
                write!(f, "stochastic:{least}..{most}:{level}:{tolerance}")
            }
        }
    }
}

/// Formats the option value.
impl fmt::Display for SelectionSettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.step, self.contrast)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn option_values_read_back_equal() {
        for text in [
            "single",
            "regular:3",
            "adaptive:0:0",
            "adaptive:3:0.05",
            "adaptive:4:0.1:items",
            "stochastic:16",
            "stochastic:8..256:0.95:0.01",
        ] {
            let sampling: SamplerSettings = text.parse().unwrap();
            assert_eq!(sampling.to_string(), text);
        }
        let selecting: SelectionSettings = "8:0.05:items".parse().unwrap();
        assert_eq!(selecting.to_string(), "8:0.05:items");
        assert_eq!("adaptive:3:1/32".parse(), "adaptive:3:0.03125".parse::<SamplerSettings>());
    }

    #[test]
    fn invalid_option_values_are_rejected_with_the_valid_ones() {
        for (text, says) in [
            ("regular:0", "must be 1 to 256"),
            ("adaptive:7:0", "0 to 6"),
            ("adaptive:2", "threshold is missing"),
            ("adaptive:2:1.5", "must be 0 to 1"),
            ("adaptive:2:0:objects", "`items`"),
            ("stochastic:0", "must be 1 to 65536"),
            ("stochastic", "stochastic:N"),
            ("stochastic:9..8:0.9", "MIN at most MAX"),
            ("stochastic:8..9", "CONFIDENCE"),
            ("stochastic:8..9:1", "less than 1"),
            ("stochastic:8..9:0.9:2", "tolerance"),
            ("stratified:4", "single, regular:N"),
        ] {
            let error = text.parse::<SamplerSettings>().unwrap_err();
            assert!(error.contains(says), "{text}: {error}");
        }
        for (text, says) in [("3:0.1", "STEP"), ("8", "missing"), ("128:0", "STEP"), ("8:x", "THRESHOLD")] {
            let error = text.parse::<SelectionSettings>().unwrap_err();
            assert!(error.contains(says), "{text}: {error}");
        }
    }

    #[test]
    fn confidence_levels_give_the_known_numbers_of_standard_errors() {
        // From tables of the normal distribution.
        for (level, errors) in [(0.682_689_5, 1.0), (0.95, 1.959_964), (0.99, 2.575_829)] {
            let got = ConfidenceSettings { confidence: level, tolerance: 0.0 }.standard_errors();
            assert!((got - errors).abs() < 1e-6, "{got}");
        }
    }
}
