//! A study from its beginning to its end.
//!
//! The levels are raised until nothing is cut, which tells the limits of the reference and how
//! long anything takes here. The reference comes next; then every knob alone, the scene's own
//! settings, mixtures, techniques; and with the time that is left, everything again, round by
//! round, so that what disturbs the machine for a while disturbs all settings alike.

use strahl_core::Limits;

use super::bench::{Bench, Taken, errors, mean};
use super::front::{Point, front};
use super::knobs;
use super::mixtures;
use super::options::Options;
use super::plan::{FINE_CUTOFF, LEVELS, NEXT_TO_NOTHING, Plan};
use super::record::{Errors, Knob, LeftOut, Reference, Role, Step, Technique};
use super::techniques;
use crate::failure::Failure;
use crate::picture::Picture;
use crate::plan::Effect;
use crate::precision::Precision;
use crate::sampling::Sampling;

/// Shares of the time that is given.
pub(super) mod time {
    /// For one level more.
    pub const LEVEL: f64 = 0.06;
    /// For the reference.
    pub const REFERENCE: f64 = 0.28;
    /// For one setting.
    pub const SETTING: f64 = 0.05;
    /// For one technique.
    pub const TECHNIQUE: f64 = 0.05;
    /// Until mixtures end.
    pub const MIXED: f64 = 0.72;
    /// Until everything ends but the page.
    pub const MEASURED: f64 = 0.92;
}

/// What was found so far.
pub struct Conduct<'b> {
    pub(super) bench: &'b Bench<'b>,
    pub(super) plan: &'b Plan,
    /// Everything that was measured.
    pub taken: Vec<Taken>,
    /// Knobs turned alone.
    pub knobs: Vec<Knob>,
    /// Techniques on and off.
    pub techniques: Vec<Technique>,
    /// The same with more and more threads.
    pub threads: Vec<usize>,
    /// What was not measured.
    pub left_out: Vec<LeftOut>,
    /// How many mixtures cannot be on the front.
    pub beaten: usize,
    /// After how many seconds all of it should be over, if nothing bounds it.
    foretold: f64,
    /// What was given up, and after how many seconds.
    given_up: Vec<(Options, f64)>,
}

/// What everything is held against.
pub struct Truth {
    /// The picture.
    pub picture: Picture,
    /// How it was made.
    pub reference: Reference,
}

impl<'b> Conduct<'b> {
    /// Nothing is measured yet.
    pub fn new(bench: &'b Bench<'b>, plan: &'b Plan) -> Self {
        let (taken, knobs, techniques, threads, left_out, given_up) = Default::default();
        let (beaten, foretold) = (0, 0.0);
        Conduct { bench, plan, taken, knobs, techniques, threads, left_out, beaten, foretold, given_up }
    }

    /// Measures a scene whose own settings are `own`, and which asks for `asks`.
    pub fn run(&mut self, own: &Options, asks: &[Effect]) -> Result<Truth, Failure> {
        let best = self.levels(own)?;
        let truth = self.reference(best)?;
        for taken in &mut self.taken {
            judge(taken, &truth.picture);
        }
        knobs::cutoffs(self, best, &truth)?;
        knobs::samplers(self, best, &truth)?;
        knobs::selections(self, best, &truth)?;
        knobs::effects(self, best, &truth, asks)?;
        self.take(Role::Own, own, f64::INFINITY, &truth.picture)?;
        techniques::precision(self, own, &truth)?;
        techniques::all(self, own, &truth)?;
        techniques::threads(self, own, &truth)?;
        mixtures::all(self, best, &truth)?;
        self.repeat()?;
        Ok(truth)
    }

    /// Measures nothing but the techniques, and `repeats` times in all; there is no reference, so the errors of
    /// runs are those against the picture of `own`.
    pub fn evaluate(&mut self, own: &Options) -> Result<(), Failure> {
        let begun = self.bench.elapsed();
        let frame = self.bench.trace(own, f64::INFINITY)?;
        let frame = frame.ok_or_else(|| Failure::Usage("the picture took for ever".into()))?;
        let setting = own.record(&frame.accelerator.choice);
        let reference = Reference { setting, noise: 0.0, cut: 0.0, seconds: self.bench.elapsed() - begun };
        techniques::all(self, own, &Truth { picture: frame.picture, reference })?;
        self.repeat()
    }

