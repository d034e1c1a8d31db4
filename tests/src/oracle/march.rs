//! Intersection of solids and curved sides by sphere tracing.

use super::answer::{OracleAnswer, OracleHit, PRECISION, band, size};
use super::distance::{curvature_at, edge_distance, normal_at, profile, signed_distance};
use super::measure::length;
use strahl_test_scene::{DVec3, TestRay, TestShape};

/// Result of marching along a ray.
#[derive(Clone, Copy, PartialEq)]
enum MarchEnd {
    /// A hit at this distance.
    At(f64),
    Miss,
    /// Too many steps without a hit or a miss.
    Lost,
}

/// Marches from `origin` in steps as long as the distance `field`. `direction`: unit vector; `size`: as of [`size()`].
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

/// Intersects a ray with a solid or an open cone.
pub(super) fn intersect(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
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
