//! The textbook's intersections of a ray from `o` in the direction `d`.

use super::roots::{quadratic, quartic};
use super::{EPSILON, TextbookHit};
use strahl_core::Vec3;

/// Solves the quadratic equation in `t` by the quadratic formula.
pub(super) fn sphere(center: Vec3, radius: f32, o: Vec3, d: Vec3) -> Option<TextbookHit> {
    let p = o - center;
    let t =
        quadratic(d.dot(d), 2.0 * p.dot(d), p.dot(p) - radius * radius)?.into_iter().find(|t| *t > 0.0)?;
    Some(TextbookHit { t, normal: (o + d * t - center) / radius })
}

/// Distance of the plane `normal . p = level`.
pub(super) fn plane(normal: Vec3, level: f32, o: Vec3, d: Vec3) -> Option<f32> {
    let cos = normal.dot(d);
    if cos.abs() < EPSILON {
        return None;
    }
    let t = (level - normal.dot(o)) / cos;
    (t > 0.0).then_some(t)
}

/// Source: Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
pub(super) fn triangle([a, b, c]: &[Vec3; 3], o: Vec3, d: Vec3) -> Option<TextbookHit> {
    let (e, f) = (*b - *a, *c - *a);
    let p = d.cross(f);
    let determinant = e.dot(p);
    if determinant.abs() < EPSILON {
        return None;
    }
    let s = o - *a;
    let u = s.dot(p) / determinant;
    let q = s.cross(e);
    let v = d.dot(q) / determinant;
    if u < 0.0 || v < 0.0 || u + v > 1.0 {
        return None;
    }
    let t = f.dot(q) / determinant;
    (t > 0.0).then_some(TextbookHit { t, normal: e.cross(f).normalize() })
}

/// Even-odd rule: counts the edges that a line to the right crosses. An edge contains both of its ends.
pub(super) fn is_inside(vertices: &[Vec3], normal: Vec3, p: Vec3) -> bool {
    let n = normal.abs();
    let flat = |v: Vec3| {
        if n.x > n.y && n.x > n.z {
            (v.y, v.z)
        } else if n.y > n.z {
            (v.z, v.x)
        } else {
            (v.x, v.y)
        }
    };
    let (x, y) = flat(p);
    let mut inside = false;
    for i in 0..vertices.len() {
        let (a, b) = (flat(vertices[i]), flat(vertices[(i + 1) % vertices.len()]));
        let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
        if y >= low.1 && y <= high.1 && high.1 > low.1 {
            let across = low.0 + (y - low.1) / (high.1 - low.1) * (high.0 - low.0);
            inside ^= across > x;
        }
    }
    inside
}

/// Slab test that orders the planes by the sign of the direction.
///
/// Source: Smits, "Efficiency Issues for Ray Tracing", 1998.
pub(super) fn cuboid(min: Vec3, max: Vec3, o: Vec3, d: Vec3) -> Option<TextbookHit> {
    let (mut near, mut far) = (f32::NEG_INFINITY, f32::INFINITY);
    let (mut in_axis, mut out_axis) = (0, 0);
    for axis in 0..3 {
        let inverse = 1.0 / d[axis];
        let (a, b) = if d[axis] >= 0.0 { (min[axis], max[axis]) } else { (max[axis], min[axis]) };
        let (entry, exit) = ((a - o[axis]) * inverse, (b - o[axis]) * inverse);
        if entry > near {
            (near, in_axis) = (entry, axis);
        }
        if exit < far {
            (far, out_axis) = (exit, axis);
        }
    }
    if near > far || far <= 0.0 {
        return None;
    }
    let mut normal = Vec3::ZERO;
    let t = if near > 0.0 {
        normal[in_axis] = -d[in_axis].signum();
        near
    } else {
        normal[out_axis] = d[out_axis].signum();
        far
    };
    Some(TextbookHit { t, normal })
}

/// Whether a ray hits a box: a slab test that orders the planes by the sign of the direction and multiplies
/// by its reciprocal.
pub fn slabs(min: Vec3, max: Vec3, o: Vec3, d: Vec3) -> bool {
    let (mut near, mut far) = (f32::NEG_INFINITY, f32::INFINITY);
    for axis in 0..3 {
        let inverse = 1.0 / d[axis];
        let (a, b) = if d[axis] >= 0.0 { (min[axis], max[axis]) } else { (max[axis], min[axis]) };
        near = near.max((a - o[axis]) * inverse);
        far = far.min((b - o[axis]) * inverse);
    }
    near <= far && far >= 0.0
}

/// Solves the quadratic equation of the side by the quadratic formula, and intersects the planes of the caps.
#[allow(clippy::too_many_arguments)] // the fields of a cone, and a ray
pub(super) fn cone(
    base: Vec3,
    axis: Vec3,
    height: f32,
    base_radius: f32,
    end_radius: f32,
    capped: bool,
    o: Vec3,
    d: Vec3,
) -> Option<TextbookHit> {
    let p = o - base;
    let (z, dz) = (p.dot(axis), d.dot(axis));
    let (q, dq) = (p - axis * z, d - axis * dz);
    let slope = (end_radius - base_radius) / height;
    let radius = base_radius + slope * z;
    let a = dq.dot(dq) - slope * slope * dz * dz;
    let b = 2.0 * (q.dot(dq) - slope * dz * radius);
    let c = q.dot(q) - radius * radius;
    let mut best: Option<TextbookHit> = None;
    let mut offer = |hit: TextbookHit| {
        if hit.t > 0.0 && best.is_none_or(|best| hit.t < best.t) {
            best = Some(hit);
        }
    };
    for t in quadratic(a, b, c).into_iter().flatten() {
        let at = z + dz * t;
        if at >= 0.0 && at <= height {
            offer(TextbookHit { t, normal: ((q + dq * t).normalize() - axis * slope).normalize() });
        }
    }
    if capped {
        for (at, radius, normal) in [(0.0, base_radius, -axis), (height, end_radius, axis)] {
            let t = (at - z) / dz;
            let r = q + dq * t;
            if r.dot(r) <= radius * radius {
                offer(TextbookHit { t, normal });
            }
        }
    }
    best
}

/// Solves the quartic in the distance by the formulas of Ferrari and Cardano.
///
/// Source: Schwarze, "Cubic and Quartic Roots", Graphics Gems, 1990.
pub(super) fn torus(
    center: Vec3,
    axis: Vec3,
    major: f32,
    minor: f32,
    o: Vec3,
    d: Vec3,
) -> Option<TextbookHit> {
    let speed = d.length();
    let (p, d) = (o - center, d / speed);
    let (z, dz) = (p.dot(axis), d.dot(axis));
    let (beta, four) = (p.dot(d), 4.0 * major * major);
    let g = p.dot(p) - major * major - minor * minor;
    let t = quartic(
        4.0 * beta,
        4.0 * beta * beta + 2.0 * g + four * dz * dz,
        4.0 * beta * g + 2.0 * four * z * dz,
        g * g + four * (z * z - minor * minor),
    )
    .into_iter()
    .filter(|t| *t > 0.0)
    .reduce(f32::min)?;
    let at = p + d * t;
    let ring = (at - axis * at.dot(axis)).normalize() * major;
    Some(TextbookHit { t: t / speed, normal: (at - ring).normalize() })
}
