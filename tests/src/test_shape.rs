//! Things and lines: shapes and rays in numbers that both cores hold exactly.

use crate::rng::{SplitMix64, rounded};
use crate::vector::{DVec3, area, dvec3, perpendicular_axes, unit};

/// A ray. Its direction may have any length.
#[derive(Clone, Copy, Debug)]
pub struct TestRay {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
}

impl TestRay {
    /// The point `t` lengths of the direction away.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// A shape. Directions may have any length: each core makes them one long, as well as it can.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // as in the core's own shapes
pub enum TestShape {
    Sphere { center: DVec3, radius: f64 },
    Plane { point: DVec3, normal: DVec3 },
    Disc { center: DVec3, normal: DVec3, radius: f64 },
    Triangle { corners: [DVec3; 3] },
    SmoothTriangle { corners: [DVec3; 3], normals: [DVec3; 3] },
    Polygon { corners: Vec<DVec3> },
    SmoothPolygon { corners: Vec<DVec3>, normals: Vec<DVec3> },
    Cuboid { min: DVec3, max: DVec3 },
    OrientedCuboid { center: DVec3, half: DVec3, first: DVec3, third: DVec3 },
    Cone { base: DVec3, base_radius: f64, end: DVec3, end_radius: f64, capped: bool },
    Torus { center: DVec3, axis: DVec3, major: f64, minor: f64 },
}

/// What random things are made like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum TestShapeKind {
    Sphere,
    Plane,
    Disc,
    Triangle,
    SmoothTriangle,
    /// Of three to nine corners, star-shaped, so that most are concave.
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

/// Each component rounded to what `f32` holds.
fn as_f32(v: DVec3) -> DVec3 {
    dvec3(rounded(v.x), rounded(v.y), rounded(v.z))
}

impl TestShape {
    /// A random thing about `size` large, about at `place`.
    ///
    /// No proportions in it are extreme: of three to one, and angles not below some 15 degrees.
    pub fn random(kind: TestShapeKind, place: DVec3, size: f64, rng: &mut SplitMix64) -> TestShape {
        let r = rng;
        let center = r.in_ball(place, 0.1 * size);
        let length = |r: &mut SplitMix64| r.between(0.35 * size, size);
        match kind {
            TestShapeKind::Sphere => TestShape::Sphere { center, radius: length(r) },
            TestShapeKind::Plane => TestShape::Plane { point: center, normal: r.direction() },
            TestShapeKind::Disc => TestShape::Disc { center, normal: r.direction(), radius: length(r) },
            TestShapeKind::Triangle => TestShape::Triangle { corners: triangle(center, size, r) },
            TestShapeKind::SmoothTriangle => {
                let corners = triangle(center, size, r);
                let normals = bent(&corners, center, size);
                TestShape::SmoothTriangle { corners, normals: [normals[0], normals[1], normals[2]] }
            }
            TestShapeKind::Polygon => TestShape::Polygon { corners: star(center, size, r) },
            TestShapeKind::SmoothPolygon => {
                let corners = star(center, size, r);
                TestShape::SmoothPolygon { normals: bent(&corners, center, size), corners }
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
                // Every fourth comes to a point, at one of both ends.
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

    /// The same thing after a map of space: of points, directions, and lengths.
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
            TestShape::Triangle { corners } => TestShape::Triangle { corners: corners.map(map) },
            TestShape::SmoothTriangle { corners, normals } => {
                TestShape::SmoothTriangle { corners: corners.map(map), normals: normals.map(turn) }
            }
            TestShape::Polygon { corners } => TestShape::Polygon { corners: points(corners) },
            TestShape::SmoothPolygon { corners, normals } => TestShape::SmoothPolygon {
                corners: points(corners),
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

    /// A ball round the thing, not much larger than needed; round a part of a plane.
    pub fn ball(&self) -> (DVec3, f64) {
        let round = |corners: &[DVec3]| {
            let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
            let reach = corners.iter().map(|c| (*c - middle).dot(*c - middle)).fold(0.0, f64::max);
            (middle, reach.sqrt())
        };
        match self {
            TestShape::Sphere { center, radius } | TestShape::Disc { center, radius, .. } => {
                (*center, *radius)
            }
            TestShape::Plane { point, .. } => (*point, 1.0),
            TestShape::Triangle { corners } | TestShape::SmoothTriangle { corners, .. } => round(corners),
            TestShape::Polygon { corners } | TestShape::SmoothPolygon { corners, .. } => round(corners),
            TestShape::Cuboid { min, max } => round(&[*min, *max]),
            TestShape::OrientedCuboid { center, half, .. } => (*center, half.dot(*half).sqrt()),
            TestShape::Cone { base, base_radius, end, end_radius, .. } => {
                let (middle, half) = round(&[*base, *end]);
                (middle, half + base_radius.max(*end_radius))
            }
            TestShape::Torus { center, major, minor, .. } => (*center, major + minor),
        }
    }
}

/// Normals of corners that lean away from the middle, so that the flat thing looks like a cap.
fn bent(corners: &[DVec3], center: DVec3, size: f64) -> Vec<DVec3> {
    let normal = unit(area(corners));
    corners.iter().map(|corner| as_f32(unit(normal + (*corner - center) * (0.5 / size)))).collect()
}

fn triangle(center: DVec3, size: f64, rng: &mut SplitMix64) -> [DVec3; 3] {
    loop {
        let corners = [(); 3].map(|()| rng.in_ball(center, size));
        let [a, b, c] = corners;
        let side = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        let area = area(&corners);
        if area.dot(area).sqrt() > 0.25 * side && side > 0.25 * size * size {
            return corners;
        }
    }
}

fn star(center: DVec3, size: f64, rng: &mut SplitMix64) -> Vec<DVec3> {
    let (x, y) = perpendicular_axes(rng.direction());
    let count = 3 + rng.below(7);
    let corner = |i: u32| {
        let angle = f64::from(i) * std::f64::consts::TAU / f64::from(count);
        as_f32(center + (x * libm::cos(angle) + y * libm::sin(angle)) * rng.between(0.35 * size, size))
    };
    (0..count).map(corner).collect()
}
