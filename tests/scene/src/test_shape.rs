//! Shapes and rays whose numbers are exact in `f32`, so that both cores get the same ones.

use crate::rng::{SplitMix64, rounded};
use crate::vector::{DVec3, area, dvec3, perpendicular_axes, unit};

/// A ray. The direction may have any length.
#[derive(Clone, Copy, Debug)]
pub struct TestRay {
    /// Origin.
    pub origin: DVec3,
    /// Direction, of any length.
    pub direction: DVec3,
}

impl TestRay {
    /// The point at distance `t`, in lengths of the direction.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// A shape. Directions may have any length; each core normalizes them.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // as in the core's own shapes
pub enum TestShape {
    Sphere { center: DVec3, radius: f64 },
    Plane { point: DVec3, normal: DVec3 },
    Disc { center: DVec3, normal: DVec3, radius: f64 },
    Triangle { vertices: [DVec3; 3] },
    SmoothTriangle { vertices: [DVec3; 3], normals: [DVec3; 3] },
    Polygon { vertices: Vec<DVec3> },
    SmoothPolygon { vertices: Vec<DVec3>, normals: Vec<DVec3> },
    Cuboid { min: DVec3, max: DVec3 },
    OrientedCuboid { center: DVec3, half: DVec3, first: DVec3, third: DVec3 },
    Cone { base: DVec3, base_radius: f64, end: DVec3, end_radius: f64, capped: bool },
    Torus { center: DVec3, axis: DVec3, major: f64, minor: f64 },
}

/// Kind of a random shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum TestShapeKind {
    Sphere,
    Plane,
    Disc,
    Triangle,
    SmoothTriangle,
    /// Star-shaped with three to nine vertices; most are concave.
    Polygon,
    SmoothPolygon,
    Cuboid,
    OrientedCuboid,
    OpenCone,
    CappedCone,
    OpenCylinder,
    CappedCylinder,
    Torus,
}

impl TestShapeKind {
    /// Every kind.
    pub const ALL: [TestShapeKind; 14] = [
        TestShapeKind::Sphere,
        TestShapeKind::Plane,
        TestShapeKind::Disc,
        TestShapeKind::Triangle,
        TestShapeKind::SmoothTriangle,
        TestShapeKind::Polygon,
        TestShapeKind::SmoothPolygon,
        TestShapeKind::Cuboid,
        TestShapeKind::OrientedCuboid,
        TestShapeKind::OpenCone,
        TestShapeKind::CappedCone,
        TestShapeKind::OpenCylinder,
        TestShapeKind::CappedCylinder,
        TestShapeKind::Torus,
    ];
}

/// Rounds each component to `f32`.
fn as_f32(v: DVec3) -> DVec3 {
    dvec3(rounded(v.x), rounded(v.y), rounded(v.z))
}

impl TestShape {
    /// A random shape of about `size`, near `position`.
    ///
    /// Proportions are at most about 3 to 1, angles at least about 15 degrees.
    pub fn random(kind: TestShapeKind, position: DVec3, size: f64, rng: &mut SplitMix64) -> TestShape {
        let r = rng;
        let center = r.in_ball(position, 0.1 * size);
        let length = |r: &mut SplitMix64| r.between(0.35 * size, size);
        match kind {
            TestShapeKind::Sphere => TestShape::Sphere { center, radius: length(r) },
            TestShapeKind::Plane => TestShape::Plane { point: center, normal: r.direction() },
            TestShapeKind::Disc => TestShape::Disc { center, normal: r.direction(), radius: length(r) },
            TestShapeKind::Triangle => TestShape::Triangle { vertices: triangle(center, size, r) },
            TestShapeKind::SmoothTriangle => {
                let vertices = triangle(center, size, r);
                let normals = cap_normals(&vertices, center, size);
                TestShape::SmoothTriangle { vertices, normals: [normals[0], normals[1], normals[2]] }
            }
            TestShapeKind::Polygon => TestShape::Polygon { vertices: star(center, size, r) },
            TestShapeKind::SmoothPolygon => {
                let vertices = star(center, size, r);
                TestShape::SmoothPolygon { normals: cap_normals(&vertices, center, size), vertices }
            }
            TestShapeKind::Cuboid => {
                let half = dvec3(length(r), length(r), length(r));
                TestShape::Cuboid { min: as_f32(center - half), max: as_f32(center + half) }
            }
            TestShapeKind::OrientedCuboid => {
                let third = r.direction();
                let first = loop {
                    let first = r.direction();
                    if first.dot(third).abs() < 0.8 {
                        break first;
                    }
                };
                let half = dvec3(length(r), length(r), length(r));
                TestShape::OrientedCuboid { center, half, first, third }
            }
            TestShapeKind::OpenCone | TestShapeKind::CappedCone => {
                let capped = kind == TestShapeKind::CappedCone;
                let end = as_f32(center + r.direction() * length(r));
                // One in four has an apex, at either end.
                let (base_radius, end_radius) = match r.below(8) {
                    0 => (0.0, length(r)),
                    1 => (length(r), 0.0),
                    _ => (length(r), length(r)),
                };
                TestShape::Cone { base: center, base_radius, end, end_radius, capped }
            }
            TestShapeKind::OpenCylinder | TestShapeKind::CappedCylinder => {
                let capped = kind == TestShapeKind::CappedCylinder;
                let end = as_f32(center + r.direction() * length(r));
                let radius = length(r);
                TestShape::Cone { base: center, base_radius: radius, end, end_radius: radius, capped }
            }
            TestShapeKind::Torus => {
                let major = length(r);
                TestShape::Torus {
                    center,
                    axis: r.direction(),
                    major,
                    minor: rounded(major * r.between(0.2, 0.8)),
                }
            }
        }
    }

