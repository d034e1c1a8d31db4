//! Where a ray meets a thing, found in other ways than the core's.
//!
//! Solids and round sides are met by going along the ray, each time as far as the surface is
//! away ("Sphere tracing", Hart 1996): no step can pass it, and no quadratic or quartic is
//! solved. Flat things are met on their plane, and what is inside is told by the angle under
//! which the border is seen. All in `f64`.
//!
//! Near a silhouette, an edge or a rim rounding decides, and either answer is right. A solid is
//! asked three times, as it is and grown and shrunk by the [`band`]; where the three do not
//! agree the truth is [`OracleAnswer::Unclear`]. A flat thing is unclear where the border is within
//! the band of the point that is met.

use crate::test_shape::{TestRay, TestShape};
use crate::vector::{DVec3, area, dvec3, perpendicular_axes, unit};

/// What is true of a ray and a thing.
#[derive(Clone, Copy, Debug)]
pub enum OracleAnswer {
    /// It is not met.
    Miss,
    /// It is met here.
    Hit(OracleHit),
    /// Rounding may decide.
    Unclear,
}

/// Where a ray meets a thing.
#[derive(Clone, Copy, Debug)]
pub struct OracleHit {
    /// How far, in lengths of the ray's direction.
    pub t: f64,
    /// How far, in scene lengths.
    pub way: f64,
    /// The point.
    pub point: DVec3,
    /// The normal, as the core's shapes promise it.
    pub normal: DVec3,
    /// The cosine between ray and normal, without its sign.
    pub slope: f64,
    /// The smallest radius of curvature there.
    pub curvature: f64,
}

/// How good the answers are: a way may be off by this times [`size`] over the slope.
pub const PRECISION: f64 = 1e-13;

/// The unit roundoff of single precision.
const U: f64 = 1.0 / (1 << 24) as f64;

/// The largest difference that must be formed to intersect the two.
pub fn size(shape: &TestShape, ray: &TestRay) -> f64 {
    let (center, radius) = shape.ball();
    let reach = length(ray.origin - center);
    match shape {
        // Its normal is rounded, and counts as far from its point as the ray meets it.
        TestShape::Plane { point, normal } => {
            let t = (*point - ray.origin).dot(*normal) / ray.direction.dot(*normal);
            reach + length(ray.direction * t)
        }
        // Its corners lie off its plane by their own rounding.
        TestShape::Polygon { corners } | TestShape::SmoothPolygon { corners, .. } => {
            reach + radius + corners.iter().copied().map(length).fold(0.0, f64::max)
        }
        _ => reach + radius,
    }
}

/// How near to a silhouette, an edge or a rim a ray may pass before either answer is right.
pub fn band(shape: &TestShape, ray: &TestRay) -> f64 {
    32.0 * U * size(shape, ray)
}

fn length(v: DVec3) -> f64 {
    v.dot(v).sqrt()
}

/// The truth.
pub fn intersect(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    // Both round the origin, where the numbers of the oracle are fine enough for what is small.
    // Differences of numbers that single precision holds are exact, or nearly.
    let center = shape.ball().0;
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

/// How far a point is from the surface: of a flat thing from its plane, of a solid below zero
/// inside, of an open cone from its side.
pub fn distance(shape: &TestShape, p: DVec3) -> f64 {
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
            let (point, normal) = level(flat);
            (p - point).dot(normal).abs()
        }
    }
}

fn box_distance(p: DVec3, half: DVec3) -> f64 {
    let q = p.abs() - half;
    length(q.max(DVec3::ZERO)) + q.max_element().min(0.0)
}

/// How far a point is from the axis and how far along it, and the length of the axis.
fn profile(base: DVec3, end: DVec3, p: DVec3) -> ((f64, f64), f64) {
    let (q, height) = (p - base, length(end - base));
    let axis = (end - base) / height;
    let z = q.dot(axis);
    ((length(q - axis * z), z), height)
}

