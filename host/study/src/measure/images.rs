//! Pictures of a study: what settings look like, and where they are wrong.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use strahl_core::Resolution;
use strahl_engine::cost_map::PixelCost;
use strahl_picture::color_map::{inferno, step_of};
use strahl_picture::{Picture, PictureFormat, srgb};

use super::benchmark::pair;
use super::measurements::{Measurements, ReferencePicture};
use crate::cost_model::{Counts, WEIGHTS};
use crate::error::StudyError;
use crate::pareto::{LIMITS, Point, cheapest_within, front};
use crate::record::words;
use crate::record::{Image, Role, Shows};

/// This many of a thousand pixels are darker than the brightest colour of a map of costs.
const BRIGHT: usize = 995;

/// Kinds of rays, in the order of counts.
const KINDS: [&str; 4] = ["camera rays", "reflected rays", "transmitted rays", "shadow rays"];

/// The most runs that are shown.
const MOST: usize = 6;

/// The reference, and the most telling runs with their errors.
pub fn all(measured: &Measurements<'_>, reference: &ReferencePicture) -> Result<Vec<Image>, StudyError> {
    let mut images = vec![image(Shows::Reference, None, "the reference", None, &reference.picture)?];
    for run in shown(measured) {
        let taken = &measured.taken[run];
        let Some(picture) = &taken.picture else { continue };
        let title = words(&taken.options);
        images.push(image(Shows::Picture, Some(run), &title, None, picture)?);
        let map = errors(picture, &reference.picture);
        images.push(image(Shows::Error, Some(run), &title, Some([0.0, 1.0]), &map)?);
    }
    images.extend(costs(measured)?);
    Ok(images)
}

/// What every pixel of the scene's own picture costs: in all, and by kind of ray.
fn costs(measured: &Measurements<'_>) -> Result<Vec<Image>, StudyError> {
    let Some(run) = measured.taken.iter().position(|taken| taken.run.role == Role::Own) else {
        return Ok(Vec::new());
    };
    let taken = &measured.taken[run];
    let Some(costs) = measured.bench.costs(&taken.options)? else { return Ok(Vec::new()) };
    let by_ray: Vec<[f64; 4]> =
        costs.iter().map(|cost| WEIGHTS.by_ray(&counts(cost), taken.run.setting.kind())).collect();
    let whole: Vec<f64> = by_ray.iter().map(|kinds| kinds.iter().sum()).collect();
    // Few pixels that take very much would leave all others dark.
    let mut sorted = whole.clone();
    sorted.sort_by(f64::total_cmp);
    let most = sorted.get((sorted.len() * BRIGHT) / 1000).copied().unwrap_or(1.0).max(1.0);
    let map = |of: &dyn Fn(usize) -> f64| {
        let steps = (0..whole.len()).map(|pixel| (255.0 * of(pixel) / most + 0.5) as u8);
        colored(measured.bench.size, steps)
    };
    let mut images = Vec::new();
    let range = Some([0.0, most]);
    images.push(image(Shows::Cost, Some(run), "all rays", range, &map(&|pixel| whole[pixel]))?);
    for (kind, name) in KINDS.iter().enumerate() {
        if taken.run.counts.rays[kind] > 0 {
            images.push(image(Shows::Cost, Some(run), name, range, &map(&|pixel| by_ray[pixel][kind]))?);
        }
    }
    Ok(images)
}

/// What was counted for a pixel.
fn counts(cost: &PixelCost) -> Counts {
    let wide = |of: [u32; 4]| of.map(u64::from);
    Counts {
        rays: wide(cost.rays),
        boxes: wide(cost.boxes),
        shapes: wide(cost.shapes),
        regions: wide(cost.regions),
        skipped: wide(cost.skipped),
        ..Counts::default()
    }
}

/// The cheapest of all, those within the limits, and the scene's own; the cheapest first.
fn shown(measured: &Measurements<'_>) -> Vec<usize> {
    let about = measured.taken.iter().enumerate().filter(|(_, taken)| taken.run.is_about_accuracy());
    let (places, points): (Vec<usize>, Vec<Point>) =
        about.map(|(place, it)| (place, Point { cost: it.run.work, error: it.run.error.rmse })).unzip();
    let cheapest = front(&points).first().copied();
    let most_accurate = front(&points).last().copied();
    let within = LIMITS.iter().filter_map(|limit| cheapest_within(&points, *limit));
    let telling = cheapest.into_iter().chain(within).chain(most_accurate).map(|place| places[place]);
    let own = measured.taken.iter().position(|taken| taken.run.role == Role::Own);
    let mut runs: Vec<usize> = own.into_iter().collect();
    // The same picture by other settings has nothing to show.
    let digest = |run: usize| &measured.taken[run].run.digest;
    for run in telling {
        if runs.len() < MOST && runs.iter().all(|shown| digest(*shown) != digest(run)) {
            runs.push(run);
        }
    }
    runs.sort_by(|a, b| measured.taken[*a].run.work.total_cmp(&measured.taken[*b].run.work));
    runs
}

/// The largest difference of each pixel as a colour.
fn errors(picture: &Picture, reference: &Picture) -> Picture {
    let steps = pair(picture, reference).differences().into_iter().map(step_of);
    colored(picture.size, steps)
}

/// Steps of the map as a picture.
fn colored(size: Resolution, steps: impl Iterator<Item = u8>) -> Picture {
    let (colors, table) = (inferno(), srgb::decode8());
    let colors = steps.map(|step| srgb::decode(&table, colors[usize::from(step)])).collect();
    Picture { size, colors }
}

fn image(
    shows: Shows,
    run: Option<usize>,
    title: &str,
    range: Option<[f64; 2]>,
    picture: &Picture,
) -> Result<Image, StudyError> {
    let file = PictureFormat::Png.encode(picture).map_err(|error| StudyError::Picture(error.into()))?;
    Ok(Image {
        shows,
        run,
        title: title.into(),
        range,
        width: picture.size.width(),
        height: picture.size.height(),
        png: STANDARD.encode(file),
    })
}
