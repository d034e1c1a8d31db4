//! The plan of a study: the values of each setting, and the share of the time for each part.

use strahl_core::Limits;
use strahl_settings::{ContrastSettings, Filter, Precision, SamplerSettings, SelectionSettings, Settings};

/// How thorough a study is.
#[derive(Clone, Copy, Debug)]
pub struct StudyPlan {
    /// Its name.
    pub name: &'static str,
    /// Minimum and maximum samples per pixel of the reference.
    pub reference: [u32; 2],
    /// Samples of the stochastic sampler.
    pub stochastic: &'static [u32],
    /// Grid sizes of the regular sampler.
    pub regular: &'static [u16],
    /// Depths and thresholds of the adaptive sampler.
    pub adaptive: &'static [(u8, f32)],
    /// Stochastic samplers with a stopping rule.
    pub stochastic_stopping: &'static [&'static str],
    /// Inverse cutoffs.
    pub cutoffs: &'static [u16],
    /// Steps and thresholds of pixel selection.
    pub selections: &'static [(u32, f32)],
    /// Maximum number of combinations.
    pub combinations: usize,
    /// Maximum number of repetitions.
    pub repeats: usize,
}

/// Values for levels, used until the level limit discards nothing.
pub const LEVELS: [u8; 15] = [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64];

/// Cutoffs of the reference, used until they discard nothing. Even hundreds of rays below the last one change no bit of an
/// 8-bit picture.
pub const REFERENCE_CUTOFFS: [f32; 4] = [1.0 / 64.0, 1.0 / 512.0, 1.0 / 4096.0, 1.0 / 65536.0];

/// A negligible share of the light.
pub const NEGLIGIBLE_SHARE: f64 = 1e-4;

/// The reference has at least this many times the samples of a sampler that is compared with it.
pub const REFERENCE_SAMPLE_FACTOR: u32 = 4;

/// Shares of the time limit.
pub(super) mod time {
    /// For the probe that determines the size.
    pub const PROBE: f64 = 0.1;
    /// For the reference.
    pub const REFERENCE: f64 = 0.28;
    /// Maximum for the reference, if it takes longer than predicted.
    pub const REFERENCE_MAX: f64 = 0.6;
    /// For one setting.
    pub const SETTING: f64 = 0.05;
    /// For one technique.
    pub const TECHNIQUE: f64 = 0.05;
    /// End of the combinations.
    pub const COMBINATIONS_END: f64 = 0.72;
    /// End of the measurements; cost maps and the report follow.
    pub const MEASURING_END: f64 = 0.9;
    /// End of tracing.
    pub const TRACING_END: f64 = 0.96;
}

impl StudyPlan {
    /// Under a minute for 256 x 256 pixels on two cores.
    pub const QUICK: StudyPlan = StudyPlan {
        name: "quick",
        reference: [32, 1024],
        stochastic: &[4, 16, 64],
        regular: &[2, 3, 4, 6],
        adaptive: &[(0, 0.0), (2, 0.1), (3, 0.05)],
        stochastic_stopping: &["stochastic:4..64:0.9:0.02"],
        cutoffs: &[8, 32, 128, 512],
        selections: &[(8, 0.1), (4, 0.05)],
        combinations: 16,
        repeats: 5,
    };

    /// Without a time limit.
    pub const FULL: StudyPlan = StudyPlan {
        name: "full",
        reference: [256, 4096],
        stochastic: &[2, 4, 8, 16, 32, 64, 128, 256],
        regular: &[2, 3, 4, 5, 6, 8, 12],
        adaptive: &[(0, 0.0), (1, 0.1), (2, 0.1), (2, 0.03), (3, 0.1), (3, 0.03), (4, 0.05), (4, 0.01)],
        stochastic_stopping: &[
            "stochastic:4..64:0.9:0.02",
            "stochastic:8..256:0.9:0.01",
            "stochastic:16..256:0.95:0.005",
        ],
        cutoffs: &[4, 8, 16, 32, 64, 128, 256, 512, 1024, 4096],
        selections: &[(16, 0.1), (8, 0.1), (4, 0.1), (4, 0.05), (2, 0.05), (2, 0.02)],
        combinations: 60,
        repeats: 9,
    };

