//! Several knobs turned at once, as long as that promises anything and time is left.

use strahl_settings::Settings;

use super::combination_search::{CombinationSearch, ParameterLevel};
use super::measurements::{Measurements, NO_TIME_LEFT, ReferencePicture};
use super::plan::time;
use crate::error::StudyError;
use crate::record::{RunRole, SweepPoint};

/// The knobs that are mixed.
const KNOBS: [&str; 4] = ["levels", "cutoff", "sampler", "select"];

/// Measures the mixtures that may be on the front. At the run at `best` every knob is at its best.
pub(super) fn all(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let (base, work) =
        (measured.measurements[best].settings.clone(), measured.measurements[best].run.work.max(1.0));
    let single = measured.measurements[best].run.wall[0];
    let (runs, notches): (Vec<_>, Vec<_>) =
        KNOBS.map(|name| turned(measured, name, best, work)).into_iter().unzip();
    let is_new = |places: &[usize]| {
        let options = mixed(measured, &base, &runs, places);
        measured.measurements.iter().all(|taken| taken.settings != options)
    };
    let mut hunt = CombinationSearch::new(&notches, work, is_new);
    for _ in 0..measured.plan.combinations {
        let Some(mix) = hunt.next(&measured.accuracy_points().1) else { break };
        let options = mixed(measured, &base, &runs, &mix.level_indices);
        let seconds = single * mix.predicted.cost / work;
        let left = measured.benchmark.time_share(time::COMBINATIONS_END) - measured.benchmark.elapsed();
        if seconds > left {
            measured.skip(&options, NO_TIME_LEFT.into());
            continue;
        }
        measured.measure(RunRole::Mix, &options, f64::INFINITY, &reference.picture)?;
        measured.drop_dominated_pictures();
    }
    measured.dominated = hunt.dominated;
    Ok(())
}

/// The runs of a knob that was turned alone, and what its notches do to an error and to `work`.
fn turned(
    measured: &Measurements<'_>,
    name: &str,
    best: usize,
    work: f64,
) -> (Vec<usize>, Vec<ParameterLevel>) {
    let steps = measured.sweeps.iter().filter(|knob| knob.name == name).flat_map(|knob| &knob.steps);
    let notch = |step: &SweepPoint| {
        let share = measured.measurements[step.run].run.work / work;
        (step.run, ParameterLevel { error: step.alone.rmse, share })
    };
    let (runs, notches): (Vec<_>, Vec<_>) = steps.map(notch).unzip();
    // A knob that cannot be turned has one notch.
    if runs.is_empty() {
        (vec![best], vec![ParameterLevel { error: 0.0, share: 1.0 }])
    } else {
        (runs, notches)
    }
}

/// `base` with all knobs turned: each to the notch that its run at that place has.
fn mixed(measured: &Measurements<'_>, base: &Settings, runs: &[Vec<usize>], places: &[usize]) -> Settings {
    let of = |knob: usize| &measured.measurements[runs[knob][places[knob]]].settings;
    Settings {
        levels: of(0).levels,
        cutoff: of(1).cutoff,
        sampler: of(2).sampler,
        select: of(3).select,
        ..base.clone()
    }
}