fn to_segment(p: (f64, f64), a: (f64, f64), b: (f64, f64)) -> f64 {
    let (way, from) = ((b.0 - a.0, b.1 - a.1), (p.0 - a.0, p.1 - a.1));
    let square = way.0 * way.0 + way.1 * way.1;
    let s = if square > 0.0 { (from.0 * way.0 + from.1 * way.1) / square } else { 0.0 }.clamp(0.0, 1.0);
    (from.0 - way.0 * s).hypot(from.1 - way.1 * s)
}

/// The outward normal at a point of a solid, or of the side of an open cone: that of the part
/// which is nearest.
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
        flat => level(flat).1,
    }
}

/// How far a point of a solid is from its edges or rims.
fn edge_distance(shape: &TestShape, p: DVec3) -> f64 {
    let of_box = |q: DVec3, half: DVec3| {
        // On a face one of the three is zero; the larger of the others is the nearest edge.
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
            let rim = |radius: f64, level: f64| {
                if radius > 0.0 { (q.0 - radius).hypot(q.1 - level) } else { f64::INFINITY }
            };
            rim(*base_radius, 0.0).min(rim(*end_radius, height))
        }
        _ => f64::INFINITY,
    }
}

/// The smallest radius of curvature at a point; the edges of solids are nobody's business here.
fn curvature_at(shape: &TestShape, p: DVec3) -> f64 {
    match shape {
        TestShape::Sphere { radius, .. } => *radius,
        TestShape::Cone { base, end, .. } => profile(*base, *end, p).0.0,
        TestShape::Torus { major, minor, .. } => minor.min(major - minor),
        _ => f64::INFINITY,
    }
}

/// How a walk along a ray ends.
#[derive(Clone, Copy, PartialEq)]
enum MarchEnd {
    At(f64),
    Nowhere,
    /// It has come too near too often without meeting anything.
    Lost,
}

fn march(
    field: impl Fn(DVec3) -> f64,
    origin: DVec3,
    direction: DVec3,
    shape: &TestShape,
    size: f64,
) -> MarchEnd {
    let (center, radius) = shape.ball();
    let far = (center - origin).dot(direction) + 1.01 * radius + 1e-3 * size;
    let mut way = 0.0;
    for _ in 0..20_000 {
        let step = field(origin + direction * way).abs();
        way += step;
        if step <= 0.1 * PRECISION * size {
            return MarchEnd::At(way);
        }
        if way > far {
            return MarchEnd::Nowhere;
        }
    }
    MarchEnd::Lost
}

fn intersect_curved(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    let speed = length(ray.direction);
    let (origin, direction) = (ray.origin, ray.direction / speed);
    let (size, band) = (size(shape, ray), band(shape, ray));
    if distance(shape, origin).abs() <= 2.0 * band {
        return OracleAnswer::Unclear;
    }
    let is_shell = matches!(shape, TestShape::Cone { capped: false, .. });
    let met = |by: f64| march(|p| distance(shape, p) - by, origin, direction, shape, size);
    let ends = (met(band), met(0.0), if is_shell { met(0.0) } else { met(-band) });
    let (grown, way, shrunk) = match ends {
        (MarchEnd::Nowhere, MarchEnd::Nowhere, MarchEnd::Nowhere) => return OracleAnswer::Miss,
        (MarchEnd::At(grown), MarchEnd::At(way), MarchEnd::At(shrunk)) => (grown, way, shrunk),
        _ => return OracleAnswer::Unclear,
    };

    let point = origin + direction * way;
    let normal = normal_at(shape, point);
    let slope = normal.dot(direction).abs();
    // Straight on, the three lie a band over the slope apart.
    let apart = band / slope;
    let bent = |other: f64| normal_at(shape, origin + direction * other).dot(normal) < 0.5;
    if (shrunk - way).abs() > 4.0 * apart || (grown - way).abs() > 4.0 * apart || bent(grown) || bent(shrunk)
    {
        return OracleAnswer::Unclear;
    }
    // Near an edge or a rim the ray may come in on either side of it.
    if edge_distance(shape, point) <= 2.0 * apart {
        return OracleAnswer::Unclear;
    }
    // A shell cannot shrink: the ray must go through it, and not through its rim.
    if let TestShape::Cone { base, end, capped: false, .. } = shape {
        let (q, height) = profile(*base, *end, point);
        let behind = distance(shape, origin + direction * (way + 4.0 * apart));
        if behind < 2.0 * band || q.1 < 8.0 * apart || height - q.1 < 8.0 * apart {
            return OracleAnswer::Unclear;
        }
    }
    let curvature = curvature_at(shape, point);
    OracleAnswer::Hit(OracleHit { t: way / speed, way, point, normal, slope, curvature })
}

