//! All measurements of a study so far.

use strahl_picture::Picture;
use strahl_settings::Settings;

use super::benchmark::{Benchmark, Measurement, error_metrics};
use super::plan::{StudyPlan, time};
use crate::error::StudyError;
use crate::pareto::{CostErrorPoint, pareto_front};
use crate::record::command_line;
use crate::record::{ErrorMetrics, ParameterSweep, ReferenceRecord, RunRole, SkippedSetting, Technique};

/// The usual reason to skip a setting.
pub const NO_TIME_LEFT: &str = "no time was left";

/// Maximum time for the reference of a study without a time limit, in seconds.
const MAX_REFERENCE_SECONDS: f64 = 3600.0;

/// The measurements of a study.
pub struct Measurements<'b> {
    /// Scene, size and time limit.
    pub benchmark: &'b Benchmark<'b>,
    /// The plan.
    pub plan: &'b StudyPlan,
    /// Measured settings.
    pub measurements: Vec<Measurement>,
    /// One-parameter sweeps.
    pub sweeps: Vec<ParameterSweep>,
    /// Techniques, on and off.
    pub techniques: Vec<Technique>,
    /// Indices of the measurements with 1, 2, 4 ... threads.
    pub threads: Vec<usize>,
    /// Settings that were not measured.
    pub skipped: Vec<SkippedSetting>,
    /// Number of combinations that were skipped as dominated.
    pub dominated: usize,
    /// Expected duration of the study without a time limit, in seconds.
    pub expected_seconds: f64,
    /// Aborted settings, and after how many seconds.
    given_up: Vec<(Settings, f64)>,
    /// The settings in `skipped`.
    missing: Vec<Settings>,
}

/// The picture that all others are compared with.
pub struct ReferencePicture {
    /// The picture.
    pub picture: Picture,
    /// How it was rendered.
    pub reference: ReferenceRecord,
}

