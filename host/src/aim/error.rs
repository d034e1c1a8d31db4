//! The cheapest settings whose error is below a limit, found on a sparse sample of pixels.
//!
//! 1. How many levels and which cutoff it takes until nothing changes any more: those of the truth.
//!    Differences of levels and cutoffs show with few rays, for these are the same in both pictures.
//! 2. Which rays keep the error with levels and a cutoff that lose little of it, from the cheapest
//!    on. A number of rays is not tried whose error cannot become small enough, however fast it falls,
//!    and none that is dearer than what has been found.
//! 3. What of both goes together: what is predicted to keep the error is tried, in the order of its
//!    predicted price, until the next one is dearer than the best that did.

use std::sync::Arc;
use std::time::Instant;

use strahl_core::{EffectSet, Rgb};

use super::plan::{LEVELS, Rays, cutoffs, rays};
use super::sparse::{Estimate, Sparse, rmse};
use super::truth::truth;
use super::{Aimed, Target};
use crate::description::Description;
use crate::frame::{self, Drawn, Frame, NoFrame, Studio};
use crate::plan::asked_by;
use crate::progress::Watch;
use crate::sampling::Sampling;
use crate::stock::single::Stock;
use crate::wanted::{Limits, Wanted};

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

/// How small a change of levels or cutoff is, as a part of the error that is aimed at, after which
/// no more are looked for.
const SETTLED: f64 = 1.0 / 24.0;
/// What the truth may lose by its levels and cutoff, as a part of the error that is aimed at.
const TRUE: f64 = 1.0 / 12.0;
/// What may be lost by those with which rays are looked for: a twentieth of what is measured then.
const WORKING: f64 = 1.0 / 3.0;
/// What is predicted to be this much too large may be small enough.
const HOPE: f64 = 1.1;
/// The most combinations that are tried.
const MOST_TRIED: usize = 24;

