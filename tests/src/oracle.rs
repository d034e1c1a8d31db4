//! An oracle for ray-shape intersection, in `f64` and by methods that differ from the core's.
//!
//! Solids and curved sides are intersected by sphere tracing: each step along the ray is as long as the
//! distance to the surface, so that no step passes it, and no quadratic or quartic equation is solved. Flat
//! shapes are intersected on their plane; the winding number of the border around the point decides what is
//! inside.
//!
//! Near a silhouette or an edge rounding decides, and hit and miss are both correct. A solid is intersected
//! three times: as it is, grown, and shrunk by the [`band`]. If the three results differ the answer is
//! [`OracleAnswer::Unclear`]. The answer of a flat shape is unclear if the border is within the band around
//! the hit point.
//!
//! Source: Hart, "Sphere Tracing", The Visual Computer 12, 1996.

use strahl_test_scene::vector::{area, perpendicular_axes, unit};
use strahl_test_scene::{DVec3, TestRay, TestShape, dvec3};

/// The oracle's answer for a ray and a shape.
#[derive(Clone, Copy, Debug)]
pub enum OracleAnswer {
    /// The ray misses the shape.
    Miss,
    /// The ray hits the shape.
    Hit(OracleHit),
    /// Rounding decides: hit and miss are both correct.
    Unclear,
}

/// A hit.
#[derive(Clone, Copy, Debug)]
pub struct OracleHit {
    /// Distance, in lengths of the ray's direction.
    pub t: f64,
    /// Distance, in scene lengths.
    pub distance: f64,
    /// Hit point.
    pub point: DVec3,
    /// Unit normal, oriented as the core's shapes document it.
    pub normal: DVec3,
    /// Absolute cosine of the angle between ray and normal.
    pub slope: f64,
    /// Smallest radius of curvature at the hit point.
    pub curvature: f64,
}

/// Error bound of the oracle: a distance may be off by this times [`size`] over the slope.
pub const PRECISION: f64 = 1e-13;

/// Unit roundoff of single precision.
const U: f64 = 1.0 / (1 << 24) as f64;

/// The largest difference that must be formed to intersect ray and shape.
pub fn size(shape: &TestShape, ray: &TestRay) -> f64 {
    let (center, radius) = shape.bounding_sphere();
    let farthest = length(ray.origin - center);
    match shape {
        // The normal is rounded; its error grows with the distance of the hit from the plane's point.
        TestShape::Plane { point, normal } => {
            let t = (*point - ray.origin).dot(*normal) / ray.direction.dot(*normal);
            farthest + length(ray.direction * t)
        }
        // Rounding moves the vertices off the plane.
        TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => {
            farthest + radius + vertices.iter().copied().map(length).fold(0.0, f64::max)
        }
        _ => farthest + radius,
    }
}

/// Distance from a silhouette or an edge below which hit and miss are both correct.
pub fn band(shape: &TestShape, ray: &TestRay) -> f64 {
    32.0 * U * size(shape, ray)
}

fn length(v: DVec3) -> f64 {
    v.dot(v).sqrt()
}

/// Intersects a ray with a shape.
pub fn intersect(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    // Around the origin, where `f64` is fine enough for small shapes. Differences of `f32` numbers are exact,
    // or nearly.
    let center = shape.bounding_sphere().0;
    let ray = TestRay { origin: ray.origin - center, ..*ray };
    match intersect_at_origin(&shape.mapped(|p| p - center, |d| d, 1.0), &ray) {
        OracleAnswer::Hit(contact) => {
            OracleAnswer::Hit(OracleHit { point: contact.point + center, ..contact })
        }
        other => other,
    }
}

fn intersect_at_origin(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    match shape {
        TestShape::Plane { .. }
        | TestShape::Disc { .. }
        | TestShape::Triangle { .. }
        | TestShape::SmoothTriangle { .. }
        | TestShape::Polygon { .. }
        | TestShape::SmoothPolygon { .. } => intersect_flat(shape, ray),
        _ => intersect_curved(shape, ray),
    }
}

