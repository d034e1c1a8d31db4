//! The cheapest settings whose error is below a limit, found on a sparse sample of pixels.
//!
//! 1. How many levels and which cutoff it takes until nothing changes any more (module `limits`): those of the
//!    reference.
//! 2. Which rays keep the error with levels and a cutoff that lose little of it, from the cheapest on. A number of rays is
//!    not tried whose error cannot become small enough, however fast it falls, and none that costs more than what has been
//!    found, whatever levels and cutoff go with it.
//! 3. What of both goes together: what is predicted to keep the error is tried, in the order of its predicted cost, until
//!    the next one costs more than the best that did.

use std::time::Instant;

use strahl_core::scene::EffectSet;
use strahl_core::{Limits, Rgb};
use strahl_engine::{Progress, RenderError, RenderOptions};
use strahl_scene::description::LoadedScene;
use strahl_settings::Settings;

use super::candidates::{MIN_COST_RATIO, SamplingStrategy, sampling_strategies};
use super::limits::{PREDICTION_SLACK, cheapest_candidate, limits_candidates, reference_limits};
use super::search::{ErrorTarget, QualitySettings, SettingsSearch, reference_settings};
use super::sparse::{ErrorEstimate, rmse};
use super::{AimResult, AimTarget};
use strahl_session::{RenderOutput, SceneStorage, Session};

/// What may be lost by those with which rays are looked for: a twentieth of what is measured then.
const SEARCH_ERROR_SHARE: f64 = 1.0 / 3.0;
/// The most combinations that are tried.
const MAX_COMBINATIONS: usize = 24;

/// Finds settings that keep the goal and renders the picture with them.
pub fn render_to_error(
    description: &LoadedScene,
    settings: &Settings,
    options: &RenderOptions<'_>,
    goal: ErrorTarget,
    progress: &dyn Progress,
) -> Result<(RenderOutput, AimResult), RenderError> {
    let mut storage = SceneStorage::new(description, settings.precision);
    let session = Session::new(&mut storage, &settings.acceleration())?;
    let clock = Instant::now();
    let mut search = SettingsSearch::new(&session, settings, *options, goal, progress);
    let found = cheapest_settings(&mut search, &session.scene().effects)?;
    let seconds = clock.elapsed().as_secs_f64();
    let taken = found.quality.apply_to(settings);
    let output = session.render(&taken, options, progress)?;
    let measured = match goal.verify {
        true => {
            let reference = reference_settings(settings, found.reference_limits, goal.max_error, 1);
            let reference = session.render(&reference, options, progress)?;
            Some(rmse(&output.picture.colors, &reference.picture.colors))
        }
        false => None,
    };
    let ErrorEstimate { error: estimate, upper_bound: at_most } = found.estimate;
    let what = reference_settings(settings, found.reference_limits, goal.max_error, 0);
    let aimed = AimResult {
        kept: at_most <= goal.max_error && measured.is_none_or(|error| error <= goal.max_error),
        target: AimTarget::Error {
            asked: goal.max_error,
            estimate,
            at_most,
            pixels: search.sparse.pixel_count(),
            tried: search.evaluated,
            truth: format!("{} with {} levels and cutoff {}", what.sampler, what.levels, what.cutoff),
            measured,
            seconds,
        },
        why: found.explanation(goal.max_error),
        settings: taken,
    };
    Ok((output, aimed))
}

/// What was found.
pub struct BestSettings {
    /// The cheapest that keeps the error, or the best that there is.
    pub quality: QualitySettings,
    /// Its error.
    pub estimate: ErrorEstimate,
    /// What its pixels cost, in instructions.
    pub cost: f64,
    /// Levels and cutoff of the reference.
    pub reference_limits: Limits,
}

impl BestSettings {
    fn explanation(&self, goal: f64) -> String {
        let QualitySettings { limits: Limits { levels, cutoff }, rays } = self.quality;
        let selecting = rays.select.map(|it| format!(", selection {it}")).unwrap_or_default();
        let what = format!("{levels} levels, cutoff {cutoff}, {}{selecting}", rays.sampler);
        if self.estimate.upper_bound <= goal {
            format!("{what}: the cheapest that keeps it")
        } else {
            format!("{what}: the best that there is")
        }
    }
}

