//! Knobs turned one by one, everything else being as good as it gets.
//!
//! What a knob alone makes wrong is the difference from the same setting with that knob at its
//! best: the same rays through the picture, so that nothing else is between the two pictures. Of
//! samplers, and of effects that need many rays, it is the difference from the reference.

use strahl_settings::Effect;
use strahl_settings::domain::fraction_text;
use strahl_settings::{SamplerSettings, Settings};

use super::benchmark::{Measurement, error_metrics};
use super::measurements::{Measurements, ReferencePicture};
use super::plan::{LEVELS, max_rays_per_pixel};
use crate::error::StudyError;
use crate::record::command_line;
use crate::record::{ParameterSweep, StudyRun, SweepPoint};

/// Samples for effects that need many: enough to see what they do.
const EFFECT_SAMPLES: u32 = 16;

/// The levels from one to those that cut as little as can be.
pub(super) fn levels(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, seconds, has_more) = (base.clone(), run.wall[0], has_secondary(run));
    let before = measured.skipped_count();
    let mut steps: Vec<SweepPoint> = Vec::new();
    let is_whole =
        |measured: &Measurements<'_>, step: &SweepPoint| measured.measurements[step.run].run.cut[0] == 0.0;
    for levels in LEVELS.into_iter().filter(|levels| has_more && *levels < base.levels) {
        // The rest would be the same picture.
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
        about: "How many times light may be mirrored or pass a surface before the eye.".into(),
        fixed: format!("--cutoff {} --sampler {}", fraction_text(base.cutoff), base.sampler),
        against: format!("{} levels", base.levels),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Whether any ray was mirrored or passed a surface: else neither levels nor a cutoff change anything.
fn has_secondary(run: &StudyRun) -> bool {
    run.counts.rays[1] + run.counts.rays[2] > 0 || run.cut != [0.0; 2]
}

/// The cutoff from coarse to none.
pub(super) fn cutoffs(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, seconds, has_more) = (base.clone(), run.wall[0], has_secondary(run));
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
        about: "Rays that would count less than this in their pixel are not sent.".into(),
        fixed: format!("--levels {} --sampler {}", base.levels, base.sampler),
        against: format!("cutoff {}", fraction_text(base.cutoff)),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// The samplers, from few rays to many.
pub(super) fn samplers(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, single) = (base.clone(), run.wall[0]);
    let samples = 2 * max_rays_per_pixel(&reference.reference.setting.settings.sampler);
    let before = measured.skipped_count();
    let mut runs = vec![best];
    for (sampler, rays) in measured.plan.samplers(base.filter) {
        let options = Settings { sampler, ..base.clone() };
        // The reference must be the finer one by far.
        if max_rays_per_pixel(&sampler) * super::plan::REFERENCE_SAMPLE_FACTOR > samples {
            measured.skip(
                &options,
                format!("a reference of only {samples} rays in a pixel is too coarse for it"),
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
        about: "How many rays make a pixel, and through which places.".into(),
        fixed: format!("--levels {} --cutoff {}", base.levels, fraction_text(base.cutoff)),
        against: "the reference".into(),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Which pixels are traced, from few to all.
pub(super) fn selections(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let (base, seconds) = (base.clone(), run.wall[0]);
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
            "One pixel in so many times so many is traced first; where neighbours agree, those between are \
                guessed."
                .into(),
        fixed: command_line(&base).replace(" --select", ""),
        against: "every pixel traced".into(),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Leaves out one after the other what the scene asks for.
pub(super) fn effects(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
    asks: &[Effect],
) -> Result<(), StudyError> {
    let Measurement { settings: base, run, .. } = &measured.measurements[best];
    let is_many = [Effect::Penumbra, Effect::Lens, Effect::Gloss, Effect::Motion]
        .iter()
        .any(|effect| asks.contains(effect));
    let rays = if is_many { EFFECT_SAMPLES } else { 4 };
    let seconds = f64::from(rays) * run.wall[0];
    let base = Settings { sampler: SamplerSettings::stochastic(rays), ..base.clone() };
    let before = measured.skipped_count();
    let mut steps = Vec::new();
    for effect in asks {
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
    // With nothing left out there is something to hold the others against.
    if !asks.is_empty()
        && let Some(run) = measured.measure_swept(&base, seconds, &reference.picture)?
    {
        steps.push(SweepPoint { value: "nothing".into(), run, alone: measured.measurements[run].run.error });
    }
    measured.sweeps.push(ParameterSweep {
        name: "without".into(),
        about: "What every effect that the scene asks for costs, and what its picture is without.".into(),
        fixed: command_line(&base),
        against: "the reference, which has all of them".into(),
        steps,
        left_out: measured.skipped_count() - before,
    });
    Ok(())
}

/// Single precision, and double, which is the yardstick.
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
        about: "What every number is computed with. Those of the scene are of single precision either way. Both are \
                measured by the same loop."
            .into(),
        fixed,
        against: "double precision".into(),
        steps,
        left_out,
    });
}
