//! A study from its beginning to its end.
//!
//! From the scene's own levels and cutoff on, whichever cuts more goes a step further, until
//! nothing is cut or the time for it is over: that tells the limits of the reference, which are
//! never coarser than the scene's own, and how long anything takes here. The reference comes next;
//! then the scene's own setting, every knob alone, techniques, mixtures; and with the time that is
//! left, everything again, round by round, so that what disturbs the machine for a while disturbs
//! all settings alike.

use strahl_settings::{Effect, SamplerSettings, Settings};

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

/// No step towards the limits of the reference takes longer than this, in seconds, in a plan without end.
const MAX_STEP_SECONDS: f64 = 60.0;

/// Measures a scene whose own settings are `own`, and which asks for `asks`.
pub fn run(
    measured: &mut Measurements<'_>,
    own: &Settings,
    asks: &[Effect],
) -> Result<ReferencePicture, StudyError> {
    let best = limits(measured, own)?;
    let reference_picture = reference(measured, best, own)?;
    for taken in &mut measured.measurements {
        set_error(taken, &reference_picture.picture);
    }
    measured.measure(RunRole::Own, own, f64::INFINITY, &reference_picture.picture)?;
    sweeps::levels(measured, best, &reference_picture)?;
    sweeps::cutoffs(measured, best, &reference_picture)?;
    sweeps::samplers(measured, best, &reference_picture)?;
    sweeps::selections(measured, best, &reference_picture)?;
    sweeps::effects(measured, best, &reference_picture, asks)?;
    techniques::precision(measured, own, &reference_picture)?;
    techniques::all(measured, own, &reference_picture)?;
    techniques::threads(measured, own, &reference_picture)?;
    combinations::all(measured, best, &reference_picture)?;
    measured.repeat()?;
    Ok(reference_picture)
}

/// Measures nothing but the techniques, and `repeats` times in all; there is no reference, so the errors of
/// runs are those against the picture of `own`.
pub fn evaluate(measured: &mut Measurements<'_>, own: &Settings) -> Result<(), StudyError> {
    let begun = measured.benchmark.elapsed();
    let frame = measured.benchmark.trace(own, f64::INFINITY)?;
    let frame = frame.ok_or_else(|| StudyError::TooShort("the picture takes too long".into()))?;
    let setting = RunSettings::new(own, &frame.accelerator.choice);
    let reference =
        ReferenceRecord { setting, noise: 0.0, cut: 0.0, seconds: measured.benchmark.elapsed() - begun };
    techniques::all(measured, own, &ReferencePicture { picture: frame.picture, reference })?;
    measured.repeat()
}

/// Goes from the scene's own levels and cutoff to finer ones, until nothing is cut or a reference with them
/// would take too long; the place of the finest.
fn limits(measured: &mut Measurements<'_>, own: &Settings) -> Result<usize, StudyError> {
    let coarse = one_ray_per_pixel(own);
    let seconds = measured.benchmark.time_share(time::REFERENCE);
    let first = measured
        .benchmark
        .measure(RunRole::Knob, &coarse, seconds)?
        .ok_or_else(|| resolution::too_short_error(measured.benchmark, None))?;
    measured.measurements.push(first);
    // Finer limits are worth nothing where too few rays are left for each pixel to hold any sampler against.
    let most = measured.bounded(time::REFERENCE)
        / f64::from(REFERENCE_SAMPLE_FACTOR * measured.plan.min_reference_samples(own));
    let most = if most < MAX_STEP_SECONDS { most } else { MAX_STEP_SECONDS };
    let (mut best, mut may) = (0, [true; 2]);
    while let Some((which, limits)) = next_finer_limits(
        measured.measurements[best].settings.limits(),
        measured.measurements[best].run.cut,
        may,
    ) {
        let options = coarse.clone().with_limits(limits);
        match measured.benchmark.measure(RunRole::Knob, &options, most)? {
            Some(taken) => {
                measured.measurements.push(taken);
                best = measured.measurements.len() - 1;
            }
            None => {
                may[which] = false;
                measured.skip(
                    &options,
                    format!("given up after {most:.2} s: a reference like this takes too long"),
                );
            }
        }
    }
    // Where the cutoff cuts nothing the same rays are sent without any.
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

/// Makes the reference with the limits of the run at `best`, and where that takes too long with the scene's
/// own.
fn reference(
    measured: &mut Measurements<'_>,
    best: usize,
    own: &Settings,
) -> Result<ReferencePicture, StudyError> {
    let begun = measured.benchmark.elapsed();
    let (fewest, seconds) = (measured.plan.min_reference_samples(own), measured.bounded(time::REFERENCE));
    let Measurement { settings: finest, run, .. } = &measured.measurements[best];
    let (finest, single) = (finest.clone(), run.wall[0]);
    let samples = measured.plan.reference_samples(fewest, single, seconds);
    let rays = measured.plan.total_rays_per_pixel(own.filter, samples);
    measured.expected_seconds = begun + single * (f64::from(samples) + rays * measured.plan.repeats as f64);
    measured.benchmark.report_seconds_left(measured.seconds_left());
    // As well as it was meant, with as few rays as may be, and as coarse as may be.
    let mut tries = vec![(finest.clone(), samples), (finest, fewest), (one_ray_per_pixel(own), fewest)];
    tries.dedup();
    for (options, samples) in tries {
        let of = |seed| Settings {
            sampler: SamplerSettings::stochastic((samples / 2).max(1)),
            seed,
            ..options.clone()
        };
        let left = || measured.benchmark.time_share(time::REFERENCE_MAX) - measured.benchmark.elapsed();
        // Half of the time for each; a first that takes longer than that is not waited for.
        let Some(one) = measured.benchmark.trace(&of(1), 0.5 * left())? else { continue };
        let Some(other) = measured.benchmark.trace(&of(2), left())? else { continue };
        let cut = one.counters.cut_fractions();
        let reference = ReferenceRecord {
            setting: RunSettings::new(&of(1), &one.accelerator.choice),
            // The mean of two has half of the variance of their difference, halved again.
            noise: 0.5 * error_metrics(&one.picture, &other.picture).rmse,
            cut: cut[0] + cut[1],
            seconds: measured.benchmark.elapsed() - begun,
        };
        return Ok(ReferencePicture { picture: mean_picture(&one.picture, &other.picture), reference });
    }
    // Foretold too well: at least twice the time.
    let enough = 1.5 * single * f64::from(fewest) / time::REFERENCE;
    let twice = measured.benchmark.time_share(2.0);
    Err(resolution::too_short_error(measured.benchmark, Some(if enough > twice { enough } else { twice })))
}
