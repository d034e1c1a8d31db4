//! Ordinary rays, to measure what the remedies cost where nothing is hard.

use super::{Line, Solver, Thing, Vector, held, towards};
use crate::textbook::Form;
use crate::{Kind, Random};

/// Rays, ready to be answered again and again.
pub struct Work {
    /// How many rays one run answers.
    pub rays: usize,
    run: Box<dyn Fn() -> f64>,
}

impl Work {
    pub(super) fn new(rays: usize, run: impl Fn() -> f64 + 'static) -> Work {
        Work { rays, run: Box::new(run) }
    }

    /// Answers every ray once; the sum of the distances, so that none can be left out.
    pub fn run(&self) -> f64 {
        (self.run)()
    }
}

pub(super) const FAMILIES: [(&str, Kind); 10] = [
    ("sphere", Kind::Sphere),
    ("cylinder, open", Kind::OpenCylinder),
    ("cone, capped", Kind::CappedCone),
    ("torus", Kind::Torus),
    ("triangle", Kind::Triangle),
    ("polygon", Kind::Polygon),
    ("plane", Kind::Plane),
    ("disc", Kind::Disc),
    ("box", Kind::Cuboid),
    ("turned box", Kind::TurnedCuboid),
];

/// Things of ordinary proportions, and rays from a few sizes away of which about half meet them.
pub(super) fn scenes(kind: Kind) -> Vec<(Thing, Vec<Line>)> {
    let mut random = Random::new(0x5eed_0007);
    let scene = |random: &mut Random| {
        let place = random.near(Vector::ZERO, 5.0);
        let thing = Thing::random(kind, place, 1.0, random);
        let line = |random: &mut Random| {
            let eye = held(place + random.direction() * random.between(2.0, 20.0));
            towards(eye, random.near(place, 1.2))
        };
        (thing, (0..40).map(|_| line(random)).collect())
    };
    (0..25).map(|_| scene(&mut random)).collect()
}

/// The families, and the work of each solver for each.
pub fn works() -> Vec<(&'static str, [Work; 3])> {
    let works = |(family, kind): (&'static str, Kind)| {
        let scenes = scenes(kind);
        let rays = scenes.iter().map(|(_, lines)| lines.len()).sum();
        let works = Solver::ALL.map(|solver| {
            let run: Box<dyn Fn() -> f64> = match solver {
                Solver::Textbook => textbook(&scenes),
                Solver::Single => in_single::work(kind, &scenes),
                Solver::Double => in_double::work(kind, &scenes),
            };
            Work { rays, run }
        });
        (family, works)
    };
    FAMILIES.into_iter().map(works).collect()
}

fn textbook(scenes: &[(Thing, Vec<Line>)]) -> Box<dyn Fn() -> f64> {
    let narrow = |v: Vector| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let ray = |line: &Line| (narrow(line.origin), narrow(line.direction));
    let prepared: Vec<(Form, Vec<_>)> =
        scenes.iter().map(|(thing, lines)| (Form::of(thing), lines.iter().map(ray).collect())).collect();
    Box::new(move || {
        let of = |(form, rays): &(Form, Vec<(strahl_core::Vec3, strahl_core::Vec3)>)| -> f64 {
            rays.iter().filter_map(|(o, d)| form.distance(*o, *d)).map(f64::from).sum()
        };
        prepared.iter().map(of).sum()
    })
}

/// A core that knows one kind of shapes alone, so that no choice between kinds is counted.
macro_rules! core {
    ($room:ident, $core:ident, $stage:path) => {
        mod $room {
            use $core::{Ray, ShapeKind, ShapeSet, Shapes, vec3};

            use $stage as Stage;

            use crate::cast::Core;
            use crate::thing::{Kind, Line, Thing, Vector};

            macro_rules! only {
                ($kind:ident) => {{
                    struct Only;
                    impl Shapes for Only {
                        const SHAPES: ShapeSet = ShapeSet::of(&[ShapeKind::$kind]);
                        const SMOOTH: bool = false;
                    }
                    answer::<Only>
                }};
            }

            #[allow(clippy::useless_conversion)] // in the twin
            fn answer<S: Shapes>(prepared: &[(Stage, Vec<Ray>)]) -> f64 {
                let of = |(stage, rays): &(Stage, Vec<Ray>)| -> f64 {
                    let geometry = stage.parts().geometry;
                    let shape = geometry.shapes[0];
                    let distance = |ray| geometry.distance::<S>(&shape, ray).map(f64::from);
                    rays.iter().filter_map(distance).sum()
                };
                prepared.iter().map(of).sum()
            }

            pub fn work(kind: Kind, scenes: &[(Thing, Vec<Line>)]) -> Box<dyn Fn() -> f64> {
                let narrow = |v: Vector| vec3(v.x as _, v.y as _, v.z as _);
                let ray = |line: &Line| Ray::new(narrow(line.origin), narrow(line.direction));
                let stage = |thing: &Thing| Stage::with(std::slice::from_ref(thing));
                let prepared: Vec<(Stage, Vec<Ray>)> = scenes
                    .iter()
                    .map(|(thing, lines)| (stage(thing), lines.iter().map(ray).collect()))
                    .collect();
                let answer = match kind {
                    Kind::Sphere => only!(Sphere),
                    Kind::OpenCylinder | Kind::CappedCone => only!(Cone),
                    Kind::Torus => only!(Torus),
                    Kind::Triangle => only!(Triangle),
                    Kind::Polygon => only!(Polygon),
                    Kind::Plane => only!(Plane),
                    Kind::Disc => only!(Disc),
                    Kind::Cuboid => only!(Cuboid),
                    Kind::TurnedCuboid => only!(TurnedCuboid),
                    other => unreachable!("{other:?} is not measured"),
                };
                Box::new(move || answer(&prepared))
            }
        }
    };
}

core!(in_single, strahl_core, crate::single::Stage);
core!(in_double, strahl_core_double, crate::double::Stage);
