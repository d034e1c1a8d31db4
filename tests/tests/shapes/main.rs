//! Every shape in both cores: where it is met, from which side, and how it is left.

mod leaving;
mod oracle;
mod paper;

use strahl_tests::{Core, Found, Kind, Line, Random, Thing, Vector, double, rounded, single, vector};

/// What a ray finds of one thing alone, and where it starts that leaves the surface.
#[derive(Clone, Copy)]
struct Caster {
    cast: fn(&Thing, &[Line]) -> Vec<Option<Found>>,
    leave: fn(&Found, Vector) -> Vector,
    roundoff: f64,
    name: &'static str,
}

impl Caster {
    const fn of<C: Core>() -> Self {
        let cast = |thing: &Thing, lines: &[Line]| C::with(std::slice::from_ref(thing)).cast(lines);
        Caster { cast, leave: C::leave, roundoff: C::ROUNDOFF, name: C::NAME }
    }

    fn one(&self, thing: &Thing, line: Line) -> Option<Found> {
        (self.cast)(thing, &[line])[0]
    }
}

const SINGLE: Caster = Caster::of::<single::Stage>();
const DOUBLE: Caster = Caster::of::<double::Stage>();
const CORES: [Caster; 2] = [SINGLE, DOUBLE];

fn length(v: Vector) -> f64 {
    v.dot(v).sqrt()
}

/// The ray from one point towards another, `speed` times as fast as to reach it at one.
fn towards(origin: Vector, target: Vector, speed: f64) -> Line {
    let way = (target - origin) * speed;
    Line { origin, direction: vector(rounded(way.x), rounded(way.y), rounded(way.z)) }
}

/// A point on the thing or beside it.
fn target(thing: &Thing, random: &mut Random) -> Vector {
    let (center, radius) = thing.ball();
    let among = |corners: &[Vector], random: &mut Random| {
        let shares: Vec<f64> = corners.iter().map(|_| random.unit()).collect();
        let mix: Vector = corners.iter().zip(&shares).map(|(corner, share)| *corner * *share).sum();
        center + (mix / shares.iter().sum::<f64>() - center) * random.between(0.0, 2.5)
    };
    match thing {
        Thing::Triangle { corners } | Thing::SmoothTriangle { corners, .. } => among(corners, random),
        Thing::Polygon { corners } | Thing::SmoothPolygon { corners, .. } => among(corners, random),
        _ => random.near(center, 1.2 * radius),
    }
}

/// A ray that probably meets the thing: from up to a hundred of its sizes away or from inside,
/// of any length.
fn random_ray(thing: &Thing, random: &mut Random) -> Line {
    let (center, radius) = thing.ball();
    let origin = match random.below(4) {
        0 => random.near(center, 0.9 * radius),
        1 => random.near(center, 3.0 * radius),
        _ => {
            let away = random.direction() * (random.scale(1.2, 100.0) * radius);
            random.near(center + away, 0.1 * radius)
        }
    };
    loop {
        let target = target(thing, random);
        if length(target - origin) > 1e-3 * radius {
            return towards(origin, target, random.scale(0.01, 100.0));
        }
    }
}

/// A test for each kind.
macro_rules! for_every_kind {
    ($check:ident, $name:ident) => {
        $crate::for_every_kind! { $check, $name:
            a_sphere: Sphere,
            a_plane: Plane,
            a_disc: Disc,
            a_triangle: Triangle,
            a_smooth_triangle: SmoothTriangle,
            a_polygon: Polygon,
            a_smooth_polygon: SmoothPolygon,
            a_box: Cuboid,
            a_turned_box: OrientedCuboid,
            an_open_cone: OpenCone,
            a_capped_cone: CappedCone,
            an_open_cylinder: OpenCylinder,
            a_capped_cylinder: CappedCylinder,
            a_torus: Torus,
        }
    };
    ($check:ident, $name:ident: $($thing:ident: $Kind:ident,)*) => { $(
        mod $thing {
            #[test]
            fn $name() {
                super::$check(super::Kind::$Kind);
            }
        }
    )* };
}
use for_every_kind;