/// A point of the plane of a flat thing, and the plane's normal.
fn level(shape: &TestShape) -> (DVec3, DVec3) {
    match shape {
        TestShape::Plane { point, normal } => (*point, unit(*normal)),
        TestShape::Disc { center, normal, .. } => (*center, unit(*normal)),
        _ => {
            let corners = corners(shape);
            (corners.iter().sum::<DVec3>() / corners.len() as f64, unit(area(corners)))
        }
    }
}

fn corners(shape: &TestShape) -> &[DVec3] {
    match shape {
        TestShape::Triangle { corners } | TestShape::SmoothTriangle { corners, .. } => corners,
        TestShape::Polygon { corners } | TestShape::SmoothPolygon { corners, .. } => corners,
        _ => &[],
    }
}

fn intersect_flat(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    let speed = length(ray.direction);
    let (origin, direction) = (ray.origin, ray.direction / speed);
    let (point, normal) = level(shape);
    let (height, slope) = ((origin - point).dot(normal), normal.dot(direction));
    let band = band(shape, ray);
    if slope.abs() < 1e-6 || height.abs() <= band {
        return OracleAnswer::Unclear;
    }
    let way = -height / slope;
    if way < 0.0 {
        return OracleAnswer::Miss;
    }
    let met = origin + direction * way;
    let (is_inside, border) = match shape {
        TestShape::Plane { .. } => (true, f64::INFINITY),
        TestShape::Disc { center, radius, .. } => {
            let from_middle = length(met - *center);
            (from_middle < *radius, (from_middle - radius).abs())
        }
        _ => inside(corners(shape), met, normal),
    };
    let slope = slope.abs();
    if border <= band / slope {
        OracleAnswer::Unclear
    } else if is_inside {
        OracleAnswer::Hit(OracleHit {
            t: way / speed,
            way,
            point: met,
            normal,
            slope,
            curvature: f64::INFINITY,
        })
    } else {
        OracleAnswer::Miss
    }
}

