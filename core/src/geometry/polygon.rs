//! Simple polygon with any number of vertices, convex or concave.
//!
//! Its plane passes through the centroid of the vertices; its normal is the normalized vector area (Newell's
//! method), so a vertex slightly off the plane does no harm. Whether a point of the plane is inside is
//! decided in two dimensions by the even-odd rule: the edges that cross the half-line from the point along
//! the first axis are counted. An edge contains its lower end but not its upper end, so a vertex on the
//! half-line counts once.
//!
//! Source: Haines, "Point in Polygon Strategies", Graphics Gems IV.

use super::clamp::clamp_to_box;
use super::plane::{plane_interaction, tangent_plane_offset};
use super::ranges::{validate_direction, validate_point};
use super::{Aabb, Ray, ShapeError, SurfaceInteraction};
use crate::math::{Axis, Real, Vec3, abs, gamma, length, try_normalize, vec3};

/// A flat polygon, hit from both sides. Its vertices are in the vertex table of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct Polygon {
    /// Index of the first vertex in the table.
    pub first_vertex: u32,
    /// Number of vertices, consecutive in the table; at least 3.
    pub vertex_count: u32,
    /// A point on the plane, near the vertices.
    pub point: Vec3,
    /// Unit normal, right-handed around the vertices.
    pub normal: Vec3,
    /// Bounds of the vertices ([`Aabb::from_points`]).
    pub bounds: Aabb,
    /// Whether the shading normal is interpolated between the vertex normals.
    pub smooth: bool,
}

impl Polygon {
    /// The polygon with the given vertices, which are in the vertex table from index `first` on.
    ///
    /// Its normal is right-handed around the vertices. `None` if there are fewer than three vertices, or if
    /// the area is zero.
    pub fn new(first: u32, vertices: &[Vec3], smooth: bool) -> Option<Self> {
        let (start, count) = (*vertices.first()?, u32::try_from(vertices.len()).ok()?);
        // Relative to the first vertex, so that errors do not depend on the position of the polygon.
        let relative = || vertices.iter().map(|vertex| *vertex - start);
        let size = relative().map(abs).fold(Vec3::ZERO, Vec3::max).max_element();
        let next = relative().skip(1).chain(relative().take(1));
        let area = relative().zip(next).fold(Vec3::ZERO, |sum, (a, b)| sum + (a / size).cross(b / size));
        let normal = try_normalize(area)?;
        // The area of three collinear vertices is almost exact; more vertices accumulate rounding errors.
        if length(area) <= gamma(4 * count.min(1 << 16)) && !(count == 3 && length(area) > gamma(2)) {
            return None;
        }
        let centroid = start + relative().fold(Vec3::ZERO, |sum, p| sum + p) / count as Real;
        Some(Polygon {
            first_vertex: first,
            vertex_count: count,
            point: centroid,
            normal,
            bounds: Aabb::from_points(vertices),
            smooth,
        })
    }

    pub(super) fn validate(&self, vertices: &[Vec3], normals: &[Vec3]) -> Result<(), ShapeError> {
        validate_point(self.point)?;
        validate_direction(self.normal)?;
        let own_vertices = self.slice_of(vertices).ok_or(ShapeError::IndexOutOfRange)?;
        if self.vertex_count < 3 || self.smooth && self.slice_of(normals).is_none() {
            return Err(ShapeError::IndexOutOfRange);
        }
        if self.bounds == Aabb::from_points(own_vertices) { Ok(()) } else { Err(ShapeError::Bounds) }
    }