    /// The shape after a similarity transform: `map` for points, `turn` for directions, `scale` for lengths.
    pub fn mapped(
        &self,
        map: impl Fn(DVec3) -> DVec3,
        turn: impl Fn(DVec3) -> DVec3,
        scale: f64,
    ) -> TestShape {
        let points = |points: &[DVec3]| points.iter().map(|p| map(*p)).collect();
        match self {
            TestShape::Sphere { center, radius } => {
                TestShape::Sphere { center: map(*center), radius: radius * scale }
            }
            TestShape::Plane { point, normal } => {
                TestShape::Plane { point: map(*point), normal: turn(*normal) }
            }
            TestShape::Disc { center, normal, radius } => {
                TestShape::Disc { center: map(*center), normal: turn(*normal), radius: radius * scale }
            }
            TestShape::Triangle { vertices } => TestShape::Triangle { vertices: vertices.map(map) },
            TestShape::SmoothTriangle { vertices, normals } => {
                TestShape::SmoothTriangle { vertices: vertices.map(map), normals: normals.map(turn) }
            }
            TestShape::Polygon { vertices } => TestShape::Polygon { vertices: points(vertices) },
            TestShape::SmoothPolygon { vertices, normals } => TestShape::SmoothPolygon {
                vertices: points(vertices),
                normals: normals.iter().map(|n| turn(*n)).collect(),
            },
            TestShape::Cuboid { min, max } => {
                let (a, b) = (map(*min), map(*max));
                TestShape::Cuboid { min: a.min(b), max: a.max(b) }
            }
            TestShape::OrientedCuboid { center, half, first, third } => TestShape::OrientedCuboid {
                center: map(*center),
                half: *half * scale,
                first: turn(*first),
                third: turn(*third),
            },
            TestShape::Cone { base, base_radius, end, end_radius, capped } => TestShape::Cone {
                base: map(*base),
                base_radius: base_radius * scale,
                end: map(*end),
                end_radius: end_radius * scale,
                capped: *capped,
            },
            TestShape::Torus { center, axis, major, minor } => TestShape::Torus {
                center: map(*center),
                axis: turn(*axis),
                major: major * scale,
                minor: minor * scale,
            },
        }
    }

    /// Center and radius of a bounding sphere that is not much larger than needed. Of a plane, a unit sphere
    /// around its point.
    pub fn bounding_sphere(&self) -> (DVec3, f64) {
        let around = |vertices: &[DVec3]| {
            let center = vertices.iter().sum::<DVec3>() / vertices.len() as f64;
            let square = vertices.iter().map(|c| (*c - center).dot(*c - center)).fold(0.0, f64::max);
            (center, square.sqrt())
        };
        match self {
            TestShape::Sphere { center, radius } | TestShape::Disc { center, radius, .. } => {
                (*center, *radius)
            }
            TestShape::Plane { point, .. } => (*point, 1.0),
            TestShape::Triangle { vertices } | TestShape::SmoothTriangle { vertices, .. } => around(vertices),
            TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => around(vertices),
            TestShape::Cuboid { min, max } => around(&[*min, *max]),
            TestShape::OrientedCuboid { center, half, .. } => (*center, half.dot(*half).sqrt()),
            TestShape::Cone { base, base_radius, end, end_radius, .. } => {
                let (center, half) = around(&[*base, *end]);
                (center, half + base_radius.max(*end_radius))
            }
            TestShape::Torus { center, major, minor, .. } => (*center, major + minor),
        }
    }
}

/// Vertex normals that lean away from the center, so that the flat shape is shaded like a cap.
fn cap_normals(vertices: &[DVec3], center: DVec3, size: f64) -> Vec<DVec3> {
    let normal = unit(area(vertices));
    vertices.iter().map(|vertex| as_f32(unit(normal + (*vertex - center) * (0.5 / size)))).collect()
}

fn triangle(center: DVec3, size: f64, rng: &mut SplitMix64) -> [DVec3; 3] {
    loop {
        let vertices = [(); 3].map(|()| rng.in_ball(center, size));
        let [a, b, c] = vertices;
        let side = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        let area = area(&vertices);
        if area.dot(area).sqrt() > 0.25 * side && side > 0.25 * size * size {
            return vertices;
        }
    }
}

fn star(center: DVec3, size: f64, rng: &mut SplitMix64) -> Vec<DVec3> {
    let (x, y) = perpendicular_axes(rng.direction());
    let count = 3 + rng.below(7);
    let vertex = |i: u32| {
        let angle = f64::from(i) * std::f64::consts::TAU / f64::from(count);
        as_f32(center + (x * libm::cos(angle) + y * libm::sin(angle)) * rng.between(0.35 * size, size))
    };
    (0..count).map(vertex).collect()
}
