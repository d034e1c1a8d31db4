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

use super::candidates::{Rays, SAVES, rays};
use super::limits::{HOPE, cheapest_within, limits_of_reference, priced_limits};
use super::search::{Candidate, Goal, Search, reference};
use super::sparse::{Estimate, rmse};
use super::{Aimed, Target};
use strahl_session::{RenderOutput, SceneStorage, Session};

/// What may be lost by those with which rays are looked for: a twentieth of what is measured then.
const WORKING: f64 = 1.0 / 3.0;
/// The most combinations that are tried.
const MOST_TRIED: usize = 24;

/// Finds settings that keep the goal and renders the picture with them.
pub fn trace(
    description: &LoadedScene,
    settings: &Settings,
    options: &RenderOptions<'_>,
    goal: Goal,
    progress: &dyn Progress,
) -> Result<(RenderOutput, Aimed), RenderError> {
    let mut storage = SceneStorage::new(description, settings.precision);
    let session = Session::new(&mut storage, &settings.acceleration())?;
    let clock = Instant::now();
    let mut search = Search::new(&session, settings, *options, goal, progress);
    let found = find(&mut search, &session.scene().effects)?;
    let seconds = clock.elapsed().as_secs_f64();
    let taken = found.candidate.apply(settings);
    let output = session.render(&taken, options, progress)?;
    let measured = match goal.verify {
        true => {
            let reference = reference(settings, found.limits, goal.error, 1);
            let reference = session.render(&reference, options, progress)?;
            Some(rmse(&output.picture.colors, &reference.picture.colors))
        }
        false => None,
    };
    let Estimate { error: estimate, at_most } = found.estimate;
    let what = reference(settings, found.limits, goal.error, 0);
    let aimed = Aimed {
        kept: at_most <= goal.error && measured.is_none_or(|error| error <= goal.error),
        target: Target::Error {
            asked: goal.error,
            estimate,
            at_most,
            pixels: search.sparse.pixels(),
            tried: search.tried,
            truth: format!("{} with {} levels and cutoff {}", what.sampler, what.levels, what.cutoff),
            measured,
            seconds,
        },
        why: found.why(goal.error),
        taken,
    };
    Ok((output, aimed))
}

/// What was found.
pub struct Found {
    /// The cheapest that keeps the error, or the best that there is.
    pub candidate: Candidate,
    /// Its error.
    pub estimate: Estimate,
    /// What its pixels cost, in instructions.
    pub cost: f64,
    /// Levels and cutoff of the reference.
    pub limits: Limits,
}

impl Found {
    fn why(&self, goal: f64) -> String {
        let Candidate { limits: Limits { levels, cutoff }, rays } = self.candidate;
        let selecting = rays.select.map(|it| format!(", selection {it}")).unwrap_or_default();
        let what = format!("{levels} levels, cutoff {cutoff}, {}{selecting}", rays.sampler);
        if self.estimate.at_most <= goal {
            format!("{what}: the cheapest that keeps it")
        } else {
            format!("{what}: the best that there is")
        }
    }
}

