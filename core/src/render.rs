//! Rendering: pixels from a sampler and a ray tracer into a sink.
//!
//! The caller chooses the pixels and their order, and splits a picture among threads: a pixel depends on
//! nothing but its coordinates. [`render_selected`] traces some pixels and interpolates the others;
//! [`render_progressive`] shows such a picture coarse first.
//!
//! A device that sends row by row renders tiles of height 1. `tracer` and `worker` are made once, as in the
//! [first program](crate); each call of `render` clears the caches, so tiles of several rows are faster:
//!
//! ```
//! use strahl_core::image::Pixel;
//! use strahl_core::*;
//!
//! # let background = Background::Color(Rgb::WHITE);
//! # let scene = Scene::new(SceneDescriptor { background, ..SceneDescriptor::EMPTY })?;
//! # let world = World::new(scene, ListWithoutBounds(0));
//! let resolution = Resolution::new(160, 120).unwrap();
//! # let camera = Camera::new(&CameraDescriptor::perspective(Vec3::ZERO, Vec3::X, 0.6), resolution)?;
//! # let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT)?;
//! # let mut worker = Worker::new(());
//! # let mut send = |_: u32, row: &[[u8; 3]]| assert_eq!(row, [[255; 3]; 160]);
//! let mut row = [[0; 3]; 160];
//! for y in 0..resolution.height() {
//!     let tile = Tile { top_left: Pixel { x: 0, y }, width: resolution.width(), height: 1 };
//!     let mut sink = |pixel: Pixel, color: Rgb| row[pixel.x as usize] = color.to_srgb8();
//!     let mut ray_tracer = tracer.with_worker(&mut worker);
//!     let Ok(()) = render(&mut ray_tracer, &mut CenterSampler, tile.pixels(), &mut sink);
//!     send(y, &row);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::image::{CornerCache, Pixel, PixelSelector, Sampler, Sink, Tile};
use crate::trace::RayTracer;

/// Renders `pixels`, in their order, into `sink`.
///
/// The caches of tracer and sampler are cleared first, so counters do not depend on earlier calls. The
/// picture does not depend on the caches.
///
/// # Errors
///
/// The error of the sink; rendering ends there. Tracing cannot fail.
///
/// ```
/// use strahl_core::image::Framebuffer;
/// use strahl_core::*;
///
/// let shapes = [Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 })];
/// let scene = Scene::new(SceneDescriptor {
///     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
///     material_ids: &[MaterialId(0)],
///     materials: &[Material { ambient: Rgb::WHITE, ..Material::MATTE }],
///     ambient: Rgb::gray(0.5),
///     ..SceneDescriptor::EMPTY
/// })?;
/// let world = World::new(scene, ListWithoutBounds(1));
/// let descriptor = CameraDescriptor {
///     position: vec3(0.0, 0.0, 0.0),
///     target: vec3(0.0, 0.0, -1.0),
///     up: vec3(0.0, 1.0, 0.0),
///     projection: Projection::Perspective { field_of_view: 1.0 },
/// };
/// let resolution = Resolution::new(3, 3).unwrap();
/// let camera = Camera::new(&descriptor, resolution)?;
/// let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT)?;
/// let mut worker = Worker::new(());
///
/// let mut picture = [Rgb::BLACK; 9];
/// let tile = Tile::full(resolution);
/// let mut framebuffer = Framebuffer::new(tile, &mut picture).unwrap();
/// let mut ray_tracer = tracer.with_worker(&mut worker);
/// let Ok(()) = render(&mut ray_tracer, &mut CenterSampler, tile.pixels(), &mut framebuffer);
///
/// // Only the ray through the center hits the sphere.
/// let (hit, miss) = (Rgb::gray(0.5), Rgb::BLACK);
/// assert_eq!(picture, [miss, miss, miss, miss, hit, miss, miss, miss, miss]);
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
    sampler.reset();
    for pixel in pixels {
        let sample = sampler.sample_pixel(pixel, tracer);
        sink.put_sample(pixel, sample)?;
    }
    Ok(())
}

/// Renders `blocks` of pixels into `sink`, block by block: some pixels of each block are traced, the others
/// interpolated where the traced ones are similar.
///
/// [`PixelSelection::block_range`](crate::image::PixelSelection::block_range) returns the blocks that cover a tile. They may
/// extend beyond its right and lower edge; the sink receives these pixels too.
///
/// # Errors
///
/// The error of the sink; rendering ends with that block.
pub fn render_selected<R, K>(
    tracer: &mut R,
    selector: &mut PixelSelector<'_, impl CornerCache, impl Sampler>,
    blocks: impl IntoIterator<Item = Pixel>,
    sink: &mut K,
) -> Result<(), K::Error>
where
    R: RayTracer + ?Sized,
    K: Sink,
{
    tracer.reset();
    selector.reset();
    for block in blocks {
        let mut result = Ok(());
        selector.sample_block(block, tracer, &mut |pixel, sample| {
            if result.is_ok() {
                result = sink.put_sample(pixel, sample);
            }
        });
        result?;
    }
    Ok(())
}

/// Renders `tile` progressively: coarse blocks first, then the quarters of blocks whose corners differ, and
/// so on. The final picture is that of [`render_selected`].
///
/// Suits displays that show the picture while it is drawn: no memory for the picture is needed, and in each
/// pass the sink receives only the pixels that change. Blocks may extend beyond the right and lower edge of
/// the tile; the sink receives these pixels too.
///
/// # Errors
///
/// The error of the sink; rendering ends with that block.
pub fn render_progressive<R, K>(
    tracer: &mut R,
    selector: &mut PixelSelector<'_, impl CornerCache, impl Sampler>,
    tile: Tile,
    sink: &mut K,
) -> Result<(), K::Error>
where
    R: RayTracer + ?Sized,
    K: Sink,
{
    tracer.reset();
    selector.reset();
    let selection = *selector.selection();
    for side in selection.refinement_sides() {
        for block in selection.block_range(tile).pixels() {
            let mut result = Ok(());
            selector.refine_block(block, side, tracer, &mut |pixel, sample| {
                if result.is_ok() {
                    result = sink.put_sample(pixel, sample);
                }
            });
            result?;
        }
    }
    Ok(())
}
