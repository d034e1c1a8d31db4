//! Hard rays at what is round: spheres, cones and cylinders, tori.

use super::case::{Aim, Case, about_one, aside, held, length, towards};
use crate::thing::{Line, Thing};
use crate::vector::Vector;
use crate::{Random, rounded};

/// Rays at one thing.
const RAYS: usize = 50;

const fn sphere(name: &'static str, naive: &'static str, aim: Aim) -> Case {
    Case::aimed("sphere", name, naive, 4.0, 200, aim)
}

const fn cone(name: &'static str, naive: &'static str, aim: Aim) -> Case {
    Case::aimed("cone, cylinder", name, naive, 8.0, 200, aim)
}

const fn torus(name: &'static str, naive: &'static str, aim: Aim) -> Case {
    Case::aimed("torus", name, naive, 8.0, 200, aim)
}

pub(super) const CASES: [Case; 21] = [
    sphere("10 to 1e5 radii away", "`b^2 - 4ac` loses all digits", far_sphere),
    sphere("of radius 1e-6", "`b^2 - 4ac` loses all digits", tiny_sphere),
    sphere("of radius 1e6, eye just above it", "`-b + sqrt(d)` cancels", huge_sphere).easy(),
    sphere("eye inside", "a normal that is not one long", inside_sphere),
    sphere("at r (1 +- 10^-k) from the centre", "hit and miss change places", grazing_sphere),
    sphere("directions 1e-30 to 1e30 long", "squares leave the range", any_length),
    cone("ray along the axis, or nearly", "`a` is all rounding", along_axis),
    cone("as thin as a hair", "`b^2 - 4ac` loses all digits", hair),
    cone("almost a cylinder", "`a` cancels", almost_cylinder),
    cone("apex, and the nappe behind it", "the mirrored nappe is met", apex),
    cone("eye inside, open ends", "the near root is behind", inside_cone),
    cone("at the rims", "hit and miss change places", rim),
    cone("100 to 1e4 sizes away", "`b^2 - 4ac` loses all digits", far_cone),
    torus("10 to 1e4 sizes away", "the quartic's coefficients lose all digits", far_torus),
    torus("thin, r/R down to 1e-4", "roots fall together", thin_torus),
    torus("thin, along the tube", "all roots fall together", along_tube),
    torus("fat, r/R up to 1 - 1e-6", "roots fall together in the middle", fat_torus),
    torus("along the axis", "odd coefficients are all rounding", down_the_hole),
    torus("in the equatorial plane", "four roots, pairs close together", equatorial_torus),
    torus("tangent to the hole", "a double root is one, two or none", hole_torus),
    torus("eye inside the tube", "the root at the eye is met again", inside_torus),
];

fn some<T>(mut one: impl FnMut() -> T) -> Vec<T> {
    (0..RAYS).map(|_| one()).collect()
}

fn any_sphere(random: &mut Random) -> (Vector, f64) {
    let radius = random.scale(1e-3, 1e3);
    (random.near(Vector::ZERO, 10.0 * radius), radius)
}

fn far_sphere(random: &mut Random) -> (Thing, Vec<Line>) {
    let (center, radius) = any_sphere(random);
    let eye = held(center + random.direction() * (radius * random.scale(10.0, 1e5)));
    (Thing::Sphere { center, radius }, some(|| towards(eye, random.near(center, 1.3 * radius))))
}

fn tiny_sphere(random: &mut Random) -> (Thing, Vec<Line>) {
    let radius = random.between(0.5e-6, 2e-6);
    let center = random.near(Vector::ZERO, 1.0);
    let eye = held(center + random.direction() * random.scale(1e-5, 1.0));
    (Thing::Sphere { center, radius }, some(|| towards(eye, random.near(center, 1.3 * radius))))
}

fn huge_sphere(random: &mut Random) -> (Thing, Vec<Line>) {
    let radius = random.between(0.5e6, 2e6);
    let up = random.direction();
    let center = held(up * -radius);
    let height = random.scale(20.0, 1e4);
    let eye = held(up * height);
    let below = up * -height;
    (Thing::Sphere { center, radius }, some(|| towards(eye, eye + random.near(below, 20.0 * height))))
}

fn inside_sphere(random: &mut Random) -> (Thing, Vec<Line>) {
    let (center, radius) = any_sphere(random);
    let line = |random: &mut Random| Line {
        origin: random.near(center, 0.99 * radius),
        direction: held(random.direction() * random.scale(0.01, 100.0)),
    };
    (Thing::Sphere { center, radius }, some(|| line(random)))
}