/// Finds settings that keep the goal and traces the picture with them.
pub fn trace(
    description: &Description,
    wanted: &Wanted,
    goal: Goal,
    watch: &Watch,
) -> Result<(Frame, Aimed), NoFrame> {
    let mut aimed = None;
    let stock = Stock::new(description);
    let asks = asked_by(description, &stock.scene().map_err(NoFrame::wrong)?);
    drop(stock);
    let frame = frame::open(description, wanted.precision, &wanted.finding, &mut |studio| {
        let clock = Instant::now();
        let mut search = Search::new(studio, wanted, goal, watch);
        let found = search.find(&asks)?;
        let seconds = clock.elapsed().as_secs_f64();
        let taken = found.setting.of(wanted);
        let drawn = studio.trace(&taken, watch)?;
        let measured = match goal.verify {
            true => {
                let truth = studio.trace(&truth(wanted, found.limits, goal.error, 1), watch)?;
                Some(rmse(&drawn.colors, &truth.colors))
            }
            false => None,
        };
        let Estimate { error: estimate, at_most } = found.estimate;
        let what = truth(wanted, found.limits, goal.error, 0);
        aimed = Some(Aimed {
            taken: taken.clone(),
            kept: at_most <= goal.error && measured.is_none_or(|error| error <= goal.error),
            target: Target::Error {
                asked: goal.error,
                estimate,
                at_most,
                pixels: search.sparse.pixels(),
                tried: search.tried,
                truth: format!(
                    "{} with {} levels and cutoff {}",
                    what.sampling, what.limits.levels, what.limits.cutoff
                ),
                measured,
                seconds,
            },
            why: found.why(goal.error),
            command: String::new(),
        });
        Ok((taken, drawn))
    })?;
    match aimed {
        Some(aimed) => Ok((frame, aimed)),
        None => Err(NoFrame::wrong("nothing was aimed at")),
    }
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
    /// The picture that is wanted, so made.
    pub fn of(self, wanted: &Wanted) -> Wanted {
        Wanted { limits: self.limits, ..self.rays.of(wanted) }
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

/// Levels and a cutoff, the error that they make by themselves, and what they cost against those
/// of the truth.
#[derive(Clone, Copy, Debug)]
pub struct Notch {
    /// Levels and cutoff.
    pub limits: Limits,
    /// What is lost by them.
    pub error: f64,
    /// The part of the price.
    pub price: f64,
}

/// A search on a sample of pixels.
pub struct Search<'s> {
    studio: &'s dyn Studio,
    wanted: Wanted,
    goal: Goal,
    watch: &'s Watch,
    /// The pixels that are looked at.
    pub sparse: Sparse,
    /// How many settings were looked at.
    pub tried: usize,
}

impl<'s> Search<'s> {
    /// For the picture that is wanted.
    pub fn new(studio: &'s dyn Studio, wanted: &Wanted, goal: Goal, watch: &'s Watch) -> Self {
        let sparse = Sparse::of(wanted);
        let wanted = sparse.only(wanted);
        Search { studio, wanted, goal, watch, sparse, tried: 0 }
    }

    /// Traces the sample; its price in instructions.
    fn look(&mut self, setting: Setting) -> Result<(Drawn, f64), NoFrame> {
        self.tried += 1;
        let sheet = self.sparse.sheet();
        let wanted = Wanted { sheet: Some(Arc::clone(&sheet)), ..setting.of(&self.wanted) };
        let drawn = self.studio.trace(&wanted, self.watch)?;
        let price = sheet.work(drawn.accelerator.choice.kind);
        Ok((drawn, price))
    }

    /// The cheapest setting that keeps the error.
    pub fn find(&mut self, asks: &EffectSet) -> Result<Found, NoFrame> {
        let notches = self.notches(asks)?;
        let Some(working) = cheapest_within(&notches, WORKING * self.goal.error) else {
            return Err(NoFrame::wrong("there are no levels"));
        };
        let limits = limits_of_truth(&notches, self.goal.error);
        let truth = truth(&self.wanted, limits, self.goal.error, 0);
        let truth = self.studio.trace(&truth, self.watch)?.colors;

        let seen = self.rays(working.limits, &truth)?;
        // The best that there is, if nothing keeps the error.
        let best = seen.iter().min_by(|a, b| a.estimate.at_most.total_cmp(&b.estimate.at_most));
        let Some(mut best) = best.copied() else { return Err(NoFrame::wrong("there are no rays")) };
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
            let estimate = self.sparse.error(&drawn.colors, &truth);
            let keeps = estimate.at_most <= self.goal.error;
            if keeps && (price < best.price || best.estimate.at_most > self.goal.error) {
                best = Seen { setting, estimate, price };
            }
        }
        let Seen { setting, estimate, price } = best;
        Ok(Found { setting, estimate, price, limits })
    }

    /// Levels and cutoffs, the finest first, none of which is dearer than another that loses less.
    pub fn notches(&mut self, asks: &EffectSet) -> Result<Vec<Notch>, NoFrame> {
        let Goal { error: goal, fixed, .. } = self.goal;
        let asked = self.wanted.limits;
        let branches = asks.reflection || asks.transmission;
        let finest = if fixed.cutoff || !branches {
            asked.cutoff
        } else {
            (goal / 64.0).clamp(1e-5, 1.0 / 512.0) as f32
        };
        let rays = Rays { sampling: Sampling::stochastic(2), selecting: None };

        // More and more levels, until nothing is cut or nothing changes.
        let mut by_levels: Vec<(u8, Vec<Rgb>, f64)> = Vec::new();
        let ladder: &[u8] = if fixed.levels || !branches { &[asked.levels] } else { &LEVELS };
        let mut settled = 0;
        for levels in ladder {
            let limits = Limits { levels: *levels, cutoff: finest };
            let (drawn, price) = self.look(Setting { limits, rays })?;
            let is_whole = drawn.counts.as_ref().is_some_and(|counts| counts.level_limit() == 0);
            let change = by_levels.last().map(|(_, last, _)| self.sparse.error(&drawn.colors, last).error);
            by_levels.push((*levels, drawn.colors, price));
            settled = if change.is_some_and(|change| change <= SETTLED * goal) { settled + 1 } else { 0 };
            if is_whole || settled >= 2 {
                break;
            }
        }
        let Some((most, best, whole)) = by_levels.last() else { return Ok(Vec::new()) };
        let limits = Limits { levels: *most, cutoff: finest };
        let mut by_cutoff = vec![(finest, 0.0, 1.0)];
        if branches && !fixed.cutoff {
            for cutoff in cutoffs().filter(|cutoff| *cutoff > finest) {
                let (drawn, price) = self.look(Setting { limits: Limits { cutoff, ..limits }, rays })?;
                by_cutoff.push((cutoff, self.sparse.error(&drawn.colors, best).error, price / whole));
            }
        }

        let mut notches = Vec::new();
        for (levels, colors, price) in &by_levels {
            let error = self.sparse.error(colors, best).error;
            for (cutoff, more, part) in &by_cutoff {
                let limits = Limits { levels: *levels, cutoff: *cutoff };
                // What levels and cutoff cut is partly the same light: the sum is the most.
                notches.push(Notch { limits, error: error + more, price: price / whole * part });
            }
        }
        // The finest, and those that lose less than all that are cheaper.
        notches.sort_by(|a, b| a.price.total_cmp(&b.price).then(a.error.total_cmp(&b.error)));
        let finest = Notch { limits, error: 0.0, price: 1.0 };
        let mut least = f64::INFINITY;
        notches.retain(|notch| {
            let keeps = notch.error < least && notch.error <= HOPE * goal && notch.limits != limits;
            if keeps {
                least = notch.error;
            }
            keeps
        });
        notches.push(finest);
        notches.reverse();
        Ok(notches)
    }

    /// What rays cost and how far they are from the truth, with its levels and cutoff.
    fn rays(&mut self, limits: Limits, truth: &[Rgb]) -> Result<Vec<Seen>, NoFrame> {
        let Goal { error: goal, fixed, .. } = self.goal;
        let mut list = rays(self.wanted.filter, goal);
        if fixed.sampling {
            list.retain(|rays| rays.selecting.is_some());
            list.iter_mut().for_each(|rays| rays.sampling = self.wanted.sampling);
            list.push(Rays { sampling: self.wanted.sampling, selecting: None });
        }
        if fixed.selecting {
            list.retain(|rays| rays.selecting.is_none());
            list.iter_mut().for_each(|rays| rays.selecting = self.wanted.selecting);
        }
        let mut seen: Vec<Seen> = Vec::new();
        let mut cheapest = f64::INFINITY;
        for rays in list {
            if let Some(count) = rays.count().filter(|_| !fixed.sampling)
                && seen.iter().any(|it| is_hopeless(it, rays, count, goal, cheapest))
            {
                continue;
            }
            let setting = Setting { limits, rays };
            let (drawn, price) = self.look(setting)?;
            let estimate = self.sparse.error(&drawn.colors, truth);
            if estimate.at_most <= goal && price < cheapest {
                cheapest = price;
            }
            seen.push(Seen { setting, estimate, price });
        }
        Ok(seen)
    }
}

