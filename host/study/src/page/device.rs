//! What firmware has measured, beside what the workstation has.

use maud::{Markup, html};
use strahl_settings::domain::fraction_text;

use super::family::SettingFamily;
use super::numbers::{count, error};
use super::pieces::{options, wide};
use super::scatter::{ScatterPlot, ScatterPoint, legend};
use crate::device::{DeviceMeasurements, DeviceRow};
use crate::record::{Study, StudyRun};

pub fn part(study: &Study, device: &DeviceMeasurements) -> Markup {
    html! {
        p {
            "Instructions that firmware needed, from " code { (device.name) } ", for each pixel of its own size. Errors there are against the "
            "best that it has done."
        }
        @if !device.scenes().contains(&study.scene.name.as_str()) {
            p.soft { "None of its scenes is named " (study.scene.name) ", as the one of this study is." }
        }
        @for scene in device.scenes() {
            @let rows: Vec<&DeviceRow> = device.rows.iter().filter(|row| row.scene == scene).collect();
            h3 { (scene) }
            (plot(scene, &rows))
            (wide(table(study, &rows)))
        }
    }
}

fn plot(scene: &str, rows: &[&DeviceRow]) -> Markup {
    let dot = |row: &&DeviceRow| {
        let point = row.point().filter(|point| point.error > 0.0)?;
        let about = format!(
            "{}: {} instructions a pixel, error {}",
            words(row),
            count(point.cost),
            error(point.error)
        );
        let family = match row.precision.as_str() {
            "single" => SettingFamily::named(&row.sampler),
            _ => SettingFamily::Double,
        };
        Some(ScatterPoint { point, spread: None, family, number: None, is_own: false, about })
    };
    let dots: Vec<ScatterPoint> = rows.iter().filter_map(dot).collect();
    html! {
        @if dots.len() > 1 {
            @let alt = format!("Error against instructions for a pixel of {} settings of {scene} on the device", dots.len());
            (legend(&dots))
            figure.half { (ScatterPlot { dots: &dots, cost: "instructions for a pixel, on the device", write: count, noise: None, alt }.draw()) }
        }
    }
}

fn words(row: &DeviceRow) -> String {
    let DeviceRow { levels, sampler, precision, .. } = row;
    format!("levels {levels} cutoff {} sampler {sampler} precision {precision}", fraction_text(row.cutoff))
}

/// The run of the study with the same setting, if the scene is the same.
fn twin<'s>(study: &'s Study, row: &DeviceRow) -> Option<&'s StudyRun> {
    let is_same = |run: &&StudyRun| {
        let it = &run.setting.settings;
        (it.levels, it.cutoff, it.sampler.to_string(), it.precision.name())
            == (row.levels, row.cutoff, row.sampler.clone(), &row.precision)
            && it.select.is_none()
            && it.without.is_empty()
    };
    study.runs.iter().filter(|_| row.scene == study.scene.name).find(is_same)
}

fn table(study: &Study, rows: &[&DeviceRow]) -> Markup {
    let pixels = f64::from(study.scene.width) * f64::from(study.scene.height);
    let has_twins = rows.iter().any(|row| twin(study, row).is_some());
    html! {
        table.plain {
            thead { tr {
                th { "setting" } th { "size" } th.number { "instructions" } th.number { "a pixel" } th.number { "a ray" } th.number { "error" }
                @if has_twins { th.number { "a pixel here (work)" } }
            } }
            tbody {
                @for row in rows {
                    tr {
                        td { (options(&words(row))) }
                        td { (row.width) " × " (row.height) }
                        td.number { (count(row.instructions as f64)) }
                        td.number { (count(row.per_pixel())) }
                        td.number { (count(row.instructions as f64 / (row.rays as f64).max(1.0))) }
                        td.number { @if let Some(rmse) = row.rmse { (error(rmse)) } @else { "–" } }
                        @if has_twins {
                            td.number { @if let Some(run) = twin(study, row) { (count(run.work / pixels)) } @else { "–" } }
                        }
                    }
                }
            }
        }
    }
}
