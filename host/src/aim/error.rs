//! The cheapest settings whose error is below a limit, found on a sparse sample of pixels.
//!
//! 1. How many levels and which cutoff it takes until nothing changes any more (room `notches`): those
//!    of the truth.
//! 2. Which rays keep the error with levels and a cutoff that lose little of it, from the cheapest
//!    on. A number of rays is not tried whose error cannot become small enough, however fast it falls,
//!    and none that is dearer than what has been found, whatever levels and cutoff go with it.
//! 3. What of both goes together: what is predicted to keep the error is tried, in the order of its
//!    predicted price, until the next one is dearer than the best that did.

use std::sync::Arc;
use std::time::Instant;

use strahl_core::{EffectSet, Rgb};

use super::notches::{HOPE, cheapest_within, limits_of_truth};
use super::plan::{Rays, SAVES, rays};
use super::sparse::{Estimate, Sparse, rmse};
use super::truth::truth;
use super::{Aimed, Target};
use crate::cost::WEIGHTS;
use crate::description::Description;
use crate::progress::Progress;
use crate::render_output::{RenderError, RenderOutput};
use crate::render_request::RenderRequest;
use crate::session::{SceneStorage, Session};
use strahl_core::Limits;

/// What is not to be changed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Fixed {
    /// Levels.
    pub levels: bool,
    /// The cutoff.
    pub cutoff: bool,
    /// Rays in a pixel.
    pub sampling: bool,
    /// Pixels that are traced.
    pub selecting: bool,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// The largest error.
    pub error: f64,
    /// What stays as it is.
    pub fixed: Fixed,
    /// Whether the true error is to be measured.
    pub verify: bool,
}

/// What may be lost by those with which rays are looked for: a twentieth of what is measured then.
const WORKING: f64 = 1.0 / 3.0;
/// The most combinations that are tried.
const MOST_TRIED: usize = 24;

/// Finds settings that keep the goal and traces the picture with them.
pub fn trace(
    description: &Description,
    request: &RenderRequest,
    goal: Goal,
    progress: &dyn Progress,
) -> Result<(RenderOutput, Aimed), RenderError> {
    let mut storage = SceneStorage::new(description, request.settings.precision);
    let session = Session::new(description, &mut storage, &request.settings.acceleration())?;
    let clock = Instant::now();
    let mut search = Search::new(&session, request, goal, progress);
    let found = search.find(&session.scene().asks)?;
    let seconds = clock.elapsed().as_secs_f64();
    let taken = found.setting.of(request);
    let output = session.render(&taken, progress)?;
    let measured = match goal.verify {
        true => {
            let truth = session.render(&truth(request, found.limits, goal.error, 1), progress)?;
            Some(rmse(&output.picture.colors, &truth.picture.colors))
        }
        false => None,
    };
    let Estimate { error: estimate, at_most } = found.estimate;
    let what = truth(request, found.limits, goal.error, 0);
    let aimed = Aimed {
        kept: at_most <= goal.error && measured.is_none_or(|error| error <= goal.error),
        target: Target::Error {
            asked: goal.error,
            estimate,
            at_most,
            pixels: search.sparse.pixels(),
            tried: search.tried,
            truth: format!(
                "{} with {} levels and cutoff {}",
                what.settings.sampler, what.settings.levels, what.settings.cutoff
            ),
            measured,
            seconds,
        },
        why: found.why(goal.error),
        taken: taken.settings,
    };
    Ok((output, aimed))
}

/// Levels, cutoff and rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel, and which pixels.
    pub rays: Rays,
}

impl Setting {
    /// The picture that is requested, so made.
    pub fn of(self, request: &RenderRequest) -> RenderRequest {
        let request = self.rays.of(request);
        request.with(request.settings.clone().with_limits(self.limits))
    }
}

/// What was found.
pub struct Found {
    /// The cheapest that keeps the error, or the best that there is.
    pub setting: Setting,
    /// Its error.
    pub estimate: Estimate,
    /// What its pixels cost, in instructions.
    pub price: f64,
    /// Levels and cutoff of the truth.
    pub limits: Limits,
}

impl Found {
    fn why(&self, goal: f64) -> String {
        let Setting { limits: Limits { levels, cutoff }, rays } = self.setting;
        let selecting = rays.selecting.map(|it| format!(", selection {it}")).unwrap_or_default();
        let what = format!("{levels} levels, cutoff {cutoff}, {}{selecting}", rays.sampling);
        if self.estimate.at_most <= goal {
            format!("{what}: the cheapest that keeps it")
        } else {
            format!("{what}: the best that there is")
        }
    }
}

/// A search on a sample of pixels.
pub struct Search<'s> {
    session: &'s Session<'s>,
    pub(super) request: RenderRequest,
    pub(super) goal: Goal,
    progress: &'s dyn Progress,
    /// The pixels that are looked at.
    pub sparse: Sparse,
    /// How many settings were looked at.
    pub tried: usize,
}

impl<'s> Search<'s> {
    /// For the picture that is requested.
    pub fn new(
        session: &'s Session<'s>,
        request: &RenderRequest,
        goal: Goal,
        progress: &'s dyn Progress,
    ) -> Self {
        let sparse = Sparse::of(request);
        let request = sparse.only(request);
        Search { session, request, goal, progress, sparse, tried: 0 }
    }

