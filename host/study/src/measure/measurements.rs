//! What was measured so far.

use strahl_picture::Picture;
use strahl_settings::Settings;

use super::benchmark::{Benchmark, Measurement, error_metrics};
use super::plan::{StudyPlan, time};
use crate::error::StudyError;
use crate::pareto::{CostErrorPoint, pareto_front};
use crate::record::command_line;
use crate::record::{ErrorMetrics, ParameterSweep, ReferenceRecord, RunRole, SkippedSetting, Technique};

/// Why most of what is left out is.
pub const NO_TIME_LEFT: &str = "no time was left";

/// In a plan without end the reference takes no longer than this, in seconds.
const MAX_REFERENCE_SECONDS: f64 = 3600.0;

/// What was found so far.
pub struct Measurements<'b> {
    /// Where it is measured.
    pub benchmark: &'b Benchmark<'b>,
    /// What is to be measured.
    pub plan: &'b StudyPlan,
    /// Everything that was measured.
    pub measurements: Vec<Measurement>,
    /// Knobs turned alone.
    pub sweeps: Vec<ParameterSweep>,
    /// Techniques on and off.
    pub techniques: Vec<Technique>,
    /// The same with more and more threads.
    pub threads: Vec<usize>,
    /// What was not measured.
    pub skipped: Vec<SkippedSetting>,
    /// How many mixtures cannot be on the front.
    pub dominated: usize,
    /// After how many seconds all of it should be over, if nothing bounds it.
    pub expected_seconds: f64,
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
    pub reference: ReferenceRecord,
}

impl<'b> Measurements<'b> {
    /// Nothing is measured yet.
    pub fn new(bench: &'b Benchmark<'b>, plan: &'b StudyPlan) -> Self {
        let (taken, knobs, techniques, threads) = Default::default();
        let (left_out, given_up, missing) = Default::default();
        let (beaten, foretold) = (0, 0.0);
        Measurements {
            benchmark: bench,
            plan,
            measurements: taken,
            sweeps: knobs,
            techniques,
            threads,
            skipped: left_out,
            dominated: beaten,
            expected_seconds: foretold,
            given_up,
            missing,
        }
    }

    /// This share of the time that is given, and an hour of a plan without end.
    pub fn bounded(&self, share: f64) -> f64 {
        let seconds = self.benchmark.time_share(share);
        if seconds < MAX_REFERENCE_SECONDS { seconds } else { MAX_REFERENCE_SECONDS }
    }

    /// Measures a setting, if it has not been, and if it takes no longer than it may; its place.
    pub fn measure(
        &mut self,
        role: RunRole,
        options: &Settings,
        most: f64,
        reference: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let is_same = |taken: &Measurement| taken.settings == *options;
        if let Some(place) = self.measurements.iter().position(is_same) {
            if role == RunRole::Own {
                self.measurements[place].run.role = role;
            }
            return Ok(Some(place));
        }
        let left = self.benchmark.time_share(time::MEASURING_END) - self.benchmark.elapsed();
        if left <= 0.0 {
            self.skip(options, NO_TIME_LEFT.into());
            return Ok(None);
        }
        let most = if most < left { most } else { left };
        // It would not be done now either.
        if self.given_up_after(options).is_some_and(|after| after >= 0.9 * most) {
            return Ok(None);
        }
        let Some(mut taken) = self.benchmark.measure(role, options, most)? else {
            self.skip(options, format!("given up after {most:.1} s"));
            self.given_up.push((options.clone(), most));
            return Ok(None);
        };
        set_error(&mut taken, reference);
        self.measurements.push(taken);
        self.benchmark.report_seconds_left(self.seconds_left());
        Ok(Some(self.measurements.len() - 1))
    }

    /// Measures a setting of one knob that is expected to take `seconds`, unless that is too long.
    pub fn measure_swept(
        &mut self,
        options: &Settings,
        seconds: f64,
        reference: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let most = self.benchmark.time_share(time::SETTING);
        if seconds > 1.5 * most {
            self.skip(options, format!("about {seconds:.0} s; a larger --time-limit allows more"));
            return Ok(None);
        }
        self.measure(RunRole::Knob, options, 2.5 * most, reference)
    }