/// Distance of a point from the surface: negative inside a solid; of a flat shape from its plane, of an open
/// cone from its side.
pub fn signed_distance(shape: &TestShape, p: DVec3) -> f64 {
    match shape {
        TestShape::Sphere { center, radius } => length(p - *center) - radius,
        TestShape::Cuboid { min, max } => box_distance(p - (*min + *max) * 0.5, (*max - *min) * 0.5),
        TestShape::OrientedCuboid { center, half, first, third } => {
            let z = unit(*third);
            let y = unit(z.cross(*first));
            let q = p - *center;
            box_distance(dvec3(q.dot(y.cross(z)), q.dot(y), q.dot(z)), *half)
        }
        TestShape::Cone { base, base_radius, end, end_radius, capped } => {
            let (q, height) = profile(*base, *end, p);
            let (first, second) = ((*base_radius, 0.0), (*end_radius, height));
            let side = to_segment(q, first, second);
            if !capped {
                return side;
            }
            let caps = to_segment(q, (0.0, 0.0), first).min(to_segment(q, (0.0, height), second));
            let level = base_radius + (end_radius - base_radius) * q.1 / height;
            let inside = q.1 > 0.0 && q.1 < height && q.0 < level;
            side.min(caps) * if inside { -1.0 } else { 1.0 }
        }
        TestShape::Torus { center, axis, major, minor } => {
            let (q, axis) = (p - *center, unit(*axis));
            let z = q.dot(axis);
            (length(q - axis * z) - major).hypot(z) - minor
        }
        flat => {
            let (point, normal) = plane_of(flat);
            (p - point).dot(normal).abs()
        }
    }
}

fn box_distance(p: DVec3, half: DVec3) -> f64 {
    let q = p.abs() - half;
    length(q.max(DVec3::ZERO)) + q.max_element().min(0.0)
}

/// Distance of a point from the axis, its coordinate along the axis, and the length of the axis.
fn profile(base: DVec3, end: DVec3, p: DVec3) -> ((f64, f64), f64) {
    let (q, height) = (p - base, length(end - base));
    let axis = (end - base) / height;
    let z = q.dot(axis);
    ((length(q - axis * z), z), height)
}

fn to_segment(p: (f64, f64), a: (f64, f64), b: (f64, f64)) -> f64 {
    let (edge, from) = ((b.0 - a.0, b.1 - a.1), (p.0 - a.0, p.1 - a.1));
    let square = edge.0 * edge.0 + edge.1 * edge.1;
    let s = if square > 0.0 { (from.0 * edge.0 + from.1 * edge.1) / square } else { 0.0 }.clamp(0.0, 1.0);
    (from.0 - edge.0 * s).hypot(from.1 - edge.1 * s)
}

/// The outward normal at the nearest point of a solid, or of the side of an open cone.
fn normal_at(shape: &TestShape, p: DVec3) -> DVec3 {
    let of_box = |q: DVec3, half: DVec3| {
        let outside = q.abs() - half;
        let along = |axis: DVec3| axis * q.dot(axis).signum();
        if outside.x >= outside.y && outside.x >= outside.z {
            along(DVec3::X)
        } else if outside.y >= outside.z {
            along(DVec3::Y)
        } else {
            along(DVec3::Z)
        }
    };
    match shape {
        TestShape::Sphere { center, .. } => unit(p - *center),
        TestShape::Cuboid { min, max } => of_box(p - (*min + *max) * 0.5, (*max - *min) * 0.5),
        TestShape::OrientedCuboid { center, half, first, third } => {
            let z = unit(*third);
            let y = unit(z.cross(*first));
            let (x, q) = (y.cross(z), p - *center);
            let own = of_box(dvec3(q.dot(x), q.dot(y), q.dot(z)), *half);
            x * own.x + y * own.y + z * own.z
        }
        TestShape::Cone { base, base_radius, end, end_radius, capped } => {
            let (q, height) = profile(*base, *end, p);
            let (first, second) = ((*base_radius, 0.0), (*end_radius, height));
            let axis = unit(*end - *base);
            let side = to_segment(q, first, second);
            let cap = if q.1 < 0.5 * height { -axis } else { axis };
            if *capped && to_segment(q, (0.0, 0.0), first).min(to_segment(q, (0.0, height), second)) < side {
                return cap;
            }
            let from = p - *base;
            let out = from - axis * from.dot(axis);
            unit(unit(out) - axis * ((end_radius - base_radius) / height))
        }
        TestShape::Torus { center, axis, major, .. } => {
            let (q, axis) = (p - *center, unit(*axis));
            unit(q - unit(q - axis * q.dot(axis)) * *major)
        }
        flat => plane_of(flat).1,
    }
}