    /// Raises the levels until nothing is cut; the place of the best.
    fn levels(&mut self, own: &Options) -> Result<usize, Failure> {
        let coarse = Options {
            limits: Limits { levels: 1, cutoff: FINE_CUTOFF },
            sampling: Sampling::Single,
            selecting: None,
            precision: Precision::Single,
            seed: 0,
            ..own.clone()
        };
        for levels in LEVELS {
            let options = Options { limits: Limits { levels, cutoff: FINE_CUTOFF }, ..coarse.clone() };
            // The first must be there. In a plan without end none may take longer than a minute.
            let is_first = self.taken.is_empty();
            let most = if is_first { f64::INFINITY } else { self.bench.share(time::LEVEL).min(60.0) };
            let Some(taken) = self.bench.take(Role::Knob, &options, most)? else {
                self.leave(&options, format!("given up after {most:.1} s"));
                break;
            };
            let is_whole = taken.run.cut[0] <= NEXT_TO_NOTHING;
            self.taken.push(taken);
            if is_whole {
                break;
            }
        }
        let last = self.taken.len() - 1;
        let step = |(run, taken): (usize, &Taken)| Step {
            value: taken.options.limits.levels.to_string(),
            run,
            alone: self.between(run, last).unwrap_or_default(),
        };
        let steps = self.taken.iter().enumerate().map(step).collect();
        self.knobs.push(Knob {
            name: "levels".into(),
            about: "How many times light may be mirrored or pass a surface before the eye.".into(),
            fixed: format!("--cutoff 1/65536 --sampler {}", coarse.sampling),
            against: "the most levels".into(),
            steps,
        });

        // No cutoff at all, where that does not take much longer.
        let (mut whole, most) = (self.taken[last].options.clone(), 3.0 * self.taken[last].run.wall[0] + 0.1);
        whole.limits.cutoff = 0.0;
        let best = match self.bench.take(Role::Knob, &whole, most.min(self.bench.share(time::LEVEL)))? {
            Some(taken) => {
                self.taken.push(taken);
                self.taken.len() - 1
            }
            None => last,
        };
        Ok(best)
    }

    /// Makes the reference with the limits of the run at `best`.
    fn reference(&mut self, best: usize) -> Result<Truth, Failure> {
        let begun = self.bench.elapsed();
        let single = &self.taken[best];
        let seconds = self.bench.share(time::REFERENCE);
        // An unlimited plan bounds its reference too: to an hour.
        let samples = self.plan.samples(single.run.wall[0], seconds.min(3600.0));
        let of = |seed| Options {
            sampling: Sampling::stochastic((samples / 2).max(1)),
            seed,
            ..single.options.clone()
        };
        let rays = self.plan.rays(single.options.filter, samples);
        self.foretold = begun + single.run.wall[0] * (f64::from(samples) + rays * self.plan.repeats as f64);
        self.bench.meter.left(self.ahead());
        let traced = |seed| {
            let frame = self.bench.trace(&of(seed), f64::INFINITY)?;
            frame.ok_or_else(|| Failure::Usage("the reference took for ever".into()))
        };
        let (one, other) = (traced(1)?, traced(2)?);
        let cut = one.counters.as_ref().map(|counts| counts.cut()).unwrap_or_default();
        let reference = Reference {
            setting: of(1).record(&one.accelerator.choice),
            // The mean of two has half of the variance of their difference, halved again.
            noise: 0.5 * errors(&one.picture, &other.picture).rmse,
            cut: cut[0] + cut[1],
            seconds: self.bench.elapsed() - begun,
        };
        Ok(Truth { picture: mean(&one.picture, &other.picture), reference })
    }

    /// Measures a setting, if it has not been, and if it takes no longer than it may; its place.
    pub(super) fn take(
        &mut self,
        role: Role,
        options: &Options,
        most: f64,
        truth: &Picture,
    ) -> Result<Option<usize>, Failure> {
        let is_same = |taken: &Taken| taken.options == *options;
        if let Some(place) = self.taken.iter().position(is_same) {
            if role == Role::Own {
                self.taken[place].run.role = role;
            }
            return Ok(Some(place));
        }
        // The scene's own setting must be there.
        let left = match role {
            Role::Own => f64::INFINITY,
            _ => self.bench.share(time::MEASURED) - self.bench.elapsed(),
        };
        if left <= 0.0 {
            self.leave(options, "no time was left".into());
            return Ok(None);
        }
        let most = if most < left { most } else { left };
        // It would not be done now either.
        if self.given_up_after(options).is_some_and(|after| after >= 0.9 * most) {
            return Ok(None);
        }
        let Some(mut taken) = self.bench.take(role, options, most)? else {
            self.leave(options, format!("given up after {most:.1} s"));
            self.given_up.push((options.clone(), most));
            return Ok(None);
        };
        judge(&mut taken, truth);
        self.taken.push(taken);
        self.bench.meter.left(self.ahead());
        Ok(Some(self.taken.len() - 1))
    }

