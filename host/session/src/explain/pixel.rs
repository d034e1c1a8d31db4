//! One pixel, traced with a recorder.
//!
//! The accelerator is the list, which needs no build and offers items in the order of the file: the tree is the same for
//! every accelerator, and only this tracer is compiled with a recorder.

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
use crate::tables::single::{camera_descriptor, scene_tables};

/// The color of a pixel and its samples.
pub struct TracedPixel {
    /// The color.
    pub color: Rgb,
    /// How the samples are combined.
    pub sum: SampleSum,
    /// The samples, in the order in which they are traced.
    pub samples: Vec<SampleRecord>,
}

/// Traces one pixel. Returns an error if the core refuses the scene, or if a sample has too many rays.
pub fn trace_pixel(
    description: &LoadedScene,
    settings: &Settings,
    pixel: Pixel,
) -> Result<TracedPixel, RenderError> {
    let tables = scene_tables(description);
    let scene = tables.scene().map_err(RenderError::invalid)?;
    let camera =
        Camera::new(&camera_descriptor(&description.camera), settings.size).map_err(RenderError::invalid)?;
    let boxes: Vec<Aabb> = scene.descriptor().geometry.all_bounds().collect();
    let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
    let world = World::new(scene, List::with_boxes(&boxes, &mut groups).map_err(RenderError::invalid)?);
    let tracer = Tracer::<_, AllEffects, MAX_LEVELS>::new(&world, camera, settings.limits())
        .map_err(RenderError::invalid)?;
    let names = SourceNames::new(description, &world);

    let mut traced = TracedSamples { samples: Vec::new(), film_points: Vec::new() };
    let mut trace = |camera_sample: CameraSample| {
        let mut worker = Worker::<_, _, MAX_LEVELS>::new(RayTreeRecorder::new(&names));
        let sample = tracer.trace(camera_sample, &mut worker);
        let rays = worker.into_tally().into_rays();
        let (number, CameraSample { point, .. }) = (traced.samples.len() + 1, camera_sample);
        traced.samples.push(SampleRecord {
            number,
            x: point.x,
            y: point.y,
            color: rgb_array(sample.color),
            rays,
        });
        traced.film_points.push((camera_sample, sample));
        sample
    };
    let (color, parts) = match AnySampler::new(settings, CornerSource::Retraced, &mut [CacheEntry::EMPTY; 0])
    {
        AnySampler::Adaptive(mut sampler) => {
            let mut parts = Vec::new();
            // Subpixels share their corners; each is traced once.
            let mut known: Vec<(CameraSample, PixelSample)> = Vec::new();
            let mut once = |at: CameraSample| match known.iter().find(|(other, _)| *other == at) {
                Some((_, sample)) => *sample,
                None => {
                    let sample = trace(at);
                    known.push((at, sample));
                    sample
                }
            };
            let sample = sampler.sample_subpixels(pixel, &mut once, &mut |part| parts.push(part));
            (sample.color, Some(parts))
        }
        mut sampler => (sampler.sample_pixel(pixel, &mut trace).color, None),
    };

    if traced.samples.iter().any(|sample| sample.rays.len() >= MAX_RAYS) {
        let reason = format!(
            "a camera ray has more than {MAX_RAYS} secondary rays; use fewer --levels or a higher --cutoff"
        );
        return Err(RenderError::invalid(reason));
    }

    let sum = match parts {
        None => SampleSum::Mean { share: 1.0 / traced.samples.len() as f32 },
        Some(parts) => SampleSum::Parts(parts.iter().map(|part| traced.subpixel(part)).collect()),
    };
    Ok(TracedPixel { color, sum, samples: traced.samples })
}

/// The samples traced so far.
struct TracedSamples {
    samples: Vec<SampleRecord>,
    film_points: Vec<(CameraSample, PixelSample)>,
}

impl TracedSamples {
    /// A subpixel with the numbers of the samples at its corners.
    fn subpixel(&self, part: &strahl_core::image::Subpixel) -> SubpixelRecord {
        let strahl_core::image::Subpixel { top_left: place, side, .. } = *part;
        let (right, below) = (place.x + side, place.y + side);
        let number = |(x, y): (f32, f32)| {
            let found = self.film_points.iter().position(|(it, _)| it.point.x == x && it.point.y == y);
            found.map_or(0, |found| found + 1)
        };
        let corners = [(place.x, place.y), (right, place.y), (place.x, below), (right, below)];
        SubpixelRecord { x: place.x, y: place.y, side, samples: corners.map(number) }
    }
}