/// Distance of a point on a solid from the solid's nearest edge.
fn edge_distance(shape: &TestShape, p: DVec3) -> f64 {
    let of_box = |q: DVec3, half: DVec3| {
        // On a face one of the three is zero; the smaller of the other two is the distance to the nearest
        // edge.
        let inside = half - q.abs();
        let (x, y, z) = (inside.x, inside.y, inside.z);
        (x.max(y)).min(y.max(z)).min(z.max(x))
    };
    match shape {
        TestShape::Cuboid { min, max } => of_box(p - (*min + *max) * 0.5, (*max - *min) * 0.5),
        TestShape::OrientedCuboid { center, half, first, third } => {
            let z = unit(*third);
            let y = unit(z.cross(*first));
            let q = p - *center;
            of_box(dvec3(q.dot(y.cross(z)), q.dot(y), q.dot(z)), *half)
        }
        TestShape::Cone { base, base_radius, end, end_radius, capped: true } => {
            let (q, height) = profile(*base, *end, p);
            let cap_edge = |radius: f64, level: f64| {
                if radius > 0.0 { (q.0 - radius).hypot(q.1 - level) } else { f64::INFINITY }
            };
            cap_edge(*base_radius, 0.0).min(cap_edge(*end_radius, height))
        }
        _ => f64::INFINITY,
    }
}

/// Smallest radius of curvature at a point; edges of solids are ignored.
fn curvature_at(shape: &TestShape, p: DVec3) -> f64 {
    match shape {
        TestShape::Sphere { radius, .. } => *radius,
        TestShape::Cone { base, end, .. } => profile(*base, *end, p).0.0,
        TestShape::Torus { major, minor, .. } => minor.min(major - minor),
        _ => f64::INFINITY,
    }
}

/// Result of marching along a ray.
#[derive(Clone, Copy, PartialEq)]
enum MarchEnd {
    At(f64),
    Miss,
    /// Too many steps without a hit or a miss.
    Lost,
}

fn march(
    field: impl Fn(DVec3) -> f64,
    origin: DVec3,
    direction: DVec3,
    shape: &TestShape,
    size: f64,
) -> MarchEnd {
    let (center, radius) = shape.bounding_sphere();
    let far = (center - origin).dot(direction) + 1.01 * radius + 1e-3 * size;
    let mut distance = 0.0;
    for _ in 0..20_000 {
        let step = field(origin + direction * distance).abs();
        distance += step;
        if step <= 0.1 * PRECISION * size {
            return MarchEnd::At(distance);
        }
        if distance > far {
            return MarchEnd::Miss;
        }
    }
    MarchEnd::Lost
}

fn intersect_curved(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    let speed = length(ray.direction);
    let (origin, direction) = (ray.origin, ray.direction / speed);
    let (size, band) = (size(shape, ray), band(shape, ray));
    if signed_distance(shape, origin).abs() <= 2.0 * band {
        return OracleAnswer::Unclear;
    }
    let is_shell = matches!(shape, TestShape::Cone { capped: false, .. });
    let end = |by: f64| march(|p| signed_distance(shape, p) - by, origin, direction, shape, size);
    let ends = (end(band), end(0.0), if is_shell { end(0.0) } else { end(-band) });
    let (grown, distance, shrunk) = match ends {
        (MarchEnd::Miss, MarchEnd::Miss, MarchEnd::Miss) => return OracleAnswer::Miss,
        (MarchEnd::At(grown), MarchEnd::At(distance), MarchEnd::At(shrunk)) => (grown, distance, shrunk),
        _ => return OracleAnswer::Unclear,
    };

    let point = origin + direction * distance;
    let normal = normal_at(shape, point);
    let slope = normal.dot(direction).abs();
    // On a flat surface the three hits are a band over the slope apart.
    let apart = band / slope;
    let bent = |other: f64| normal_at(shape, origin + direction * other).dot(normal) < 0.5;
    if (shrunk - distance).abs() > 4.0 * apart
        || (grown - distance).abs() > 4.0 * apart
        || bent(grown)
        || bent(shrunk)
    {
        return OracleAnswer::Unclear;
    }
    // Near an edge the ray may hit either side of it.
    if edge_distance(shape, point) <= 2.0 * apart {
        return OracleAnswer::Unclear;
    }
    // A shell cannot shrink: the ray must cross it, and not near its edge.
    if let TestShape::Cone { base, end, capped: false, .. } = shape {
        let (q, height) = profile(*base, *end, point);
        let behind = signed_distance(shape, origin + direction * (distance + 4.0 * apart));
        if behind < 2.0 * band || q.1 < 8.0 * apart || height - q.1 < 8.0 * apart {
            return OracleAnswer::Unclear;
        }
    }
    let curvature = curvature_at(shape, point);
    OracleAnswer::Hit(OracleHit { t: distance / speed, distance, point, normal, slope, curvature })
}