    /// Measures a setting of one knob that is expected to take `seconds`, unless that is too long.
    pub(super) fn turn(
        &mut self,
        options: &Options,
        seconds: f64,
        truth: &Picture,
    ) -> Result<Option<usize>, Failure> {
        let most = self.bench.share(time::SETTING);
        if seconds > 1.5 * most {
            self.leave(options, format!("about {seconds:.0} s; a larger --time-limit allows more"));
            return Ok(None);
        }
        self.take(Role::Knob, options, 2.5 * most, truth)
    }

    /// After how many seconds of wall-clock time a setting was given up, if it was.
    pub(super) fn given_up_after(&self, options: &Options) -> Option<f64> {
        self.given_up.iter().rev().find(|(it, _)| it == options).map(|(_, after)| *after)
    }

    /// The most seconds that a technique may take.
    pub(super) fn patience(&self) -> f64 {
        self.bench.share(time::TECHNIQUE).min(120.0)
    }

    /// How far the picture of one run is from that of another, while both are there.
    pub(super) fn between(&self, place: usize, other: usize) -> Option<Errors> {
        let picture = |place: usize| self.taken[place].picture.as_ref();
        Some(errors(picture(place)?, picture(other)?))
    }

    pub(super) fn leave(&mut self, options: &Options, why: String) {
        self.left_out.push(LeftOut { setting: options.words(), why });
    }

    /// Places of what tells what accuracy costs, and how it stands.
    pub(super) fn points(&self) -> (Vec<usize>, Vec<Point>) {
        let all = self.taken.iter().enumerate().filter(|(_, taken)| taken.run.is_about_accuracy());
        all.map(|(place, it)| (place, Point { cost: it.run.work, error: it.run.error.rmse })).unzip()
    }

    /// Drops the pictures that nobody will look at: those of settings that others beat.
    pub(super) fn forget(&mut self) {
        let (places, points) = self.points();
        let kept: Vec<usize> = front(&points).into_iter().map(|place| places[place]).collect();
        for (place, taken) in self.taken.iter_mut().enumerate() {
            if !kept.contains(&place) && taken.run.role != Role::Own {
                taken.picture = None;
            }
        }
    }

    /// Measures times again, round by round, until they are known or the time is over.
    fn repeat(&mut self) -> Result<(), Failure> {
        self.forget();
        let (places, points) = self.points();
        let kept: Vec<usize> = front(&points).into_iter().map(|place| places[place]).collect();
        // Mixtures that others beat are not looked at twice.
        let is_wanted = |place: &usize| kept.contains(place) || self.taken[*place].run.role != Role::Mix;
        let wanted: Vec<usize> = (0..self.taken.len()).filter(is_wanted).collect();
        let end = self.bench.share(time::MEASURED);
        for round in 1..self.plan.repeats {
            for (done, place) in wanted.iter().enumerate() {
                let again = self.taken[*place].run.wall[0] + self.taken[*place].run.build;
                let left = end - self.bench.elapsed();
                // What is long is repeated where much time is left, and disturbed less anyway.
                if again > 0.1 * left {
                    continue;
                }
                self.bench.repeat(&mut self.taken[*place])?;
                let rounds = (self.plan.repeats - round) as f64 - done as f64 / wanted.len() as f64;
                let all: f64 = wanted.iter().map(|place| self.taken[*place].run.wall[0]).sum();
                self.bench.meter.left((rounds * all).min(left));
            }
        }
        Ok(())
    }

    /// Seconds that are left.
    fn ahead(&self) -> f64 {
        let end = self.foretold.min(self.bench.share(1.0));
        end - self.bench.elapsed()
    }
}

/// Holds a picture against the truth.
pub(super) fn judge(taken: &mut Taken, truth: &Picture) {
    if let Some(picture) = &taken.picture {
        taken.run.error = errors(picture, truth);
    }
}
