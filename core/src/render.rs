//! The front door.

use crate::accel::Accelerator;
use crate::image::{Pixel, Sampler, Sink};
use crate::scene::Effects;
use crate::tally::Tally;
use crate::trace::{Tracer, Worker};

/// Traces `pixels`, in their order, into `sink`; ends early only when the sink fails.
///
/// Order, progress and threads are the caller's: a pixel's colour depends on nothing but its
/// place. The worker begins with nothing remembered, so that its work does not depend on
/// earlier calls either.
///
/// ```
/// use strahl_core::*;
///
/// let shapes = [Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 })];
/// let scene = Scene::new(Parts {
///     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
///     made_of: &[MaterialId(0)],
///     materials: &[Material::MATTE],
///     ambient: Rgb::gray(0.5),
///     ..Parts::EMPTY
/// })?;
/// let world = World::new(scene, List::bare(1));
/// let view = View {
///     from: vec3(0.0, 0.0, 0.0),
///     at: vec3(0.0, 0.0, -1.0),
///     up: vec3(0.0, 1.0, 0.0),
///     projection: Projection::Perspective { angle: 1.0 },
/// };
/// let size = Size::new(3, 3).unwrap();
/// let camera = Camera::new(&view, size)?;
/// let tracer = Tracer::<_, Everything, 5>::new(&world, camera, Limits::DEFAULT)?;
///
/// let mut picture = [Rgb::BLACK; 9];
/// let mut frame = Frame::new(Tile::whole(size), &mut picture).unwrap();
/// let Ok(()) = render(&tracer, &mut Single, &mut Worker::new(()), Tile::whole(size).pixels(), &mut frame);
///
/// let (ball, space) = (Rgb::gray(0.5), Rgb::BLACK);
/// assert_eq!(picture, [space, space, space, space, ball, space, space, space, space]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn render<A, E, T, S, K, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    sampler: &mut S,
    worker: &mut Worker<A, T, LEVELS>,
    pixels: impl IntoIterator<Item = Pixel>,
    sink: &mut K,
) -> Result<(), K::Error>
where
    A: Accelerator,
    E: Effects,
    T: Tally,
    S: Sampler,
    K: Sink,
{
    worker.forget();
    for pixel in pixels {
        let color = sampler.color(pixel, &mut |place| tracer.radiance(place, worker));
        sink.put(pixel, color)?;
    }
    Ok(())
}