/// The cheapest settings that keep the error.
pub fn find(search: &mut Search<'_>, effects: &EffectSet) -> Result<Found, RenderError> {
    let goal = search.goal.error;
    let priced = priced_limits(search, effects)?;
    let Some(working) = cheapest_within(&priced, WORKING * goal) else {
        return Err(RenderError::invalid("there are no levels"));
    };
    let limits = limits_of_reference(&priced, goal);
    let reference = search.trace_reference(limits)?.picture.colors;

    // The most that coarser levels and cutoffs can save.
    let part = priced.last().map_or(1.0, |it| it.cost / working.cost);
    let tried = tried_rays(search, working.limits, part, &reference)?;
    // The best that there is, if nothing keeps the error.
    let best = tried.iter().min_by(|a, b| a.estimate.at_most.total_cmp(&b.estimate.at_most));
    let Some(mut best) = best.copied() else { return Err(RenderError::invalid("there are no rays")) };
    if let Some(cheapest) =
        tried.iter().filter(|it| it.estimate.at_most <= goal).min_by(|a, b| a.cost.total_cmp(&b.cost))
    {
        best = *cheapest;
    }

    let mut pairs: Vec<(f64, Candidate)> = Vec::new();
    for it in &tried {
        for other in priced.iter().filter(|other| other.limits != working.limits) {
            let square = |error: f64| error * error;
            let alone = (square(it.estimate.error) - square(working.error)).max(0.0);
            let error = (alone + square(other.error)).sqrt();
            if error <= HOPE * goal {
                let candidate = Candidate { limits: other.limits, rays: it.candidate.rays };
                pairs.push((it.cost * other.cost / working.cost, candidate));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (predicted, candidate) in pairs.into_iter().take(MOST_TRIED) {
        let is_better = best.estimate.at_most > goal || predicted < best.cost;
        if !is_better {
            break;
        }
        let (output, cost) = search.trace(candidate)?;
        let estimate = search.sparse.error(&output.picture.colors, &reference);
        let keeps = estimate.at_most <= goal;
        if keeps && (cost < best.cost || best.estimate.at_most > goal) {
            best = Tried { candidate, estimate, cost };
        }
    }
    let Tried { candidate, estimate, cost } = best;
    Ok(Found { candidate, estimate, cost, limits })
}

/// What rays cost and how far they are from the reference, with levels and a cutoff that lose little; others may cost
/// this part of it.
fn tried_rays(
    search: &mut Search<'_>,
    limits: Limits,
    part: f64,
    reference: &[Rgb],
) -> Result<Vec<Tried>, RenderError> {
    let (settings, Goal { error: goal, fixed, .. }) = (search.settings, search.goal);
    let mut list = rays(settings.filter, goal);
    if fixed.sampler {
        list.retain(|rays| rays.select.is_some());
        list.iter_mut().for_each(|rays| rays.sampler = settings.sampler);
        list.push(Rays { sampler: settings.sampler, select: None });
    }
    if fixed.select {
        list.retain(|rays| rays.select.is_none());
        list.iter_mut().for_each(|rays| rays.select = settings.select);
    }
    let mut tried: Vec<Tried> = Vec::new();
    let mut cheapest = f64::INFINITY;
    for rays in list {
        if !fixed.sampler
            && tried.iter().any(|it| it.is_dearer(rays, cheapest / part) || it.is_worse(rays, goal))
        {
            continue;
        }
        let candidate = Candidate { limits, rays };
        let (output, cost) = search.trace(candidate)?;
        let estimate = search.sparse.error(&output.picture.colors, reference);
        if estimate.at_most <= goal && cost < cheapest {
            cheapest = cost;
        }
        tried.push(Tried { candidate, estimate, cost });
    }
    Ok(tried)
}

/// Rays that were tried.
#[derive(Clone, Copy, Debug)]
struct Tried {
    candidate: Candidate,
    estimate: Estimate,
    cost: f64,
}

/// How fast the error of more rays falls at most: as this power of their number.
const FALLS: f64 = 0.85;

impl Tried {
    /// Whether other rays cost more than `cheapest`, because these do.
    fn is_dearer(&self, rays: Rays, cheapest: f64) -> bool {
        let times = rays.times(self.candidate.rays);
        times.is_some_and(|times| SAVES * times * self.cost > cheapest)
    }

    /// Whether more rays of the same sampler cannot keep the error, however fast it falls.
    fn is_worse(&self, rays: Rays, goal: f64) -> bool {
        let it = self.candidate.rays;
        let same = std::mem::discriminant(&it.sampler) == std::mem::discriminant(&rays.sampler);
        match (it.count(), rays.count()) {
            (Some(known), Some(count)) if same && 1 < known && known < count => {
                self.estimate.error / libm::pow(f64::from(count) / f64::from(known), FALLS) > goal
            }
            _ => false,
        }
    }
}
