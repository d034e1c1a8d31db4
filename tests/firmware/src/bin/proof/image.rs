//! Samplers, filters and pixel selection.

use strahl_core::accel::Accelerator;
use strahl_core::image::{
    AdaptiveSampler, CacheEntry, Confidence, ContrastThreshold, CornerCache, CornerRowCache, Filter,
    FramebufferPixel, Pixel, PixelEstimate, PixelSelection, PixelSelector, PretracedCorners, RegularSampler,
    Sampler, StochasticSampler, StridedSampler, Subdivision, Subpixel, UncachedCorners,
    UpperLeftCornerSampler,
};
use strahl_core::scene::{CameraSample, Effects};
use strahl_core::tally::Tally;
use strahl_core::trace::{HitId, PixelSample, RayTracer};
use strahl_core::{CenterSampler, Rgb, Tile, Tracer, Worker};

use crate::any::{any, number, used};
use crate::render::{rendered, selected};
use crate::scene::{any_sample, any_size};

pub fn entry_points() {
    let pixel = any(Pixel { x: 0, y: 0 });
    used((
        Tile::full(any_size()),
        PretracedCorners::corner_tile(any_tile()),
        Tile::intersection(any_tile(), any_tile()),
    ));
    used((Tile::len(any_tile()), Tile::is_empty(any_tile()), Tile::index_of(any_tile(), pixel)));
    Tile::tiles(any_tile(), any(1)).for_each(used);
}

pub fn any_tile() -> Tile {
    any(Tile { top_left: Pixel { x: 0, y: 0 }, width: 1, height: 1 })
}

/// With every sampler.
pub fn sampled<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
) {
    rendered(tracer, worker, CenterSampler);
    rendered(tracer, worker, ArbitrarySampler);
    let (filter, seed) = (any(Filter::Gaussian), any(0));
    if let Some(regular) = RegularSampler::new(any(1)) {
        rendered(
            tracer,
            worker,
            RegularSampler::with_seed(RegularSampler::with_filter(regular, filter), seed),
        );
    }
    if let Some(stochastic) = StochasticSampler::new(any(1)) {
        rendered(tracer, worker, StochasticSampler::with_filter(stochastic, filter));
    }
    let ends = any(Confidence { standard_errors: 1.0, tolerance: 0.1 });
    if let Some(mut stochastic) = StochasticSampler::with_range(any(1), any(2), ends) {
        let mut estimate = any(PixelEstimate::EMPTY);
        let pixel = any(Pixel { x: 0, y: 0 });
        StochasticSampler::continue_pixel(&stochastic, pixel, &mut estimate, &mut any_trace);
        used((
            PixelEstimate::to_sample(estimate),
            PixelEstimate::sample_count(&estimate),
            PixelEstimate::srgb_confidence_radius(&estimate, number()),
        ));
        rendered(tracer, worker, &mut StochasticSampler::with_seed(stochastic, seed));
        stochastic.reset();
    }
    corners(tracer, worker);
}

fn contrast() -> Option<ContrastThreshold> {
    let colors = ContrastThreshold::new(number())?;
    Some(if any(true) { ContrastThreshold::with_items(colors) } else { colors })
}

/// Samplers that share the corners of pixels or of blocks.
fn corners<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
) {
    let Some(contrast) = contrast() else { return };
    used(CornerCache::corners(&mut UncachedCorners, any(Pixel { x: 0, y: 0 }), &mut |_| {
        any(PixelSample::BLACK)
    }));
    used((
        <Rgb as FramebufferPixel>::from_sample(any(PixelSample::BLACK)),
        <PixelSample as FramebufferPixel>::from_sample(any(PixelSample::BLACK)),
    ));
    let samples = any([PixelSample::BLACK; 4]);
    let (mut row, mut cache) = (any([PixelSample::BLACK; 4]), any([CacheEntry::EMPTY; 4]));
    if let Some(subdivision) = Subdivision::new(any(1), contrast) {
        let subdivision = Subdivision::with_seed(subdivision, any(0));
        rendered(tracer, worker, UpperLeftCornerSampler(subdivision));
        rendered(tracer, worker, AdaptiveSampler::new(subdivision, UncachedCorners, any(&mut cache[..])));
        let mut adaptive = AdaptiveSampler::new(subdivision, UncachedCorners, any(&mut cache[..]));
        let pixel = any(Pixel { x: 0, y: 0 });
        let trace = &mut any_trace;
        used(AdaptiveSampler::sample_subpixels(&mut adaptive, pixel, trace, &mut |subpixel: Subpixel| {
            used(subpixel)
        }));
        let row = CornerRowCache::new(any(&mut row[..]));
        rendered(tracer, worker, AdaptiveSampler::new(subdivision, row, any(&mut cache[..])));
        if let Some(corners) = PretracedCorners::new(any_tile(), any(&samples[..])) {
            rendered(tracer, worker, AdaptiveSampler::new(subdivision, corners, any(&mut cache[..])));
        }
    }
    if let Some(selection) = PixelSelection::new(any(4), contrast) {
        used((PixelSelection::step(&selection), PixelSelection::block_range(&selection, any_tile())));
        used(PixelSelection::pixels_of(&selection, any_tile()));
        PixelSelection::refinement_sides(&selection).for_each(used);
        let every: StridedSampler<CenterSampler> =
            PixelSelection::first_pass_sampler(&selection, CenterSampler);
        rendered(tracer, worker, every);
        selected(
            tracer,
            worker,
            PixelSelector::new(selection, CenterSampler, UncachedCorners, any(&mut cache[..])),
        );
    }
}

/// Traces arbitrary rays.
struct ArbitrarySampler;

impl Sampler for ArbitrarySampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, _: Pixel, tracer: &mut R) -> PixelSample {
        let sample = tracer.trace(any_sample());
        used(HitId::same_or_mixed(sample.hit, any(HitId::Mixed)));
        sample
    }
}

/// A ray tracer with arbitrary results.
pub fn any_trace(sample: CameraSample) -> PixelSample {
    any((sample, PixelSample::BLACK)).1
}
