//! The front door.

use crate::image::{Corners, Pixel, Sampler, Selected, Sink, Tile};
use crate::trace::RayTracer;

/// Traces `pixels`, in their order, into `sink`; ends early only when the sink fails.
///
/// Order, progress and threads are the caller's: a pixel's colour depends on nothing but its
/// place. The worker begins with nothing remembered, so that its work does not depend on
/// earlier calls either.
///
/// ```
/// use strahl_core::image::Frame;
/// use strahl_core::*;
///
/// let shapes = [Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 })];
/// let scene = Scene::new(SceneDescriptor {
///     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
///     material_ids: &[MaterialId(0)],
///     materials: &[Material::MATTE],
///     ambient: Rgb::gray(0.5),
///     ..SceneDescriptor::EMPTY
/// })?;
/// let world = World::new(scene, BareList(1));
/// let view = CameraDescriptor {
///     position: vec3(0.0, 0.0, 0.0),
///     target: vec3(0.0, 0.0, -1.0),
///     up: vec3(0.0, 1.0, 0.0),
///     projection: Projection::Perspective { field_of_view: 1.0 },
/// };
/// let resolution = Resolution::new(3, 3).unwrap();
/// let camera = Camera::new(&view, resolution)?;
/// let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT)?;
/// let mut worker = Worker::new(());
///
/// let mut picture = [Rgb::BLACK; 9];
/// let whole = Tile::whole(resolution);
/// let mut frame = Frame::new(whole, &mut picture).unwrap();
/// let Ok(()) = render(&mut tracer.with_worker(&mut worker), &mut Single, whole.pixels(), &mut frame);
///
/// let (ball, space) = (Rgb::gray(0.5), Rgb::BLACK);
/// assert_eq!(picture, [space, space, space, space, ball, space, space, space, space]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn render<R, S, K>(
    tracer: &mut R,
    sampler: &mut S,
    pixels: impl IntoIterator<Item = Pixel>,
    sink: &mut K,
) -> Result<(), K::Error>
where
    R: RayTracer + ?Sized,
    S: Sampler,
    K: Sink,
{
    tracer.reset();
    sampler.begin();
    for pixel in pixels {
        let sample = sampler.sample_pixel(pixel, tracer);
        sink.put_sample(pixel, sample)?;
    }
    Ok(())
}

/// Traces some pixels of each of `blocks`, guesses the others, and puts them all into `sink`,
/// block by block; ends early only when the sink fails.
///
/// [`Selection::blocks`](crate::image::Selection::blocks) lists the blocks of a picture or of a part
/// of it. The sink also gets the pixels of these blocks that lie outside of it, beyond the
/// right and the lower edge.
pub fn render_selected<R, K>(
    tracer: &mut R,
    selected: &mut Selected<'_, impl Corners, impl Sampler>,
    blocks: impl IntoIterator<Item = Pixel>,
    sink: &mut K,
) -> Result<(), K::Error>
where
    R: RayTracer + ?Sized,
    K: Sink,
{
    tracer.reset();
    selected.begin();
    for block in blocks {
        let mut result = Ok(());
        selected.sample_block(block, tracer, &mut |pixel, sample| {
            if result.is_ok() {
                result = sink.put_sample(pixel, sample);
            }
        });
        result?;
    }
    Ok(())
}

/// Traces `tile` so that the whole of it is there soon: coarse blocks at first, then the quarters of
/// those that do not agree, and so on, until all is as [`render_selected`] makes it; ends early
/// only when the sink fails.
///
/// For a display that is looked at while it is drawn: it needs no memory for the picture, and gets
/// those pixels anew that have changed. As there, it also gets pixels beyond the right and the
/// lower edge.
pub fn render_progressive<R, K>(
    tracer: &mut R,
    selected: &mut Selected<'_, impl Corners, impl Sampler>,
    tile: Tile,
    sink: &mut K,
) -> Result<(), K::Error>
where
    R: RayTracer + ?Sized,
    K: Sink,
{
    tracer.reset();
    selected.begin();
    let selection = *selected.selection();
    for side in selection.sides() {
        for block in selection.blocks(tile).pixels() {
            let mut result = Ok(());
            selected.refine_block(block, side, tracer, &mut |pixel, sample| {
                if result.is_ok() {
                    result = sink.put_sample(pixel, sample);
                }
            });
            result?;
        }
    }
    Ok(())
}
