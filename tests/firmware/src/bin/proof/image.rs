//! What makes pixels of samples.

use strahl_core::accel::Accelerator;
use strahl_core::image::{
    Adaptive, Agreement, Confidence, Corner, CornerRow, Corners, Every, Filter, Gathered, Kept, Lattice,
    Loose, Part, Parting, Pixel, Record, Regular, Sampler, Selected, Selection, Stochastic,
};
use strahl_core::scene::{CameraSample, Effects};
use strahl_core::tally::Tally;
use strahl_core::trace::{HitId, PixelSample, RayTracer};
use strahl_core::{Rgb, Single, Tile, Tracer, Worker};

use crate::any::{any, number, used};
use crate::render::{rendered, selected};
use crate::scene::{any_sample, any_size};

pub fn doors() {
    let pixel = any(Pixel { x: 0, y: 0 });
    used((Tile::whole(any_size()), Lattice::tile(any_tile()), Tile::within(any_tile(), any_tile())));
    used((Tile::len(any_tile()), Tile::is_empty(any_tile()), Tile::place(any_tile(), pixel)));
    Tile::tiles(any_tile(), any(1)).for_each(used);
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
        rendered(tracer, worker, Regular::seeded(Regular::filtered(regular, filter), seed));
    }
    if let Some(stochastic) = Stochastic::new(any(1)) {
        rendered(tracer, worker, Stochastic::filtered(stochastic, filter));
    }
    let ends = any(Confidence { errors: 1.0, tolerance: 0.1 });
    if let Some(mut stochastic) = Stochastic::between(any(1), any(2), ends) {
        let mut gathered = any(Gathered::NONE);
        let pixel = any(Pixel { x: 0, y: 0 });
        Stochastic::continue_pixel(&stochastic, pixel, &mut gathered, &mut any_trace);
        used((Gathered::sample(&gathered), Gathered::rays(&gathered), Gathered::doubt(&gathered, number())));
        rendered(tracer, worker, &mut Stochastic::seeded(stochastic, seed));
        stochastic.begin();
    }
    corners(tracer, worker);
}

fn agreement() -> Option<Agreement> {
    let colors = Agreement::of_colors(number())?;
    Some(if any(true) { Agreement::and_items(colors) } else { colors })
}

/// What shares the corners of pixels or of blocks.
fn corners<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
) {
    let Some(agreement) = agreement() else { return };
    used(Corners::corners(&mut Loose, any(Pixel { x: 0, y: 0 }), &mut |_| any(PixelSample::BLACK)));
    used((
        <Rgb as Record>::of(any(PixelSample::BLACK)),
        <PixelSample as Record>::of(any(PixelSample::BLACK)),
    ));
    let samples = any([PixelSample::BLACK; 4]);
    let (mut row, mut kept) = (any([PixelSample::BLACK; 4]), any([Kept::NOTHING; 4]));
    if let Some(parting) = Parting::new(any(1), agreement) {
        let parting = Parting::seeded(parting, any(0));
        rendered(tracer, worker, Corner(parting));
        rendered(tracer, worker, Adaptive::new(parting, Loose, any(&mut kept[..])));
        let mut parted = Adaptive::new(parting, Loose, any(&mut kept[..]));
        let pixel = any(Pixel { x: 0, y: 0 });
        let trace = &mut any_trace;
        used(Adaptive::sample_by_parts(&mut parted, pixel, trace, &mut |part: Part| used(part)));
        let row = CornerRow::new(any(&mut row[..]));
        rendered(tracer, worker, Adaptive::new(parting, row, any(&mut kept[..])));
        if let Some(lattice) = Lattice::new(any_tile(), any(&samples[..])) {
            rendered(tracer, worker, Adaptive::new(parting, lattice, any(&mut kept[..])));
        }
    }
    if let Some(selection) = Selection::new(any(4), agreement) {
        used((Selection::step(&selection), Selection::blocks(&selection, any_tile())));
        used(Selection::area(&selection, any_tile()));
        Selection::sides(&selection).for_each(used);
        let every: Every<Single> = Selection::raster(&selection, Single);
        rendered(tracer, worker, every);
        selected(tracer, worker, Selected::new(selection, Single, Loose, any(&mut kept[..])));
    }
}

/// Rays that go anywhere.
struct Somewhere;

impl Sampler for Somewhere {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, _: Pixel, tracer: &mut R) -> PixelSample {
        let sample = tracer.trace(any_sample());
        used(HitId::merged(sample.hit, any(HitId::Mixed)));
        sample
    }
}

/// A ray tracer of which nothing is known.
pub fn any_trace(sample: CameraSample) -> PixelSample {
    any((sample, PixelSample::BLACK)).1
}
