//! A study from its beginning to its end.
//!
//! From the scene's own levels and cutoff on, whichever cuts more goes a step further, until
//! nothing is cut or the time for it is over: that tells the limits of the reference, which are
//! never coarser than the scene's own, and how long anything takes here. The reference comes next;
//! then the scene's own setting, every knob alone, techniques, mixtures; and with the time that is
//! left, everything again, round by round, so that what disturbs the machine for a while disturbs
//! all settings alike.

use strahl_picture::Picture;
use strahl_settings::{Sampling, Settings};

use super::afford;
use super::bench::{Bench, Taken, errors, mean};
use super::error::StudyError;
use super::front::{Point, front};
use super::knobs;
use super::mixtures;
use super::options::{coarse, record, words};
use super::plan::{FINER, Plan, finer, time};
use super::record::{Errors, Knob, LeftOut, Reference, Role, Technique};
use super::techniques;
use crate::plan::Effect;

/// Why most of what is left out is.
pub(super) const NO_TIME: &str = "no time was left";

/// In a plan without end the reference takes no longer than this, in seconds.
const HOUR: f64 = 3600.0;

/// And no step towards its limits longer than this.
const MINUTE: f64 = 60.0;

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
    given_up: Vec<(Settings, f64)>,
    /// Each setting that is in `left_out`.
    missing: Vec<Settings>,
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
        let (taken, knobs, techniques, threads) = Default::default();
        let (left_out, given_up, missing) = Default::default();
        let (beaten, foretold) = (0, 0.0);
        Conduct {
            bench,
            plan,
            taken,
            knobs,
            techniques,
            threads,
            left_out,
            beaten,
            foretold,
            given_up,
            missing,
        }
    }

    /// Measures a scene whose own settings are `own`, and which asks for `asks`.
    pub fn run(&mut self, own: &Settings, asks: &[Effect]) -> Result<Truth, StudyError> {
        let best = self.limits(own)?;
        let truth = self.reference(best, own)?;
        for taken in &mut self.taken {
            judge(taken, &truth.picture);
        }
        self.take(Role::Own, own, f64::INFINITY, &truth.picture)?;
        knobs::levels(self, best, &truth)?;
        knobs::cutoffs(self, best, &truth)?;
        knobs::samplers(self, best, &truth)?;
        knobs::selections(self, best, &truth)?;
        knobs::effects(self, best, &truth, asks)?;
        techniques::precision(self, own, &truth)?;
        techniques::all(self, own, &truth)?;
        techniques::threads(self, own, &truth)?;
        mixtures::all(self, best, &truth)?;
        self.repeat()?;
        Ok(truth)
    }

    /// Measures nothing but the techniques, and `repeats` times in all; there is no reference, so the errors of
    /// runs are those against the picture of `own`.
    pub fn evaluate(&mut self, own: &Settings) -> Result<(), StudyError> {
        let begun = self.bench.elapsed();
        let frame = self.bench.trace(own, f64::INFINITY)?;
        let frame = frame.ok_or_else(|| StudyError::TooShort("the picture takes too long".into()))?;
        let setting = record(own, &frame.accelerator.choice);
        let reference = Reference { setting, noise: 0.0, cut: 0.0, seconds: self.bench.elapsed() - begun };
        techniques::all(self, own, &Truth { picture: frame.picture, reference })?;
        self.repeat()
    }

    /// Goes from the scene's own levels and cutoff to finer ones, until nothing is cut or a reference with them
    /// would take too long; the place of the finest.
    fn limits(&mut self, own: &Settings) -> Result<usize, StudyError> {
        let coarse = coarse(own);
        let seconds = self.bench.share(time::REFERENCE);
        let first =
            self.bench.take(Role::Knob, &coarse, seconds)?.ok_or_else(|| afford::short(self.bench, None))?;
        self.taken.push(first);
        // Finer limits are worth nothing where too few rays are left for each pixel to hold any sampler against.
        let most = self.bounded(time::REFERENCE) / f64::from(FINER * self.plan.fewest(own));
        let most = if most < MINUTE { most } else { MINUTE };
        let (mut best, mut may) = (0, [true; 2]);
        while let Some((which, limits)) =
            finer(self.taken[best].options.limits(), self.taken[best].run.cut, may)
        {
            let options = coarse.clone().with_limits(limits);
            match self.bench.take(Role::Knob, &options, most)? {
                Some(taken) => {
                    self.taken.push(taken);
                    best = self.taken.len() - 1;
                }
                None => {
                    may[which] = false;
                    self.leave(
                        &options,
                        format!("given up after {most:.2} s: a reference like this takes too long"),
                    );
                }
            }
        }
        // Where the cutoff cuts nothing the same rays are sent without any.
        let Taken { options, run, .. } = &self.taken[best];
        if run.cut[1] == 0.0 && options.cutoff > 0.0 {
            let options = Settings { cutoff: 0.0, ..options.clone() };
            if let Some(taken) = self.bench.take(Role::Knob, &options, 3.0 * most)? {
                self.taken.push(taken);
                best = self.taken.len() - 1;
            }
        }
        Ok(best)
    }

    /// Makes the reference with the limits of the run at `best`, and where that takes too long with the scene's
    /// own.
    fn reference(&mut self, best: usize, own: &Settings) -> Result<Truth, StudyError> {
        let begun = self.bench.elapsed();
        let (fewest, seconds) = (self.plan.fewest(own), self.bounded(time::REFERENCE));
        let Taken { options: finest, run, .. } = &self.taken[best];
        let (finest, single) = (finest.clone(), run.wall[0]);
        let samples = self.plan.samples(fewest, single, seconds);
        let rays = self.plan.rays(own.filter, samples);
        self.foretold = begun + single * (f64::from(samples) + rays * self.plan.repeats as f64);
        self.bench.left(self.ahead());
        // As well as it was meant, with as few rays as may be, and as coarse as may be.
        let mut tries = vec![(finest.clone(), samples), (finest, fewest), (coarse(own), fewest)];
        tries.dedup();
        for (options, samples) in tries {
            let of = |seed| Settings {
                sampler: Sampling::stochastic((samples / 2).max(1)),
                seed,
                ..options.clone()
            };
            let left = || self.bench.share(time::PATIENCE) - self.bench.elapsed();
            // Half of the time for each; a first that takes longer than that is not waited for.
            let Some(one) = self.bench.trace(&of(1), 0.5 * left())? else { continue };
            let Some(other) = self.bench.trace(&of(2), left())? else { continue };
            let cut = one.counters.cut();
            let reference = Reference {
                setting: record(&of(1), &one.accelerator.choice),
                // The mean of two has half of the variance of their difference, halved again.
                noise: 0.5 * errors(&one.picture, &other.picture).rmse,
                cut: cut[0] + cut[1],
                seconds: self.bench.elapsed() - begun,
            };
            return Ok(Truth { picture: mean(&one.picture, &other.picture), reference });
        }
        // Foretold too well: at least twice the time.
        let enough = 1.5 * single * f64::from(fewest) / time::REFERENCE;
        let twice = self.bench.share(2.0);
        Err(afford::short(self.bench, Some(if enough > twice { enough } else { twice })))
    }

    /// This share of the time that is given, and an hour of a plan without end.
    fn bounded(&self, share: f64) -> f64 {
        let seconds = self.bench.share(share);
        if seconds < HOUR { seconds } else { HOUR }
    }

    /// Measures a setting, if it has not been, and if it takes no longer than it may; its place.
    pub(super) fn take(
        &mut self,
        role: Role,
        options: &Settings,
        most: f64,
        truth: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let is_same = |taken: &Taken| taken.options == *options;
        if let Some(place) = self.taken.iter().position(is_same) {
            if role == Role::Own {
                self.taken[place].run.role = role;
            }
            return Ok(Some(place));
        }
        let left = self.bench.share(time::MEASURED) - self.bench.elapsed();
        if left <= 0.0 {
            self.leave(options, NO_TIME.into());
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
        self.bench.left(self.ahead());
        Ok(Some(self.taken.len() - 1))
    }

    /// Measures a setting of one knob that is expected to take `seconds`, unless that is too long.
    pub(super) fn turn(
        &mut self,
        options: &Settings,
        seconds: f64,
        truth: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let most = self.bench.share(time::SETTING);
        if seconds > 1.5 * most {
            self.leave(options, format!("about {seconds:.0} s; a larger --time-limit allows more"));
            return Ok(None);
        }
        self.take(Role::Knob, options, 2.5 * most, truth)
    }

    /// After how many seconds of wall-clock time a setting was given up, if it was.
    pub(super) fn given_up_after(&self, options: &Settings) -> Option<f64> {
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

    /// Tells, once, that a setting is not measured.
    pub(super) fn leave(&mut self, options: &Settings, why: String) {
        if !self.missing.contains(options) {
            self.missing.push(options.clone());
            self.left_out.push(LeftOut { setting: words(options), why });
        }
    }

    /// How many settings have been left out so far.
    pub(super) fn missing(&self) -> usize {
        self.missing.len()
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
    fn repeat(&mut self) -> Result<(), StudyError> {
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
                self.bench.left((rounds * all).min(left));
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
