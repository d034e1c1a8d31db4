//! The cheapest settings that reach a target error, searched on a sparse sample of pixels.
//!
//! 1. Levels and cutoff are refined until the picture converges (module `limits`); these are the limits of the reference.
//! 2. Sampling strategies are evaluated with levels and a cutoff of small error, cheapest first. A strategy is skipped if
//!    its error cannot satisfy the target at the fastest possible convergence, or if it costs more than the best one found,
//!    whatever its levels and cutoff.
//! 3. Combinations of both that are predicted to reach the target are evaluated in the order of their predicted cost, until
//!    the next one costs more than the best one found.

use std::time::Instant;

use strahl_core::scene::EffectSet;
use strahl_core::{Limits, Rgb};
use strahl_engine::{Progress, RenderError, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_session::{RenderOutput, SceneStorage, Session};
use strahl_settings::Settings;

use super::candidates::{MIN_COST_RATIO, SamplingStrategy, sampling_strategies};
use super::limits::{PREDICTION_SLACK, cheapest_candidate, limits_candidates, reference_limits};
use super::search::{ErrorTarget, QualitySettings, SettingsSearch, reference_settings};
use super::sparse::{ErrorEstimate, rmse};
use super::{AimResult, AimTarget};

/// Error of the levels and cutoff used for the search of strategies, relative to the target. Errors add as squares, so this
/// is about a twentieth of the measured error.
const SEARCH_ERROR_SHARE: f64 = 1.0 / 3.0;
/// Maximum number of combinations that are evaluated.
const MAX_COMBINATIONS: usize = 24;

/// Finds the cheapest settings that reach the target and renders the picture with them.
pub fn render_to_error(
    description: &LoadedScene,
    settings: &Settings,
    options: &RenderOptions<'_>,
    target: ErrorTarget,
    progress: &dyn Progress,
) -> Result<(RenderOutput, AimResult), RenderError> {
    let mut storage = SceneStorage::new(description, settings.precision);
    let session = Session::new(&mut storage, &settings.acceleration())?;
    let clock = Instant::now();
    let mut search = SettingsSearch::new(&session, settings, *options, target, progress);
    let found = cheapest_settings(&mut search, &session.scene().effects)?;
    let seconds = clock.elapsed().as_secs_f64();
    let chosen = found.quality.apply_to(settings);
    let output = session.render(&chosen, options, progress)?;
    let measured = match target.verify {
        true => {
            let reference = reference_settings(settings, found.reference_limits, target.max_error, 1);
            let reference = session.render(&reference, options, progress)?;
            Some(rmse(&output.picture.colors, &reference.picture.colors))
        }
        false => None,
    };
    let ErrorEstimate { error: estimate, upper_bound: at_most } = found.estimate;
    let reference = reference_settings(settings, found.reference_limits, target.max_error, 0);
    let result = AimResult {
        is_met: at_most <= target.max_error && measured.is_none_or(|error| error <= target.max_error),
        target: AimTarget::Error {
            requested: target.max_error,
            estimate,
            at_most,
            pixels: search.sparse.pixel_count(),
            tried: search.evaluated,
            reference: format!(
                "{} with {} levels and cutoff {}",
                reference.sampler, reference.levels, reference.cutoff
            ),
            measured,
            seconds,
        },
        why: found.explanation(target.max_error),
        settings: chosen,
    };
    Ok((output, result))
}

/// The result of a search.
pub struct BestSettings {
    /// The cheapest settings that reach the target, or the most accurate ones found.
    pub quality: QualitySettings,
    /// Their error.
    pub estimate: ErrorEstimate,
    /// Cost of the sampled pixels, in instructions.
    pub cost: f64,
    /// Levels and cutoff of the reference.
    pub reference_limits: Limits,
}

impl BestSettings {
    fn explanation(&self, max_error: f64) -> String {
        let QualitySettings { limits: Limits { levels, cutoff }, rays } = self.quality;
        let selecting = rays.select.map(|it| format!(", selection {it}")).unwrap_or_default();
        let what = format!("{levels} levels, cutoff {cutoff}, {}{selecting}", rays.sampler);
        if self.estimate.upper_bound <= max_error {
            format!("{what}: the cheapest that reaches it")
        } else {
            format!("{what}: the most accurate found")
        }
    }
}

/// Finds the cheapest settings that reach the target.
pub fn cheapest_settings(
    search: &mut SettingsSearch<'_>,
    effects: &EffectSet,
) -> Result<BestSettings, RenderError> {
    let max_error = search.target.max_error;
    let priced = limits_candidates(search, effects)?;
    let Some(working) = cheapest_candidate(&priced, SEARCH_ERROR_SHARE * max_error) else {
        return Err(RenderError::invalid("there are no levels"));
    };
    let limits = reference_limits(&priced, max_error);
    let reference = search.render_reference(limits)?.picture.colors;

    // Cost of the coarsest limits, relative to the working limits.
    let part = priced.last().map_or(1.0, |it| it.relative_cost / working.relative_cost);
    let evaluated = evaluate_strategies(search, working.limits, part, &reference)?;
    // The best that there is, if nothing keeps the error.
    let best = evaluated.iter().min_by(|a, b| a.estimate.upper_bound.total_cmp(&b.estimate.upper_bound));
    let Some(mut best) = best.copied() else { return Err(RenderError::invalid("there are no rays")) };
    if let Some(cheapest) = evaluated
        .iter()
        .filter(|it| it.estimate.upper_bound <= max_error)
        .min_by(|a, b| a.cost.total_cmp(&b.cost))
    {
        best = *cheapest;
    }

    let mut pairs: Vec<(f64, QualitySettings)> = Vec::new();
    for it in &evaluated {
        for other in priced.iter().filter(|other| other.limits != working.limits) {
            let square = |error: f64| error * error;
            let alone = (square(it.estimate.error) - square(working.error)).max(0.0);
            let error = (alone + square(other.error)).sqrt();
            if error <= PREDICTION_SLACK * max_error {
                let candidate = QualitySettings { limits: other.limits, rays: it.candidate.rays };
                pairs.push((it.cost * other.relative_cost / working.relative_cost, candidate));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (predicted, candidate) in pairs.into_iter().take(MAX_COMBINATIONS) {
        let is_better = best.estimate.upper_bound > max_error || predicted < best.cost;
        if !is_better {
            break;
        }
        let (output, cost) = search.evaluate(candidate)?;
        let estimate = search.sparse.error_estimate(&output.picture.colors, &reference);
        let keeps = estimate.upper_bound <= max_error;
        if keeps && (cost < best.cost || best.estimate.upper_bound > max_error) {
            best = Evaluation { candidate, estimate, cost };
        }
    }
    let Evaluation { candidate, estimate, cost } = best;
    Ok(BestSettings { quality: candidate, estimate, cost, reference_limits: limits })
}

/// Evaluates sampling strategies with levels and a cutoff of small error. `part` is the cost of the coarsest limits,
/// relative to these.
fn evaluate_strategies(
    search: &mut SettingsSearch<'_>,
    limits: Limits,
    part: f64,
    reference: &[Rgb],
) -> Result<Vec<Evaluation>, RenderError> {
    let (settings, ErrorTarget { max_error, fixed, .. }) = (search.settings, search.target);
    let mut list = sampling_strategies(settings.filter, max_error);
    if fixed.sampler {
        list.retain(|rays| rays.select.is_some());
        list.iter_mut().for_each(|rays| rays.sampler = settings.sampler);
        list.push(SamplingStrategy { sampler: settings.sampler, select: None });
    }
    if fixed.select {
        list.retain(|rays| rays.select.is_none());
        list.iter_mut().for_each(|rays| rays.select = settings.select);
    }
    let mut evaluated: Vec<Evaluation> = Vec::new();
    let mut cheapest = f64::INFINITY;
    for rays in list {
        if !fixed.sampler
            && evaluated
                .iter()
                .any(|it| it.costs_more_than(rays, cheapest / part) || it.cannot_satisfy(rays, max_error))
        {
            continue;
        }
        let candidate = QualitySettings { limits, rays };
        let (output, cost) = search.evaluate(candidate)?;
        let estimate = search.sparse.error_estimate(&output.picture.colors, reference);
        if estimate.upper_bound <= max_error && cost < cheapest {
            cheapest = cost;
        }
        evaluated.push(Evaluation { candidate, estimate, cost });
    }
    Ok(evaluated)
}

/// Evaluated settings.
#[derive(Clone, Copy, Debug)]
struct Evaluation {
    candidate: QualitySettings,
    estimate: ErrorEstimate,
    cost: f64,
}

/// The fastest convergence: the error falls as this power of the number of rays.
const MAX_CONVERGENCE_EXPONENT: f64 = 0.85;

impl Evaluation {
    /// Whether another strategy must cost more than `cheapest`, given the cost of this one.
    fn costs_more_than(&self, rays: SamplingStrategy, cheapest: f64) -> bool {
        let times = rays.min_ray_ratio(self.candidate.rays);
        times.is_some_and(|times| MIN_COST_RATIO * times * self.cost > cheapest)
    }

    /// Whether more rays of the same sampler cannot satisfy the target, even at the fastest convergence.
    fn cannot_satisfy(&self, rays: SamplingStrategy, max_error: f64) -> bool {
        let it = self.candidate.rays;
        let same = std::mem::discriminant(&it.sampler) == std::mem::discriminant(&rays.sampler);
        match (it.fixed_rays_per_pixel(), rays.fixed_rays_per_pixel()) {
            (Some(known), Some(count)) if same && 1 < known && known < count => {
                self.estimate.error / libm::pow(f64::from(count) / f64::from(known), MAX_CONVERGENCE_EXPONENT)
                    > max_error
            }
            _ => false,
        }
    }
}
