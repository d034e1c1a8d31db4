//! Signed distances from shapes, and normal, nearest edge and curvature at their points.

use super::flat::plane_of;
use super::measure::{length, to_segment};
use strahl_test_scene::vector::unit;
use strahl_test_scene::{DVec3, TestShape, dvec3};

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

/// Signed distance of a point from a box that is centered at the origin.
fn box_distance(p: DVec3, half: DVec3) -> f64 {
    let q = p.abs() - half;
    length(q.max(DVec3::ZERO)) + q.max_element().min(0.0)
}

/// Distance of a point from the axis, its coordinate along the axis, and the length of the axis.
pub(super) fn profile(base: DVec3, end: DVec3, p: DVec3) -> ((f64, f64), f64) {
    let (q, height) = (p - base, length(end - base));
    let axis = (end - base) / height;
    let z = q.dot(axis);
    ((length(q - axis * z), z), height)
}

/// The outward normal at the nearest point of a solid, or of the side of an open cone.
pub(super) fn normal_at(shape: &TestShape, p: DVec3) -> DVec3 {
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
pub(super) fn edge_distance(shape: &TestShape, p: DVec3) -> f64 {
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
pub(super) fn curvature_at(shape: &TestShape, p: DVec3) -> f64 {
    match shape {
        TestShape::Sphere { radius, .. } => *radius,
        TestShape::Cone { base, end, .. } => profile(*base, *end, p).0.0,
        TestShape::Torus { major, minor, .. } => minor.min(major - minor),
        _ => f64::INFINITY,
    }
}
