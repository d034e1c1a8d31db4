//! Which rays make a pixel, and which pixels are traced.

use std::fmt;
use std::str::FromStr;

use strahl_core::image::{RegularSampler, Selection, StochasticSampler, Subdivision};

use crate::choices;

/// Which rays make a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SamplerSettings {
    /// One through the middle.
    Single,
    /// n times n.
    Regular(u16),
    /// Through the corners, and more where they do not agree.
    Adaptive {
        /// How often a pixel can be quartered.
        max_depth: u8,
        /// When it is not.
        contrast: ContrastSettings,
    },
    /// Through places that follow no raster.
    Stochastic {
        /// The least number.
        min_samples: u32,
        /// The largest number.
        max_samples: u32,
        /// When it may be less than that.
        confidence: ConfidenceSettings,
    },
}

/// When neighbours are taken to look the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContrastSettings {
    /// The largest difference of sRGB-encoded channels, in `0..=1`.
    pub threshold: f32,
    /// Whether they must be of the same item, too.
    pub items: bool,
}

/// When a pixel is known well enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConfidenceSettings {
    /// How sure that is to be, between 0 and 1.
    pub confidence: f64,
    /// How far off the mean may be: sRGB-encoded, in `0..=1`.
    pub tolerance: f32,
}

/// Which pixels are traced, where not all are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelectionSettings {
    /// The distance of those that are traced first: 2, 4, 8, 16, 32 or 64.
    pub step: u32,
    /// When those between are guessed.
    pub contrast: ContrastSettings,
}

choices! {
    /// How much of its surroundings counts in a pixel.
    pub enum Filter {
        /// Nothing but the pixel.
        Box = "box",
        /// Up to the next pixels, the less the farther.
        Tent = "tent",
        /// Up to one pixel and a half, by a normal distribution.
        Gaussian = "gaussian",
    }
}

/// The mean may be two steps of eight bits off.
const DEFAULT_TOLERANCE: f32 = 1.0 / 128.0;

impl SamplerSettings {
    /// The corners alone, which neighbours share.
    pub const CORNERS: SamplerSettings = SamplerSettings::Adaptive {
        max_depth: 0,
        contrast: ContrastSettings { threshold: 0.0, items: false },
    };

    /// This many rays, whatever they see.
    pub const fn stochastic(n: u32) -> Self {
        let confidence = ConfidenceSettings { confidence: 0.5, tolerance: 0.0 };
        SamplerSettings::Stochastic { min_samples: n, max_samples: n, confidence }
    }

    /// Whether a filter can go with it: adaptive supersampling fills the pixel by itself.
    pub fn allows_filter(&self) -> bool {
        !matches!(self, SamplerSettings::Adaptive { .. })
    }
}

