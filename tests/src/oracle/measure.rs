//! Lengths and angles.

use strahl_test_scene::DVec3;

pub(super) fn length(v: DVec3) -> f64 {
    v.dot(v).sqrt()
}

/// Distance of a point from a line segment, in two dimensions.
pub(super) fn to_segment(p: (f64, f64), a: (f64, f64), b: (f64, f64)) -> f64 {
    let (edge, from) = ((b.0 - a.0, b.1 - a.1), (p.0 - a.0, p.1 - a.1));
    let square = edge.0 * edge.0 + edge.1 * edge.1;
    let s = if square > 0.0 { (from.0 * edge.0 + from.1 * edge.1) / square } else { 0.0 }.clamp(0.0, 1.0);
    (from.0 - edge.0 * s).hypot(from.1 - edge.1 * s)
}

/// Angle from one direction to another, positive counterclockwise.
pub(super) fn angle(a: (f64, f64), b: (f64, f64)) -> f64 {
    (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1)
}