impl<'b> Measurements<'b> {
    /// No measurements yet.
    pub fn new(bench: &'b Benchmark<'b>, plan: &'b StudyPlan) -> Self {
        let (measurement, knobs, techniques, threads) = Default::default();
        let (left_out, given_up, missing) = Default::default();
        let (beaten, foretold) = (0, 0.0);
        Measurements {
            benchmark: bench,
            plan,
            measurements: measurement,
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

    /// A share of the time limit, in seconds; one hour without a limit.
    pub fn bounded(&self, share: f64) -> f64 {
        let seconds = self.benchmark.time_share(share);
        if seconds < MAX_REFERENCE_SECONDS { seconds } else { MAX_REFERENCE_SECONDS }
    }

    /// Measures a setting unless that is done. Returns its index, or `None` if it takes more than `max_seconds`.
    pub fn measure(
        &mut self,
        role: RunRole,
        options: &Settings,
        most: f64,
        reference: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let is_same = |measurement: &Measurement| measurement.settings == *options;
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
        // A second attempt would not finish either.
        if self.given_up_after(options).is_some_and(|after| after >= 0.9 * most) {
            return Ok(None);
        }
        let Some(mut measurement) = self.benchmark.measure(role, options, most)? else {
            self.skip(options, format!("aborted after {most:.1} s"));
            self.given_up.push((options.clone(), most));
            return Ok(None);
        };
        set_error(&mut measurement, reference);
        self.measurements.push(measurement);
        self.benchmark.report_seconds_left(self.seconds_left());
        Ok(Some(self.measurements.len() - 1))
    }

    /// Measures a setting of a sweep. Skips it if the expected `seconds` are too many.
    pub fn measure_swept(
        &mut self,
        options: &Settings,
        seconds: f64,
        reference: &Picture,
    ) -> Result<Option<usize>, StudyError> {
        let most = self.benchmark.time_share(time::SETTING);
        if seconds > 1.5 * most {
            self.skip(options, format!("would take about {seconds:.0} s; use a larger --time-limit"));
            return Ok(None);
        }
        self.measure(RunRole::Knob, options, 2.5 * most, reference)
    }

    /// Wall-clock seconds after which a setting was aborted, if it was.
    pub fn given_up_after(&self, options: &Settings) -> Option<f64> {
        self.given_up.iter().rev().find(|(it, _)| it == options).map(|(_, after)| *after)
    }

    /// Time limit of one technique, in seconds.
    pub fn technique_limit(&self) -> f64 {
        self.benchmark.time_share(time::TECHNIQUE).min(120.0)
    }

    /// The error between two pictures, if both still exist.
    pub fn difference(&self, place: usize, other: usize) -> Option<ErrorMetrics> {
        let picture = |place: usize| self.measurements[place].picture.as_ref();
        Some(error_metrics(picture(place)?, picture(other)?))
    }

    /// Records once that a setting is not measured.
    pub fn skip(&mut self, options: &Settings, why: String) {
        if !self.missing.contains(options) {
            self.missing.push(options.clone());
            self.skipped.push(SkippedSetting { setting: command_line(options), why });
        }
    }

    /// Number of skipped settings so far.
    pub fn skipped_count(&self) -> usize {
        self.missing.len()
    }

    /// Indices, costs and errors of the runs that measure accuracy.
    pub fn accuracy_points(&self) -> (Vec<usize>, Vec<CostErrorPoint>) {
        let all = self
            .measurements
            .iter()
            .enumerate()
            .filter(|(_, measurement)| measurement.run.measures_accuracy());
        all.map(|(place, it)| (place, CostErrorPoint { cost: it.run.work, error: it.run.error.rmse })).unzip()
    }

    /// Drops pictures of dominated settings; they are not shown.
    pub fn drop_dominated_pictures(&mut self) {
        let (places, points) = self.accuracy_points();
        let front: Vec<usize> = pareto_front(&points).into_iter().map(|place| places[place]).collect();
        for (place, measurement) in self.measurements.iter_mut().enumerate() {
            if !front.contains(&place) && measurement.run.role != RunRole::Own {
                measurement.picture = None;
            }
        }
    }

    /// Repeats measurements in rounds until the planned number or the end of the time.
    pub fn repeat(&mut self) -> Result<(), StudyError> {
        self.drop_dominated_pictures();
        let (places, points) = self.accuracy_points();
        let front: Vec<usize> = pareto_front(&points).into_iter().map(|place| places[place]).collect();
        // Dominated combinations are not repeated.
        let is_repeated =
            |place: &usize| front.contains(place) || self.measurements[*place].run.role != RunRole::Mix;
        let repeated: Vec<usize> = (0..self.measurements.len()).filter(is_repeated).collect();
        let end = self.benchmark.time_share(time::MEASURING_END);
        for round in 1..self.plan.repeats {
            for (done, place) in repeated.iter().enumerate() {
                let again =
                    self.measurements[*place].run.elapsed_seconds[0] + self.measurements[*place].run.build;
                let left = end - self.benchmark.elapsed();
                // Long measurements are repeated only if much time is left; load disturbs them less.
                if again > 0.1 * left {
                    continue;
                }
                self.benchmark.repeat(&mut self.measurements[*place])?;
                let rounds = (self.plan.repeats - round) as f64 - done as f64 / repeated.len() as f64;
                let all: f64 =
                    repeated.iter().map(|place| self.measurements[*place].run.elapsed_seconds[0]).sum();
                self.benchmark.report_seconds_left((rounds * all).min(left));
            }
        }
        Ok(())
    }

    /// Remaining seconds.
    pub fn seconds_left(&self) -> f64 {
        let end = self.expected_seconds.min(self.benchmark.time_share(1.0));
        end - self.benchmark.elapsed()
    }
}

/// Sets the error of a measurement.
pub fn set_error(measurement: &mut Measurement, reference: &Picture) {
    if let Some(picture) = &measurement.picture {
        measurement.run.error = error_metrics(picture, reference);
    }
}
