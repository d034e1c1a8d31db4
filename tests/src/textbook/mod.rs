//! The textbook's formulas in single precision, for comparison with the core's numerically stable ones.
//!
//! They are those of introductions and small ray tracers, correct in exact arithmetic and unprotected against
//! rounding. Only the tests use them: they run them through the same checks as the core and expect them to
//! fail.

// Not the core: the platform's square root is correctly rounded as well.
#![allow(clippy::disallowed_methods)]

pub mod accelerators;

use strahl_core::Vec3;

use strahl_test_scene::vector::{area, unit};
use strahl_test_scene::{DVec3, TestRay, TestShape};

/// A hit by the textbook's formula.
#[derive(Clone, Copy, Debug)]
pub struct TextbookHit {
    /// Distance, in lengths of the ray's direction.
    pub t: f32,
    /// Normal at the hit point.
    pub normal: Vec3,
}

/// A determinant or a cosine below this counts as zero.
const EPSILON: f32 = 1e-6;

/// Fixed offset of a ray origin from the surface, in scene lengths.
pub const OFFSET: f32 = 1e-4;

fn narrow(v: DVec3) -> Vec3 {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

/// A shape in the textbook's representation, with precomputed values.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // as in `TestShape`
pub enum TextbookShape {
    Sphere {
        center: Vec3,
        radius: f32,
    },
    /// `n . p = d`.
    Plane {
        normal: Vec3,
        d: f32,
    },
    Disc {
        center: Vec3,
        normal: Vec3,
        d: f32,
        radius: f32,
    },
    Triangle {
        vertices: [Vec3; 3],
    },
    Polygon {
        vertices: Vec<Vec3>,
        normal: Vec3,
        d: f32,
    },
    Cuboid {
        min: Vec3,
        max: Vec3,
    },
    /// Center in the box's own frame, and the axes of the frame.
    OrientedCuboid {
        center: Vec3,
        half: Vec3,
        axes: [Vec3; 3],
    },
    Cone {
        base: Vec3,
        axis: Vec3,
        height: f32,
        base_radius: f32,
        end_radius: f32,
        capped: bool,
    },
    Torus {
        center: Vec3,
        axis: Vec3,
        major: f32,
        minor: f32,
    },
}

impl TextbookShape {
    /// Converts a test shape.
    pub fn of(shape: &TestShape) -> TextbookShape {
        match shape {
            TestShape::Sphere { center, radius } => {
                TextbookShape::Sphere { center: narrow(*center), radius: *radius as f32 }
            }
            TestShape::Plane { point, normal } => {
                let normal = narrow(*normal).normalize();
                TextbookShape::Plane { normal, d: normal.dot(narrow(*point)) }
            }
            TestShape::Disc { center, normal, radius } => {
                let (center, normal) = (narrow(*center), narrow(*normal).normalize());
                TextbookShape::Disc { center, normal, d: normal.dot(center), radius: *radius as f32 }
            }
            TestShape::Triangle { vertices } | TestShape::SmoothTriangle { vertices, .. } => {
                TextbookShape::Triangle { vertices: vertices.map(narrow) }
            }
            TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => {
                let normal = narrow(unit(area(vertices)));
                let vertices: Vec<Vec3> = vertices.iter().copied().map(narrow).collect();
                let d = normal.dot(vertices[0]);
                TextbookShape::Polygon { vertices, normal, d }
            }
            TestShape::Cuboid { min, max } => TextbookShape::Cuboid { min: narrow(*min), max: narrow(*max) },
            TestShape::OrientedCuboid { center, half, first, third } => {
                let z = narrow(*third).normalize();
                let y = z.cross(narrow(*first)).normalize();
                let axes = [y.cross(z), y, z];
                let center = narrow(*center);
                TextbookShape::OrientedCuboid { center: to_frame(center, &axes), half: narrow(*half), axes }
            }
            TestShape::Cone { base, base_radius, end, end_radius, capped } => {
                let (base, end) = (narrow(*base), narrow(*end));
                let height = (end - base).length();
                TextbookShape::Cone {
                    base,
                    axis: (end - base) / height,
                    height,
                    base_radius: *base_radius as f32,
                    end_radius: *end_radius as f32,
                    capped: *capped,
                }
            }
            TestShape::Torus { center, axis, major, minor } => TextbookShape::Torus {
                center: narrow(*center),
                axis: narrow(*axis).normalize(),
                major: *major as f32,
                minor: *minor as f32,
            },
        }
    }

    /// Nearest hit of a ray.
    pub fn intersect(&self, ray: &TestRay) -> Option<TextbookHit> {
        self.hit(narrow(ray.origin), narrow(ray.direction))
    }

    /// Distance of the nearest hit of the ray from `o` in the direction `d`.
    pub fn distance(&self, o: Vec3, d: Vec3) -> Option<f32> {
        self.hit(o, d).map(|hit| hit.t)
    }

    /// Nearest hit of the ray from `o` in the direction `d`.
    #[inline]
    fn hit(&self, o: Vec3, d: Vec3) -> Option<TextbookHit> {
        match self {
            TextbookShape::Sphere { center, radius } => sphere(*center, *radius, o, d),
            TextbookShape::Plane { normal, d: level } => {
                plane(*normal, *level, o, d).map(|t| TextbookHit { t, normal: *normal })
            }
            TextbookShape::Disc { center, normal, d: level, radius } => {
                let t = plane(*normal, *level, o, d)?;
                let away = o + d * t - *center;
                (away.dot(away) <= radius * radius).then_some(TextbookHit { t, normal: *normal })
            }
            TextbookShape::Triangle { vertices } => triangle(vertices, o, d),
            TextbookShape::Polygon { vertices, normal, d: level } => {
                let t = plane(*normal, *level, o, d)?;
                is_inside(vertices, *normal, o + d * t).then_some(TextbookHit { t, normal: *normal })
            }
            TextbookShape::Cuboid { min, max } => cuboid(*min, *max, o, d),
            TextbookShape::OrientedCuboid { center, half, axes } => {
                let hit = cuboid(*center - *half, *center + *half, to_frame(o, axes), to_frame(d, axes))?;
                let n = hit.normal;
                Some(TextbookHit { t: hit.t, normal: axes[0] * n.x + axes[1] * n.y + axes[2] * n.z })
            }
            TextbookShape::Cone { base, axis, height, base_radius, end_radius, capped } => {
                cone(*base, *axis, *height, *base_radius, *end_radius, *capped, o, d)
            }
            TextbookShape::Torus { center, axis, major, minor } => {
                torus(*center, *axis, *major, *minor, o, d)
            }
        }
    }
}

fn to_frame(v: Vec3, axes: &[Vec3; 3]) -> Vec3 {
    Vec3::new(v.dot(axes[0]), v.dot(axes[1]), v.dot(axes[2]))
}

/// The roots of `a x^2 + b x + c` in ascending order, by the quadratic formula.
fn quadratic(a: f32, b: f32, c: f32) -> Option<[f32; 2]> {
    let d = b * b - 4.0 * a * c;
    if d < 0.0 {
        return None;
    }
    let (x, y) = ((-b - d.sqrt()) / (2.0 * a), (-b + d.sqrt()) / (2.0 * a));
    Some(if x < y { [x, y] } else { [y, x] })
}

fn sphere(center: Vec3, radius: f32, o: Vec3, d: Vec3) -> Option<TextbookHit> {
    let p = o - center;
    let t =
        quadratic(d.dot(d), 2.0 * p.dot(d), p.dot(p) - radius * radius)?.into_iter().find(|t| *t > 0.0)?;
    Some(TextbookHit { t, normal: (o + d * t - center) / radius })
}

fn plane(normal: Vec3, level: f32, o: Vec3, d: Vec3) -> Option<f32> {
    let cos = normal.dot(d);
    if cos.abs() < EPSILON {
        return None;
    }
    let t = (level - normal.dot(o)) / cos;
    (t > 0.0).then_some(t)
}

/// Source: Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
fn triangle([a, b, c]: &[Vec3; 3], o: Vec3, d: Vec3) -> Option<TextbookHit> {
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
fn is_inside(vertices: &[Vec3], normal: Vec3, p: Vec3) -> bool {
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
fn cuboid(min: Vec3, max: Vec3, o: Vec3, d: Vec3) -> Option<TextbookHit> {
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

#[allow(clippy::too_many_arguments)] // the fields of a cone, and a ray
fn cone(
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
fn torus(center: Vec3, axis: Vec3, major: f32, minor: f32, o: Vec3, d: Vec3) -> Option<TextbookHit> {
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

/// The real roots of `x^4 + a x^3 + b x^2 + c x + d`.
pub(crate) fn quartic(a: f32, b: f32, c: f32, d: f32) -> Vec<f32> {
    // x = y - a/4: y^4 + p y^2 + q y + r.
    let s = a * a;
    let p = b - 0.375 * s;
    let q = 0.125 * s * a - 0.5 * a * b + c;
    let r = -3.0 / 256.0 * s * s + s * b / 16.0 - 0.25 * a * c + d;
    let z = resolvent(-0.5 * p, -r, 0.5 * r * p - 0.125 * q * q);
    let (u, v) = (z * z - r, 2.0 * z - p);
    if u < 0.0 || v < 0.0 {
        return Vec::new();
    }
    let (u, v) = (u.sqrt(), v.sqrt());
    let v = if q < 0.0 { -v } else { v };
    [quadratic(1.0, v, z - u), quadratic(1.0, -v, z + u)]
        .into_iter()
        .flatten()
        .flatten()
        .map(|y| y - 0.25 * a)
        .collect()
}

/// A real root of `x^3 + a x^2 + b x + c`.
fn resolvent(a: f32, b: f32, c: f32) -> f32 {
    let p = (b - a * a / 3.0) / 3.0;
    let q = 0.5 * (2.0 / 27.0 * a * a * a - a * b / 3.0 + c);
    let d = q * q + p * p * p;
    let y = if d < 0.0 {
        let angle = libm::acosf(-q / (-p * p * p).sqrt()) / 3.0;
        2.0 * (-p).sqrt() * libm::cosf(angle)
    } else {
        libm::cbrtf(d.sqrt() - q) - libm::cbrtf(d.sqrt() + q)
    };
    y - a / 3.0
}

/// Moves a ray origin off the surface by [`OFFSET`] on the side of `normal`.
pub fn offset_origin(point: Vec3, normal: Vec3) -> Vec3 {
    point + normal * OFFSET
}

/// Direction of the refracted ray, and the Fresnel reflectance.
pub fn refracted(d: Vec3, n: Vec3, ratio: f32) -> (Vec3, f32) {
    let cos = -d.dot(n);
    let cos_behind = (1.0 - ratio * ratio * (1.0 - cos * cos)).sqrt();
    let across = (ratio * cos - cos_behind) / (ratio * cos + cos_behind);
    let along = (cos - ratio * cos_behind) / (cos + ratio * cos_behind);
    (d * ratio + n * (ratio * cos - cos_behind), 0.5 * (across * across + along * along))
}