    /// The entries of this polygon in a table of all vertices or vertex normals.
    fn slice_of<'t>(&self, table: &'t [Vec3]) -> Option<&'t [Vec3]> {
        let first = self.first_vertex as usize;
        table.get(first..first.checked_add(self.vertex_count as usize)?)
    }

    /// The `t` of the hit, clamped to the bounds as in [`Geometry::intersect`](super::Geometry::intersect).
    #[inline(always)]
    pub(super) fn intersect(&self, vertices: &[Vec3], ray: &Ray) -> Option<Real> {
        let t = (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        // `is_inside` rejects an infinite `t`: all projections are then infinite with one sign, or NaN.
        if !(t > 0.0) {
            return None;
        }
        let (o, d) = (ray.origin, ray.direction);
        self.intersect_at(vertices, t, o.x, o.y, o.z, d.x, d.y, d.z)
    }

    /// As `hit`, for a ray that intersects the plane at `t`.
    ///
    /// Not inlined because most rays miss the plane or intersect it behind their origin.
    #[inline(never)]
    #[allow(clippy::too_many_arguments)] // passed in registers
    fn intersect_at(
        &self,
        vertices: &[Vec3],
        t: Real,
        ox: Real,
        oy: Real,
        oz: Real,
        dx: Real,
        dy: Real,
        dz: Real,
    ) -> Option<Real> {
        let (o, d) = (vec3(ox, oy, oz), vec3(dx, dy, dz));
        let displacement = d * t;
        let vertices = self.slice_of(vertices)?;
        // Project along the dominant axis of the normal.
        let inside = match Axis::dominant(self.normal) {
            Axis::X => {
                self.is_inside(vertices, |p| (p.y - o.y) - displacement.y, |p| (p.z - o.z) - displacement.z)
            }
            Axis::Y => {
                self.is_inside(vertices, |p| (p.z - o.z) - displacement.z, |p| (p.x - o.x) - displacement.x)
            }
            Axis::Z => {
                self.is_inside(vertices, |p| (p.x - o.x) - displacement.x, |p| (p.y - o.y) - displacement.y)
            }
        };
        if inside { clamp_to_box(self.bounds, t, o, 1.0 / d) } else { None }
    }

    /// Whether the origin of a two-dimensional frame is inside the polygon. `x` and `y` project a point
    /// into that frame.
    #[inline(always)]
    fn is_inside(&self, vertices: &[Vec3], x: impl Fn(&Vec3) -> Real, y: impl Fn(&Vec3) -> Real) -> bool {
        // Early out if the origin is outside the bounds. The projection is monotone, so all vertices are
        // then on one side of it.
        let Aabb { min, max } = &self.bounds;
        if x(min) > 0.0 || x(max) < 0.0 || y(min) > 0.0 || y(max) <= 0.0 {
            return false;
        }
        let Some(mut last) = vertices.last() else { return false };
        let (mut inside, mut rest) = (false, vertices);
        if vertices.len() >= CHUNK_SIZE {
            let (chunks, remainder) = vertices.as_chunks();
            (inside, last) = crossing_parity(chunks, last, &x, &y);
            rest = remainder;
        }
        let (mut a, mut a_y) = (last, y(last));
        let mut a_is_above = a_y > 0.0;
        for b in rest {
            let b_y = y(b);
            let b_is_above = b_y > 0.0;
            if a_is_above != b_is_above && is_right_of_origin([x(a), a_y], [x(b), b_y]) {
                inside = !inside;
            }
            (a, a_y, a_is_above) = (b, b_y, b_is_above);
        }
        inside
    }

    /// [`Geometry::terminator_offset`](super::Geometry::terminator_offset) of a polygon; `None` if it is not
    /// smooth.
    pub(super) fn terminator_offset(
        &self,
        vertices: &[Vec3],
        normals: &[Vec3],
        point: Vec3,
        front_face: bool,
    ) -> Option<Vec3> {
        if !self.smooth {
            return None;
        }
        let (vertices, normals) = (self.slice_of(vertices)?, self.slice_of(normals)?);
        let value = |vertex, normal| tangent_plane_offset(vertex, normal, front_face);
        let (sum, weight) = mean_value_interpolate(point, self.normal, vertices, normals, value)?;
        Some(sum / weight)
    }

    /// Inlined, with the interpolation outside, so that a tracer of smooth shapes takes no longer for flat polygons.
    #[inline(always)]
    pub(super) fn surface_interaction(
        &self,
        vertices: &[Vec3],
        normals: Option<&[Vec3]>,
        ray: &Ray,
        t: Real,
    ) -> SurfaceInteraction {
        let mut surface = plane_interaction(ray, t, self.point, self.normal);
        // Vertices, and with them the bounds, may be some roundings off the plane.
        surface.point_error += abs(self.point) * gamma(4);
        if self.smooth
            && let Some(normals) = normals
            && let Some(shading) = self.interpolate_normal(vertices, normals, surface.point)
        {
            surface.shading_normal = shading;
        }
        surface
    }

    /// The unit normal that the vertex normals give at `point`; `None` where they cancel.
    #[inline(never)]
    fn interpolate_normal(&self, vertices: &[Vec3], normals: &[Vec3], point: Vec3) -> Option<Vec3> {
        let (vertices, normals) = (self.slice_of(vertices)?, self.slice_of(normals)?);
        let (sum, _) = mean_value_interpolate(point, self.normal, vertices, normals, |_, normal| normal)?;
        try_normalize(sum)
    }
}

/// Whether the edge from `a` to `b`, whose ends are on different sides of the x axis, crosses the positive
/// x axis.
#[inline(always)]
fn is_right_of_origin(a: [Real; 2], b: [Real; 2]) -> bool {
    (a[0] * b[1] > a[1] * b[0]) == (b[1] > 0.0)
}

/// Number of vertices whose side is computed at once.
const CHUNK_SIZE: usize = 16;

