//! Pictures of the report: renderings, error maps and cost maps.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use strahl_core::Resolution;
use strahl_engine::cost_map::PixelCost;
use strahl_picture::color_map::{inferno, step_of};
use strahl_picture::{Picture, PictureFormat, srgb};

use super::benchmark::picture_pair;
use super::measurements::{Measurements, ReferencePicture};
use crate::cost_model::{EventCounts, WEIGHTS};
use crate::error::StudyError;
use crate::pareto::{CostErrorPoint, ERROR_LIMITS, cheapest_within, pareto_front};
use crate::record::command_line;
use crate::record::{ImageContent, RunRole, StudyImage};

/// This many of a thousand pixels are below the brightest color of a cost map.
const BRIGHTEST_PERMILLE: usize = 995;

/// Ray kinds, in the order of [`EventCounts`].
const KINDS: [&str; 4] = ["camera rays", "reflected rays", "transmitted rays", "shadow rays"];

/// Maximum number of runs shown.
const MAX_PICTURES: usize = 6;

/// The reference, chosen runs with their error maps, and cost maps.
pub fn all(measured: &Measurements<'_>, reference: &ReferencePicture) -> Result<Vec<StudyImage>, StudyError> {
    let mut images = vec![image(ImageContent::Reference, None, "the reference", None, &reference.picture)?];
    for run in chosen_runs(measured) {
        let measurement = &measured.measurements[run];
        let Some(picture) = &measurement.picture else { continue };
        let title = command_line(&measurement.settings);
        images.push(image(ImageContent::Picture, Some(run), &title, None, picture)?);
        let map = error_map(picture, &reference.picture);
        images.push(image(ImageContent::Error, Some(run), &title, Some([0.0, 1.0]), &map)?);
    }
    images.extend(cost_maps(measured)?);
    Ok(images)
}

/// Cost per pixel with the settings of the scene, in total and by ray kind.
fn cost_maps(measured: &Measurements<'_>) -> Result<Vec<StudyImage>, StudyError> {
    let Some(run) = measured.measurements.iter().position(|measurement| measurement.run.role == RunRole::Own)
    else {
        return Ok(Vec::new());
    };
    let measurement = &measured.measurements[run];
    let Some(costs) = measured.benchmark.costs(&measurement.settings)? else { return Ok(Vec::new()) };
    let by_ray: Vec<[f64; 4]> = costs
        .iter()
        .map(|cost| {
            WEIGHTS.instructions_by_ray_kind(&event_counts(cost), measurement.run.setting.accelerator_kind())
        })
        .collect();
    let whole: Vec<f64> = by_ray.iter().map(|kinds| kinds.iter().sum()).collect();
    // A few very expensive pixels must not make all others dark.
    let mut sorted = whole.clone();
    sorted.sort_by(f64::total_cmp);
    let most = sorted.get((sorted.len() * BRIGHTEST_PERMILLE) / 1000).copied().unwrap_or(1.0).max(1.0);
    let map = |of: &dyn Fn(usize) -> f64| {
        let steps = (0..whole.len()).map(|pixel| (255.0 * of(pixel) / most + 0.5) as u8);
        colored(measured.benchmark.size, steps)
    };
    let mut images = Vec::new();
    let range = Some([0.0, most]);
    images.push(image(ImageContent::Cost, Some(run), "all rays", range, &map(&|pixel| whole[pixel]))?);
    for (kind, name) in KINDS.iter().enumerate() {
        if measurement.run.counts.rays[kind] > 0 {
            images.push(image(
                ImageContent::Cost,
                Some(run),
                name,
                range,
                &map(&|pixel| by_ray[pixel][kind]),
            )?);
        }
    }
    Ok(images)
}

/// The event counts of a pixel.
fn event_counts(cost: &PixelCost) -> EventCounts {
    let wide = |of: [u32; 4]| of.map(u64::from);
    EventCounts {
        rays: wide(cost.rays),
        boxes: wide(cost.boxes),
        shapes: wide(cost.shapes),
        regions: wide(cost.regions),
        skipped: wide(cost.skipped),
        ..EventCounts::default()
    }
}

/// The cheapest run, the cheapest within each error limit, the most accurate one, and that of the scene; cheapest first.
fn chosen_runs(measured: &Measurements<'_>) -> Vec<usize> {
    let about = measured
        .measurements
        .iter()
        .enumerate()
        .filter(|(_, measurement)| measurement.run.measures_accuracy());
    let (places, points): (Vec<usize>, Vec<CostErrorPoint>) = about
        .map(|(place, it)| (place, CostErrorPoint { cost: it.run.work, error: it.run.error.rmse }))
        .unzip();
    let cheapest = pareto_front(&points).first().copied();
    let most_accurate = pareto_front(&points).last().copied();
    let within = ERROR_LIMITS.iter().filter_map(|limit| cheapest_within(&points, *limit));
    let candidates = cheapest.into_iter().chain(within).chain(most_accurate).map(|place| places[place]);
    let own = measured.measurements.iter().position(|measurement| measurement.run.role == RunRole::Own);
    let mut runs: Vec<usize> = own.into_iter().collect();
    // Each picture is shown once.
    let digest = |run: usize| &measured.measurements[run].run.digest;
    for run in candidates {
        if runs.len() < MAX_PICTURES && runs.iter().all(|shown| digest(*shown) != digest(run)) {
            runs.push(run);
        }
    }
    runs.sort_by(|a, b| measured.measurements[*a].run.work.total_cmp(&measured.measurements[*b].run.work));
    runs
}

/// The largest channel difference of each pixel, as a color.
fn error_map(picture: &Picture, reference: &Picture) -> Picture {
    let steps = picture_pair(picture, reference).differences().into_iter().map(step_of);
    colored(picture.size, steps)
}

/// A picture from indices of the color map.
fn colored(size: Resolution, steps: impl Iterator<Item = u8>) -> Picture {
    let (colors, table) = (inferno(), srgb::decode8());
    let colors = steps.map(|step| srgb::decode(&table, colors[usize::from(step)])).collect();
    Picture { size, colors }
}

fn image(
    shows: ImageContent,
    run: Option<usize>,
    title: &str,
    range: Option<[f64; 2]>,
    picture: &Picture,
) -> Result<StudyImage, StudyError> {
    let file = PictureFormat::Png.encode(picture).map_err(|error| StudyError::Picture(error.into()))?;
    Ok(StudyImage {
        shows,
        run,
        title: title.into(),
        range,
        width: picture.size.width(),
        height: picture.size.height(),
        png: STANDARD.encode(file),
    })
}
