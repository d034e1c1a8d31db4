//! Triangle, flat or smooth: watertight intersection.
//!
//! The vertices are transformed into a frame in which the ray starts at the origin and runs along the z
//! axis. The signs of three two-dimensional edge functions then decide whether it hits. Two triangles with
//! a common edge evaluate the same function of the same numbers, so no ray passes between them.
//!
//! Source: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2013.
//!
//! Differences:
//!
//! * The rows of the shear matrix are permuted once per ray, not the axes of each vertex.
//! * Edge functions are computed again, with the errors of their products instead of a wider type, not only
//!   if one rounds to zero but also if much of the products cancels. So `t` and the barycentric coordinates
//!   of a sliver are as accurate as those of any other triangle. Only hits pay for this.

use super::{Aabb, Ray, SurfaceInteraction, plane::tangent_plane_offset, ray::OFFSET_ROUNDINGS};
use crate::math::{
    ROUNDOFF, Real, Vec3, abs, difference_error, difference_of_products, gamma, max, max_abs_component, min,
    try_normalize, vec3,
};

/// Intersection of a ray with a triangle.
pub(super) struct TriangleHit {
    pub(super) t: Real,
    /// Barycentric coordinates of the hit point.
    barycentric: [Real; 3],
}

pub(super) fn bounds(vertices: [&Vec3; 3]) -> Aabb {
    Aabb::enclosing(vertices.map(|vertex| *vertex))
}

/// Ratio of an area to the product of the lengths that it is computed from, below which the rounding
/// errors of the products matter.
const SLIVER_RATIO: Real = 1.0 / 8.0;

/// `(b - a) x (c - a)`, whose length is twice the area, with a relative error of some roundoffs. Zero if it
/// cannot be distinguished from zero.
///
/// It does not overflow if coordinates are at most [`MAX_COORDINATE`](crate::math::MAX_COORDINATE).
fn area([a, b, c]: [Vec3; 3]) -> Vec3 {
    let (e, f) = (b - a, c - a);
    let (rounded, square) = (e.cross(f), max_abs_component(e) * max_abs_component(f));
    if max_abs_component(rounded) > SLIVER_RATIO * square {
        return rounded;
    }
    // A sliver: rounding errors of the products and of the edges would rotate the normal.
    let (de, df) = (difference_error(b, a, e), difference_error(c, a, f));
    let exact = vec3(
        difference_of_products(e.y, f.z, e.z, f.y),
        difference_of_products(e.z, f.x, e.x, f.z),
        difference_of_products(e.x, f.y, e.y, f.x),
    );
    let area = exact + (e.cross(df) - f.cross(de));
    if max_abs_component(area) > MIN_RELATIVE_AREA * square { area } else { Vec3::ZERO }
}

/// Whether the triangle with the given vertices has an area that is distinguishable from zero. A triangle
/// without area is never hit.
pub fn has_area(vertices: [Vec3; 3]) -> bool {
    area(vertices) != Vec3::ZERO
}

/// Relative error of the exact cross product of two edges: a smaller area counts as zero.
const MIN_RELATIVE_AREA: Real = 16.0 * ROUNDOFF * ROUNDOFF;

/// The intersection of the ray with the triangle, which contains its edges and vertices.
#[inline]
pub(super) fn intersect([a, b, c]: [&Vec3; 3], ray: &Ray) -> Option<TriangleHit> {
    let [pa, pb, pc] = [a, b, c].map(|vertex| to_ray_space(*vertex, ray));
    let edges = edge_functions(pa, pb, pc);
    if is_outside(edges) { None } else { complete_hit([a, b, c], [pa, pb, pc], edges, ray) }
}

/// The coordinates of a vertex perpendicular to the ray, in the frame in which the ray is the z axis.
#[inline(always)]
fn to_ray_space(vertex: Vec3, ray: &Ray) -> [Real; 2] {
    let p = vertex - ray.origin;
    [p.dot(ray.shear_x), p.dot(ray.shear_y)]
}

/// The edge functions: the sign of each says on which side of an edge the ray passes. Rounding may turn a
/// value into zero, but never changes its sign.
#[inline(always)]
fn edge_functions(a: [Real; 2], b: [Real; 2], c: [Real; 2]) -> [Real; 3] {
    [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]]
}

