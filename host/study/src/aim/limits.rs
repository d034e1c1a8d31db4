//! Candidates for levels and cutoff, with the error and cost of each.
//!
//! Few rays per pixel suffice, because all compared pictures use the same rays. Levels are raised until no ray is discarded
//! or the picture converges; then cutoffs up to that of the reference are compared with it.

use strahl_core::scene::EffectSet;
use strahl_core::{Limits, Rgb};
use strahl_engine::RenderError;
use strahl_settings::SamplerSettings;

use super::candidates::{LEVEL_STEPS, SamplingStrategy, cutoff_steps};
use super::search::{ErrorTarget, QualitySettings, SettingsSearch};

/// The change of the picture, relative to the target error, below which levels have converged.
const CONVERGED_SHARE: f64 = 1.0 / 24.0;
/// Maximum error of the reference by its levels and cutoff, relative to the target error.
const REFERENCE_ERROR_SHARE: f64 = 1.0 / 12.0;
/// A predicted error of up to this times the target may still reach it.
pub const PREDICTION_SLACK: f64 = 1.1;

/// Levels and a cutoff, with their error and cost.
#[derive(Clone, Copy, Debug)]
pub struct LimitsCandidate {
    /// Levels and cutoff.
    pub limits: Limits,
    /// The error that they cause alone.
    pub error: f64,
    /// The cost, relative to the finest candidate.
    pub relative_cost: f64,
}

/// Candidates, finest first. None is more expensive than another one of smaller error.
pub fn limits_candidates(
    search: &mut SettingsSearch<'_>,
    effects: &EffectSet,
) -> Result<Vec<LimitsCandidate>, RenderError> {
    let ErrorTarget { max_error, fixed, .. } = search.target;
    let requested = search.settings.limits();
    let branches = effects.reflection || effects.transmission;
    let finest = if fixed.cutoff || !branches {
        requested.cutoff
    } else {
        (max_error / 64.0).clamp(1e-5, 1.0 / 512.0) as f32
    };
    let rays = SamplingStrategy { sampler: SamplerSettings::stochastic(2), select: None };

    // Raise the levels until no ray is discarded or the picture converges.
    let mut by_levels: Vec<(u8, Vec<Rgb>, f64)> = Vec::new();
    let level_steps: &[u8] = if fixed.levels || !branches { &[requested.levels] } else { &LEVEL_STEPS };
    let mut converged = 0;
    for levels in level_steps {
        let limits = Limits { levels: *levels, cutoff: finest };
        let (output, cost) = search.evaluate(QualitySettings { limits, rays })?;
        let is_whole = output.counters.level_limit.rays == 0;
        let change = by_levels
            .last()
            .map(|(_, last, _)| search.sparse.error_estimate(&output.picture.colors, last).error);
        by_levels.push((*levels, output.picture.colors, cost));
        converged = if change.is_some_and(|change| change <= CONVERGED_SHARE * max_error) {
            converged + 1
        } else {
            0
        };
        if is_whole || converged >= 2 {
            break;
        }
    }
    let Some((most, best, whole)) = by_levels.last() else { return Ok(Vec::new()) };
    let limits = Limits { levels: *most, cutoff: finest };
    let mut by_cutoff = vec![(finest, 0.0, 1.0)];
    if branches && !fixed.cutoff {
        for cutoff in cutoff_steps().filter(|cutoff| *cutoff > finest) {
            let (output, cost) =
                search.evaluate(QualitySettings { limits: Limits { cutoff, ..limits }, rays })?;
            by_cutoff.push((
                cutoff,
                search.sparse.error_estimate(&output.picture.colors, best).error,
                cost / whole,
            ));
        }
    }

    let mut candidates = Vec::new();
    for (levels, colors, cost) in &by_levels {
        let error = search.sparse.error_estimate(colors, best).error;
        for (cutoff, more, part) in &by_cutoff {
            let limits = Limits { levels: *levels, cutoff: *cutoff };
            // Levels and cutoff partly discard the same light, so the sum is an upper bound.
            candidates.push(LimitsCandidate {
                limits,
                error: error + more,
                relative_cost: cost / whole * part,
            });
        }
    }
    // Keep the finest, and those that are more accurate than all cheaper ones.
    candidates.sort_by(|a, b| a.relative_cost.total_cmp(&b.relative_cost).then(a.error.total_cmp(&b.error)));
    let finest = LimitsCandidate { limits, error: 0.0, relative_cost: 1.0 };
    let mut least = f64::INFINITY;
    candidates.retain(|it| {
        let keeps = it.error < least && it.error <= PREDICTION_SLACK * max_error && it.limits != limits;
        if keeps {
            least = it.error;
        }
        keeps
    });
    candidates.push(finest);
    candidates.reverse();
    Ok(candidates)
}

/// The cheapest candidate whose error is at most `max_error`, or the finest one. `None` if there are no candidates.
pub fn cheapest_candidate(candidates: &[LimitsCandidate], max_error: f64) -> Option<LimitsCandidate> {
    candidates.iter().rev().find(|it| it.error <= max_error).or(candidates.first()).copied()
}

/// Levels and cutoff of the reference for a target error.
pub fn reference_limits(candidates: &[LimitsCandidate], max_error: f64) -> Limits {
    cheapest_candidate(candidates, REFERENCE_ERROR_SHARE * max_error).map_or(Limits::DEFAULT, |it| it.limits)
}
