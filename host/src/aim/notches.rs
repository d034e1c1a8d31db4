//! Levels and cutoffs: what each loses by itself, and what it costs.
//!
//! They show with few rays, for these are the same in all pictures that are compared. Levels are raised
//! until nothing is cut or nothing changes; then the cutoff is lowered as far as that of the truth.

use strahl_core::{EffectSet, Rgb};

use super::error::{Goal, Search, Setting};
use super::plan::{LEVELS, Rays, cutoffs};
use crate::render_output::RenderError;
use crate::sampling::Sampling;
use strahl_core::Limits;

/// How small a change of levels or cutoff is, as a part of the error that is aimed at, after which
/// no more are looked for.
const SETTLED: f64 = 1.0 / 24.0;
/// What the truth may lose by its levels and cutoff, as a part of the error that is aimed at.
const TRUE: f64 = 1.0 / 12.0;
/// What is predicted to be this much too large may be small enough.
pub(super) const HOPE: f64 = 1.1;

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

impl Search<'_> {
    /// Levels and cutoffs, the finest first, none of which is dearer than another that loses less.
    pub fn notches(&mut self, asks: &EffectSet) -> Result<Vec<Notch>, RenderError> {
        let Goal { error: goal, fixed, .. } = self.goal;
        let asked = self.request.settings.limits();
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
            let is_whole = drawn.counters.level_limit.rays == 0;
            let change =
                by_levels.last().map(|(_, last, _)| self.sparse.error(&drawn.picture.colors, last).error);
            by_levels.push((*levels, drawn.picture.colors, price));
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
                by_cutoff.push((cutoff, self.sparse.error(&drawn.picture.colors, best).error, price / whole));
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
}

/// The cheapest of some notches, the finest of which come first, that loses no more than this.
pub(super) fn cheapest_within(notches: &[Notch], most: f64) -> Option<Notch> {
    notches.iter().rev().find(|notch| notch.error <= most).or(notches.first()).copied()
}

/// Levels and cutoff of the truth for this error.
pub fn limits_of_truth(notches: &[Notch], goal: f64) -> Limits {
    cheapest_within(notches, TRUE * goal).map_or(Limits::DEFAULT, |notch| notch.limits)
}