fn grazing_sphere(random: &mut Random) -> (Thing, Vec<Line>) {
    let (center, radius) = any_sphere(random);
    let way = random.direction() * (radius * random.scale(1.5, 1000.0));
    let eye = held(center + way);
    let line = |random: &mut Random| {
        let impact = radius * about_one(random);
        let away = length(way);
        towards(
            eye,
            center + aside(way, random) * (impact / (1.0 - (impact / away) * (impact / away)).sqrt()),
        )
    };
    (Thing::Sphere { center, radius }, some(|| line(random)))
}

fn any_length(random: &mut Random) -> (Thing, Vec<Line>) {
    let (center, radius) = any_sphere(random);
    let eye = held(center + random.direction() * (radius * random.scale(1.5, 30.0)));
    let line = |random: &mut Random| {
        let way = random.near(center, 1.3 * radius) - eye;
        Line { origin: eye, direction: held(way / length(way) * random.scale(1e-30, 1e30)) }
    };
    (Thing::Sphere { center, radius }, some(|| line(random)))
}

/// A cone or a cylinder, and what it is made from.
struct Tube {
    base: Vector,
    /// As long as the height.
    axis: Vector,
    height: f64,
    radius: f64,
    thing: Thing,
}

fn tube(radius: f64, end_radius: f64, random: &mut Random) -> Tube {
    let scale = random.scale(1e-3, 1e3);
    let base = random.near(Vector::ZERO, 3.0 * scale);
    let end = held(base + random.direction() * scale);
    let (radius, end_radius) = (rounded(radius * scale), rounded(end_radius * scale));
    let capped = random.below(2) == 0;
    let thing = Thing::Cone { base, base_radius: radius, end, end_radius, capped };
    Tube { base, axis: end - base, height: length(end - base), radius, thing }
}

/// A cone or a cylinder of no extreme proportions.
fn any_tube(random: &mut Random) -> Tube {
    let radius = random.scale(0.1, 2.0);
    let end = [radius, 0.0, radius * random.scale(0.3, 3.0)][random.below(3) as usize];
    tube(radius, end, random)
}

fn along_axis(random: &mut Random) -> (Thing, Vec<Line>) {
    let tube = any_tube(random);
    let line = |random: &mut Random| {
        let start = tube.base - tube.axis * random.scale(0.1, 10.0);
        let origin = held(start + aside(tube.axis, random) * (1.3 * tube.radius * random.unit()));
        let lean = if random.below(4) == 0 { 0.0 } else { random.scale(1e-7, 0.1) };
        let direction = tube.axis / tube.height + aside(tube.axis, random) * lean;
        Line { origin, direction: held(direction) }
    };
    let lines = some(|| line(random));
    (tube.thing, lines)
}

/// From `away` heights at the side, and somewhat beside it.
fn at_side(tube: &Tube, near: f64, far: f64, random: &mut Random) -> Line {
    let eye =
        held(tube.base + tube.axis * 0.5 + random.direction() * (tube.height * random.scale(near, far)));
    let target = tube.base + tube.axis * random.between(-0.1, 1.1);
    towards(eye, target + random.direction() * (1.5 * tube.radius * random.unit()))
}

fn hair(random: &mut Random) -> (Thing, Vec<Line>) {
    let radius = random.scale(1e-5, 1e-2);
    let tube = tube(radius, radius, random);
    let lines = some(|| at_side(&tube, 0.6, 10.0, random));
    (tube.thing, lines)
}

fn almost_cylinder(random: &mut Random) -> (Thing, Vec<Line>) {
    let radius = random.scale(0.05, 2.0);
    let tube = tube(radius, radius * about_one(random), random);
    let lines = some(|| at_side(&tube, 1.0, 30.0, random));
    (tube.thing, lines)
}

fn apex(random: &mut Random) -> (Thing, Vec<Line>) {
    let tube = tube(random.scale(0.1, 2.0), 0.0, random);
    let line = |random: &mut Random| {
        let eye = held(tube.base + random.direction() * (tube.height * random.scale(0.3, 20.0)));
        let aside = random.direction() * (tube.radius * random.scale(1e-5, 1.0));
        towards(eye, tube.base + tube.axis * random.between(0.9, 2.0) + aside)
    };
    let lines = some(|| line(random));
    (tube.thing, lines)
}

fn inside_cone(random: &mut Random) -> (Thing, Vec<Line>) {
    let tube = any_tube(random);
    let line = |random: &mut Random| {
        let (level, out) = (random.unit(), random.unit());
        let start =
            tube.base + tube.axis * level + aside(tube.axis, random) * (tube.radius * out * (1.0 - level));
        Line { origin: held(start), direction: held(random.direction() * random.scale(0.1, 10.0)) }
    };
    let lines = some(|| line(random));
    (tube.thing, lines)
}

fn rim(random: &mut Random) -> (Thing, Vec<Line>) {
    let tube = any_tube(random);
    let line = |random: &mut Random| {
        let eye = held(tube.base + random.direction() * (tube.height * random.scale(1.0, 30.0)));
        towards(eye, tube.base + aside(tube.axis, random) * (tube.radius * about_one(random)))
    };
    let lines = some(|| line(random));
    (tube.thing, lines)
}

