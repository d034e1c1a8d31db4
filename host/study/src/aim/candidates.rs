//! Candidates for levels, cutoffs, samplers and pixel selection.

use strahl_settings::{
    ConfidenceSettings, ContrastSettings, Filter, SamplerSettings, SelectionSettings, Settings,
};

/// Candidates for levels.
pub const LEVEL_STEPS: [u8; 15] = [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64];

/// Inverse of the candidates for the cutoff.
const INVERSE_CUTOFFS: [u16; 10] = [8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/// Candidates for the cutoff, largest first.
pub fn cutoff_steps() -> impl Iterator<Item = f32> {
    INVERSE_CUTOFFS.into_iter().map(|part| 1.0 / f32::from(part))
}

/// `n` times the rays cost at least this times `n`.
pub const MIN_COST_RATIO: f64 = 0.9;

/// Which rays are traced for a pixel, and which pixels are traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplingStrategy {
    /// The rays in a pixel.
    pub sampler: SamplerSettings,
    /// Pixel selection; `None`: all pixels are traced.
    pub select: Option<SelectionSettings>,
}

impl SamplingStrategy {
    /// The sampler in every pixel.
    const fn all(sampler: SamplerSettings) -> Self {
        SamplingStrategy { sampler, select: None }
    }

    /// The settings with this strategy.
    pub fn apply_to(self, settings: &Settings) -> Settings {
        Settings { sampler: self.sampler, select: self.select, ..settings.clone() }
    }

    /// Number of rays per pixel, if it does not depend on the picture.
    pub fn fixed_rays_per_pixel(self) -> Option<u32> {
        match self {
            SamplingStrategy { select: Some(_), .. } => None,
            SamplingStrategy { sampler: SamplerSettings::Single, .. } => Some(1),
            SamplingStrategy { sampler: SamplerSettings::Regular(n), .. } => {
                Some(u32::from(n) * u32::from(n))
            }
            SamplingStrategy {
                sampler: SamplerSettings::Stochastic { min_samples: least, max_samples: most, .. },
                ..
            } if least == most => Some(most),
            _ => None,
        }
    }

    /// Minimum number of rays per pixel, if all pixels are traced.
    fn min_rays_per_pixel(self) -> Option<u32> {
        match self {
            SamplingStrategy { select: Some(_), .. } => None,
            // Neighbors share corners.
            SamplingStrategy { sampler: SamplerSettings::Adaptive { .. }, .. } => Some(1),
            SamplingStrategy { sampler: SamplerSettings::Stochastic { min_samples: least, .. }, .. } => {
                Some(least)
            }
            _ => self.fixed_rays_per_pixel(),
        }
    }

    /// Minimum ratio of the number of rays to that of `other`; `None` if unknown.
    pub fn min_ray_ratio(self, other: SamplingStrategy) -> Option<f64> {
        if let (Some(least), Some(count)) = (self.min_rays_per_pixel(), other.fixed_rays_per_pixel()) {
            return Some(f64::from(least) / f64::from(count));
        }
        let is_more = match (self, other) {
            (SamplingStrategy { select: Some(a), .. }, SamplingStrategy { select: Some(b), .. }) => {
                a.step <= b.step && a.contrast.threshold <= b.contrast.threshold
            }
            (SamplingStrategy { select: Some(_), .. }, _) | (_, SamplingStrategy { select: Some(_), .. }) => {
                false
            }
            (SamplingStrategy { sampler: a, .. }, SamplingStrategy { sampler: b, .. }) => refines(a, b),
        };
        is_more.then_some(1.0)
    }
}

/// Whether `a` traces all rays of `b`: both adaptive, or both stochastic.
fn refines(a: SamplerSettings, b: SamplerSettings) -> bool {
    match (a, b) {
        (
            SamplerSettings::Adaptive { max_depth: depth, contrast },
            SamplerSettings::Adaptive { max_depth: other, contrast: ContrastSettings { threshold, .. } },
        ) => depth >= other && contrast.threshold <= threshold,
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

/// All candidates for a target error, roughly from cheap to expensive.
pub fn sampling_strategies(filter: Filter, goal: f64) -> Vec<SamplingStrategy> {
    let contrast = |threshold| ContrastSettings { threshold, items: false };
    let selected = |(step, threshold)| SamplingStrategy {
        sampler: SamplerSettings::Single,
        select: Some(SelectionSettings { step, contrast: contrast(threshold) }),
    };
    let adaptive = |(depth, threshold)| {
        SamplingStrategy::all(SamplerSettings::Adaptive { max_depth: depth, contrast: contrast(threshold) })
    };
    let stopping = |(min_samples, max_samples, confidence, tolerance)| {
        SamplingStrategy::all(SamplerSettings::Stochastic {
            min_samples,
            max_samples,
            confidence: ConfidenceSettings { confidence, tolerance },
        })
    };
    let mut list: Vec<SamplingStrategy> =
        [(16, 0.2), (8, 0.2), (8, 0.1), (8, 0.05), (4, 0.1), (4, 0.05), (2, 0.05), (2, 0.02)]
            .map(selected)
            .to_vec();
    list.push(SamplingStrategy::all(SamplerSettings::Single));
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
    // Tolerances above the error: uniform pixels have less than the tolerance.
    for part in [8.0, 5.0, 3.5, 2.5, 1.75, 1.25] {
        let tolerance = format!("{:.1e}", (part * goal).min(1.0)).parse().unwrap_or(1.0);
        list.extend([2, 4, 8].map(|min_samples| stopping((min_samples, 4096, 0.9, tolerance))));
    }
    let mut counted: Vec<SamplingStrategy> =
        (2..=12).map(|n| SamplingStrategy::all(SamplerSettings::Regular(n))).collect();
    counted.extend(
        [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048]
            .map(|n| SamplingStrategy::all(SamplerSettings::stochastic(n))),
    );
    counted.sort_by_key(|rays| rays.fixed_rays_per_pixel());
    list.extend(counted);
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ray_ratio_is_known_for_comparable_strategies() {
        let of = |words: &str| SamplingStrategy::all(words.parse().unwrap());
        let times = |more: &str, than: &str| of(more).min_ray_ratio(of(than));
        assert_eq!(times("regular:3", "single"), Some(9.0));
        assert_eq!(times("stochastic:8", "regular:2"), Some(2.0));
        assert_eq!(times("stochastic:4..4096:0.9:0.1", "single"), Some(4.0));
        assert_eq!(times("adaptive:3:0.05", "single"), Some(1.0));
        assert_eq!(times("adaptive:3:0.05", "adaptive:2:0.1"), Some(1.0));
        assert_eq!(times("stochastic:4..4096:0.9:0.1", "stochastic:2..4096:0.9:0.2"), Some(1.0));
        // Deeper, but less sensitive.
        assert_eq!(times("adaptive:3:0.2", "adaptive:2:0.1"), None);
        assert_eq!(times("single", "adaptive:0:0"), None);
        let mut selected = of("single");
        selected.select = Some("8:0.1".parse().unwrap());
        assert_eq!(
            (selected.min_ray_ratio(of("single")), of("single").min_ray_ratio(selected)),
            (None, None)
        );
    }
}
