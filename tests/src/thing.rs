//! Things and lines: shapes and rays in numbers that both cores hold exactly.

use crate::random::{Random, rounded};
use crate::vector::{Vector, area, unit, upright, vector};

/// A ray. Its direction may have any length.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Where it starts.
    pub origin: Vector,
    /// Where it goes.
    pub direction: Vector,
}

impl Line {
    /// The point `t` lengths of the direction away.
    pub fn at(&self, t: f64) -> Vector {
        self.origin + self.direction * t
    }
}

/// A shape. Directions may have any length: each core makes them one long, as well as it can.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // as in the core's own shapes
pub enum Thing {
    Sphere { center: Vector, radius: f64 },
    Plane { point: Vector, normal: Vector },
    Disc { center: Vector, normal: Vector, radius: f64 },
    Triangle { corners: [Vector; 3] },
    SmoothTriangle { corners: [Vector; 3], normals: [Vector; 3] },
    Polygon { corners: Vec<Vector> },
    SmoothPolygon { corners: Vec<Vector>, normals: Vec<Vector> },
    Cuboid { min: Vector, max: Vector },
    OrientedCuboid { center: Vector, half: Vector, first: Vector, third: Vector },
    Cone { base: Vector, base_radius: f64, end: Vector, end_radius: f64, capped: bool },
    Torus { center: Vector, axis: Vector, major: f64, minor: f64 },
}

/// What random things are made like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Kind {
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

impl Kind {
    /// Every kind.
    pub const ALL: [Kind; 14] = [
        Kind::Sphere,
        Kind::Plane,
        Kind::Disc,
        Kind::Triangle,
        Kind::SmoothTriangle,
        Kind::Polygon,
        Kind::SmoothPolygon,
        Kind::Cuboid,
        Kind::OrientedCuboid,
        Kind::OpenCone,
        Kind::CappedCone,
        Kind::OpenCylinder,
        Kind::CappedCylinder,
        Kind::Torus,
    ];
}

/// Each component rounded to what `f32` holds.
fn held(v: Vector) -> Vector {
    vector(rounded(v.x), rounded(v.y), rounded(v.z))
}