    /// The samplers except `single`, with the expected rays per pixel. Samplers that do not support the filter are left out.
    pub fn samplers(&self, filter: Filter) -> Vec<(SamplerSettings, f64)> {
        let contrast = |threshold| ContrastSettings { threshold, items: false };
        let regular =
            self.regular.iter().map(|n| (SamplerSettings::Regular(*n), f64::from(*n) * f64::from(*n)));
        let adaptive = self.adaptive.iter().map(|(depth, threshold)| {
            let most = libm::pow(4.0, f64::from(*depth));
            (
                SamplerSettings::Adaptive { max_depth: *depth, contrast: contrast(*threshold) },
                1.0 + 0.4 * (most - 1.0),
            )
        });
        let stochastic = self.stochastic.iter().map(|n| (SamplerSettings::stochastic(*n), f64::from(*n)));
        let stopping = self.stochastic_stopping.iter().filter_map(|text| {
            let sampling: SamplerSettings = text.parse().ok()?;
            Some((sampling, f64::from(max_rays_per_pixel(&sampling)) / 2.0))
        });
        let all = regular.chain(adaptive).chain(stochastic).chain(stopping);
        all.filter(|(sampling, _)| filter == Filter::Box || sampling.allows_filter()).collect()
    }

    /// The values for pixel selection.
    pub fn selections(&self) -> impl Iterator<Item = SelectionSettings> {
        let with = |(step, threshold): &(u32, f32)| SelectionSettings {
            step: *step,
            contrast: ContrastSettings { threshold: *threshold, items: true },
        };
        self.selections.iter().map(with)
    }

    /// The cutoffs, from coarse to fine.
    pub fn cutoffs(&self) -> impl Iterator<Item = f32> {
        self.cutoffs.iter().map(|whole| 1.0 / f32::from(*whole))
    }

    /// Approximate rays per pixel of all settings, each measured once, for a reference with `samples` samples per pixel.
    pub fn total_rays_per_pixel(&self, filter: Filter, samples: u32) -> f64 {
        let samplers = self.samplers(filter).into_iter();
        let of_samplers: f64 = samplers
            .filter(|(it, _)| max_rays_per_pixel(it) * REFERENCE_SAMPLE_FACTOR <= samples)
            .map(|(_, rays)| rays)
            .sum();
        // About sixteen techniques; adaptive and stochastic sampling need most of it.
        const TECHNIQUES: f64 = 70.0;
        // A combination needs as many as a medium sampler.
        const COMBINATION: f64 = 8.0;
        let others = self.cutoffs.len() + self.selections.len();
        of_samplers + others as f64 + TECHNIQUES + COMBINATION * self.combinations as f64
    }

    /// Minimum samples per pixel of the reference: at least those of the scene, and a power of two, for which the Sobol
    /// sequence is best.
    pub fn min_reference_samples(&self, own: &Settings) -> u32 {
        let [least, _] = self.reference;
        let rays = max_rays_per_pixel(&own.sampler);
        let least = if rays > least { rays } else { least };
        least.checked_next_power_of_two().unwrap_or(least)
    }

    /// Samples per pixel of the reference, at least `fewest`, if one sample per pixel takes `single` seconds and all may
    /// take `seconds`.
    pub fn reference_samples(&self, fewest: u32, single: f64, seconds: f64) -> u32 {
        let [_, most] = self.reference;
        let fits = |samples: u32| f64::from(samples) * single <= seconds;
        let mut samples = fewest;
        while samples < most && fits(2 * samples) {
            samples *= 2;
        }
        samples
    }
}

/// The next finer limits for the reference. `cut` holds the shares of the light that levels and cutoff discard; the larger
/// one is refined, if it `may`. `None` if nothing is discarded any more. The first value is 0 for levels, 1 for the cutoff.
pub fn next_finer_limits(limits: Limits, cut: [f64; 2], may: [bool; 2]) -> Option<(usize, Limits)> {
    let levels = LEVELS.into_iter().find(|levels| *levels > limits.levels);
    let cutoff = REFERENCE_CUTOFFS.into_iter().find(|cutoff| *cutoff < limits.cutoff);
    let next =
        [levels.map(|levels| Limits { levels, ..limits }), cutoff.map(|cutoff| Limits { cutoff, ..limits })];
    let open = (0..2).filter(|which| may[*which] && cut[*which] > NEGLIGIBLE_SHARE);
    let open = open.filter_map(|which| Some((which, next[which]?)));
    open.max_by(|(a, _), (b, _)| cut[*a].total_cmp(&cut[*b]))
}

