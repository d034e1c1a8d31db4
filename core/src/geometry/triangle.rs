//! Triangle, flat or smooth, and watertight.
//!
//! The corners are looked at along the ray, in a frame in which it starts in the origin and runs
//! along the third axis; then the question is only on which side of three lines in the plane the
//! origin lies. Two triangles that share an edge ask the same question of it with the same
//! numbers, so that no ray slips between them ("Watertight Ray/Triangle Intersection", Woop,
//! Benthin, Wald, JCGT 2013).
//!
//! Differs from it: the axes are not permuted for each corner, but the two lines of the ray's
//! matrix, once for each ray. And edge functions are computed again, with the errors of their
//! products (which the `f64` twin can do as well as a wider type), not only where one of them
//! rounds to zero but wherever much of the products cancels: the distance of a needle, and what
//! leaves it, is then as good as that of any other triangle. Only rays that meet pay for asking.

use super::{Aabb, Ray, Surface, plane::above, ray::LEAVING};
use crate::math::{
    ROUNDOFF, Real, Vec3, abs, difference_error, difference_of_products, gamma, greatest, largest, least,
    unit, vec3,
};

/// Where a ray meets a triangle: how far, and the shares of the three corners.
pub(super) struct Contact {
    pub(super) t: Real,
    shares: [Real; 3],
}

pub(super) fn bounds(corners: [&Vec3; 3]) -> Aabb {
    Aabb::around(corners.map(|corner| *corner))
}

/// How small an area is, beside the square of what it is measured from, before the roundings of
/// the products that make it count.
const SLIM: Real = 1.0 / 8.0;

/// `(v1 - v0) x (v2 - v0)`, as long as twice the area: right to some roundoffs of itself, and
/// zero where that cannot be told from no area. With corners within
/// [`FARTHEST`](crate::math::FARTHEST) it stays in range.
fn area([a, b, c]: [Vec3; 3]) -> Vec3 {
    let (e, f) = (b - a, c - a);
    let (rough, square) = (e.cross(f), largest(e) * largest(f));
    if largest(rough) > SLIM * square {
        return rough;
    }
    // A needle: what rounding takes from the products and from the sides turns the normal.
    let (de, df) = (difference_error(b, a, e), difference_error(c, a, f));
    let exact = vec3(
        difference_of_products(e.y, f.z, e.z, f.y),
        difference_of_products(e.z, f.x, e.x, f.z),
        difference_of_products(e.x, f.y, e.y, f.x),
    );
    let area = exact + (e.cross(df) - f.cross(de));
    if largest(area) > NOTHING * square { area } else { Vec3::ZERO }
}

/// Whether the tracer sees any area between three corners. What has none is never met.
pub fn has_area(corners: [Vec3; 3]) -> bool {
    area(corners) != Vec3::ZERO
}

/// How much of the product of two sides is left of their exact cross product by rounding alone.
const NOTHING: Real = 16.0 * ROUNDOFF * ROUNDOFF;

/// Where the ray meets the triangle, edges and corners included.
#[inline]
pub(super) fn hit([a, b, c]: [&Vec3; 3], ray: &Ray) -> Option<Contact> {
    let [at, bt, ct] = [a, b, c].map(|corner| seen(*corner, ray));
    let sides = sides(at, bt, ct);
    if is_beside(sides) { None } else { contact([a, b, c], [at, bt, ct], sides, ray) }
}

/// A corner, seen along the ray.
#[inline(always)]
fn seen(corner: Vec3, ray: &Ray) -> [Real; 2] {
    let p = corner - ray.origin;
    [p.dot(ray.across), p.dot(ray.upward)]
}

/// On which side of each edge the ray passes. The products are rounded, but never past each
/// other: the sign may be lost, and is not wrong.
#[inline(always)]
fn sides(a: [Real; 2], b: [Real; 2], c: [Real; 2]) -> [Real; 3] {
    [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]]
}

