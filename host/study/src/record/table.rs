//! `study.csv`: one row per run, for spreadsheets.

use crate::pareto::{CostErrorPoint, pareto_front};
use serde_json::Value;

use super::{RunSettings, Study, StudyRun};
use crate::statistics::{median, min_max};

/// The columns after the settings.
const MEASURED: [&str; 22] = [
    "accelerator",
    "camera",
    "reflected",
    "transmitted",
    "shadow",
    "boxes",
    "shapes",
    "regions",
    "work",
    "cpu_median",
    "cpu_least",
    "cpu_most",
    "wall_median",
    "repetitions",
    "build",
    "rmse",
    "largest",
    "beyond",
    "ssim",
    "front_by_work",
    "front_by_time",
    "digest",
];

/// Indices of the runs on the Pareto front of accuracy and cost.
pub fn pareto_runs(study: &Study, cost: fn(&StudyRun) -> f64) -> Vec<usize> {
    let about = study.runs.iter().enumerate().filter(|(_, run)| run.measures_accuracy());
    let (indices, points): (Vec<_>, Vec<_>) =
        about.map(|(index, run)| (index, CostErrorPoint { cost: cost(run), error: run.error.rmse })).unzip();
    pareto_front(&points).into_iter().map(|index| indices[index]).collect()
}

/// The file.
pub fn to_csv(study: &Study) -> String {
    let (by_work, by_time) =
        (pareto_runs(study, |run| run.work), pareto_runs(study, StudyRun::median_cpu_seconds));
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory cannot fail.
    let settings = RunSettings::recorded().map(|setting| setting.name);
    let _ = writer.write_record(["run", "role"].into_iter().chain(settings).chain(MEASURED));
    for (index, run) in study.runs.iter().enumerate() {
        let (setting, counts, error) = (&run.setting, &run.counts, &run.error);
        let sum = |of: [u64; 4]| of.iter().sum::<u64>().to_string();
        let [least, most] = min_max(&run.cpu_seconds);
        let role = format!("{:?}", run.role).to_lowercase();
        let mut row = vec![index.to_string(), role];
        row.extend(RunSettings::recorded().map(|it| cell(&it.to_json(&setting.settings))));
        row.push(setting.accelerator.clone());
        row.extend(counts.rays.map(|rays| rays.to_string()));
        row.extend([sum(counts.boxes), sum(counts.shapes), sum(counts.regions)]);
        row.extend(
            [run.work, median(&run.cpu_seconds), least, most, median(&run.elapsed_seconds)]
                .map(|it| it.to_string()),
        );
        row.push(run.cpu_seconds.len().to_string());
        row.extend([run.build, error.rmse, error.largest, error.beyond, error.ssim].map(|it| it.to_string()));
        row.extend([by_work.contains(&index), by_time.contains(&index)].map(|it| it.to_string()));
        row.push(run.digest.clone());
        let _ = writer.write_record(&row);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// A value of JSON as spreadsheets take it.
fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(list) => list.iter().map(cell).collect::<Vec<_>>().join(" "),
        other => other.to_string(),
    }
}
