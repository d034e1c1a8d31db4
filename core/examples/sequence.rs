//! Errors of samplers at equal numbers of rays: the scrambled low-discrepancy sequence of stochastic
//! supersampling, jittered samples, and a regular grid.
//!
//! ```text
//! cargo run --release -p strahl-core --example sequence
//! ```
//!
//! Root mean square error over 4096 pixels with 16 and with 256 rays each:
//!
//! | | edge | edge | zone plate | zone plate |
//! |---|---|---|---|---|
//! | rays | 16 | 256 | 16 | 256 |
//! | regular | 0.0030 | 0.0003 | 0.0047 | 0.0003 |
//! | jittered | 0.0083 | 0.0009 | 0.0164 | 0.0010 |
//! | stochastic | 0.0062 | 0.0006 | 0.0076 | 0.0002 |
//!
//! At a straight edge that is not aligned with the grid, and for textures coarser than the grid, the regular
//! grid has the smallest error; where there is structure to alias with, the sequence has.

use strahl_core::Rgb;
use strahl_core::image::{Pixel, RegularSampler, Sampler, StochasticSampler};
use strahl_core::math::{Dimension, SobolSequence};
use strahl_core::scene::{CameraSample, FilmPoint};
use strahl_core::trace::{HitId, PixelSample, RayTracer};

/// Jittered sampling: n x n cells with a ray through a random point of each.
struct Jittered {
    n: u32,
}

impl Sampler for Jittered {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let n = self.n;
        let mut sum = Rgb::BLACK;
        for index in 0..n * n {
            // Another seed for each cell, so that the cells are independent.
            let [x, y] = SobolSequence::new(pixel.x, pixel.y, 0, index + 1).sample_2d(Dimension::PIXEL);
            let point = FilmPoint {
                x: pixel.x as f32 + ((index % n) as f32 + x) / n as f32,
                y: pixel.y as f32 + ((index / n) as f32 + y) / n as f32,
            };
            sum += tracer
                .trace(CameraSample { point, sequence: SobolSequence::new(pixel.x, pixel.y, index, 0) })
                .color;
        }
        PixelSample { color: sum * (1.0 / (n * n) as f32), hit: HitId::Nothing }
    }
}

/// Pixels along one side.
const SIDE: u32 = 64;

/// White on one side of a slanted edge.
fn edge(point: FilmPoint) -> f32 {
    if 0.83 * point.x + 0.31 * point.y < 36.1 { 1.0 } else { 0.0 }
}

/// Zone plate: rings that are finer than pixels far from the center.
fn zone_plate(point: FilmPoint) -> f32 {
    let (x, y) = (point.x - 31.7, point.y - 32.4);
    0.5 + 0.5 * libm::cosf(0.05 * (x * x + y * y))
}

/// Root mean square error of a sampler, compared with 96 x 96 samples per pixel.
fn error(mut sampler: impl Sampler, scene: fn(FilmPoint) -> f32) -> f64 {
    let mut shade =
        |sample: CameraSample| PixelSample { color: Rgb::gray(scene(sample.point)), hit: HitId::Nothing };
    let mut reference = RegularSampler::new(96).unwrap_or(RegularSampler::CENTER);
    let mut sum_of_squares = 0.0;
    for pixel in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| Pixel { x, y })) {
        let difference = sampler.sample_pixel(pixel, &mut shade).color.r
            - reference.sample_pixel(pixel, &mut shade).color.r;
        sum_of_squares += f64::from(difference * difference);
    }
    (sum_of_squares / f64::from(SIDE * SIDE)).sqrt()
}

fn main() {
    for (name, sampler) in [("regular", 0), ("jittered", 1), ("stochastic", 2)] {
        let mut row = format!("| {name} |");
        for scene in [edge as fn(FilmPoint) -> f32, zone_plate] {
            for n in [4_u16, 16] {
                let rays = u32::from(n) * u32::from(n);
                let error = match sampler {
                    0 => error(RegularSampler::new(n).unwrap_or(RegularSampler::CENTER), scene),
                    1 => error(Jittered { n: n.into() }, scene),
                    _ => StochasticSampler::new(rays).map_or(f64::NAN, |sampler| error(sampler, scene)),
                };
                row += &format!(" {error:.4} |");
            }
        }
        println!("{row}");
    }
}