impl ConfidenceSettings {
    /// How many standard errors an interval reaches to both sides, in which a normal
    /// distribution lies with this confidence.
    pub fn standard_errors(&self) -> f64 {
        // What lies inside grows with the width, so that halving finds it.
        let (mut low, mut high) = (0.0, 10.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let inside = libm::erf(middle * std::f64::consts::FRAC_1_SQRT_2);
            if inside < self.confidence { low = middle } else { high = middle }
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
fn agreement(words: &[&str]) -> Result<ContrastSettings, String> {
    let (text, items) = match words {
        [text] => (text, false),
        [text, "items"] => (text, true),
        [_, other, ..] => return Err(format!("after the threshold comes `items` or nothing, not `{other}`")),
        [] => return Err("the threshold is missing".into()),
    };
    match threshold(text) {
        Some(threshold) => Ok(ContrastSettings { threshold, items }),
        None => Err("THRESHOLD must be between 0 and 1, as in 0.05 or 1/32".into()),
    }
}

fn stochastic(words: &[&str]) -> Result<SamplerSettings, String> {
    let count = |text: &str| text.parse::<u32>().ok().filter(|n| StochasticSampler::new(*n).is_some());
    let most = StochasticSampler::MAX_SAMPLES;
    if let [n] = words
        && !n.contains("..")
    {
        let wrong = || format!("in stochastic:N, N must be between 1 and {most}");
        return count(n).map(SamplerSettings::stochastic).ok_or_else(wrong);
    }
    let (range, level, tolerance) = match *words {
        [range, level] => (range, level, Some(DEFAULT_TOLERANCE)),
        [range, level, tolerance] => (range, level, threshold(tolerance)),
        _ => return Err("stochastic:N or stochastic:MIN..MAX:CONFIDENCE is expected".into()),
    };
    let (least, most) = range
        .split_once("..")
        .and_then(|(least, most)| Some((count(least)?, count(most)?)))
        .filter(|(least, most)| least <= most)
        .ok_or_else(|| {
            format!("in stochastic:MIN..MAX, MIN and MAX must be between 1 and {most}, MIN first")
        })?;
    let level = level.parse::<f64>().ok().filter(|level| *level > 0.0 && *level < 1.0);
    let level = level.ok_or("CONFIDENCE must be more than 0 and less than 1, as in 0.95")?;
    let tolerance = tolerance.ok_or("the tolerance must be between 0 and 1, as in 1/128")?;
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
                _ => Err(format!("in regular:N, N must be between 1 and {}", RegularSampler::MAX_CELLS)),
            },
            ("adaptive", [depth, rest @ ..]) => match depth.parse::<u8>() {
                Ok(depth) if depth <= Subdivision::MAX_DEPTH => {
                    Ok(SamplerSettings::Adaptive { max_depth: depth, contrast: agreement(rest)? })
                }
                _ => {
                    Err(format!("in adaptive:DEPTH:THRESHOLD, DEPTH must be 0 to {}", Subdivision::MAX_DEPTH))
                }
            },
            ("stochastic", rest) => stochastic(rest),
            _ => Err("single, regular:N, adaptive:DEPTH:THRESHOLD[:items], stochastic:N or \
                 stochastic:MIN..MAX:CONFIDENCE[:TOLERANCE] is expected"
                .into()),
        }
    }
}

impl FromStr for SelectionSettings {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut words = text.split(':');
        let step = words.next().and_then(|step| step.parse::<u32>().ok());
        let is_step = |step: &u32| step.is_power_of_two() && *step >= 2 && *step <= Selection::MAX_STEP;
        let step = step.filter(is_step).ok_or("in STEP:THRESHOLD, STEP must be 2, 4, 8, 16, 32 or 64")?;
        Ok(SelectionSettings { step, contrast: agreement(&words.collect::<Vec<_>>())? })
    }
}

impl fmt::Display for ContrastSettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.threshold, if self.items { ":items" } else { "" })
    }
}

/// As the command line has it.
impl fmt::Display for SamplerSettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SamplerSettings::Single => f.write_str("single"),
            SamplerSettings::Regular(n) => write!(f, "regular:{n}"),
            SamplerSettings::Adaptive { max_depth: depth, contrast: agreement } => {
                write!(f, "adaptive:{depth}:{agreement}")
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

/// As the command line has it.
impl fmt::Display for SelectionSettings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.step, self.contrast)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shown_reads_back_as_the_same() {
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
    fn what_makes_no_sense_is_refused_with_what_would() {
        for (text, says) in [
            ("regular:0", "between 1 and 256"),
            ("adaptive:7:0", "0 to 6"),
            ("adaptive:2", "threshold is missing"),
            ("adaptive:2:1.5", "between 0 and 1"),
            ("adaptive:2:0:objects", "`items`"),
            ("stochastic:0", "between 1 and 65536"),
            ("stochastic", "stochastic:N"),
            ("stochastic:9..8:0.9", "MIN first"),
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
    fn confidence_is_told_in_standard_errors() {
        // From every table of the normal distribution.
        for (level, errors) in [(0.682_689_5, 1.0), (0.95, 1.959_964), (0.99, 2.575_829)] {
            let got = ConfidenceSettings { confidence: level, tolerance: 0.0 }.standard_errors();
            assert!((got - errors).abs() < 1e-6, "{got}");
        }
    }
}
