//! What makes pixels of samples.

use strahl_core::*;

use crate::any::{any, number, used};
use crate::render::{rendered, selected};
use crate::scene::{any_sample, any_size};

pub fn doors() {
    let pixel = any(Pixel { x: 0, y: 0 });
    used((Tile::whole(any_size()), Lattice::tile(any_tile()), any_tile().within(any_tile())));
    used((any_tile().len(), any_tile().is_empty(), any_tile().place(pixel)));
    any_tile().tiles(any(1)).for_each(used);
}

pub fn any_tile() -> Tile {
    any(Tile { first: Pixel { x: 0, y: 0 }, width: 1, height: 1 })
}

/// With every sampler.
pub fn sampled<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
) {
    rendered(tracer, worker, Single);
    rendered(tracer, worker, Somewhere);
    let (filter, seed) = (any(Filter::Gaussian), any(0));
    if let Some(regular) = Regular::new(any(1)) {
        rendered(tracer, worker, regular.filtered(filter).seeded(seed));
    }
    if let Some(stochastic) = Stochastic::new(any(1)) {
        rendered(tracer, worker, stochastic.filtered(filter));
    }
    let ends = any(Confidence { errors: 1.0, tolerance: 0.1 });
    if let Some(mut stochastic) = Stochastic::between(any(1), any(2), ends) {
        let mut gathered = any(Gathered::NONE);
        stochastic.continue_pixel(any(Pixel { x: 0, y: 0 }), &mut gathered, &mut any_trace);
        used((gathered.sample(), gathered.rays(), gathered.doubt(number())));
        rendered(tracer, worker, &mut stochastic.seeded(seed));
        stochastic.begin();
    }
    corners(tracer, worker);
}

fn agreement() -> Option<Agreement> {
    let colors = Agreement::of_colors(number())?;
    Some(if any(true) { colors.and_items() } else { colors })
}

/// What shares the corners of pixels or of blocks.
fn corners<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
) {
    let Some(agreement) = agreement() else { return };
    used(Corners::corners(&mut Loose, any(Pixel { x: 0, y: 0 }), &mut |_| any(PixelSample::BLACK)));
    used((<Rgb as Record>::of(any(PixelSample::BLACK)), <PixelSample as Record>::of(any(PixelSample::BLACK))));
    let samples = any([PixelSample::BLACK; 4]);
    let (mut row, mut kept) = (any([PixelSample::BLACK; 4]), any([Kept::NOTHING; 4]));
    if let Some(parting) = Parting::new(any(1), agreement) {
        let parting = parting.seeded(any(0));
        rendered(tracer, worker, Corner(parting));
        rendered(tracer, worker, Adaptive::new(parting, Loose, any(&mut kept[..])));
        let mut parted = Adaptive::new(parting, Loose, any(&mut kept[..]));
        let pixel = any(Pixel { x: 0, y: 0 });
        used(parted.sample_by_parts(pixel, &mut any_trace, &mut |part: Part| used(part)));
        let row = CornerRow::new(any(&mut row[..]));
        rendered(tracer, worker, Adaptive::new(parting, row, any(&mut kept[..])));
        if let Some(lattice) = Lattice::new(any_tile(), any(&samples[..])) {
            rendered(tracer, worker, Adaptive::new(parting, lattice, any(&mut kept[..])));
        }
    }
    if let Some(selection) = Selection::new(any(4), agreement) {
        used((selection.step(), selection.blocks(any_tile()), selection.area(any_tile())));
        selection.sides().for_each(used);
        let every: Every<Single> = selection.raster(Single);
        rendered(tracer, worker, every);
        selected(tracer, worker, Selected::new(selection, Single, Loose, any(&mut kept[..])));
    }
}

/// Rays that go anywhere.
struct Somewhere;

impl Sampler for Somewhere {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, _: Pixel, tracer: &mut R) -> PixelSample {
        let sample = tracer.trace(any_sample());
        used(sample.hit.and(any(HitId::Several)));
        sample
    }
}

/// A ray tracer of which nothing is known.
pub fn any_trace(sample: CameraSample) -> PixelSample {
    any((sample, PixelSample::BLACK)).1
}