fn far_cone(random: &mut Random) -> (Thing, Vec<Line>) {
    let tube = any_tube(random);
    let lines = some(|| at_side(&tube, 100.0, 1e4, random));
    (tube.thing, lines)
}

/// A torus of some proportions, and rays at its tube.
struct Ring {
    center: Vector,
    axis: Vector,
    major: f64,
    minor: f64,
}

impl Ring {
    fn new(proportion: f64, random: &mut Random) -> Ring {
        let major = random.scale(1e-2, 1e2);
        let (center, axis) = (random.near(Vector::ZERO, 3.0 * major), random.direction());
        let minor = rounded(major * proportion);
        Ring { center, axis, major, minor: if minor < major { minor } else { major } }
    }

    fn any(random: &mut Random) -> Ring {
        let proportion = random.scale(0.1, 0.9);
        Ring::new(proportion, random)
    }

    fn thing(&self) -> Thing {
        Thing::Torus { center: self.center, axis: self.axis, major: self.major, minor: self.minor }
    }

    /// A point of the tube, or somewhat beside it.
    fn in_tube(&self, random: &mut Random) -> Vector {
        let middle = self.center + aside(self.axis, random) * self.major;
        random.near(middle, 1.2 * self.minor)
    }

    fn at_tube(&self, near: f64, far: f64, random: &mut Random) -> Line {
        let size = self.major + self.minor;
        let eye = held(self.center + random.direction() * (size * random.scale(near, far)));
        towards(eye, self.in_tube(random))
    }
}

fn far_torus(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = Ring::any(random);
    (ring.thing(), some(|| ring.at_tube(10.0, 1e4, random)))
}

fn thin_torus(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = Ring::new(random.scale(1e-4, 1e-2), random);
    (ring.thing(), some(|| ring.at_tube(0.2, 3.0, random)))
}

fn along_tube(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = Ring::new(random.scale(1e-4, 1e-2), random);
    let line = |random: &mut Random| {
        let out = aside(ring.axis, random);
        let along = ring.axis.cross(out) / length(ring.axis);
        let target = random.near(ring.center + out * ring.major, ring.minor);
        let lean = if random.below(3) == 0 { 0.0 } else { random.scale(1e-6, 0.1) };
        let way = along + random.direction() * lean;
        towards(held(target - way * (ring.major * random.scale(0.5, 3.0))), target)
    };
    (ring.thing(), some(|| line(random)))
}

fn fat_torus(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = Ring::new(1.0 - random.scale(1e-6, 0.1), random);
    (ring.thing(), some(|| ring.at_tube(1.1, 30.0, random)))
}

fn down_the_hole(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = Ring::any(random);
    let line = |random: &mut Random| {
        let out = (ring.major + ring.minor) * 1.1 * random.unit();
        let start = ring.center + aside(ring.axis, random) * out;
        let lean = if random.below(3) == 0 { 0.0 } else { random.scale(1e-7, 0.1) };
        let direction = held(-ring.axis + random.direction() * lean);
        Line { origin: held(start + ring.axis * (ring.major * random.scale(1.0, 30.0))), direction }
    };
    (ring.thing(), some(|| line(random)))
}

/// Upright on a coordinate axis, so that the plane is hit exactly; and as it comes.
fn flat_ring(random: &mut Random) -> Ring {
    let ring = Ring::any(random);
    let axis = [Vector::X, Vector::Y, Vector::Z, ring.axis][random.below(4) as usize];
    Ring { axis, ..ring }
}

fn equatorial_torus(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = flat_ring(random);
    let line = |random: &mut Random| {
        let eye = held(ring.center + aside(ring.axis, random) * (ring.major * random.scale(0.1, 10.0)));
        let direction = aside(ring.axis, random);
        Line { origin: eye, direction: held(direction) }
    };
    (ring.thing(), some(|| line(random)))
}

fn hole_torus(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = flat_ring(random);
    let line = |random: &mut Random| {
        let out = aside(ring.axis, random);
        let closest = ring.center + out * ((ring.major - ring.minor) * about_one(random));
        let along = ring.axis.cross(out) / length(ring.axis);
        towards(held(closest - along * (ring.major * random.scale(2.0, 20.0))), closest)
    };
    (ring.thing(), some(|| line(random)))
}

fn inside_torus(random: &mut Random) -> (Thing, Vec<Line>) {
    let ring = Ring::any(random);
    let line = |random: &mut Random| {
        let middle = ring.center + aside(ring.axis, random) * ring.major;
        let origin = random.near(middle, 0.95 * ring.minor);
        Line { origin, direction: held(random.direction() * random.scale(0.1, 10.0)) }
    };
    (ring.thing(), some(|| line(random)))
}
