//! Buffers for corners and pixels: a smaller one costs rays or is refused, and never changes a picture.

use crate::*;

/// The mean of the four corners of each pixel, each traced separately.
struct FourCorners;

impl Sampler for FourCorners {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, Pixel { x, y }: Pixel, tracer: &mut R) -> PixelSample {
        let mut corner = |dx, dy| {
            let point = FilmPoint { x: (x + dx) as Real, y: (y + dy) as Real };
            tracer.trace(CameraSample { point, sequence: SobolSequence::new(0, 0, 0, 0) }).color
        };
        let (upper, lower) = (corner(0, 0) + corner(1, 0), corner(0, 1) + corner(1, 1));
        PixelSample { color: (upper + lower) * 0.25, hit: HitId::Nothing }
    }
}

/// A subdivision of depth zero: corners only.
fn corners_only() -> Subdivision {
    Subdivision::new(0, ContrastThreshold::new(0.0).unwrap()).unwrap()
}

#[test]
fn corners_are_the_same_from_any_buffer_and_none_is_traced_twice() {
    let scene = mixed_scene();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    for (w, h) in [(1, 1), (1, 9), (9, 1), (24, 16)] {
        let s = size(w, h);
        let corners = u64::from((w + 1) * (h + 1));
        let (expected, counters) = picture::<_, AllEffects, 5>(&world, s, Limits::DEFAULT, &mut FourCorners);
        assert_eq!(counters.rays[RayKind::Camera], u64::from(4 * w * h));

        let mut row = vec![PixelSample::BLACK; w as usize + 1];
        let mut sampler = AdaptiveSampler::new(corners_only(), CornerRowCache::new(&mut row), &mut []);
        let (colors, counters) = picture::<_, AllEffects, 5>(&world, s, Limits::DEFAULT, &mut sampler);
        assert_eq!((colors, counters.rays[RayKind::Camera]), (expected.clone(), corners), "{w}x{h}");

        let camera = Camera::new(&VIEW, s).unwrap();
        let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT).unwrap();
        let whole = Tile::full(s);
        let mut memory = vec![PixelSample::BLACK; PretracedCorners::corner_tile(whole).len()];
        let mut frame = Framebuffer::new(PretracedCorners::corner_tile(whole), &mut memory).unwrap();
        let mut worker = Worker::new(Counters::new());
        // In any order: here from the last tile to the first.
        let tiles: Vec<Tile> = PretracedCorners::corner_tile(whole).tiles(5).collect();
        for tile in tiles.into_iter().rev() {
            let Ok(()) = render(
                &mut tracer.with_worker(&mut worker),
                &mut UpperLeftCornerSampler(corners_only()),
                tile.pixels(),
                &mut frame,
            );
        }
        assert_eq!(worker.tally().rays[RayKind::Camera], corners);
        let mut sampler =
            AdaptiveSampler::new(corners_only(), PretracedCorners::new(whole, &memory).unwrap(), &mut []);
        let (colors, counters) = picture::<_, AllEffects, 5>(&world, s, Limits::DEFAULT, &mut sampler);
        assert_eq!((colors, counters), (expected, Counters::new()), "{w}x{h}");
    }
}

#[test]
fn a_row_of_corners_that_is_too_short_costs_rays_and_changes_no_pixel() {
    let scene = mixed_scene();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    for (w, h) in [(1, 5), (6, 5)] {
        let (expected, _) =
            picture::<_, AllEffects, 5>(&world, size(w, h), Limits::DEFAULT, &mut FourCorners);
        let mut row = [PixelSample::BLACK; 10];
        let mut max_rays = u64::MAX;
        for capacity in 0..=w as usize + 3 {
            let mut sampler =
                AdaptiveSampler::new(corners_only(), CornerRowCache::new(&mut row[..capacity]), &mut []);
            let (colors, counters) =
                picture::<_, AllEffects, 5>(&world, size(w, h), Limits::DEFAULT, &mut sampler);
            assert_eq!(colors, expected, "{capacity} corners for rows of {w} pixels");
            let rays = counters.rays[RayKind::Camera];
            assert!(rays <= u64::from(4 * w * h) && rays >= u64::from((w + 1) * (h + 1)));
            if capacity <= w as usize + 1 {
                assert!(rays <= max_rays, "{capacity} corners");
                max_rays = rays;
            }
        }
    }
}

#[test]
fn framebuffers_and_corners_of_another_size_are_refused() {
    let s = size(3, 2);
    let mut memory = vec![PixelSample::BLACK; 20];
    for provided in 0..20 {
        assert_eq!(
            Framebuffer::new(Tile::full(s), &mut memory[..provided]).is_some(),
            provided == 6,
            "{provided}"
        );
        assert_eq!(
            PretracedCorners::new(Tile::full(s), &memory[..provided]).is_some(),
            provided == 12,
            "{provided}"
        );
    }
}

#[test]
fn a_sink_that_is_full_ends_the_picture() {
    struct FullSink {
        capacity: usize,
    }
    impl Sink for FullSink {
        type Error = Pixel;

        fn put(&mut self, pixel: Pixel, _: Rgb) -> Result<(), Pixel> {
            self.capacity = self.capacity.checked_sub(1).ok_or(pixel)?;
            Ok(())
        }
    }
    let scene = mixed_scene();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let s = size(4, 3);
    let camera = Camera::new(&VIEW, s).unwrap();
    let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT).unwrap();
    for (capacity, end) in [(0, Err(Pixel { x: 0, y: 0 })), (5, Err(Pixel { x: 1, y: 1 })), (12, Ok(()))] {
        let mut worker = Worker::new(Counters::new());
        let result = render(
            &mut tracer.with_worker(&mut worker),
            &mut CenterSampler,
            Tile::full(s).pixels(),
            &mut FullSink { capacity },
        );
        assert_eq!(result, end);
        let pixels = if end.is_ok() { capacity } else { capacity + 1 };
        assert_eq!(worker.tally().rays[RayKind::Camera], pixels as u64);
    }
}
