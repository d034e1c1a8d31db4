//! One pixel is traced, and everything that comes of it is told.
//!
//! Items are found by the list, which needs no building and offers them in the order of the file: the
//! tree is the same for every accelerator, and this is the only tracer that is compiled for
//! somebody who listens.

use strahl_core::accel::{List, group_count};
use strahl_core::geometry::Aabb;
use strahl_core::image::{CacheEntry, Pixel, Sampler};
use strahl_core::scene::CameraSample;
use strahl_core::trace::PixelSample;
use strahl_core::{AllEffects, Camera, Rgb, Tracer, Worker, World};
use strahl_engine::RenderError;
use strahl_engine::samplers::{AnySampler, CornerSource};
use strahl_scene::description::LoadedScene;
use strahl_settings::{MAX_LEVELS, Settings};

use super::recorder::{MAX_RAYS, RayTreeRecorder};
use super::source_names::SourceNames;
use super::tree::{SampleRecord, SampleSum, SubpixelRecord, rgb_array};
use crate::tables::single::{scene_tables, view};

/// The colour of a pixel, and how it comes about.
pub struct TracedPixel {
    /// The colour.
    pub color: Rgb,
    /// How it comes of the samples.
    pub sum: SampleSum,
    /// The rays through the picture, in their order.
    pub samples: Vec<SampleRecord>,
}

/// Traces one pixel of the picture that is asked for.
pub fn trace_pixel(
    description: &LoadedScene,
    settings: &Settings,
    pixel: Pixel,
) -> Result<TracedPixel, RenderError> {
    let stock = scene_tables(description);
    let scene = stock.scene().map_err(RenderError::invalid)?;
    let camera = Camera::new(&view(&description.camera), settings.size).map_err(RenderError::invalid)?;
    let boxes: Vec<Aabb> = scene.descriptor().geometry.all_bounds().collect();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let world = World::new(scene, List::with_boxes(&boxes, &mut groups).map_err(RenderError::invalid)?);
    let tracer = Tracer::<_, AllEffects, MAX_LEVELS>::new(&world, camera, settings.limits())
        .map_err(RenderError::invalid)?;
    let names = SourceNames::new(description, &world);

    let mut seen = TracedSamples { samples: Vec::new(), film_points: Vec::new() };
    let mut trace = |place: CameraSample| {
        let mut worker = Worker::<_, _, MAX_LEVELS>::new(RayTreeRecorder::new(&names));
        let sight = tracer.trace(place, &mut worker);
        let rays = worker.into_tally().into_rays();
        let (number, CameraSample { point: at, .. }) = (seen.samples.len() + 1, place);
        seen.samples.push(SampleRecord { number, x: at.x, y: at.y, color: rgb_array(sight.color), rays });
        seen.film_points.push((place, sight));
        sight
    };
    let (color, parts) = match AnySampler::new(settings, CornerSource::Retraced, &mut [CacheEntry::EMPTY; 0])
    {
        AnySampler::Adaptive(mut sampler) => {
            let mut parts = Vec::new();
            // Parts share their corners, and none is told twice.
            let mut known: Vec<(CameraSample, PixelSample)> = Vec::new();
            let mut once = |place: CameraSample| match known.iter().find(|(other, _)| *other == place) {
                Some((_, sight)) => *sight,
                None => {
                    let sight = trace(place);
                    known.push((place, sight));
                    sight
                }
            };
            let sight = sampler.sample_subpixels(pixel, &mut once, &mut |part| parts.push(part));
            (sight.color, Some(parts))
        }
        mut sampler => (sampler.sample_pixel(pixel, &mut trace).color, None),
    };

    if seen.samples.iter().any(|sample| sample.rays.len() >= MAX_RAYS) {
        let reason = format!(
            "a ray through the picture leads to more than {MAX_RAYS} others: fewer --levels or a higher --cutoff tell less"
        );
        return Err(RenderError::invalid(reason));
    }

    let sum = match parts {
        None => SampleSum::Mean { share: 1.0 / seen.samples.len() as f32 },
        Some(parts) => SampleSum::Parts(parts.iter().map(|part| seen.part(part)).collect()),
    };
    Ok(TracedPixel { color, sum, samples: seen.samples })
}

/// What has been traced.
struct TracedSamples {
    samples: Vec<SampleRecord>,
    film_points: Vec<(CameraSample, PixelSample)>,
}

impl TracedSamples {
    /// A part of a pixel, with its corners by their numbers.
    fn part(&self, part: &strahl_core::image::Subpixel) -> SubpixelRecord {
        let strahl_core::image::Subpixel { place, side, .. } = *part;
        let (right, below) = (place.x + side, place.y + side);
        let number = |(x, y): (f32, f32)| {
            let found = self.film_points.iter().position(|(it, _)| it.point.x == x && it.point.y == y);
            found.map_or(0, |found| found + 1)
        };
        let corners = [(place.x, place.y), (right, place.y), (place.x, below), (right, below)];
        SubpixelRecord { x: place.x, y: place.y, side, samples: corners.map(number) }
    }
}
