//! Measurements made by firmware, next to those of the workstation.

use maud::{Markup, html};
use strahl_settings::domain::fraction_text;

use super::family::SettingFamily;
use super::numbers::{count, error};
use super::pieces::{options, scrollable};
use super::scatter::{ScatterPlot, ScatterPoint, legend};
use crate::device::{DeviceMeasurements, DeviceRow};
use crate::record::{Study, StudyRun};

pub fn section(study: &Study, device: &DeviceMeasurements) -> Markup {
    html! {
        p {
            "Instructions per pixel measured on the device, from " code { (device.name) } ". Errors are relative to its most accurate "
            "picture."
        }
        @if !device.scenes().contains(&study.scene.name.as_str()) {
            p.soft { "None of its scenes is named " (study.scene.name) "." }
        }
        @for scene in device.scenes() {
            @let rows: Vec<&DeviceRow> = device.rows.iter().filter(|row| row.scene == scene).collect();
            h3 { (scene) }
            (plot(scene, &rows))
            (scrollable(table(study, &rows)))
        }
    }
}

fn plot(scene: &str, rows: &[&DeviceRow]) -> Markup {
    let dot = |row: &&DeviceRow| {
        let point = row.point().filter(|point| point.error > 0.0)?;
        let about = format!(
            "{}: {} instructions per pixel, error {}",
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
            @let alt = format!("Error against instructions per pixel of {} settings of {scene} on the device", dots.len());
            (legend(&dots))
            figure.half { (ScatterPlot { dots: &dots, cost: "instructions per pixel, on the device", write: count, noise: None, alt }.draw()) }
        }
    }
}

fn words(row: &DeviceRow) -> String {
    let DeviceRow { levels, sampler, precision, .. } = row;
    format!("levels {levels} cutoff {} sampler {sampler} precision {precision}", fraction_text(row.cutoff))
}

/// The run of the study with the same settings, if the scene is the same.
fn matching_run<'s>(study: &'s Study, row: &DeviceRow) -> Option<&'s StudyRun> {
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
    let has_matches = rows.iter().any(|row| matching_run(study, row).is_some());
    html! {
        table.plain {
            thead { tr {
                th { "setting" } th { "size" } th.number { "instructions" } th.number { "per pixel" } th.number { "per ray" } th.number { "error" }
                @if has_matches { th.number { "per pixel on this machine (work)" } }
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
                        @if has_matches {
                            td.number { @if let Some(run) = matching_run(study, row) { (count(run.work / pixels)) } @else { "–" } }
                        }
                    }
                }
            }
        }
    }
}
