//! Rendering, from a tracer into every kind of sink.

use embedded_graphics_core::Pixel as Dot;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size as Extent};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::primitives::Rectangle;
use strahl_core::accel::Accelerator;
use strahl_core::image::{
    Dither, DrawTargetSink, Framebuffer, FromChannels, Pixel, PixelSelector, Sampler, Sink, UncachedCorners,
};
use strahl_core::render::{render_progressive, render_selected};
use strahl_core::scene::Effects;
use strahl_core::tally::Tally;
use strahl_core::{CenterSampler, Rgb, Tile, Tracer, Worker, render};

use crate::any::{any, used};
use crate::image::{any_tile, any_trace};

/// Renders into memory, a function, and a display.
pub fn rendered<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
    mut sampler: impl Sampler,
) {
    let mut colors = [Rgb::BLACK; 4];
    if let Some(mut frame) = Framebuffer::new(any_tile(), any(&mut colors[..])) {
        let Ok(()) = render(
            &mut Tracer::with_worker(tracer, worker),
            &mut sampler,
            Tile::pixels(any_tile()),
            &mut frame,
        );
    }
    let Ok(()) = render(
        &mut Tracer::with_worker(tracer, worker),
        &mut sampler,
        Tile::pixels(any_tile()),
        &mut |pixel, color| used((pixel, color)),
    );
    used(render(
        &mut Tracer::with_worker(tracer, worker),
        &mut sampler,
        [any(Pixel { x: 0, y: 0 })],
        &mut FailingDisplay,
    ));
    let mut failing_display = FailingDisplay;
    let mut display =
        DrawTargetSink::new(&mut failing_display, Point::new(any(0), any(0)), any(Dither::Ordered));
    used(render(
        &mut Tracer::with_worker(tracer, worker),
        &mut sampler,
        [any(Pixel { x: 0, y: 0 })],
        &mut display,
    ));
    used(<Rgb565 as FromChannels>::from_channels(any([0; 3])));
}

/// Renders with pixel selection.
pub fn selected<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
    mut selected: PixelSelector<'_, UncachedCorners, CenterSampler>,
) {
    used(render_selected(
        &mut Tracer::with_worker(tracer, worker),
        &mut selected,
        Tile::pixels(any_tile()),
        &mut FailingDisplay,
    ));
    used(render_progressive(
        &mut Tracer::with_worker(tracer, worker),
        &mut selected,
        any_tile(),
        &mut FailingDisplay,
    ));
    used(*PixelSelector::selection(&selected));
    PixelSelector::reset(&mut selected);
    PixelSelector::refine_block(
        &mut selected,
        any(Pixel { x: 0, y: 0 }),
        any(4),
        &mut any_trace,
        &mut |_, _| {},
    );
    PixelSelector::sample_block(&mut selected, any(Pixel { x: 0, y: 0 }), &mut any_trace, &mut |_, _| {});
}

/// A display that may fail.
struct FailingDisplay;

impl Dimensions for FailingDisplay {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::zero(), Extent::zero())
    }
}

impl DrawTarget for FailingDisplay {
    type Color = Rgb565;
    type Error = u8;

    fn draw_iter<I: IntoIterator<Item = Dot<Rgb565>>>(&mut self, pixels: I) -> Result<(), u8> {
        pixels.into_iter().for_each(used);
        any(Ok(()))
    }
}

impl Sink for FailingDisplay {
    type Error = u8;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), u8> {
        used((pixel, color));
        any(Ok(()))
    }
}
