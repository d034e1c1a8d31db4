//! Which settings are looked at for the cheapest that keep an error.

use strahl_settings::{
    ConfidenceSettings, ContrastSettings, Filter, SamplerSettings, SelectionSettings, Settings,
};

/// Levels that are tried.
pub const LEVELS: [u8; 15] = [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64];

/// One over the cutoffs that are tried.
const CUTOFFS: [u16; 10] = [8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/// The cutoffs that are tried, from the largest.
pub fn cutoffs() -> impl Iterator<Item = f32> {
    CUTOFFS.into_iter().map(|part| 1.0 / f32::from(part))
}

/// So many times the rays cost at least this many times as much.
pub const SAVES: f64 = 0.9;

/// Which rays make pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rays {
    /// In a pixel.
    pub sampler: SamplerSettings,
    /// Which pixels are traced, where not all are.
    pub select: Option<SelectionSettings>,
}

impl Rays {
    /// In every pixel.
    const fn all(sampler: SamplerSettings) -> Self {
        Rays { sampler, select: None }
    }

    /// The same settings with these rays.
    pub fn apply(self, settings: &Settings) -> Settings {
        Settings { sampler: self.sampler, select: self.select, ..settings.clone() }
    }

    /// How many there are in each pixel, where that is known before.
    pub fn count(self) -> Option<u32> {
        match self {
            Rays { select: Some(_), .. } => None,
            Rays { sampler: SamplerSettings::Single, .. } => Some(1),
            Rays { sampler: SamplerSettings::Regular(n), .. } => Some(u32::from(n) * u32::from(n)),
            Rays {
                sampler: SamplerSettings::Stochastic { min_samples: least, max_samples: most, .. },
                ..
            } if least == most => Some(most),
            _ => None,
        }
    }

    /// How many there are in each pixel at least, where all pixels are traced.
    fn least(self) -> Option<u32> {
        match self {
            Rays { select: Some(_), .. } => None,
            // Corners are shared by neighbours.
            Rays { sampler: SamplerSettings::Adaptive { .. }, .. } => Some(1),
            Rays { sampler: SamplerSettings::Stochastic { min_samples: least, .. }, .. } => Some(least),
            _ => self.count(),
        }
    }

    /// How many times those of another there are at least; none where that is not known.
    pub fn times(self, other: Rays) -> Option<f64> {
        if let (Some(least), Some(count)) = (self.least(), other.count()) {
            return Some(f64::from(least) / f64::from(count));
        }
        let is_more = match (self, other) {
            (Rays { select: Some(a), .. }, Rays { select: Some(b), .. }) => {
                a.step <= b.step && a.contrast.threshold <= b.contrast.threshold
            }
            (Rays { select: Some(_), .. }, _) | (_, Rays { select: Some(_), .. }) => false,
            (Rays { sampler: a, .. }, Rays { sampler: b, .. }) => is_finer(a, b),
        };
        is_more.then_some(1.0)
    }
}

/// Whether all rays of the one are sent by the other too: both adaptive, or both stochastic.
fn is_finer(a: SamplerSettings, b: SamplerSettings) -> bool {
    match (a, b) {
        (
            SamplerSettings::Adaptive { max_depth: depth, contrast: agreement },
            SamplerSettings::Adaptive { max_depth: other, contrast: ContrastSettings { threshold, .. } },
        ) => depth >= other && agreement.threshold <= threshold,
        (
            SamplerSettings::Stochastic { min_samples: least, max_samples: most, confidence },
            SamplerSettings::Stochastic {
                min_samples: other,
                max_samples: bound,
                confidence: ConfidenceSettings { confidence: level, tolerance },
            },
        ) => {
            least >= other
                && most >= bound
                && confidence.confidence >= level
                && confidence.tolerance <= tolerance
        }
        _ => false,
    }
}

/// All that may be tried for an error, about from the cheapest on.
pub fn rays(filter: Filter, goal: f64) -> Vec<Rays> {
    let agreement = |threshold| ContrastSettings { threshold, items: false };
    let selected = |(step, threshold)| Rays {
        sampler: SamplerSettings::Single,
        select: Some(SelectionSettings { step, contrast: agreement(threshold) }),
    };
    let adaptive = |(depth, threshold)| {
        Rays::all(SamplerSettings::Adaptive { max_depth: depth, contrast: agreement(threshold) })
    };
    let ruled = |(least, most, level, tolerance)| {
        Rays::all(SamplerSettings::Stochastic {
            min_samples: least,
            max_samples: most,
            confidence: ConfidenceSettings { confidence: level, tolerance },
        })
    };
    let mut list: Vec<Rays> =
        [(16, 0.2), (8, 0.2), (8, 0.1), (8, 0.05), (4, 0.1), (4, 0.05), (2, 0.05), (2, 0.02)]
            .map(selected)
            .to_vec();
    list.push(Rays::all(SamplerSettings::Single));
    if filter == Filter::Box {
        list.extend(
            [
                (0, 0.0),
                (1, 0.3),
                (1, 0.2),
                (1, 0.1),
                (1, 0.05),
                (2, 0.4),
                (2, 0.3),
                (2, 0.2),
                (2, 0.1),
                (2, 0.05),
                (2, 0.02),
                (3, 0.1),
                (3, 0.05),
                (3, 0.02),
                (4, 0.05),
                (4, 0.02),
                (4, 0.01),
                (5, 0.02),
                (5, 0.01),
            ]
            .map(adaptive),
        );
    }
    // Tolerances about the error: pixels whose rays all see the same make up for the others.
    for part in [8.0, 5.0, 3.5, 2.5, 1.75, 1.25] {
        let tolerance = format!("{:.1e}", (part * goal).min(1.0)).parse().unwrap_or(1.0);
        list.extend([2, 4, 8].map(|least| ruled((least, 4096, 0.9, tolerance))));
    }
    let mut counted: Vec<Rays> = (2..=12).map(|n| Rays::all(SamplerSettings::Regular(n))).collect();
    counted.extend(
        [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048]
            .map(|n| Rays::all(SamplerSettings::stochastic(n))),
    );
    counted.sort_by_key(|rays| rays.count());
    list.extend(counted);
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_sends_more_rays_is_known_for_what_can_be_compared() {
        let of = |words: &str| Rays::all(words.parse().unwrap());
        let times = |more: &str, than: &str| of(more).times(of(than));
        assert_eq!(times("regular:3", "single"), Some(9.0));
        assert_eq!(times("stochastic:8", "regular:2"), Some(2.0));
        assert_eq!(times("stochastic:4..4096:0.9:0.1", "single"), Some(4.0));
        assert_eq!(times("adaptive:3:0.05", "single"), Some(1.0));
        assert_eq!(times("adaptive:3:0.05", "adaptive:2:0.1"), Some(1.0));
        assert_eq!(times("stochastic:4..4096:0.9:0.1", "stochastic:2..4096:0.9:0.2"), Some(1.0));
        // Deeper, but less often.
        assert_eq!(times("adaptive:3:0.2", "adaptive:2:0.1"), None);
        assert_eq!(times("single", "adaptive:0:0"), None);
        let mut selected = of("single");
        selected.select = Some("8:0.1".parse().unwrap());
        assert_eq!((selected.times(of("single")), of("single").times(selected)), (None, None));
    }
}