/// Not inlined: most rays miss most triangles, and need not carry its numbers.
#[inline(never)]
fn contact(
    corners: [&Vec3; 3],
    [a, b, c]: [[Real; 2]; 3],
    mut sides: [Real; 3],
    ray: &Ray,
) -> Option<Contact> {
    let [u, v, w] = sides;
    let extent = |[x, y]: [Real; 2]| greatest(x.abs(), y.abs());
    let extent = greatest(extent(a), greatest(extent(b), extent(c)));
    // A needle, one seen on edge, or one met at its edge.
    if !((u + v + w).abs() > SLIM * (extent * extent)) || u == 0.0 || v == 0.0 || w == 0.0 {
        sides = exact_sides(a, b, c);
        // What has no area is no surface, though rounding may have given it some width here.
        if is_beside(sides) || !has_area(corners.map(|corner| *corner)) {
            return None;
        }
    }
    let [u, v, w] = sides;
    let sum = u + v + w;
    // Three quotients and not one reciprocal: that of a tiny sum would leave the range.
    let shares = [u / sum, v / sum, w / sum];
    let [a, b, c] = corners.map(|corner| ray.axis.to_third(*corner - ray.origin).z);
    let t = (shares[0] * a + shares[1] * b + shares[2] * c) * ray.third;
    Some(Contact { t, shares })
}

/// Whether two edges have the ray on different sides.
#[inline(always)]
fn is_beside([u, v, w]: [Real; 3]) -> bool {
    least(u, least(v, w)) < 0.0 && greatest(u, greatest(v, w)) > 0.0
}

/// The edge functions where they are small differences of large products, which are found with
/// the errors of these.
#[cold]
#[inline(never)]
fn exact_sides(a: [Real; 2], b: [Real; 2], c: [Real; 2]) -> [Real; 3] {
    [
        difference_of_products(c[0], b[1], c[1], b[0]),
        difference_of_products(a[0], c[1], a[1], c[0]),
        difference_of_products(b[0], a[1], b[1], a[0]),
    ]
}

/// How far off `point` the round surface is that is meant.
pub(super) fn lift(corners: [&Vec3; 3], normals: [Vec3; 3], point: Vec3, outside: bool) -> Vec3 {
    let seen = corners.map(|corner| *corner - point);
    let [a, b, c] = seen;
    let upright = (b - a).cross(c - a);
    let all = upright.dot(upright);
    // Each corner counts as much as the area opposite it.
    let shares = [b.cross(c), c.cross(a), a.cross(b)].map(|area| area.dot(upright) / all);
    let share = |sum: Vec3, ((corner, normal), share)| sum + above(corner, normal, outside) * share;
    seen.into_iter().zip(normals).zip(shares).fold(Vec3::ZERO, share)
}

pub(super) fn surface(corners: [&Vec3; 3], normals: Option<[Vec3; 3]>, ray: &Ray) -> Option<Surface> {
    let contact = hit(corners, ray)?;
    let corners = corners.map(|corner| *corner);
    let mix = |v: [Vec3; 3]| v[0] * contact.shares[0] + v[1] * contact.shares[1] + v[2] * contact.shares[2];
    let flat = unit(area(corners))?;
    let point = mix(corners);
    // The shares of the corners add up to one within three roundings, and each product and
    // sum adds one; twice that for the test that starts here. What that test rounds besides
    // follows the distance of the corners, also where their coordinates are small, and so does
    // what a place that is left there loses.
    let away = corners.iter().fold(0.0, |away, corner| greatest(away, largest(*corner - point)));
    let error = mix(corners.map(abs)) * gamma(16 + LEAVING) + Vec3::splat(away) * gamma(10 + LEAVING);
    let shading = normals.and_then(|normals| unit(mix(normals))).unwrap_or(flat);
    Some(Surface { point, error, normal: flat, shading })
}