/// The cheapest of some notches, the finest of which come first, that loses no more than this.
fn cheapest_within(notches: &[Notch], most: f64) -> Option<Notch> {
    notches.iter().rev().find(|notch| notch.error <= most).or(notches.first()).copied()
}

/// Levels and cutoff of the truth for this error.
pub fn limits_of_truth(notches: &[Notch], goal: f64) -> Limits {
    cheapest_within(notches, TRUE * goal).map_or(Limits::DEFAULT, |notch| notch.limits)
}

/// How fast the error of more rays falls at most: as this power of their number.
const FALLS: f64 = 0.85;

/// Whether this many rays of the same sampler cannot keep the error, or only for more than `cheapest`.
fn is_hopeless(it: &Seen, rays: Rays, count: u32, goal: f64, cheapest: f64) -> bool {
    let Some(known) = it.setting.rays.count().filter(|known| *known < count && *known > 1) else {
        return false;
    };
    let ratio = f64::from(count) / f64::from(known);
    // Rays through the same pixels cost about the same.
    let is_dear = 0.9 * it.price * ratio > cheapest;
    let same = std::mem::discriminant(&it.setting.rays.sampling) == std::mem::discriminant(&rays.sampling);
    is_dear || same && it.estimate.error / libm::pow(ratio, FALLS) > goal
}

/// Rays that were tried.
#[derive(Clone, Copy, Debug)]
struct Seen {
    setting: Setting,
    estimate: Estimate,
    price: f64,
}
