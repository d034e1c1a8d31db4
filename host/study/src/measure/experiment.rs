//! A study from its beginning to its end.
//!
//! From the scene's own levels and cutoff on, whichever cuts more goes a step further, until
//! nothing is cut or the time for it is over: that tells the limits of the reference, which are
//! never coarser than the scene's own, and how long anything takes here. The reference comes next;
//! then the scene's own setting, every knob alone, techniques, mixtures; and with the time that is
//! left, everything again, round by round, so that what disturbs the machine for a while disturbs
//! all settings alike.

use strahl_settings::{Effect, SamplerSettings, Settings};

use super::benchmark::{Taken, errors, mean};
use super::combinations;
use super::measurements::{Measurements, ReferencePicture, judge};
use super::plan::coarse;
use super::plan::{FINER, finer, time};
use super::resolution;
use super::sweeps;
use super::techniques;
use crate::error::StudyError;
use crate::record::{Reference, Role, RunSettings};

/// No step towards the limits of the reference takes longer than this, in seconds, in a plan without end.
const MINUTE: f64 = 60.0;

/// Measures a scene whose own settings are `own`, and which asks for `asks`.
pub fn run(
    measured: &mut Measurements<'_>,
    own: &Settings,
    asks: &[Effect],
) -> Result<ReferencePicture, StudyError> {
    let best = limits(measured, own)?;
    let reference_picture = reference(measured, best, own)?;
    for taken in &mut measured.taken {
        judge(taken, &reference_picture.picture);
    }
    measured.take(Role::Own, own, f64::INFINITY, &reference_picture.picture)?;
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
    let begun = measured.bench.elapsed();
    let frame = measured.bench.trace(own, f64::INFINITY)?;
    let frame = frame.ok_or_else(|| StudyError::TooShort("the picture takes too long".into()))?;
    let setting = RunSettings::new(own, &frame.accelerator.choice);
    let reference = Reference { setting, noise: 0.0, cut: 0.0, seconds: measured.bench.elapsed() - begun };
    techniques::all(measured, own, &ReferencePicture { picture: frame.picture, reference })?;
    measured.repeat()
}

/// Goes from the scene's own levels and cutoff to finer ones, until nothing is cut or a reference with them
/// would take too long; the place of the finest.
fn limits(measured: &mut Measurements<'_>, own: &Settings) -> Result<usize, StudyError> {
    let coarse = coarse(own);
    let seconds = measured.bench.share(time::REFERENCE);
    let first = measured
        .bench
        .take(Role::Knob, &coarse, seconds)?
        .ok_or_else(|| resolution::short(measured.bench, None))?;
    measured.taken.push(first);
    // Finer limits are worth nothing where too few rays are left for each pixel to hold any sampler against.
    let most = measured.bounded(time::REFERENCE) / f64::from(FINER * measured.plan.fewest(own));
    let most = if most < MINUTE { most } else { MINUTE };
    let (mut best, mut may) = (0, [true; 2]);
    while let Some((which, limits)) =
        finer(measured.taken[best].options.limits(), measured.taken[best].run.cut, may)
    {
        let options = coarse.clone().with_limits(limits);
        match measured.bench.take(Role::Knob, &options, most)? {
            Some(taken) => {
                measured.taken.push(taken);
                best = measured.taken.len() - 1;
            }
            None => {
                may[which] = false;
                measured.leave(
                    &options,
                    format!("given up after {most:.2} s: a reference like this takes too long"),
                );
            }
        }
    }
    // Where the cutoff cuts nothing the same rays are sent without any.
    let Taken { options, run, .. } = &measured.taken[best];
    if run.cut[1] == 0.0 && options.cutoff > 0.0 {
        let options = Settings { cutoff: 0.0, ..options.clone() };
        if let Some(taken) = measured.bench.take(Role::Knob, &options, 3.0 * most)? {
            measured.taken.push(taken);
            best = measured.taken.len() - 1;
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
    let begun = measured.bench.elapsed();
    let (fewest, seconds) = (measured.plan.fewest(own), measured.bounded(time::REFERENCE));
    let Taken { options: finest, run, .. } = &measured.taken[best];
    let (finest, single) = (finest.clone(), run.wall[0]);
    let samples = measured.plan.samples(fewest, single, seconds);
    let rays = measured.plan.rays(own.filter, samples);
    measured.foretold = begun + single * (f64::from(samples) + rays * measured.plan.repeats as f64);
    measured.bench.left(measured.ahead());
    // As well as it was meant, with as few rays as may be, and as coarse as may be.
    let mut tries = vec![(finest.clone(), samples), (finest, fewest), (coarse(own), fewest)];
    tries.dedup();
    for (options, samples) in tries {
        let of = |seed| Settings {
            sampler: SamplerSettings::stochastic((samples / 2).max(1)),
            seed,
            ..options.clone()
        };
        let left = || measured.bench.share(time::PATIENCE) - measured.bench.elapsed();
        // Half of the time for each; a first that takes longer than that is not waited for.
        let Some(one) = measured.bench.trace(&of(1), 0.5 * left())? else { continue };
        let Some(other) = measured.bench.trace(&of(2), left())? else { continue };
        let cut = one.counters.cut_fractions();
        let reference = Reference {
            setting: RunSettings::new(&of(1), &one.accelerator.choice),
            // The mean of two has half of the variance of their difference, halved again.
            noise: 0.5 * errors(&one.picture, &other.picture).rmse,
            cut: cut[0] + cut[1],
            seconds: measured.bench.elapsed() - begun,
        };
        return Ok(ReferencePicture { picture: mean(&one.picture, &other.picture), reference });
    }
    // Foretold too well: at least twice the time.
    let enough = 1.5 * single * f64::from(fewest) / time::REFERENCE;
    let twice = measured.bench.share(2.0);
    Err(resolution::short(measured.bench, Some(if enough > twice { enough } else { twice })))
}
