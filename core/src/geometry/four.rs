//! Four triangles in SIMD layout, for one conservative test of all of them.
//!
//! Most rays miss most of the triangles that they are tested against. The vertices are stored as a
//! structure of arrays, so with vector instructions the test of four triangles takes hardly longer than
//! the test of one.

use super::Ray;
use crate::math::{Lanes, Vec3, vec3};

/// The vertices of up to four triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct FourTriangles {
    /// By vertex and coordinate; element `i` is that of triangle `i`.
    vertices: [[Lanes; 3]; 3],
}

impl FourTriangles {
    /// Initial value, with all vertices at the origin.
    pub(crate) const ZERO: FourTriangles = FourTriangles { vertices: [[Lanes::splat(0.0); 3]; 3] };

    /// Sets the vertices of the triangle at `index`. Does nothing if `index` is greater than 3.
    pub(crate) fn put(&mut self, index: usize, vertices: [&Vec3; 3]) {
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
    pub(crate) fn corners(&self, index: usize) -> Option<[Vec3; 3]> {
        let element = |elements: &Lanes| elements.0.get(index).copied();
        let vertex = |[x, y, z]: &[Lanes; 3]| Some(vec3(element(x)?, element(y)?, element(z)?));
        let [a, b, c] = &self.vertices;
        Some([vertex(a)?, vertex(b)?, vertex(c)?])
    }

    /// The mask of the triangles that the ray may hit: bit `i` is zero if it certainly misses triangle `i`.
    ///
    /// It performs the first step of the triangle test, with the same operations in the same order.
    #[inline(always)]
    pub(crate) fn may_meet(&self, ray: &Ray) -> u32 {
        let [a, b, c] = self.vertices.each_ref().map(|vertex| to_ray_space(vertex, ray));
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (min, max) = (u.least(v.least(w)), u.greatest(v.greatest(w)));
        Lanes::ALL ^ min.bits(max, |min, max| (min < 0.0) & (max > 0.0))
    }
}

/// The coordinates of vertices perpendicular to the ray, in the frame in which the ray is the z axis.
#[inline(always)]
fn to_ray_space([x, y, z]: &[Lanes; 3], ray: &Ray) -> [Lanes; 2] {
    let origin = ray.origin;
    let p = [*x - Lanes::splat(origin.x), *y - Lanes::splat(origin.y), *z - Lanes::splat(origin.z)];
    let dot = |v: Vec3| p[0] * Lanes::splat(v.x) + p[1] * Lanes::splat(v.y) + p[2] * Lanes::splat(v.z);
    [dot(ray.shear_x), dot(ray.shear_y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_beside_the_ray_are_excluded() {
        let ray = Ray::new(vec3(0.25, 0.25, 1.0), vec3(0.0, 0.0, -1.0));
        let mut four = FourTriangles::ZERO;
        let hit = [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
        let missed = hit.map(|vertex| vertex + vec3(1.0, 0.0, 0.0));
        four.put(1, hit.each_ref());
        four.put(2, missed.each_ref());
        four.put(4, missed.each_ref());
        assert_eq!(four.may_meet(&ray) & 0b0110, 0b0010);
        assert_eq!((four.corners(1), four.corners(2), four.corners(4)), (Some(hit), Some(missed), None));
    }
}
