//! The sequence of measurements of a study.
//!
//! 1. Limits of the reference: starting from the levels and cutoff of the scene, the one that discards more light is refined
//!    until nothing is discarded or its time is over. This also measures the speed.
//! 2. The reference.
//! 3. The settings of the scene, sweeps of each setting, techniques, combinations.
//! 4. Repetitions with the remaining time, in rounds over all settings, so that other load affects all alike.

use strahl_settings::{OptionalEffect, SamplerSettings, Settings};

use super::benchmark::{Measurement, error_metrics, mean_picture};
use super::combinations;
use super::measurements::{Measurements, ReferencePicture, set_error};
use super::plan::one_ray_per_pixel;
use super::plan::{REFERENCE_SAMPLE_FACTOR, next_finer_limits, time};
use super::resolution;
use super::sweeps;
use super::techniques;
use crate::error::StudyError;
use crate::record::{ReferenceRecord, RunRole, RunSettings};

/// Maximum time for one step towards the limits of the reference without a time limit, in seconds.
const MAX_STEP_SECONDS: f64 = 60.0;

/// Measures a scene with the settings `own` that requires the effects `required`.
pub fn run(
    measured: &mut Measurements<'_>,
    own: &Settings,
    required: &[OptionalEffect],
) -> Result<ReferencePicture, StudyError> {
    let best = limits(measured, own)?;
    let reference_picture = reference(measured, best, own)?;
    for measurement in &mut measured.measurements {
        set_error(measurement, &reference_picture.picture);
    }
    measured.measure(RunRole::Own, own, f64::INFINITY, &reference_picture.picture)?;
    sweeps::levels(measured, best, &reference_picture)?;
    sweeps::cutoffs(measured, best, &reference_picture)?;
    sweeps::samplers(measured, best, &reference_picture)?;
    sweeps::selections(measured, best, &reference_picture)?;
    sweeps::effects(measured, best, &reference_picture, required)?;
    techniques::precision(measured, own, &reference_picture)?;
    techniques::all(measured, own, &reference_picture)?;
    techniques::threads(measured, own, &reference_picture)?;
    combinations::all(measured, best, &reference_picture)?;
    measured.repeat()?;
    Ok(reference_picture)
}

/// Measures only the techniques, `repeats` times each. Errors are relative to the picture of `own`.
pub fn evaluate(measured: &mut Measurements<'_>, own: &Settings) -> Result<(), StudyError> {
    let begun = measured.benchmark.elapsed();
    let output = measured.benchmark.trace(own, f64::INFINITY)?;
    let output = output.ok_or_else(|| StudyError::TooShort("the picture was not finished in time".into()))?;
    let setting = RunSettings::new(own, &output.accelerator.choice);
    let reference =
        ReferenceRecord { setting, noise: 0.0, cut: 0.0, seconds: measured.benchmark.elapsed() - begun };
    techniques::all(measured, own, &ReferencePicture { picture: output.picture, reference })?;
    measured.repeat()
}

/// Refines the levels and cutoff of the scene until nothing is discarded or a reference would take too long. Returns the
/// index of the finest measurement.
fn limits(measured: &mut Measurements<'_>, own: &Settings) -> Result<usize, StudyError> {
    let base = one_ray_per_pixel(own);
    let seconds = measured.benchmark.time_share(time::REFERENCE);
    let first = measured
        .benchmark
        .measure(RunRole::Knob, &base, seconds)?
        .ok_or_else(|| resolution::too_short_error(measured.benchmark, None))?;
    measured.measurements.push(first);
    // Each step must leave time for enough samples per pixel of the reference.
    let most = measured.bounded(time::REFERENCE)
        / f64::from(REFERENCE_SAMPLE_FACTOR * measured.plan.min_reference_samples(own));
    let most = if most < MAX_STEP_SECONDS { most } else { MAX_STEP_SECONDS };
    let (mut best, mut may) = (0, [true; 2]);
    while let Some((which, limits)) = next_finer_limits(
        measured.measurements[best].settings.limits(),
        measured.measurements[best].run.cut,
        may,
    ) {
        let options = base.clone().with_limits(limits);
        match measured.benchmark.measure(RunRole::Knob, &options, most)? {
            Some(taken) => {
                measured.measurements.push(taken);
                best = measured.measurements.len() - 1;
            }
            None => {
                may[which] = false;
                measured.skip(&options, format!("aborted after {most:.2} s: too slow for the reference"));
            }
        }
    }
    // If the cutoff discards nothing, cutoff 0 traces the same rays.
    let Measurement { settings: options, run, .. } = &measured.measurements[best];
    if run.cut[1] == 0.0 && options.cutoff > 0.0 {
        let options = Settings { cutoff: 0.0, ..options.clone() };
        if let Some(taken) = measured.benchmark.measure(RunRole::Knob, &options, 3.0 * most)? {
            measured.measurements.push(taken);
            best = measured.measurements.len() - 1;
        }
    }
    Ok(best)
}

/// Renders the reference with the limits of the measurement `best`, or if that takes too long with those of the scene.
fn reference(
    measured: &mut Measurements<'_>,
    best: usize,
    own: &Settings,
) -> Result<ReferencePicture, StudyError> {
    let begun = measured.benchmark.elapsed();
    let (fewest, seconds) = (measured.plan.min_reference_samples(own), measured.bounded(time::REFERENCE));
    let Measurement { settings: finest, run, .. } = &measured.measurements[best];
    let (finest, single) = (finest.clone(), run.elapsed_seconds[0]);
    let samples = measured.plan.reference_samples(fewest, single, seconds);
    let rays = measured.plan.total_rays_per_pixel(own.filter, samples);
    measured.expected_seconds = begun + single * (f64::from(samples) + rays * measured.plan.repeats as f64);
    measured.benchmark.report_seconds_left(measured.seconds_left());
    // As planned, then with the minimum of samples, then with the coarsest limits.
    let mut tries = vec![(finest.clone(), samples), (finest, fewest), (one_ray_per_pixel(own), fewest)];
    tries.dedup();
    for (options, samples) in tries {
        let of = |seed| Settings {
            sampler: SamplerSettings::stochastic((samples / 2).max(1)),
            seed,
            ..options.clone()
        };
        let left = || measured.benchmark.time_share(time::REFERENCE_MAX) - measured.benchmark.elapsed();
        // Half of the time for each of the two pictures.
        let Some(one) = measured.benchmark.trace(&of(1), 0.5 * left())? else { continue };
        let Some(other) = measured.benchmark.trace(&of(2), left())? else { continue };
        let cut = one.counters.cut_fractions();
        let reference = ReferenceRecord {
            setting: RunSettings::new(&of(1), &one.accelerator.choice),
            // The variance of the mean is a quarter of the variance of the difference.
            noise: 0.5 * error_metrics(&one.picture, &other.picture).rmse,
            cut: cut[0] + cut[1],
            seconds: measured.benchmark.elapsed() - begun,
        };
        return Ok(ReferencePicture { picture: mean_picture(&one.picture, &other.picture), reference });
    }
    // The prediction was too optimistic: at least twice the time.
    let enough = 1.5 * single * f64::from(fewest) / time::REFERENCE;
    let twice = measured.benchmark.time_share(2.0);
    Err(resolution::too_short_error(measured.benchmark, Some(if enough > twice { enough } else { twice })))
}
