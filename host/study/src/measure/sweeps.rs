//! Sweeps of one setting; all others are at their most accurate value.
//!
//! The error of a value is the difference from the most accurate value with the same camera rays, so that nothing else
//! differs. For samplers, and for effects that need many rays, it is the difference from the reference.

use strahl_settings::OptionalEffect;
use strahl_settings::domain::fraction_text;
use strahl_settings::{SamplerSettings, Settings};

use super::benchmark::{Measurement, error_metrics};
use super::measurements::{Measurements, ReferencePicture};
use super::plan::{LEVELS, max_rays_per_pixel};
use crate::error::StudyError;
use crate::record::command_line;
use crate::record::{ParameterSweep, StudyRun, SweepPoint};

/// Samples per pixel for effects that need many.
const EFFECT_SAMPLES: u32 = 16;

/// Levels from 1 to the finest.
pub(super) fn levels(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, seconds, has_more) = (base.clone(), run.elapsed_seconds[0], has_secondary(run));
    let before = measured.skipped_count();
    let mut steps: Vec<SweepPoint> = Vec::new();
    let is_whole =
        |measured: &Measurements<'_>, step: &SweepPoint| measured.measurements[step.run].run.cut[0] == 0.0;
    for levels in LEVELS.into_iter().filter(|levels| has_more && *levels < base.levels) {
        // More levels give the same picture.
        if steps.last().is_some_and(|step| is_whole(measured, step)) {
            break;
        }
        let options = Settings { levels, ..base.clone() };
        if let Some(run) = measured.measure_swept(&options, seconds, &reference.picture)? {
            let alone = measured.difference(run, best).unwrap_or_default();
            steps.push(SweepPoint { value: levels.to_string(), run, alone });
        }
    }
    if !steps.last().is_some_and(|step| is_whole(measured, step)) {
        let alone = measured.difference(best, best).unwrap_or_default();
        steps.push(SweepPoint { value: base.levels.to_string(), run: best, alone });
    }
    measured.sweeps.push(ParameterSweep {
        name: "levels".into(),
        about: "Maximum number of reflections and transmissions between a light and the camera.".into(),
        fixed: format!("--cutoff {} --sampler {}", fraction_text(base.cutoff), base.sampler),
        against: format!("{} levels", base.levels),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Whether there are secondary rays; otherwise levels and cutoff have no effect.
fn has_secondary(run: &StudyRun) -> bool {
    run.counts.rays[1] + run.counts.rays[2] > 0 || run.cut != [0.0; 2]
}

/// Cutoffs from coarse to the finest.
pub(super) fn cutoffs(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, seconds, has_more) = (base.clone(), run.elapsed_seconds[0], has_secondary(run));
    let before = measured.skipped_count();
    let mut steps = Vec::new();
    for value in measured.plan.cutoffs().filter(|value| has_more && *value > base.cutoff) {
        let options = Settings { cutoff: value, ..base.clone() };
        if let Some(run) = measured.measure_swept(&options, seconds, &reference.picture)? {
            let alone = measured.difference(run, best).unwrap_or_default();
            steps.push(SweepPoint { value: fraction_text(value), run, alone });
        }
    }
    let alone = measured.difference(best, best).unwrap_or_default();
    steps.push(SweepPoint { value: fraction_text(base.cutoff), run: best, alone });
    measured.sweeps.push(ParameterSweep {
        name: "cutoff".into(),
        about: "Rays whose weight in the pixel is below this are not traced.".into(),
        fixed: format!("--levels {} --sampler {}", base.levels, base.sampler),
        against: format!("cutoff {}", fraction_text(base.cutoff)),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Samplers, from few rays to many.
pub(super) fn samplers(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, single) = (base.clone(), run.elapsed_seconds[0]);
    let samples = 2 * max_rays_per_pixel(&reference.reference.setting.settings.sampler);
    let before = measured.skipped_count();
    let mut runs = vec![best];
    for (sampler, rays) in measured.plan.samplers(base.filter) {
        let options = Settings { sampler, ..base.clone() };
        // The reference must be much finer.
        if max_rays_per_pixel(&sampler) * super::plan::REFERENCE_SAMPLE_FACTOR > samples {
            measured.skip(
                &options,
                format!("the reference has only {samples} samples per pixel, too few to judge it"),
            );
            continue;
        }
        runs.extend(measured.measure_swept(&options, rays * single, &reference.picture)?);
    }
    runs.sort_by_key(|run| measured.measurements[*run].run.counts.rays[0]);
    let step = |run: usize| {
        let Measurement { settings: options, run: found, .. } = &measured.measurements[run];
        SweepPoint { value: options.sampler.to_string(), run, alone: found.error }
    };
    let steps = runs.into_iter().map(step).collect();
    measured.sweeps.push(ParameterSweep {
        name: "sampler".into(),
        about: "Number and positions of the rays in a pixel.".into(),
        fixed: format!("--levels {} --cutoff {}", base.levels, fraction_text(base.cutoff)),
        against: "the reference".into(),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Pixel selections, from few pixels to all.
pub(super) fn selections(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, seconds) = (base.clone(), run.elapsed_seconds[0]);
    let before = measured.skipped_count();
    let mut steps = Vec::new();
    for selecting in measured.plan.selections() {
        let options = Settings { select: Some(selecting), ..base.clone() };
        if let Some(run) = measured.measure_swept(&options, seconds, &reference.picture)? {
            let alone = measured.difference(run, best).unwrap_or_default();
            steps.push(SweepPoint { value: selecting.to_string(), run, alone });
        }
    }
    let alone = measured.difference(best, best).unwrap_or_default();
    steps.push(SweepPoint { value: "all".into(), run: best, alone });
    measured.sweeps.push(ParameterSweep {
        name: "select".into(),
        about:
            "One pixel per STEP x STEP block is traced first; where neighbors agree, the pixels between are \
                interpolated."
                .into(),
        fixed: command_line(&base).replace(" --select", ""),
        against: "every pixel traced".into(),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Disables each required effect.
pub(super) fn effects(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
    required: &[OptionalEffect],
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let is_many =
        [OptionalEffect::SoftShadows, OptionalEffect::Lens, OptionalEffect::Gloss, OptionalEffect::Motion]
            .iter()
            .any(|effect| required.contains(effect));
    let rays = if is_many { EFFECT_SAMPLES } else { 4 };
    let seconds = f64::from(rays) * run.elapsed_seconds[0];
    let base = Settings { sampler: SamplerSettings::stochastic(rays), ..base.clone() };
    let before = measured.skipped_count();
    let mut steps = Vec::new();
    for effect in required {
        let options = Settings { without: vec![*effect], ..base.clone() };
        if let Some(run) = measured.measure_swept(&options, seconds, &reference.picture)? {
            steps.push(SweepPoint {
                value: effect.name().into(),
                run,
                alone: measured.measurements[run].run.error,
            });
        }
    }
    steps.sort_by(|a, b| b.alone.rmse.total_cmp(&a.alone.rmse));
    // All effects, for comparison.
    if !required.is_empty()
        && let Some(run) = measured.measure_swept(&base, seconds, &reference.picture)?
    {
        steps.push(SweepPoint { value: "nothing".into(), run, alone: measured.measurements[run].run.error });
    }
    measured.sweeps.push(ParameterSweep {
        name: "without".into(),
        about: "Cost of each required effect, and the error without it.".into(),
        fixed: command_line(&base),
        against: "the reference, with all effects".into(),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Single precision compared with double precision.
pub(super) fn precision(measured: &mut Measurements<'_>, runs: [Option<usize>; 2], fixed: String) {
    let picture = |run: usize| measured.measurements[run].picture.as_ref();
    let alone = |run: usize, double: usize| match (picture(run), picture(double)) {
        (Some(a), Some(b)) => error_metrics(a, b),
        _ => Default::default(),
    };
    let step = |value: &str, run, double| SweepPoint { value: value.into(), run, alone: alone(run, double) };
    let (steps, left_out) = match runs {
        [Some(single), Some(double)] => {
            (vec![step("single", single, double), step("double", double, double)], 0)
        }
        _ => (Vec::new(), runs.iter().filter(|run| run.is_none()).count()),
    };
    measured.sweeps.push(ParameterSweep {
        name: "precision".into(),
        about:
            "Floating-point precision. Scene numbers are single precision in both. Both run the same code."
                .into(),
        fixed,
        against: "double precision".into(),
        steps,
        left_out,
    });
}
