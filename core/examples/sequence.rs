//! Why stochastic supersampling takes a scrambled low-discrepancy sequence: its error beside
//! that of jittered cells and of a regular raster, at equal numbers of rays.
//!
//! ```text
//! cargo run --release -p strahl-core --example sequence
//! ```
//!
//! The root of the mean square error over 4096 pixels, of 16 and of 256 rays in each:
//!
//! | | edge | edge | zone plate | zone plate |
//! |---|---|---|---|---|
//! | rays | 16 | 256 | 16 | 256 |
//! | regular | 0.0030 | 0.0003 | 0.0047 | 0.0003 |
//! | jittered | 0.0083 | 0.0009 | 0.0164 | 0.0010 |
//! | stochastic | 0.0062 | 0.0006 | 0.0076 | 0.0002 |
//!
//! At one straight edge that no raster is aligned with, and where texture is coarser than the
//! raster, the regular one is hard to beat; it pays where there is structure to alias with.

use strahl_core::Rgb;
use strahl_core::image::{Pixel, Regular, Sampler, Stochastic};
use strahl_core::math::{Dimension, SobolSequence};
use strahl_core::scene::{CameraSample, FilmPoint};
use strahl_core::trace::{HitId, PixelSample, RayTracer};

/// n times n cells with a ray through a random place of each.
struct Jittered {
    n: u32,
}

impl Sampler for Jittered {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let n = self.n;
        let mut sum = Rgb::BLACK;
        for index in 0..n * n {
            // Another seed for each cell, so that they have nothing to do with each other.
            let [x, y] = SobolSequence::new(pixel.x, pixel.y, 0, index + 1).sample_2d(Dimension::PIXEL);
            let place = FilmPoint {
                x: pixel.x as f32 + ((index % n) as f32 + x) / n as f32,
                y: pixel.y as f32 + ((index / n) as f32 + y) / n as f32,
            };
            sum += tracer
                .trace(CameraSample {
                    point: place,
                    sequence: SobolSequence::new(pixel.x, pixel.y, index, 0),
                })
                .color;
        }
        PixelSample { color: sum * (1.0 / (n * n) as f32), hit: HitId::Nothing }
    }
}

/// Pixels along one side.
const SIDE: u32 = 64;

/// White on one side of a slanted line.
fn edge(place: FilmPoint) -> f32 {
    if 0.83 * place.x + 0.31 * place.y < 36.1 { 1.0 } else { 0.0 }
}

/// Rings that are finer than pixels far from the middle.
fn plate(place: FilmPoint) -> f32 {
    let (x, y) = (place.x - 31.7, place.y - 32.4);
    0.5 + 0.5 * libm::cosf(0.05 * (x * x + y * y))
}

fn error(mut sampler: impl Sampler, scene: fn(FilmPoint) -> f32) -> f64 {
    let mut see =
        |sample: CameraSample| PixelSample { color: Rgb::gray(scene(sample.point)), hit: HitId::Nothing };
    let mut truth = Regular::new(96).unwrap_or(Regular::ONE);
    let mut squares = 0.0;
    for pixel in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| Pixel { x, y })) {
        let difference =
            sampler.sample_pixel(pixel, &mut see).color.r - truth.sample_pixel(pixel, &mut see).color.r;
        squares += f64::from(difference * difference);
    }
    (squares / f64::from(SIDE * SIDE)).sqrt()
}

fn main() {
    for (name, sampler) in [("regular", 0), ("jittered", 1), ("stochastic", 2)] {
        let mut row = format!("| {name} |");
        for scene in [edge as fn(FilmPoint) -> f32, plate] {
            for n in [4_u16, 16] {
                let rays = u32::from(n) * u32::from(n);
                let error = match sampler {
                    0 => error(Regular::new(n).unwrap_or(Regular::ONE), scene),
                    1 => error(Jittered { n: n.into() }, scene),
                    _ => Stochastic::new(rays).map_or(f64::NAN, |sampler| error(sampler, scene)),
                };
                row += &format!(" {error:.4} |");
            }
        }
        println!("{row}");
    }
}