/// Maximum rays per pixel of a sampler, without shared corners.
pub fn max_rays_per_pixel(sampling: &SamplerSettings) -> u32 {
    match sampling {
        SamplerSettings::Single => 1,
        SamplerSettings::Regular(n) => u32::from(*n) * u32::from(*n),
        SamplerSettings::Adaptive { max_depth: depth, .. } => 4_u32.saturating_pow(u32::from(*depth)),
        SamplerSettings::Stochastic { max_samples: most, .. } => *most,
    }
}

/// The same levels and cutoff with one ray per pixel; all other settings that change the picture are defaults.
pub fn one_ray_per_pixel(settings: &Settings) -> Settings {
    Settings {
        sampler: SamplerSettings::Single,
        select: None,
        precision: Precision::Single,
        seed: 0,
        ..settings.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sampler_of_a_plan_is_valid_on_the_command_line() {
        for plan in [StudyPlan::QUICK, StudyPlan::FULL] {
            let all = plan.samplers(Filter::Box);
            let kinds = plan.stochastic.len()
                + plan.regular.len()
                + plan.adaptive.len()
                + plan.stochastic_stopping.len();
            assert_eq!(all.len(), kinds, "{}", plan.name);
            for (sampling, rays) in &all {
                assert_eq!(sampling.to_string().parse(), Ok(*sampling));
                assert!(*rays >= 1.0);
            }
            assert!(plan.samplers(Filter::Tent).iter().all(|(sampling, _)| sampling.allows_filter()));
            assert!(plan.cutoffs().any(|it| it == 1.0 / 512.0), "the default is among the cutoffs");
        }
    }

    #[test]
    fn a_reference_has_as_many_samples_as_its_time_allows() {
        let plan = StudyPlan { reference: [32, 1024], ..StudyPlan::QUICK };
        let samples = |seconds| plan.reference_samples(32, 0.1, seconds);
        assert_eq!([0.0, 6.3, 6.4, 25.0, 30.0, 1e9].map(samples), [32, 32, 64, 128, 256, 1024]);
        assert_eq!(plan.reference_samples(32, 0.1, f64::INFINITY), 1024);
    }

    #[test]
    fn a_reference_has_at_least_the_samples_of_the_scene() {
        let fewest = |sampler: &str| {
            StudyPlan::QUICK
                .min_reference_samples(&Settings { sampler: sampler.parse().unwrap(), ..Settings::default() })
        };
        let samplers = [
            "single",
            "regular:4",
            "regular:7",
            "stochastic:1500",
            "adaptive:4:0.1",
            "stochastic:4..96:0.9:0.1",
        ];
        assert_eq!(samplers.map(fewest), [32, 32, 64, 2048, 256, 128]);
        // For any time.
        assert_eq!(StudyPlan::QUICK.reference_samples(2048, 1.0, 0.0), 2048);
    }

    #[test]
    fn the_limit_that_discards_more_is_refined_until_nothing_is_discarded() {
        let from = |levels, cutoff| Limits { levels, cutoff };
        let next =
            |limits, cut, may| next_finer_limits(limits, cut, may).map(|(_, it)| (it.levels, it.cutoff));
        let (both, own) = ([true, true], from(5, 1.0 / 512.0));
        assert_eq!(next(own, [0.1, 0.01], both), Some((6, 1.0 / 512.0)));
        assert_eq!(next(own, [0.01, 0.1], both), Some((5, 1.0 / 4096.0)));
        assert_eq!(next(own, [0.01, 0.1], [true, false]), Some((6, 1.0 / 512.0)));
        assert_eq!(next(own, [0.0, 1e-5], both), None);
        assert_eq!(next(own, [0.1, 0.1], [false, false]), None);
        // After the last value of one, the other is refined.
        assert_eq!(next(from(64, 0.3), [0.9, 0.1], both), Some((64, 1.0 / 64.0)));
        assert_eq!(next(from(7, 0.0), [0.1, 0.0], both), Some((8, 0.0)));
        // Limits never become coarser.
        let mut limits = from(2, 0.004);
        while let Some((_, finer)) = next_finer_limits(limits, [0.1, 0.2], both) {
            assert!(finer.levels >= limits.levels && finer.cutoff <= limits.cutoff && finer != limits);
            limits = finer;
        }
        assert_eq!(limits, from(64, 1.0 / 65536.0));
    }
}