/// The corners one after the other, each with the next.
fn edges(corners: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// Whether a point of the plane is inside, by the angle under which it sees the border, and how
/// far the border is.
fn inside(corners: &[DVec3], p: DVec3, normal: DVec3) -> (bool, f64) {
    let (x, y) = perpendicular_axes(normal);
    let flat = |corner: DVec3| ((corner - p).dot(x), (corner - p).dot(y));
    let (mut turn, mut border) = (0.0_f64, f64::INFINITY);
    for (a, b) in edges(corners) {
        let (a, b) = (flat(a), flat(b));
        turn += angle(a, b);
        border = border.min(to_segment((0.0, 0.0), a, b));
    }
    (turn.abs() > std::f64::consts::PI, border)
}

/// From one direction to another, more than zero to the left.
fn angle(a: (f64, f64), b: (f64, f64)) -> f64 {
    (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1)
}

/// The shading normal of a smooth thing at a point of its plane, and how far the nearest corner
/// is; none for other things.
///
/// For a triangle the shares of the corners are the areas opposite them, for a polygon Floater's
/// weights, each with the tangents of half of the angles on both sides of its corner.
pub fn shading(shape: &TestShape, p: DVec3) -> Option<(DVec3, f64)> {
    let (corners, normals) = match shape {
        TestShape::SmoothTriangle { corners, normals } => (&corners[..], &normals[..]),
        TestShape::SmoothPolygon { corners, normals } => (&corners[..], &normals[..]),
        _ => return None,
    };
    let (_, upward) = level(shape);
    let nearest = corners.iter().map(|corner| length(*corner - p)).fold(f64::INFINITY, f64::min);
    let share = |i: usize| {
        let (before, here, after) =
            (corners[(i + corners.len() - 1) % corners.len()], corners[i], corners[(i + 1) % corners.len()]);
        if let TestShape::SmoothTriangle { .. } = shape {
            return (after - p).cross(before - p).dot(upward);
        }
        let (x, y) = perpendicular_axes(upward);
        let flat = |corner: DVec3| ((corner - p).dot(x), (corner - p).dot(y));
        let half = |a: DVec3, b: DVec3| (0.5 * angle(flat(a), flat(b))).tan();
        (half(before, here) + half(here, after)) / length(here - p)
    };
    Some((unit(normals.iter().enumerate().map(|(i, normal)| unit(*normal) * share(i)).sum()), nearest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ray(origin: DVec3, direction: DVec3) -> TestRay {
        TestRay { origin, direction }
    }

    fn way(shape: &TestShape, ray: &TestRay) -> Option<f64> {
        match intersect(shape, ray) {
            OracleAnswer::Hit(contact) => Some(contact.way),
            OracleAnswer::Miss => None,
            OracleAnswer::Unclear => panic!("unclear"),
        }
    }

    #[test]
    fn the_oracle_knows_what_is_known_on_paper() {
        let close = |got: Option<f64>, want: f64| (got.unwrap() - want).abs() <= 1e-12;
        let along_x = ray(dvec3(-5.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0));
        let ball = TestShape::Sphere { center: DVec3::ZERO, radius: 1.5 };
        assert!(close(way(&ball, &along_x), 3.5));
        assert!(close(way(&ball, &ray(dvec3(0.5, 0.0, 0.0), DVec3::X)), 1.0));
        let ring = TestShape::Torus { center: DVec3::ZERO, axis: DVec3::Z, major: 2.0, minor: 0.5 };
        assert!(close(way(&ring, &along_x), 2.5));
        assert!(close(way(&ring, &ray(dvec3(-1.0, 0.0, 0.0), DVec3::X)), 2.5));
        assert_eq!(way(&ring, &ray(dvec3(0.0, 0.0, 3.0), -DVec3::Z)), None);
        let cone = |capped| TestShape::Cone {
            base: DVec3::ZERO,
            base_radius: 2.0,
            end: dvec3(0.0, 0.0, 2.0),
            end_radius: 0.0,
            capped,
        };
        let up = ray(dvec3(1.0, 0.0, -1.0), DVec3::Z);
        assert!(close(way(&cone(true), &up), 1.0) && close(way(&cone(false), &up), 2.0));
        let tilted = ray(dvec3(2.0, 1.5, 0.5), dvec3(-1.0, -1.0, 0.0));
        let cube = TestShape::Cuboid { min: dvec3(-1.0, 0.0, 0.0), max: DVec3::ONE };
        assert!(close(way(&cube, &tilted), 2.0_f64.sqrt()));
    }

    #[test]
    fn a_point_in_a_notch_is_outside() {
        let corners =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 1.0), (0.0, 3.0)].map(|(x, y)| dvec3(x, y, 0.0));
        assert_eq!(inside(&corners, dvec3(2.0, 0.5, 0.0), DVec3::Z), (true, 0.5));
        assert!(!inside(&corners, dvec3(2.0, 2.0, 0.0), DVec3::Z).0);
    }
}