/// A point of the plane of a flat shape, and the plane's normal.
fn plane_of(shape: &TestShape) -> (DVec3, DVec3) {
    match shape {
        TestShape::Plane { point, normal } => (*point, unit(*normal)),
        TestShape::Disc { center, normal, .. } => (*center, unit(*normal)),
        _ => {
            let vertices = vertices(shape);
            (vertices.iter().sum::<DVec3>() / vertices.len() as f64, unit(area(vertices)))
        }
    }
}

fn vertices(shape: &TestShape) -> &[DVec3] {
    match shape {
        TestShape::Triangle { vertices } | TestShape::SmoothTriangle { vertices, .. } => vertices,
        TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => vertices,
        _ => &[],
    }
}

fn intersect_flat(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    let speed = length(ray.direction);
    let (origin, direction) = (ray.origin, ray.direction / speed);
    let (point, normal) = plane_of(shape);
    let (height, slope) = ((origin - point).dot(normal), normal.dot(direction));
    let band = band(shape, ray);
    if slope.abs() < 1e-6 || height.abs() <= band {
        return OracleAnswer::Unclear;
    }
    let distance = -height / slope;
    if distance < 0.0 {
        return OracleAnswer::Miss;
    }
    let point_on_plane = origin + direction * distance;
    let (is_inside, border) = match shape {
        TestShape::Plane { .. } => (true, f64::INFINITY),
        TestShape::Disc { center, radius, .. } => {
            let from_center = length(point_on_plane - *center);
            (from_center < *radius, (from_center - radius).abs())
        }
        _ => inside(vertices(shape), point_on_plane, normal),
    };
    let slope = slope.abs();
    if border <= band / slope {
        OracleAnswer::Unclear
    } else if is_inside {
        OracleAnswer::Hit(OracleHit {
            t: distance / speed,
            distance,
            point: point_on_plane,
            normal,
            slope,
            curvature: f64::INFINITY,
        })
    } else {
        OracleAnswer::Miss
    }
}

/// The edges: each vertex with the next.
fn edges(vertices: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
    vertices.iter().copied().zip(vertices.iter().copied().cycle().skip(1))
}

/// Whether a point of the plane is inside, by the winding number of the border, and its distance from the
/// border.
fn inside(vertices: &[DVec3], p: DVec3, normal: DVec3) -> (bool, f64) {
    let (x, y) = perpendicular_axes(normal);
    let flat = |vertex: DVec3| ((vertex - p).dot(x), (vertex - p).dot(y));
    let (mut turn, mut border) = (0.0_f64, f64::INFINITY);
    for (a, b) in edges(vertices) {
        let (a, b) = (flat(a), flat(b));
        turn += angle(a, b);
        border = border.min(to_segment((0.0, 0.0), a, b));
    }
    (turn.abs() > std::f64::consts::PI, border)
}

/// Angle from one direction to another, positive counterclockwise.
fn angle(a: (f64, f64), b: (f64, f64)) -> f64 {
    (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1)
}

