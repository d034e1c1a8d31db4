//! Meshes of a chosen size, and rays at them.

use strahl_core::geometry::Ray;
use strahl_core::math::PI;
use strahl_core::{Vec3, vec3};

/// A triangle mesh.
pub struct BenchMesh {
    pub points: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl BenchMesh {
    /// A sphere with bumps, of about `triangles` triangles.
    pub fn bumpy_sphere(triangles: usize) -> BenchMesh {
        let rows = ((triangles as f32) / 4.0).sqrt().round().max(3.0) as u32;
        let columns = 2 * rows;
        let mut points = Vec::new();
        for row in 0..=rows {
            let polar = PI * row as f32 / rows as f32;
            for column in 0..columns {
                let azimuth = 2.0 * PI * column as f32 / columns as f32;
                let bumps = 0.08 * (9.0 * azimuth).sin() * (7.0 * polar).sin()
                    + 0.02 * (43.0 * azimuth).sin() * (37.0 * polar).cos();
                let radius = 1.0 + bumps;
                let ring = radius * polar.sin();
                points.push(vec3(ring * azimuth.cos(), radius * polar.cos(), ring * azimuth.sin()));
            }
        }
        let mut faces = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let at = |row, column| row * columns + column % columns;
                let [a, b] = [at(row, column), at(row, column + 1)];
                let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
                if row > 0 {
                    faces.push([a, b, d]);
                }
                if row + 1 < rows {
                    faces.push([a, d, c]);
                }
            }
        }
        BenchMesh { points, triangles: faces }
    }

    pub fn vertices(&self) -> impl Iterator<Item = [Vec3; 3]> + '_ {
        self.triangles.iter().map(|vertices| vertices.map(|index| self.points[index as usize]))
    }
}

/// The generator SplitMix64.
///
/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / (1 << 24) as f32
    }

    fn in_cube(&mut self, half_extent: f32) -> Vec3 {
        let mut one = || (2.0 * self.unit() - 1.0) * half_extent;
        vec3(one(), one(), one())
    }
}

/// Camera rays of a picture of `side` times `side` pixels, row by row.
pub fn camera_rays(side: u32) -> Vec<Ray> {
    let viewpoint = vec3(1.2, 1.6, 2.4);
    let toward = -viewpoint.normalize_or_zero();
    let right = toward.cross(Vec3::Y).normalize_or_zero();
    let up = right.cross(toward);
    let at = |pixel: u32| (pixel as f32 + 0.5) / side as f32 * 2.0 - 1.0;
    let rays = (0..side).flat_map(|y| (0..side).map(move |x| (x, y)));
    rays.map(|(x, y)| {
        Ray::new(viewpoint, (toward + right * (at(x) * 0.45) - up * (at(y) * 0.45)).normalize_or_zero())
    })
    .collect()
}

/// Rays between random points near the mesh.
pub fn random_rays(count: usize) -> Vec<Ray> {
    let mut rng = SplitMix64(1);
    let ray = |_| {
        let from = rng.in_cube(1.6);
        Ray::new(from, (rng.in_cube(1.1) - from).normalize_or_zero())
    };
    (0..count).map(ray).collect()
}