    /// After how many seconds of wall-clock time a setting was given up, if it was.
    pub fn given_up_after(&self, options: &Settings) -> Option<f64> {
        self.given_up.iter().rev().find(|(it, _)| it == options).map(|(_, after)| *after)
    }

    /// The most seconds that a technique may take.
    pub fn technique_limit(&self) -> f64 {
        self.benchmark.time_share(time::TECHNIQUE).min(120.0)
    }

    /// How far the picture of one run is from that of another, while both are there.
    pub fn difference(&self, place: usize, other: usize) -> Option<ErrorMetrics> {
        let picture = |place: usize| self.measurements[place].picture.as_ref();
        Some(error_metrics(picture(place)?, picture(other)?))
    }

    /// Tells, once, that a setting is not measured.
    pub fn skip(&mut self, options: &Settings, why: String) {
        if !self.missing.contains(options) {
            self.missing.push(options.clone());
            self.skipped.push(SkippedSetting { setting: command_line(options), why });
        }
    }

    /// How many settings have been left out so far.
    pub fn skipped_count(&self) -> usize {
        self.missing.len()
    }

    /// Places of what tells what accuracy costs, and how it stands.
    pub fn accuracy_points(&self) -> (Vec<usize>, Vec<CostErrorPoint>) {
        let all = self.measurements.iter().enumerate().filter(|(_, taken)| taken.run.measures_accuracy());
        all.map(|(place, it)| (place, CostErrorPoint { cost: it.run.work, error: it.run.error.rmse })).unzip()
    }

    /// Drops the pictures that nobody will look at: those of settings that others beat.
    pub fn drop_dominated_pictures(&mut self) {
        let (places, points) = self.accuracy_points();
        let kept: Vec<usize> = pareto_front(&points).into_iter().map(|place| places[place]).collect();
        for (place, taken) in self.measurements.iter_mut().enumerate() {
            if !kept.contains(&place) && taken.run.role != RunRole::Own {
                taken.picture = None;
            }
        }
    }

    /// Measures times again, round by round, until they are known or the time is over.
    pub fn repeat(&mut self) -> Result<(), StudyError> {
        self.drop_dominated_pictures();
        let (places, points) = self.accuracy_points();
        let kept: Vec<usize> = pareto_front(&points).into_iter().map(|place| places[place]).collect();
        // Mixtures that others beat are not looked at twice.
        let is_wanted =
            |place: &usize| kept.contains(place) || self.measurements[*place].run.role != RunRole::Mix;
        let wanted: Vec<usize> = (0..self.measurements.len()).filter(is_wanted).collect();
        let end = self.benchmark.time_share(time::MEASURING_END);
        for round in 1..self.plan.repeats {
            for (done, place) in wanted.iter().enumerate() {
                let again = self.measurements[*place].run.wall[0] + self.measurements[*place].run.build;
                let left = end - self.benchmark.elapsed();
                // What is long is repeated where much time is left, and disturbed less anyway.
                if again > 0.1 * left {
                    continue;
                }
                self.benchmark.repeat(&mut self.measurements[*place])?;
                let rounds = (self.plan.repeats - round) as f64 - done as f64 / wanted.len() as f64;
                let all: f64 = wanted.iter().map(|place| self.measurements[*place].run.wall[0]).sum();
                self.benchmark.report_seconds_left((rounds * all).min(left));
            }
        }
        Ok(())
    }

    /// Seconds that are left.
    pub fn seconds_left(&self) -> f64 {
        let end = self.expected_seconds.min(self.benchmark.time_share(1.0));
        end - self.benchmark.elapsed()
    }
}

/// Compares a picture with the reference.
pub fn set_error(taken: &mut Measurement, reference: &Picture) {
    if let Some(picture) = &taken.picture {
        taken.run.error = error_metrics(picture, reference);
    }
}