/// The shading normal of a smooth shape at a point of its plane, and the distance of the nearest vertex.
/// `None` for other shapes.
///
/// The weights of the vertex normals are barycentric coordinates for a triangle, and mean value coordinates
/// for a polygon.
///
/// Source: Floater, "Mean Value Coordinates", Computer Aided Geometric Design 20, 2003.
pub fn shading(shape: &TestShape, p: DVec3) -> Option<(DVec3, f64)> {
    let (vertices, normals) = match shape {
        TestShape::SmoothTriangle { vertices, normals } => (&vertices[..], &normals[..]),
        TestShape::SmoothPolygon { vertices, normals } => (&vertices[..], &normals[..]),
        _ => return None,
    };
    let (_, upward) = plane_of(shape);
    let nearest = vertices.iter().map(|vertex| length(*vertex - p)).fold(f64::INFINITY, f64::min);
    let weight = |i: usize| {
        let (before, here, after) = (
            vertices[(i + vertices.len() - 1) % vertices.len()],
            vertices[i],
            vertices[(i + 1) % vertices.len()],
        );
        if let TestShape::SmoothTriangle { .. } = shape {
            return (after - p).cross(before - p).dot(upward);
        }
        let (x, y) = perpendicular_axes(upward);
        let flat = |vertex: DVec3| ((vertex - p).dot(x), (vertex - p).dot(y));
        let half = |a: DVec3, b: DVec3| (0.5 * angle(flat(a), flat(b))).tan();
        (half(before, here) + half(here, after)) / length(here - p)
    };
    Some((unit(normals.iter().enumerate().map(|(i, normal)| unit(*normal) * weight(i)).sum()), nearest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ray(origin: DVec3, direction: DVec3) -> TestRay {
        TestRay { origin, direction }
    }

    fn distance(shape: &TestShape, ray: &TestRay) -> Option<f64> {
        match intersect(shape, ray) {
            OracleAnswer::Hit(contact) => Some(contact.distance),
            OracleAnswer::Miss => None,
            OracleAnswer::Unclear => panic!("unclear"),
        }
    }

    #[test]
    fn the_oracle_agrees_with_results_known_on_paper() {
        let close = |got: Option<f64>, want: f64| (got.unwrap() - want).abs() <= 1e-12;
        let along_x = ray(dvec3(-5.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0));
        let ball = TestShape::Sphere { center: DVec3::ZERO, radius: 1.5 };
        assert!(close(distance(&ball, &along_x), 3.5));
        assert!(close(distance(&ball, &ray(dvec3(0.5, 0.0, 0.0), DVec3::X)), 1.0));
        let ring = TestShape::Torus { center: DVec3::ZERO, axis: DVec3::Z, major: 2.0, minor: 0.5 };
        assert!(close(distance(&ring, &along_x), 2.5));
        assert!(close(distance(&ring, &ray(dvec3(-1.0, 0.0, 0.0), DVec3::X)), 2.5));
        assert_eq!(distance(&ring, &ray(dvec3(0.0, 0.0, 3.0), -DVec3::Z)), None);
        let cone = |capped| TestShape::Cone {
            base: DVec3::ZERO,
            base_radius: 2.0,
            end: dvec3(0.0, 0.0, 2.0),
            end_radius: 0.0,
            capped,
        };
        let up = ray(dvec3(1.0, 0.0, -1.0), DVec3::Z);
        assert!(close(distance(&cone(true), &up), 1.0) && close(distance(&cone(false), &up), 2.0));
        let tilted = ray(dvec3(2.0, 1.5, 0.5), dvec3(-1.0, -1.0, 0.0));
        let cube = TestShape::Cuboid { min: dvec3(-1.0, 0.0, 0.0), max: DVec3::ONE };
        assert!(close(distance(&cube, &tilted), 2.0_f64.sqrt()));
    }

    #[test]
    fn a_point_in_a_concave_corner_is_outside() {
        let vertices =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 1.0), (0.0, 3.0)].map(|(x, y)| dvec3(x, y, 0.0));
        assert_eq!(inside(&vertices, dvec3(2.0, 0.5, 0.0), DVec3::Z), (true, 0.5));
        assert!(!inside(&vertices, dvec3(2.0, 2.0, 0.0), DVec3::Z).0);
    }
}
