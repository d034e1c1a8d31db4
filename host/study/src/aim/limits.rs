//! Levels and cutoffs: what each loses by itself, and what it costs.
//!
//! They show with few rays, for these are the same in all pictures that are compared. Levels are raised until nothing is
//! cut or nothing changes; then the cutoff is lowered as far as that of the reference.

use strahl_core::scene::EffectSet;
use strahl_core::{Limits, Rgb};
use strahl_engine::RenderError;
use strahl_settings::SamplerSettings;

use super::candidates::{LEVEL_STEPS, SamplingStrategy, cutoff_steps};
use super::search::{ErrorTarget, QualitySettings, SettingsSearch};

/// How small a change of levels or cutoff is, as a part of the error that is aimed at, after which
/// no more are looked for.
const CONVERGED_SHARE: f64 = 1.0 / 24.0;
/// What the reference may lose by its levels and cutoff, as a part of the error that is aimed at.
const REFERENCE_ERROR_SHARE: f64 = 1.0 / 12.0;
/// What is predicted to be this much too large may be small enough.
pub const PREDICTION_SLACK: f64 = 1.1;

/// Levels and a cutoff, the error that they make by themselves, and what they cost against those of the reference.
#[derive(Clone, Copy, Debug)]
pub struct LimitsCandidate {
    /// Levels and cutoff.
    pub limits: Limits,
    /// What is lost by them.
    pub error: f64,
    /// The part of the cost.
    pub relative_cost: f64,
}

/// Levels and cutoffs, the finest first, none of which is dearer than another that loses less.
pub fn limits_candidates(
    search: &mut SettingsSearch<'_>,
    effects: &EffectSet,
) -> Result<Vec<LimitsCandidate>, RenderError> {
    let ErrorTarget { max_error: goal, fixed, .. } = search.target;
    let asked = search.settings.limits();
    let branches = effects.reflection || effects.transmission;
    let finest =
        if fixed.cutoff || !branches { asked.cutoff } else { (goal / 64.0).clamp(1e-5, 1.0 / 512.0) as f32 };
    let rays = SamplingStrategy { sampler: SamplerSettings::stochastic(2), select: None };

    // More and more levels, until nothing is cut or nothing changes.
    let mut by_levels: Vec<(u8, Vec<Rgb>, f64)> = Vec::new();
    let ladder: &[u8] = if fixed.levels || !branches { &[asked.levels] } else { &LEVEL_STEPS };
    let mut settled = 0;
    for levels in ladder {
        let limits = Limits { levels: *levels, cutoff: finest };
        let (output, cost) = search.evaluate(QualitySettings { limits, rays })?;
        let is_whole = output.counters.level_limit.rays == 0;
        let change = by_levels
            .last()
            .map(|(_, last, _)| search.sparse.error_estimate(&output.picture.colors, last).error);
        by_levels.push((*levels, output.picture.colors, cost));
        settled = if change.is_some_and(|change| change <= CONVERGED_SHARE * goal) { settled + 1 } else { 0 };
        if is_whole || settled >= 2 {
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

    let mut priced = Vec::new();
    for (levels, colors, cost) in &by_levels {
        let error = search.sparse.error_estimate(colors, best).error;
        for (cutoff, more, part) in &by_cutoff {
            let limits = Limits { levels: *levels, cutoff: *cutoff };
            // What levels and cutoff cut is partly the same light: the sum is the most.
            priced.push(LimitsCandidate { limits, error: error + more, relative_cost: cost / whole * part });
        }
    }
    // The finest, and those that lose less than all that are cheaper.
    priced.sort_by(|a, b| a.relative_cost.total_cmp(&b.relative_cost).then(a.error.total_cmp(&b.error)));
    let finest = LimitsCandidate { limits, error: 0.0, relative_cost: 1.0 };
    let mut least = f64::INFINITY;
    priced.retain(|it| {
        let keeps = it.error < least && it.error <= PREDICTION_SLACK * goal && it.limits != limits;
        if keeps {
            least = it.error;
        }
        keeps
    });
    priced.push(finest);
    priced.reverse();
    Ok(priced)
}

/// The cheapest of some limits, the finest of which come first, that loses no more than this.
pub fn cheapest_candidate(priced: &[LimitsCandidate], most: f64) -> Option<LimitsCandidate> {
    priced.iter().rev().find(|it| it.error <= most).or(priced.first()).copied()
}

/// Levels and cutoff of the reference for this error.
pub fn reference_limits(priced: &[LimitsCandidate], goal: f64) -> Limits {
    cheapest_candidate(priced, REFERENCE_ERROR_SHARE * goal).map_or(Limits::DEFAULT, |it| it.limits)
}
