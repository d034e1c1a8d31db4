//! What was measured so far.

use strahl_picture::Picture;
use strahl_settings::Settings;

use super::benchmark::{Bench, Taken, errors};
use super::plan::{Plan, time};
use crate::error::StudyError;
use crate::pareto::{Point, front};
use crate::record::words;
use crate::record::{Errors, Knob, LeftOut, Reference, Role, Technique};

/// Why most of what is left out is.
pub const NO_TIME: &str = "no time was left";

/// In a plan without end the reference takes no longer than this, in seconds.
const HOUR: f64 = 3600.0;

/// What was found so far.
pub struct Measurements<'b> {
    /// Where it is measured.
    pub bench: &'b Bench<'b>,
    /// What is to be measured.
    pub plan: &'b Plan,
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
    pub foretold: f64,
    /// What was given up, and after how many seconds.
    given_up: Vec<(Settings, f64)>,
    /// Each setting that is in `left_out`.
    missing: Vec<Settings>,
}

/// What everything is compared with.
pub struct ReferencePicture {
    /// The picture.
    pub picture: Picture,
    /// How it was made.
    pub reference: Reference,
}

impl<'b> Measurements<'b> {
    /// Nothing is measured yet.
    pub fn new(bench: &'b Bench<'b>, plan: &'b Plan) -> Self {
        let (taken, knobs, techniques, threads) = Default::default();
        let (left_out, given_up, missing) = Default::default();
        let (beaten, foretold) = (0, 0.0);
        Measurements {
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

    /// This share of the time that is given, and an hour of a plan without end.
    pub fn bounded(&self, share: f64) -> f64 {
        let seconds = self.bench.share(share);
        if seconds < HOUR { seconds } else { HOUR }
    }

    /// Measures a setting, if it has not been, and if it takes no longer than it may; its place.
    pub fn take(
        &mut self,
        role: Role,
        options: &Settings,
        most: f64,
        reference: &Picture,
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
        judge(&mut taken, reference);
        self.taken.push(taken);
        self.bench.left(self.ahead());
        Ok(Some(self.taken.len() - 1))
    }

    /// Measures a setting of one knob that is expected to take `seconds`, unless that is too long.
    pub fn turn(
        &mut self,
        options: &Settings,
        seconds: f64,
        reference: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let most = self.bench.share(time::SETTING);
        if seconds > 1.5 * most {
            self.leave(options, format!("about {seconds:.0} s; a larger --time-limit allows more"));
            return Ok(None);
        }
        self.take(Role::Knob, options, 2.5 * most, reference)
    }

    /// After how many seconds of wall-clock time a setting was given up, if it was.
    pub fn given_up_after(&self, options: &Settings) -> Option<f64> {
        self.given_up.iter().rev().find(|(it, _)| it == options).map(|(_, after)| *after)
    }

    /// The most seconds that a technique may take.
    pub fn patience(&self) -> f64 {
        self.bench.share(time::TECHNIQUE).min(120.0)
    }

    /// How far the picture of one run is from that of another, while both are there.
    pub fn between(&self, place: usize, other: usize) -> Option<Errors> {
        let picture = |place: usize| self.taken[place].picture.as_ref();
        Some(errors(picture(place)?, picture(other)?))
    }

    /// Tells, once, that a setting is not measured.
    pub fn leave(&mut self, options: &Settings, why: String) {
        if !self.missing.contains(options) {
            self.missing.push(options.clone());
            self.left_out.push(LeftOut { setting: words(options), why });
        }
    }

    /// How many settings have been left out so far.
    pub fn missing(&self) -> usize {
        self.missing.len()
    }

    /// Places of what tells what accuracy costs, and how it stands.
    pub fn points(&self) -> (Vec<usize>, Vec<Point>) {
        let all = self.taken.iter().enumerate().filter(|(_, taken)| taken.run.is_about_accuracy());
        all.map(|(place, it)| (place, Point { cost: it.run.work, error: it.run.error.rmse })).unzip()
    }

    /// Drops the pictures that nobody will look at: those of settings that others beat.
    pub fn forget(&mut self) {
        let (places, points) = self.points();
        let kept: Vec<usize> = front(&points).into_iter().map(|place| places[place]).collect();
        for (place, taken) in self.taken.iter_mut().enumerate() {
            if !kept.contains(&place) && taken.run.role != Role::Own {
                taken.picture = None;
            }
        }
    }

    /// Measures times again, round by round, until they are known or the time is over.
    pub fn repeat(&mut self) -> Result<(), StudyError> {
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
    pub fn ahead(&self) -> f64 {
        let end = self.foretold.min(self.bench.share(1.0));
        end - self.bench.elapsed()
    }
}

/// Compares a picture with the reference.
pub fn judge(taken: &mut Taken, reference: &Picture) {
    if let Some(picture) = &taken.picture {
        taken.run.error = errors(picture, reference);
    }
}
