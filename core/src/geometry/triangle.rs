//! Triangle, flat or smooth, and watertight.
//!
//! The corners are moved into a frame in which the ray starts in the origin and runs along
//! the third axis; then the question is only on which side of three lines in the plane the
//! origin lies. Two triangles that share an edge ask the same question of it with the same
//! numbers, so that no ray slips between them ("Watertight Ray/Triangle Intersection", Woop,
//! Benthin, Wald, JCGT 2013).
//!
//! Differs from it: an edge function that rounds to zero is not computed again in a wider
//! type but with the errors of its two products, which the `f64` twin can do as well; and the
//! shear uses the ray's reciprocal, which is as good, because it is the same for all.

use super::{Aabb, Ray, Surface};
use crate::math::{Real, Vec3, abs, difference_of_products, gamma, greatest, largest, unit};

/// Where a ray meets a triangle: how far, and the shares of the three corners.
pub(super) struct Contact {
    pub(super) t: Real,
    shares: [Real; 3],
}

pub(super) fn bounds(corners: [Vec3; 3]) -> Aabb {
    Aabb::around(corners)
}

/// `(v1 - v0) x (v2 - v0)`, as long as twice the area. With corners within
/// [`FARTHEST`](crate::math::FARTHEST) it stays in range.
fn area([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
}

#[inline]
pub(super) fn hit(corners: [Vec3; 3], ray: &Ray) -> Option<Contact> {
    let inverse = ray.axis.to_third(ray.inverse).z;
    let d = ray.axis.to_third(ray.direction) * inverse;
    let [a, b, c] = corners.map(|corner| {
        let p = ray.axis.to_third(corner - ray.origin);
        Vec3::new(p.x - d.x * p.z, p.y - d.y * p.z, p.z * inverse)
    });

    let mut u = c.x * b.y - c.y * b.x;
    let mut v = a.x * c.y - a.y * c.x;
    let mut w = b.x * a.y - b.y * a.x;
    if u == 0.0 || v == 0.0 || w == 0.0 {
        u = difference_of_products(c.x, b.y, c.y, b.x);
        v = difference_of_products(a.x, c.y, a.y, c.x);
        w = difference_of_products(b.x, a.y, b.y, a.x);
    }
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    let sum = u + v + w;
    // What has no area is no surface, though rounding may have given it some width here.
    if sum == 0.0 || area(corners) == Vec3::ZERO {
        return None;
    }
    // Three quotients and not one reciprocal: that of a tiny sum would leave the range.
    let shares = [u / sum, v / sum, w / sum];
    Some(Contact { t: shares[0] * a.z + shares[1] * b.z + shares[2] * c.z, shares })
}

pub(super) fn surface(corners: [Vec3; 3], normals: Option<[Vec3; 3]>, ray: &Ray) -> Option<Surface> {
    let contact = hit(corners, ray)?;
    let mix = |v: [Vec3; 3]| v[0] * contact.shares[0] + v[1] * contact.shares[1] + v[2] * contact.shares[2];
    let flat = unit(area(corners))?;
    let point = mix(corners);
    // The shares of the corners add up to one within three roundings, and each product and
    // sum adds one; twice that for the test that starts here. What that test rounds besides
    // follows the distance of the corners, also where their coordinates are small.
    let away = corners.iter().fold(0.0, |away, corner| greatest(away, largest(*corner - point)));
    let error = mix(corners.map(abs)) * gamma(16) + Vec3::splat(away) * gamma(8);
    let shading = normals.and_then(|normals| unit(mix(normals))).unwrap_or(flat);
    Some(Surface { point, error, normal: flat, shading })
}