/// The cheapest settings that keep the error.
pub fn cheapest_settings(
    search: &mut SettingsSearch<'_>,
    effects: &EffectSet,
) -> Result<BestSettings, RenderError> {
    let goal = search.target.max_error;
    let priced = limits_candidates(search, effects)?;
    let Some(working) = cheapest_candidate(&priced, SEARCH_ERROR_SHARE * goal) else {
        return Err(RenderError::invalid("there are no levels"));
    };
    let limits = reference_limits(&priced, goal);
    let reference = search.render_reference(limits)?.picture.colors;

    // The most that coarser levels and cutoffs can save.
    let part = priced.last().map_or(1.0, |it| it.relative_cost / working.relative_cost);
    let tried = evaluate_strategies(search, working.limits, part, &reference)?;
    // The best that there is, if nothing keeps the error.
    let best = tried.iter().min_by(|a, b| a.estimate.upper_bound.total_cmp(&b.estimate.upper_bound));
    let Some(mut best) = best.copied() else { return Err(RenderError::invalid("there are no rays")) };
    if let Some(cheapest) =
        tried.iter().filter(|it| it.estimate.upper_bound <= goal).min_by(|a, b| a.cost.total_cmp(&b.cost))
    {
        best = *cheapest;
    }

    let mut pairs: Vec<(f64, QualitySettings)> = Vec::new();
    for it in &tried {
        for other in priced.iter().filter(|other| other.limits != working.limits) {
            let square = |error: f64| error * error;
            let alone = (square(it.estimate.error) - square(working.error)).max(0.0);
            let error = (alone + square(other.error)).sqrt();
            if error <= PREDICTION_SLACK * goal {
                let candidate = QualitySettings { limits: other.limits, rays: it.candidate.rays };
                pairs.push((it.cost * other.relative_cost / working.relative_cost, candidate));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (predicted, candidate) in pairs.into_iter().take(MAX_COMBINATIONS) {
        let is_better = best.estimate.upper_bound > goal || predicted < best.cost;
        if !is_better {
            break;
        }
        let (output, cost) = search.evaluate(candidate)?;
        let estimate = search.sparse.error_estimate(&output.picture.colors, &reference);
        let keeps = estimate.upper_bound <= goal;
        if keeps && (cost < best.cost || best.estimate.upper_bound > goal) {
            best = Evaluation { candidate, estimate, cost };
        }
    }
    let Evaluation { candidate, estimate, cost } = best;
    Ok(BestSettings { quality: candidate, estimate, cost, reference_limits: limits })
}

/// What rays cost and how far they are from the reference, with levels and a cutoff that lose little; others may cost
/// this part of it.
fn evaluate_strategies(
    search: &mut SettingsSearch<'_>,
    limits: Limits,
    part: f64,
    reference: &[Rgb],
) -> Result<Vec<Evaluation>, RenderError> {
    let (settings, ErrorTarget { max_error: goal, fixed, .. }) = (search.settings, search.target);
    let mut list = sampling_strategies(settings.filter, goal);
    if fixed.sampler {
        list.retain(|rays| rays.select.is_some());
        list.iter_mut().for_each(|rays| rays.sampler = settings.sampler);
        list.push(SamplingStrategy { sampler: settings.sampler, select: None });
    }
    if fixed.select {
        list.retain(|rays| rays.select.is_none());
        list.iter_mut().for_each(|rays| rays.select = settings.select);
    }
    let mut tried: Vec<Evaluation> = Vec::new();
    let mut cheapest = f64::INFINITY;
    for rays in list {
        if !fixed.sampler
            && tried.iter().any(|it| it.costs_more_than(rays, cheapest / part) || it.cannot_reach(rays, goal))
        {
            continue;
        }
        let candidate = QualitySettings { limits, rays };
        let (output, cost) = search.evaluate(candidate)?;
        let estimate = search.sparse.error_estimate(&output.picture.colors, reference);
        if estimate.upper_bound <= goal && cost < cheapest {
            cheapest = cost;
        }
        tried.push(Evaluation { candidate, estimate, cost });
    }
    Ok(tried)
}

/// Rays that were tried.
#[derive(Clone, Copy, Debug)]
struct Evaluation {
    candidate: QualitySettings,
    estimate: ErrorEstimate,
    cost: f64,
}

/// How fast the error of more rays falls at most: as this power of their number.
const MAX_CONVERGENCE_EXPONENT: f64 = 0.85;

impl Evaluation {
    /// Whether other rays cost more than `cheapest`, because these do.
    fn costs_more_than(&self, rays: SamplingStrategy, cheapest: f64) -> bool {
        let times = rays.min_ray_ratio(self.candidate.rays);
        times.is_some_and(|times| MIN_COST_RATIO * times * self.cost > cheapest)
    }

    /// Whether more rays of the same sampler cannot keep the error, however fast it falls.
    fn cannot_reach(&self, rays: SamplingStrategy, goal: f64) -> bool {
        let it = self.candidate.rays;
        let same = std::mem::discriminant(&it.sampler) == std::mem::discriminant(&rays.sampler);
        match (it.fixed_rays_per_pixel(), rays.fixed_rays_per_pixel()) {
            (Some(known), Some(count)) if same && 1 < known && known < count => {
                self.estimate.error / libm::pow(f64::from(count) / f64::from(known), MAX_CONVERGENCE_EXPONENT)
                    > goal
            }
            _ => false,
        }
    }
}