    /// Traces the sample; its price in instructions.
    pub(super) fn look(&mut self, setting: Setting) -> Result<(RenderOutput, f64), RenderError> {
        self.tried += 1;
        let cost_map = self.sparse.cost_map();
        let request = RenderRequest { cost_map: Some(Arc::clone(&cost_map)), ..setting.of(&self.request) };
        let drawn = self.session.render(&request, self.progress)?;
        let price = WEIGHTS.work_of_map(&cost_map, drawn.accelerator.choice.kind);
        Ok((drawn, price))
    }

    /// The cheapest setting that keeps the error.
    pub fn find(&mut self, asks: &EffectSet) -> Result<Found, RenderError> {
        let notches = self.notches(asks)?;
        let Some(working) = cheapest_within(&notches, WORKING * self.goal.error) else {
            return Err(RenderError::invalid("there are no levels"));
        };
        let limits = limits_of_truth(&notches, self.goal.error);
        let truth = truth(&self.request, limits, self.goal.error, 0);
        let truth = self.session.render(&truth, self.progress)?.picture.colors;

        // The most that coarser levels and cutoffs can save.
        let part = notches.last().map_or(1.0, |notch| notch.price / working.price);
        let seen = self.rays(working.limits, part, &truth)?;
        // The best that there is, if nothing keeps the error.
        let best = seen.iter().min_by(|a, b| a.estimate.at_most.total_cmp(&b.estimate.at_most));
        let Some(mut best) = best.copied() else { return Err(RenderError::invalid("there are no rays")) };
        if let Some(cheapest) = seen
            .iter()
            .filter(|it| it.estimate.at_most <= self.goal.error)
            .min_by(|a, b| a.price.total_cmp(&b.price))
        {
            best = *cheapest;
        }

        let mut pairs: Vec<(f64, Setting)> = Vec::new();
        for it in &seen {
            for notch in notches.iter().filter(|notch| notch.limits != working.limits) {
                let square = |error: f64| error * error;
                let alone = (square(it.estimate.error) - square(working.error)).max(0.0);
                let error = (alone + square(notch.error)).sqrt();
                if error <= HOPE * self.goal.error {
                    let setting = Setting { limits: notch.limits, rays: it.setting.rays };
                    pairs.push((it.price * notch.price / working.price, setting));
                }
            }
        }
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (predicted, setting) in pairs.into_iter().take(MOST_TRIED) {
            let is_better = best.estimate.at_most > self.goal.error || predicted < best.price;
            if !is_better {
                break;
            }
            let (drawn, price) = self.look(setting)?;
            let estimate = self.sparse.error(&drawn.picture.colors, &truth);
            let keeps = estimate.at_most <= self.goal.error;
            if keeps && (price < best.price || best.estimate.at_most > self.goal.error) {
                best = Seen { setting, estimate, price };
            }
        }
        let Seen { setting, estimate, price } = best;
        Ok(Found { setting, estimate, price, limits })
    }

    /// What rays cost and how far they are from the truth, with levels and a cutoff that lose little;
    /// others may take this part of the price.
    fn rays(&mut self, limits: Limits, part: f64, truth: &[Rgb]) -> Result<Vec<Seen>, RenderError> {
        let Goal { error: goal, fixed, .. } = self.goal;
        let mut list = rays(self.request.settings.filter, goal);
        if fixed.sampling {
            list.retain(|rays| rays.selecting.is_some());
            list.iter_mut().for_each(|rays| rays.sampling = self.request.settings.sampler);
            list.push(Rays { sampling: self.request.settings.sampler, selecting: None });
        }
        if fixed.selecting {
            list.retain(|rays| rays.selecting.is_none());
            list.iter_mut().for_each(|rays| rays.selecting = self.request.settings.select);
        }
        let mut seen: Vec<Seen> = Vec::new();
        let mut cheapest = f64::INFINITY;
        for rays in list {
            if !fixed.sampling
                && seen.iter().any(|it| it.is_dearer(rays, cheapest / part) || it.is_worse(rays, goal))
            {
                continue;
            }
            let setting = Setting { limits, rays };
            let (drawn, price) = self.look(setting)?;
            let estimate = self.sparse.error(&drawn.picture.colors, truth);
            if estimate.at_most <= goal && price < cheapest {
                cheapest = price;
            }
            seen.push(Seen { setting, estimate, price });
        }
        Ok(seen)
    }
}

/// Rays that were tried.
#[derive(Clone, Copy, Debug)]
struct Seen {
    setting: Setting,
    estimate: Estimate,
    price: f64,
}

/// How fast the error of more rays falls at most: as this power of their number.
const FALLS: f64 = 0.85;

impl Seen {
    /// Whether other rays cost more than `cheapest`, because these do.
    fn is_dearer(&self, rays: Rays, cheapest: f64) -> bool {
        let times = rays.times(self.setting.rays);
        times.is_some_and(|times| SAVES * times * self.price > cheapest)
    }

    /// Whether more rays of the same sampler cannot keep the error, however fast it falls.
    fn is_worse(&self, rays: Rays, goal: f64) -> bool {
        let it = self.setting.rays;
        let same = std::mem::discriminant(&it.sampling) == std::mem::discriminant(&rays.sampling);
        match (it.count(), rays.count()) {
            (Some(known), Some(count)) if same && 1 < known && known < count => {
                self.estimate.error / libm::pow(f64::from(count) / f64::from(known), FALLS) > goal
            }
            _ => false,
        }
    }
}
