//! Four triangles in SIMD layout, for one conservative test of all of them.
//!
//! Most rays miss most of the triangles that they are tested against. The vertices are stored as a
//! structure of arrays, so with vector instructions the test of four triangles takes hardly longer than
//! the test of one.

use super::Ray;
use crate::math::{Real4, Vec3, vec3};

/// The vertices of up to four triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Triangle4 {
    /// By vertex and coordinate; element `i` is that of triangle `i`.
    vertices: [[Real4; 3]; 3],
}

impl Triangle4 {
    /// Initial value, with all vertices at the origin.
    pub(crate) const ZERO: Triangle4 = Triangle4 { vertices: [[Real4::splat(0.0); 3]; 3] };

    /// Sets the vertices of the triangle at `index`. Does nothing if `index` is greater than 3.
    pub(crate) fn set(&mut self, index: usize, vertices: [&Vec3; 3]) {
        for (coordinates, vertex) in self.vertices.iter_mut().zip(vertices) {
            for (elements, x) in coordinates.iter_mut().zip(vertex.to_array()) {
                if let Some(element) = elements.0.get_mut(index) {
                    *element = x;
                }
            }
        }
    }

    /// The vertices of the triangle at `index`; `None` if `index` is greater than 3.
    #[inline(always)]
    pub(crate) fn vertices(&self, index: usize) -> Option<[Vec3; 3]> {
        let element = |elements: &Real4| elements.0.get(index).copied();
        let vertex = |[x, y, z]: &[Real4; 3]| Some(vec3(element(x)?, element(y)?, element(z)?));
        let [a, b, c] = &self.vertices;
        Some([vertex(a)?, vertex(b)?, vertex(c)?])
    }

    /// The mask of the triangles that the ray may hit: bit `i` is zero if it certainly misses triangle `i`.
    ///
    /// It performs the first step of the triangle test, with the same operations in the same order.
    #[inline(always)]
    pub(crate) fn possible_hits(&self, ray: &Ray) -> u32 {
        let [a, b, c] = self.vertices.each_ref().map(|vertex| to_ray_space(vertex, ray));
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (min, max) = (u.min(v.min(w)), u.max(v.max(w)));
        Real4::FULL_MASK ^ min.compare(max, |min, max| (min < 0.0) & (max > 0.0))
    }
}

/// The coordinates of vertices perpendicular to the ray, in the frame in which the ray is the z axis.
#[inline(always)]
fn to_ray_space([x, y, z]: &[Real4; 3], ray: &Ray) -> [Real4; 2] {
    let origin = ray.origin;
    let p = [*x - Real4::splat(origin.x), *y - Real4::splat(origin.y), *z - Real4::splat(origin.z)];
    let dot = |v: Vec3| p[0] * Real4::splat(v.x) + p[1] * Real4::splat(v.y) + p[2] * Real4::splat(v.z);
    [dot(ray.shear_x), dot(ray.shear_y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_beside_the_ray_are_excluded() {
        let ray = Ray::new(vec3(0.25, 0.25, 1.0), vec3(0.0, 0.0, -1.0));
        let mut four = Triangle4::ZERO;
        let hit = [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
        let missed = hit.map(|vertex| vertex + vec3(1.0, 0.0, 0.0));
        four.set(1, hit.each_ref());
        four.set(2, missed.each_ref());
        four.set(4, missed.each_ref());
        assert_eq!(four.possible_hits(&ray) & 0b0110, 0b0010);
        assert_eq!((four.vertices(1), four.vertices(2), four.vertices(4)), (Some(hit), Some(missed), None));
    }
}