/// Computes `t` and the barycentric coordinates of a probable hit, or rejects it.
///
/// Not inlined because most rays miss most triangles and need no registers for these numbers.
#[inline(never)]
fn complete_hit(
    vertices: [&Vec3; 3],
    [a, b, c]: [[Real; 2]; 3],
    mut edges: [Real; 3],
    ray: &Ray,
) -> Option<TriangleHit> {
    let [u, v, w] = edges;
    let extent = |[x, y]: [Real; 2]| max(x.abs(), y.abs());
    let extent = max(extent(a), max(extent(b), extent(c)));
    // A sliver, a triangle seen nearly edge-on, or a hit on an edge.
    if !((u + v + w).abs() > SLIVER_RATIO * (extent * extent)) || u == 0.0 || v == 0.0 || w == 0.0 {
        edges = exact_edge_functions(a, b, c);
        // Rounding of the projection can give a width to a triangle without area.
        if is_outside(edges) || !has_area(vertices.map(|vertex| *vertex)) {
            return None;
        }
    }
    let [u, v, w] = edges;
    let sum = u + v + w;
    // Quotients, because the reciprocal of a tiny sum would overflow.
    let barycentric = [u / sum, v / sum, w / sum];
    let [a, b, c] = vertices.map(|vertex| ray.dominant_axis.permute_to_z(*vertex - ray.origin).z);
    let t = (barycentric[0] * a + barycentric[1] * b + barycentric[2] * c) * ray.inverse_dominant;
    Some(TriangleHit { t, barycentric })
}

/// Whether the edge functions have different signs: the ray misses the triangle.
#[inline(always)]
fn is_outside([u, v, w]: [Real; 3]) -> bool {
    min(u, min(v, w)) < 0.0 && max(u, max(v, w)) > 0.0
}

/// The edge functions, computed with the rounding errors of their products.
#[cold]
#[inline(never)]
fn exact_edge_functions(a: [Real; 2], b: [Real; 2], c: [Real; 2]) -> [Real; 3] {
    [
        difference_of_products(c[0], b[1], c[1], b[0]),
        difference_of_products(a[0], c[1], a[1], c[0]),
        difference_of_products(b[0], a[1], b[1], a[0]),
    ]
}

/// [`Geometry::terminator_offset`](super::Geometry::terminator_offset) of a smooth triangle.
pub(super) fn terminator_offset(
    vertices: [&Vec3; 3],
    normals: [Vec3; 3],
    point: Vec3,
    front_face: bool,
) -> Vec3 {
    let relative = vertices.map(|vertex| *vertex - point);
    let [a, b, c] = relative;
    let area = (b - a).cross(c - a);
    let area_squared = area.dot(area);
    // The barycentric coordinate of a vertex is proportional to the area opposite to it.
    let barycentric = [b.cross(c), c.cross(a), a.cross(b)].map(|opposite| opposite.dot(area) / area_squared);
    let add = |sum: Vec3, ((vertex, normal), weight)| {
        sum + tangent_plane_offset(vertex, normal, front_face) * weight
    };
    relative.into_iter().zip(normals).zip(barycentric).fold(Vec3::ZERO, add)
}

pub(super) fn surface_interaction(
    vertices: [&Vec3; 3],
    normals: Option<[Vec3; 3]>,
    ray: &Ray,
) -> Option<SurfaceInteraction> {
    let [wa, wb, wc] = intersect(vertices, ray)?.barycentric;
    let vertices = vertices.map(|vertex| *vertex);
    let interpolate = |[a, b, c]: [Vec3; 3]| a * wa + b * wb + c * wc;
    let normal = try_normalize(area(vertices))?;
    let point = interpolate(vertices);
    // The barycentric coordinates add up to one within three roundings, and each product and sum adds one.
    // This is doubled for the test of the next ray. The other rounding errors of that test, and of the
    // offset of its origin, are relative to the distance of the vertices, even if coordinates are small.
    let max_distance =
        vertices.iter().fold(0.0, |distance, vertex| max(distance, max_abs_component(*vertex - point)));
    let error = interpolate(vertices.map(abs)) * gamma(16 + OFFSET_ROUNDINGS)
        + Vec3::splat(max_distance) * gamma(10 + OFFSET_ROUNDINGS);
    let shading = normals.and_then(|normals| try_normalize(interpolate(normals))).unwrap_or(normal);
    Some(SurfaceInteraction { point, point_error: error, normal, shading_normal: shading })
}