impl Thing {
    /// A random thing about `size` large, about at `place`.
    ///
    /// No proportions in it are extreme: of three to one, and angles not below some 15 degrees.
    pub fn random(kind: Kind, place: Vector, size: f64, random: &mut Random) -> Thing {
        let r = random;
        let center = r.near(place, 0.1 * size);
        let length = |r: &mut Random| r.between(0.35 * size, size);
        match kind {
            Kind::Sphere => Thing::Sphere { center, radius: length(r) },
            Kind::Plane => Thing::Plane { point: center, normal: r.direction() },
            Kind::Disc => Thing::Disc { center, normal: r.direction(), radius: length(r) },
            Kind::Triangle => Thing::Triangle { corners: triangle(center, size, r) },
            Kind::SmoothTriangle => {
                let corners = triangle(center, size, r);
                let normals = bent(&corners, center, size);
                Thing::SmoothTriangle { corners, normals: [normals[0], normals[1], normals[2]] }
            }
            Kind::Polygon => Thing::Polygon { corners: star(center, size, r) },
            Kind::SmoothPolygon => {
                let corners = star(center, size, r);
                Thing::SmoothPolygon { normals: bent(&corners, center, size), corners }
            }
            Kind::Cuboid => {
                let half = vector(length(r), length(r), length(r));
                Thing::Cuboid { min: held(center - half), max: held(center + half) }
            }
            Kind::OrientedCuboid => {
                let third = r.direction();
                let first = loop {
                    let first = r.direction();
                    if first.dot(third).abs() < 0.8 {
                        break first;
                    }
                };
                let half = vector(length(r), length(r), length(r));
                Thing::OrientedCuboid { center, half, first, third }
            }
            Kind::OpenCone | Kind::CappedCone => {
                let capped = kind == Kind::CappedCone;
                let end = held(center + r.direction() * length(r));
                // Every fourth comes to a point, at one of both ends.
                let (base_radius, end_radius) = match r.below(8) {
                    0 => (0.0, length(r)),
                    1 => (length(r), 0.0),
                    _ => (length(r), length(r)),
                };
                Thing::Cone { base: center, base_radius, end, end_radius, capped }
            }
            Kind::OpenCylinder | Kind::CappedCylinder => {
                let capped = kind == Kind::CappedCylinder;
                let end = held(center + r.direction() * length(r));
                let radius = length(r);
                Thing::Cone { base: center, base_radius: radius, end, end_radius: radius, capped }
            }
            Kind::Torus => {
                let major = length(r);
                Thing::Torus {
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
        map: impl Fn(Vector) -> Vector,
        turn: impl Fn(Vector) -> Vector,
        scale: f64,
    ) -> Thing {
        let points = |points: &[Vector]| points.iter().map(|p| map(*p)).collect();
        match self {
            Thing::Sphere { center, radius } => {
                Thing::Sphere { center: map(*center), radius: radius * scale }
            }
            Thing::Plane { point, normal } => Thing::Plane { point: map(*point), normal: turn(*normal) },
            Thing::Disc { center, normal, radius } => {
                Thing::Disc { center: map(*center), normal: turn(*normal), radius: radius * scale }
            }
            Thing::Triangle { corners } => Thing::Triangle { corners: corners.map(map) },
            Thing::SmoothTriangle { corners, normals } => {
                Thing::SmoothTriangle { corners: corners.map(map), normals: normals.map(turn) }
            }
            Thing::Polygon { corners } => Thing::Polygon { corners: points(corners) },
            Thing::SmoothPolygon { corners, normals } => Thing::SmoothPolygon {
                corners: points(corners),
                normals: normals.iter().map(|n| turn(*n)).collect(),
            },
            Thing::Cuboid { min, max } => {
                let (a, b) = (map(*min), map(*max));
                Thing::Cuboid { min: a.min(b), max: a.max(b) }
            }
            Thing::OrientedCuboid { center, half, first, third } => Thing::OrientedCuboid {
                center: map(*center),
                half: *half * scale,
                first: turn(*first),
                third: turn(*third),
            },
            Thing::Cone { base, base_radius, end, end_radius, capped } => Thing::Cone {
                base: map(*base),
                base_radius: base_radius * scale,
                end: map(*end),
                end_radius: end_radius * scale,
                capped: *capped,
            },
            Thing::Torus { center, axis, major, minor } => Thing::Torus {
                center: map(*center),
                axis: turn(*axis),
                major: major * scale,
                minor: minor * scale,
            },
        }
    }

    /// A ball round the thing, not much larger than needed; round a part of a plane.
    pub fn ball(&self) -> (Vector, f64) {
        let round = |corners: &[Vector]| {
            let middle = corners.iter().sum::<Vector>() / corners.len() as f64;
            let reach = corners.iter().map(|c| (*c - middle).dot(*c - middle)).fold(0.0, f64::max);
            (middle, reach.sqrt())
        };
        match self {
            Thing::Sphere { center, radius } | Thing::Disc { center, radius, .. } => (*center, *radius),
            Thing::Plane { point, .. } => (*point, 1.0),
            Thing::Triangle { corners } | Thing::SmoothTriangle { corners, .. } => round(corners),
            Thing::Polygon { corners } | Thing::SmoothPolygon { corners, .. } => round(corners),
            Thing::Cuboid { min, max } => round(&[*min, *max]),
            Thing::OrientedCuboid { center, half, .. } => (*center, half.dot(*half).sqrt()),
            Thing::Cone { base, base_radius, end, end_radius, .. } => {
                let (middle, half) = round(&[*base, *end]);
                (middle, half + base_radius.max(*end_radius))
            }
            Thing::Torus { center, major, minor, .. } => (*center, major + minor),
        }
    }
}

/// Normals of corners that lean away from the middle, so that the flat thing looks like a cap.
fn bent(corners: &[Vector], center: Vector, size: f64) -> Vec<Vector> {
    let normal = unit(area(corners));
    corners.iter().map(|corner| held(unit(normal + (*corner - center) * (0.5 / size)))).collect()
}

fn triangle(center: Vector, size: f64, random: &mut Random) -> [Vector; 3] {
    loop {
        let corners = [(); 3].map(|()| random.near(center, size));
        let [a, b, c] = corners;
        let side = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        let area = area(&corners);
        if area.dot(area).sqrt() > 0.25 * side && side > 0.25 * size * size {
            return corners;
        }
    }
}

fn star(center: Vector, size: f64, random: &mut Random) -> Vec<Vector> {
    let (x, y) = upright(random.direction());
    let count = 3 + random.below(7);
    let corner = |i: u32| {
        let angle = f64::from(i) * std::f64::consts::TAU / f64::from(count);
        held(center + (x * libm::cos(angle) + y * libm::sin(angle)) * random.between(0.35 * size, size))
    };
    (0..count).map(corner).collect()
}
