//! Four triangles side by side, for one quick question to all of them.
//!
//! Most rays miss most triangles that they are held against. Laid out corner by corner and
//! axis by axis, four triangles take hardly more than one on a machine that counts four numbers
//! at once, and no more than four on one that does not.

use super::Ray;
use crate::math::{Lanes, Vec3, vec3};

/// The corners of up to four triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct FourTriangles {
    /// By corner and axis; a lane for each triangle.
    corners: [[Lanes; 3]; 3],
}

impl FourTriangles {
    /// To be overwritten: all corners in the origin.
    pub(crate) const ZERO: FourTriangles = FourTriangles { corners: [[Lanes::splat(0.0); 3]; 3] };

    /// Puts a triangle into one of the places; there is none behind the fourth.
    pub(crate) fn put(&mut self, place: usize, corners: [&Vec3; 3]) {
        for (axes, corner) in self.corners.iter_mut().zip(corners) {
            for (lanes, x) in axes.iter_mut().zip(corner.to_array()) {
                if let Some(lane) = lanes.0.get_mut(place) {
                    *lane = x;
                }
            }
        }
    }

    /// The corners of one of them.
    #[inline(always)]
    pub(crate) fn corners(&self, place: usize) -> Option<[Vec3; 3]> {
        let x = |lanes: &Lanes| lanes.0.get(place).copied();
        let corner = |[a, b, c]: &[Lanes; 3]| Some(vec3(x(a)?, x(b)?, x(c)?));
        let [a, b, c] = &self.corners;
        Some([corner(a)?, corner(b)?, corner(c)?])
    }

    /// Which of them the line of the ray may meet: bit `i` is set unless it certainly misses
    /// triangle `i`. It is the first question of a triangle's own test, asked by the same
    /// operations in the same order.
    #[inline(always)]
    pub(crate) fn may_meet(&self, ray: &Ray) -> u32 {
        let [a, b, c] = self.corners.each_ref().map(|corner| seen(corner, ray));
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let (lowest, highest) = (u.least(v.least(w)), u.greatest(v.greatest(w)));
        Lanes::ALL ^ lowest.bits(highest, |low, high| (low < 0.0) & (high > 0.0))
    }
}

/// Corners, seen along the ray.
#[inline(always)]
fn seen([x, y, z]: &[Lanes; 3], ray: &Ray) -> [Lanes; 2] {
    let origin = ray.origin;
    let p = [*x - Lanes::splat(origin.x), *y - Lanes::splat(origin.y), *z - Lanes::splat(origin.z)];
    let on = |v: Vec3| p[0] * Lanes::splat(v.x) + p[1] * Lanes::splat(v.y) + p[2] * Lanes::splat(v.z);
    [on(ray.across), on(ray.upward)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_four_triangles_those_beside_the_ray_are_ruled_out() {
        let ray = Ray::new(vec3(0.25, 0.25, 1.0), vec3(0.0, 0.0, -1.0));
        let mut four = FourTriangles::ZERO;
        let met = [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
        let missed = met.map(|corner| corner + vec3(1.0, 0.0, 0.0));
        four.put(1, met.each_ref());
        four.put(2, missed.each_ref());
        four.put(4, missed.each_ref());
        assert_eq!(four.may_meet(&ray) & 0b0110, 0b0010);
        assert_eq!((four.corners(1), four.corners(2), four.corners(4)), (Some(met), Some(missed), None));
    }
}
