//! A fractal landscape below four glass spheres.
//!
//! Midpoint displacement: the center of each square gets the mean of the corners and a random displacement, which
//! decreases with the size of the square. Random numbers depend on the position only, so a larger size refines the same
//! landscape.
//!
//! Source: Fournier, Fussell and Carpenter, "Computer Rendering of Stochastic Models", CACM 25(6), 1982 (in the
//! diamond-square order). View, light and materials are those of `mount` of the Standard Procedural Databases (Eric
//! Haines, 1987); the landscape differs.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter, turns_to_radians};

/// The number of spheres.
pub const BALLS: u64 = 4;

const GLASS: ProceduralMaterial = ProceduralMaterial {
    name: "glass",
    color: [1.0; 3],
    kd: 0.1,
    ks: 0.1,
    shine: 101.148,
    glass: Some((0.9, 1.5)),
};
const ROCK: ProceduralMaterial = ProceduralMaterial::matte("rock", [0.5, 0.45, 0.35], 1.0);

/// The largest displacement of the center, and its factor for each halving: 2^-0.85, for a fractal dimension of 2.15.
const RISE: f64 = 0.9;
const SHRINKS: f64 = 0.554_784_736;

/// The mean height of the center; towards the edge all heights fall to zero.
const MEAN: f64 = 0.4;

/// Writes the scene; size 1 is a grid of 2 x 2 squares.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    writer.header(&SceneHeader {
        from: dvec3(-1.6, 1.6, 1.7),
        at: DVec3::ZERO,
        up: dvec3(0.0, 0.0, 1.0),
        lights: &[dvec3(-100.0, -100.0, 100.0)],
    })?;
    // One sphere on three others.
    writer.material(&GLASS)?;
    writer.sphere(dvec3(-0.8, 0.8, 1.208_21), 0.17)?;
    for k in 0..3 {
        let angle = turns_to_radians(f64::from(k) / 3.0 - 0.125);
        let out = 0.196_292;
        writer.sphere(dvec3(-0.8 + out * libm::cos(angle), 0.8 + out * libm::sin(angle), 0.930_598), 0.17)?;
    }
    writer.material(&ROCK)?;
    writer.mesh(&FractalTerrain::of(size))
}

/// A square grid of heights over [-1, 1] x [-1, 1].
pub struct FractalTerrain {
    /// The number of squares along each side, a power of two.
    squares: u32,
    /// The heights, row by row.
    heights: Vec<f32>,
}

impl FractalTerrain {
    /// The terrain of a size, at least 1.
    pub fn of(size: u32) -> Self {
        let squares = 1_u32 << size;
        let side = squares as usize + 1;
        let mut mountain = FractalTerrain { squares, heights: vec![0.0; side * side] };
        let mut step = squares as usize;
        let mut rise = RISE;
        while step > 1 {
            mountain.refine(step, rise);
            step /= 2;
            rise *= SHRINKS;
        }
        mountain
    }

    /// Sets the heights at the centers of all squares of this width, and at the midpoints of their sides.
    fn refine(&mut self, step: usize, rise: f64) {
        let (half, last) = (step / 2, self.squares as usize);
        let inner = (half..last).step_by(step);
        for y in inner.clone() {
            for x in inner.clone() {
                let corners =
                    [(x - half, y - half), (x + half, y - half), (x - half, y + half), (x + half, y + half)];
                self.raise(x, y, &corners, rise);
            }
        }
        for y in (0..=last).step_by(half) {
            let from = if (y / half).is_multiple_of(2) { half } else { 0 };
            for x in (from..=last).step_by(step) {
                let (left, right) = (x.checked_sub(half), Some(x + half).filter(|x| *x <= last));
                let (below, above) = (y.checked_sub(half), Some(y + half).filter(|y| *y <= last));
                let row = [left, right].into_iter().flatten().map(|x| (x, y));
                let column = [below, above].into_iter().flatten().map(|y| (x, y));
                let around: Vec<_> = row.chain(column).collect();
                // A side is shorter than a diagonal by a factor of sqrt(2).
                self.raise(x, y, &around, rise * std::f64::consts::FRAC_1_SQRT_2);
            }
        }
    }

    /// Sets a height to the mean of those around it, with a random displacement.
    fn raise(&mut self, x: usize, y: usize, around: &[(usize, usize)], rise: f64) {
        let sum: f64 = around.iter().map(|(x, y)| f64::from(self.heights[self.index(*x, *y)])).sum();
        let index = self.index(x, y);
        self.heights[index] = (sum / around.len() as f64 + rise * self.random(x, y)) as f32;
    }

    fn index(&self, x: usize, y: usize) -> usize {
        y * (self.squares as usize + 1) + x
    }

    /// A random number in [-1, 1) that depends on the position, not on the size.
    fn random(&self, x: usize, y: usize) -> f64 {
        let part = (1_u64 << 32) / u64::from(self.squares);
        let key = (x as u64 * part) ^ (y as u64 * part).rotate_left(31);
        // The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
        let key = key.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let key = (key ^ (key >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let key = (key ^ (key >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let bits = (key ^ (key >> 31)) >> 11;
        bits as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

impl ProceduralMesh for FractalTerrain {
    fn points(&self) -> u32 {
        (self.squares + 1) * (self.squares + 1)
    }

    fn point(&self, number: u32) -> (DVec3, Option<DVec3>) {
        let side = self.squares + 1;
        let along = |k: u32| 2.0 * f64::from(k) / f64::from(self.squares) - 1.0;
        let (x, y) = (along(number % side), along(number / side));
        let height = self.heights.get(number as usize).copied().unwrap_or(0.0);
        (dvec3(x, y, (MEAN + f64::from(height)) * (1.0 - x * x) * (1.0 - y * y)), None)
    }

    fn triangles(&self) -> u32 {
        2 * self.squares * self.squares
    }

    fn triangle(&self, number: u32) -> [u32; 3] {
        let square = number / 2;
        let side = self.squares + 1;
        let corner = square / self.squares * side + square % self.squares;
        match number % 2 {
            0 => [corner, corner + 1, corner + side + 1],
            _ => [corner + side + 1, corner + side, corner],
        }
    }
}