/// Whether an odd number of the edges that end in the vertices of `chunks` crosses the positive x axis. The
/// first edge begins in `last`. Also returns the last vertex, in which the next edge begins.
///
/// In a polygon of many vertices few edges cross the x axis, and only these need both coordinates. The
/// sides of all vertices of a chunk become bits of one integer, without branches, so that compilers use
/// vector instructions.
#[inline(always)]
fn crossing_parity<'v>(
    chunks: &'v [[Vec3; CHUNK_SIZE]],
    mut last: &'v Vec3,
    x: impl Fn(&Vec3) -> Real,
    y: impl Fn(&Vec3) -> Real,
) -> (bool, &'v Vec3) {
    let mut is_odd = false;
    let mut last_is_above = u32::from(y(last) > 0.0);
    for chunk in chunks {
        // Bit 0 is the vertex before the chunk.
        let mut above = last_is_above;
        for (index, vertex) in chunk.iter().enumerate() {
            above |= u32::from(y(vertex) > 0.0) << (index + 1);
        }
        last_is_above = above >> CHUNK_SIZE;
        let mut changes = above ^ (above >> 1 | last_is_above << CHUNK_SIZE);
        while changes != 0 {
            let index = changes.trailing_zeros() as usize;
            let a = chunk.get(index.wrapping_sub(1)).unwrap_or(last);
            let crosses = |b| is_right_of_origin([x(a), y(a)], [x(b), y(b)]);
            is_odd ^= chunk.get(index).is_some_and(crosses);
            changes &= changes - 1;
        }
        let [.., end] = chunk;
        last = end;
    }
    (is_odd, last)
}

/// Interpolates a value of the vertices at the point `p` of the polygon: returns the weighted sum of the
/// values and the sum of the weights.
///
/// `value` maps a vertex, relative to `p`, and its normal to the value. The weights are mean value
/// coordinates, which are smooth inside every simple polygon and linear along its edges. They need the
/// tangent of half of the angle of each edge seen from `p`, which is `(|a||b| - a.b) / (a x b)`.
///
/// Source: Floater, "Mean Value Coordinates", Computer Aided Geometric Design 2003.
#[inline(always)]
fn mean_value_interpolate(
    p: Vec3,
    normal: Vec3,
    vertices: &[Vec3],
    normals: &[Vec3],
    value: impl Fn(Vec3, Vec3) -> Vec3,
) -> Option<(Vec3, Real)> {
    let relative = |(vertex, normal): (&Vec3, &Vec3)| (*vertex - p, value(*vertex - p, *normal));
    let entries = vertices.iter().zip(normals).map(relative);
    let (mut sum, mut weight) = (Vec3::ZERO, 0.0);
    let (mut a, mut value_a) = entries.clone().next_back()?;
    for (b, value_b) in entries {
        let (la, lb) = (length(a), length(b));
        if lb == 0.0 {
            return Some((value_b, 1.0)); // at the vertex
        }
        let (dot, cross) = (a.dot(b), a.cross(b).dot(normal));
        let tangent = (la * lb - dot) / cross;
        if la > 0.0 && tangent.abs() <= Real::MAX {
            sum += value_a * (tangent / la) + value_b * (tangent / lb);
            weight += tangent / la + tangent / lb;
        } else if dot < 0.0 {
            return Some((value_a * lb + value_b * la, la + lb)); // on the edge
        }
        (a, value_a) = (b, value_b);
    }
    Some((sum, weight))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The even-odd rule in exact integer arithmetic.
    fn contains(vertices: &[[i32; 2]], [x, y]: [i32; 2]) -> bool {
        let edges = vertices.iter().zip(vertices.iter().cycle().skip(1));
        let crossings = edges.filter(|([ax, ay], [bx, by])| {
            let is_counterclockwise = (ax - x) * (by - y) > (ay - y) * (bx - x);
            (*ay > y) != (*by > y) && is_counterclockwise == (*by > y)
        });
        crossings.count() % 2 == 1
    }

    #[test]
    fn point_in_polygon_agrees_with_integer_arithmetic() {
        let mut seed = 1_u32;
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 16) as i32 % 9
        };
        let mut hits = 0;
        for count in (3..=70).flat_map(|count| [count; 4]) {
            let flat: [[i32; 2]; 70] = core::array::from_fn(|_| [random(), random()]);
            let flat = &flat[..count];
            let vertices: [Vec3; 70] = core::array::from_fn(|index| {
                let [x, y] = flat[index % count];
                vec3(x as Real, y as Real, 0.0)
            });
            let Some(polygon) = Polygon::new(0, &vertices[..count], false) else { continue };
            for [x, y] in (0..81).map(|index| [index % 9, index / 9]) {
                let ray = Ray::new(vec3(x as Real, y as Real, 1.0), vec3(0.0, 0.0, -1.0));
                let hit = polygon.intersect(&vertices, &ray);
                assert_eq!(hit.is_some(), contains(flat, [x, y]), "{x}, {y} in {flat:?}");
                hits += u32::from(hit.is_some());
            }
        }
        assert!(hits > 5_000, "only {hits} hits");
    }
}
