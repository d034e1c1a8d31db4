//! Combinations of several settings, measured while there is a predicted gain and time is left.

use strahl_settings::Settings;

use super::combination_search::{CombinationSearch, ParameterLevel};
use super::measurements::{Measurements, NO_TIME_LEFT, ReferencePicture};
use super::plan::time;
use crate::error::StudyError;
use crate::record::{RunRole, SweepPoint};

/// The settings that are combined.
const PARAMETERS: [&str; 4] = ["levels", "cutoff", "sampler", "select"];

/// Measures the combinations that may be on the Pareto front. At the measurement `best` every setting is at its most
/// accurate value.
pub(super) fn all(
    measured: &mut Measurements<'_>,
    best: usize,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let (base, work) =
        (measured.measurements[best].settings.clone(), measured.measurements[best].run.work.max(1.0));
    let single = measured.measurements[best].run.elapsed_seconds[0];
    let (runs, levels): (Vec<_>, Vec<_>) =
        PARAMETERS.map(|name| swept(measured, name, best, work)).into_iter().unzip();
    let is_new = |indices: &[usize]| {
        let options = combined(measured, &base, &runs, indices);
        measured.measurements.iter().all(|taken| taken.settings != options)
    };
    let mut search = CombinationSearch::new(&levels, work, is_new);
    for _ in 0..measured.plan.combinations {
        let Some(mix) = search.next(&measured.accuracy_points().1) else { break };
        let options = combined(measured, &base, &runs, &mix.level_indices);
        let seconds = single * mix.predicted.cost / work;
        let left = measured.benchmark.time_share(time::COMBINATIONS_END) - measured.benchmark.elapsed();
        if seconds > left {
            measured.skip(&options, NO_TIME_LEFT.into());
            continue;
        }
        measured.measure(RunRole::Mix, &options, f64::INFINITY, &reference.picture)?;
        measured.drop_dominated_pictures();
    }
    measured.dominated = search.dominated;
    Ok(())
}

/// The measurements of a sweep, and the error and work of each value, relative to `work`.
fn swept(
    measured: &Measurements<'_>,
    name: &str,
    best: usize,
    work: f64,
) -> (Vec<usize>, Vec<ParameterLevel>) {
    let steps = measured
        .sweeps
        .iter()
        .filter(|parameter| parameter.name == name)
        .flat_map(|parameter| &parameter.steps);
    let level = |step: &SweepPoint| {
        let share = measured.measurements[step.run].run.work / work;
        (step.run, ParameterLevel { error: step.alone.rmse, share })
    };
    let (runs, levels): (Vec<_>, Vec<_>) = steps.map(level).unzip();
    // A setting without a sweep has one value.
    if runs.is_empty() {
        (vec![best], vec![ParameterLevel { error: 0.0, share: 1.0 }])
    } else {
        (runs, levels)
    }
}

/// `base` with each setting at the value of its measurement at that index.
fn combined(
    measured: &Measurements<'_>,
    base: &Settings,
    runs: &[Vec<usize>],
    indices: &[usize],
) -> Settings {
    let of = |parameter: usize| &measured.measurements[runs[parameter][indices[parameter]]].settings;
    Settings {
        levels: of(0).levels,
        cutoff: of(1).cutoff,
        sampler: of(2).sampler,
        select: of(3).select,
        ..base.clone()
    }
}
