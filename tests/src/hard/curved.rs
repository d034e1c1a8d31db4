//! Hard rays at curved shapes: spheres, cones and cylinders, tori.

use super::case::{AimFunction, HardCase, about_one, as_f32, length, perpendicular, towards};
use strahl_test_scene::{DVec3, SplitMix64, TestRay, TestShape, rounded};

/// Rays at each shape.
const RAYS: usize = 50;

const fn sphere(name: &'static str, naive: &'static str, aim: AimFunction) -> HardCase {
    HardCase::aimed("sphere", name, naive, 4.0, 200, aim)
}

const fn cone(name: &'static str, naive: &'static str, aim: AimFunction) -> HardCase {
    HardCase::aimed("cone, cylinder", name, naive, 8.0, 200, aim)
}

const fn torus(name: &'static str, naive: &'static str, aim: AimFunction) -> HardCase {
    HardCase::aimed("torus", name, naive, 8.0, 200, aim)
}

pub(super) const CASES: [HardCase; 21] = [
    sphere("10 to 1e5 radii away", "`b^2 - 4ac` loses all digits", far_sphere),
    sphere("of radius 1e-6", "`b^2 - 4ac` loses all digits", tiny_sphere),
    sphere("of radius 1e6, eye just above it", "`-b + sqrt(d)` cancels", huge_sphere).easy(),
    sphere("eye inside", "a normal that is not of unit length", inside_sphere),
    sphere("at r (1 +- 10^-k) from the center", "hit and miss are swapped", grazing_sphere)
        .seed(0xa321_c46d_086c_514c),
    sphere("directions 1e-30 to 1e30 long", "squares leave the range", any_length),
    cone("ray along the axis, or nearly", "`a` is only rounding error", along_axis),
    cone("as thin as a hair", "`b^2 - 4ac` loses all digits", hair),
    cone("almost a cylinder", "`a` cancels", almost_cylinder),
    cone("apex, and the nappe behind it", "the second nappe is hit", apex),
    cone("eye inside, open ends", "the near root is behind", inside_cone),
    cone("at the end circles", "hit and miss are swapped", end_circle).seed(0x4e2a_913b_62f8_a877),
    cone("100 to 1e4 sizes away", "`b^2 - 4ac` loses all digits", far_cone),
    torus("10 to 1e4 sizes away", "the quartic's coefficients lose all digits", far_torus),
    torus("thin, r/R down to 1e-4", "roots coincide", thin_torus),
    torus("thin, along the tube", "all roots coincide", along_tube),
    torus("fat, r/R up to 1 - 1e-6", "roots coincide near the center", fat_torus),
    torus("along the axis", "odd coefficients are only rounding errors", through_hole),
    torus("in the equatorial plane", "four roots, pairs close together", equatorial_torus),
    torus("tangent to the hole", "a double root is one, two or none", hole_torus),
    torus("eye inside the tube", "the root at the eye is found again", inside_torus),
];

fn rays<T>(mut one: impl FnMut() -> T) -> Vec<T> {
    (0..RAYS).map(|_| one()).collect()
}

fn any_sphere(rng: &mut SplitMix64) -> (DVec3, f64) {
    let radius = rng.log_between(1e-3, 1e3);
    (rng.in_ball(DVec3::ZERO, 10.0 * radius), radius)
}

fn far_sphere(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (center, radius) = any_sphere(rng);
    let viewpoint = as_f32(center + rng.direction() * (radius * rng.log_between(10.0, 1e5)));
    (TestShape::Sphere { center, radius }, rays(|| towards(viewpoint, rng.in_ball(center, 1.3 * radius))))
}

fn tiny_sphere(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let radius = rng.between(0.5e-6, 2e-6);
    let center = rng.in_ball(DVec3::ZERO, 1.0);
    let viewpoint = as_f32(center + rng.direction() * rng.log_between(1e-5, 1.0));
    (TestShape::Sphere { center, radius }, rays(|| towards(viewpoint, rng.in_ball(center, 1.3 * radius))))
}

fn huge_sphere(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let radius = rng.between(0.5e6, 2e6);
    let up = rng.direction();
    let center = as_f32(up * -radius);
    let height = rng.log_between(20.0, 1e4);
    let viewpoint = as_f32(up * height);
    let below = up * -height;
    (
        TestShape::Sphere { center, radius },
        rays(|| towards(viewpoint, viewpoint + rng.in_ball(below, 20.0 * height))),
    )
}

fn inside_sphere(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (center, radius) = any_sphere(rng);
    let ray = |rng: &mut SplitMix64| TestRay {
        origin: rng.in_ball(center, 0.99 * radius),
        direction: as_f32(rng.direction() * rng.log_between(0.01, 100.0)),
    };
    (TestShape::Sphere { center, radius }, rays(|| ray(rng)))
}

fn grazing_sphere(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (center, radius) = any_sphere(rng);
    let offset = rng.direction() * (radius * rng.log_between(1.5, 1000.0));
    let viewpoint = as_f32(center + offset);
    let ray = |rng: &mut SplitMix64| {
        let impact = radius * about_one(rng);
        let away = length(offset);
        towards(
            viewpoint,
            center + perpendicular(offset, rng) * (impact / (1.0 - (impact / away) * (impact / away)).sqrt()),
        )
    };
    (TestShape::Sphere { center, radius }, rays(|| ray(rng)))
}

fn any_length(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let (center, radius) = any_sphere(rng);
    let viewpoint = as_f32(center + rng.direction() * (radius * rng.log_between(1.5, 30.0)));
    let ray = |rng: &mut SplitMix64| {
        let direction = rng.in_ball(center, 1.3 * radius) - viewpoint;
        TestRay {
            origin: viewpoint,
            direction: as_f32(direction / length(direction) * rng.log_between(1e-30, 1e30)),
        }
    };
    (TestShape::Sphere { center, radius }, rays(|| ray(rng)))
}

/// A cone or a cylinder, and its parameters.
struct Tube {
    base: DVec3,
    /// From the base to the end, not normalized.
    axis: DVec3,
    height: f64,
    radius: f64,
    shape: TestShape,
}

fn tube(radius: f64, end_radius: f64, rng: &mut SplitMix64) -> Tube {
    let scale = rng.log_between(1e-3, 1e3);
    let base = rng.in_ball(DVec3::ZERO, 3.0 * scale);
    let end = as_f32(base + rng.direction() * scale);
    let (radius, end_radius) = (rounded(radius * scale), rounded(end_radius * scale));
    let capped = rng.below(2) == 0;
    let shape = TestShape::Cone { base, base_radius: radius, end, end_radius, capped };
    Tube { base, axis: end - base, height: length(end - base), radius, shape }
}

/// A cone or a cylinder without extreme proportions.
fn any_tube(rng: &mut SplitMix64) -> Tube {
    let radius = rng.log_between(0.1, 2.0);
    let end = [radius, 0.0, radius * rng.log_between(0.3, 3.0)][rng.below(3) as usize];
    tube(radius, end, rng)
}

fn along_axis(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let tube = any_tube(rng);
    let ray = |rng: &mut SplitMix64| {
        let start = tube.base - tube.axis * rng.log_between(0.1, 10.0);
        let origin = as_f32(start + perpendicular(tube.axis, rng) * (1.3 * tube.radius * rng.unit()));
        let lean = if rng.below(4) == 0 { 0.0 } else { rng.log_between(1e-7, 0.1) };
        let direction = tube.axis / tube.height + perpendicular(tube.axis, rng) * lean;
        TestRay { origin, direction: as_f32(direction) }
    };
    let rays = rays(|| ray(rng));
    (tube.shape, rays)
}

/// A ray from `near` to `far` heights away, at the side or slightly beside it.
fn at_side(tube: &Tube, near: f64, far: f64, rng: &mut SplitMix64) -> TestRay {
    let viewpoint =
        as_f32(tube.base + tube.axis * 0.5 + rng.direction() * (tube.height * rng.log_between(near, far)));
    let target = tube.base + tube.axis * rng.between(-0.1, 1.1);
    towards(viewpoint, target + rng.direction() * (1.5 * tube.radius * rng.unit()))
}

fn hair(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let radius = rng.log_between(1e-5, 1e-2);
    let tube = tube(radius, radius, rng);
    let rays = rays(|| at_side(&tube, 0.6, 10.0, rng));
    (tube.shape, rays)
}

fn almost_cylinder(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let radius = rng.log_between(0.05, 2.0);
    let tube = tube(radius, radius * about_one(rng), rng);
    let rays = rays(|| at_side(&tube, 1.0, 30.0, rng));
    (tube.shape, rays)
}

fn apex(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let tube = tube(rng.log_between(0.1, 2.0), 0.0, rng);
    let ray = |rng: &mut SplitMix64| {
        let viewpoint = as_f32(tube.base + rng.direction() * (tube.height * rng.log_between(0.3, 20.0)));
        let perpendicular = rng.direction() * (tube.radius * rng.log_between(1e-5, 1.0));
        towards(viewpoint, tube.base + tube.axis * rng.between(0.9, 2.0) + perpendicular)
    };
    let rays = rays(|| ray(rng));
    (tube.shape, rays)
}

fn inside_cone(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let tube = any_tube(rng);
    let ray = |rng: &mut SplitMix64| {
        let (level, out) = (rng.unit(), rng.unit());
        let start = tube.base
            + tube.axis * level
            + perpendicular(tube.axis, rng) * (tube.radius * out * (1.0 - level));
        TestRay { origin: as_f32(start), direction: as_f32(rng.direction() * rng.log_between(0.1, 10.0)) }
    };
    let rays = rays(|| ray(rng));
    (tube.shape, rays)
}

fn end_circle(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let tube = any_tube(rng);
    let ray = |rng: &mut SplitMix64| {
        let viewpoint = as_f32(tube.base + rng.direction() * (tube.height * rng.log_between(1.0, 30.0)));
        towards(viewpoint, tube.base + perpendicular(tube.axis, rng) * (tube.radius * about_one(rng)))
    };
    let rays = rays(|| ray(rng));
    (tube.shape, rays)
}

fn far_cone(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let tube = any_tube(rng);
    let rays = rays(|| at_side(&tube, 100.0, 1e4, rng));
    (tube.shape, rays)
}

/// Parameters of a torus.
struct Ring {
    center: DVec3,
    axis: DVec3,
    major: f64,
    minor: f64,
}

impl Ring {
    fn new(proportion: f64, rng: &mut SplitMix64) -> Ring {
        let major = rng.log_between(1e-2, 1e2);
        let (center, axis) = (rng.in_ball(DVec3::ZERO, 3.0 * major), rng.direction());
        let minor = rounded(major * proportion);
        Ring { center, axis, major, minor: if minor < major { minor } else { major } }
    }

    fn any(rng: &mut SplitMix64) -> Ring {
        let proportion = rng.log_between(0.1, 0.9);
        Ring::new(proportion, rng)
    }

    fn shape(&self) -> TestShape {
        TestShape::Torus { center: self.center, axis: self.axis, major: self.major, minor: self.minor }
    }

    /// A point of the tube, or slightly beside it.
    fn in_tube(&self, rng: &mut SplitMix64) -> DVec3 {
        let ring_point = self.center + perpendicular(self.axis, rng) * self.major;
        rng.in_ball(ring_point, 1.2 * self.minor)
    }

    fn at_tube(&self, near: f64, far: f64, rng: &mut SplitMix64) -> TestRay {
        let size = self.major + self.minor;
        let viewpoint = as_f32(self.center + rng.direction() * (size * rng.log_between(near, far)));
        towards(viewpoint, self.in_tube(rng))
    }
}

fn far_torus(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = Ring::any(rng);
    (ring.shape(), rays(|| ring.at_tube(10.0, 1e4, rng)))
}

fn thin_torus(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = Ring::new(rng.log_between(1e-4, 1e-2), rng);
    (ring.shape(), rays(|| ring.at_tube(0.2, 3.0, rng)))
}

fn along_tube(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = Ring::new(rng.log_between(1e-4, 1e-2), rng);
    let ray = |rng: &mut SplitMix64| {
        let out = perpendicular(ring.axis, rng);
        let along = ring.axis.cross(out) / length(ring.axis);
        let target = rng.in_ball(ring.center + out * ring.major, ring.minor);
        let lean = if rng.below(3) == 0 { 0.0 } else { rng.log_between(1e-6, 0.1) };
        let direction = along + rng.direction() * lean;
        towards(as_f32(target - direction * (ring.major * rng.log_between(0.5, 3.0))), target)
    };
    (ring.shape(), rays(|| ray(rng)))
}

fn fat_torus(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = Ring::new(1.0 - rng.log_between(1e-6, 0.1), rng);
    (ring.shape(), rays(|| ring.at_tube(1.1, 30.0, rng)))
}

fn through_hole(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = Ring::any(rng);
    let ray = |rng: &mut SplitMix64| {
        let out = (ring.major + ring.minor) * 1.1 * rng.unit();
        let start = ring.center + perpendicular(ring.axis, rng) * out;
        let lean = if rng.below(3) == 0 { 0.0 } else { rng.log_between(1e-7, 0.1) };
        let direction = as_f32(-ring.axis + rng.direction() * lean);
        TestRay { origin: as_f32(start + ring.axis * (ring.major * rng.log_between(1.0, 30.0))), direction }
    };
    (ring.shape(), rays(|| ray(rng)))
}

/// Along a coordinate axis, so that the plane is hit exactly, or along a random axis.
fn flat_ring(rng: &mut SplitMix64) -> Ring {
    let ring = Ring::any(rng);
    let axis = [DVec3::X, DVec3::Y, DVec3::Z, ring.axis][rng.below(4) as usize];
    Ring { axis, ..ring }
}

fn equatorial_torus(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = flat_ring(rng);
    let ray = |rng: &mut SplitMix64| {
        let viewpoint =
            as_f32(ring.center + perpendicular(ring.axis, rng) * (ring.major * rng.log_between(0.1, 10.0)));
        let direction = perpendicular(ring.axis, rng);
        TestRay { origin: viewpoint, direction: as_f32(direction) }
    };
    (ring.shape(), rays(|| ray(rng)))
}

fn hole_torus(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = flat_ring(rng);
    let ray = |rng: &mut SplitMix64| {
        let out = perpendicular(ring.axis, rng);
        let closest = ring.center + out * ((ring.major - ring.minor) * about_one(rng));
        let along = ring.axis.cross(out) / length(ring.axis);
        towards(as_f32(closest - along * (ring.major * rng.log_between(2.0, 20.0))), closest)
    };
    (ring.shape(), rays(|| ray(rng)))
}

fn inside_torus(rng: &mut SplitMix64) -> (TestShape, Vec<TestRay>) {
    let ring = Ring::any(rng);
    let ray = |rng: &mut SplitMix64| {
        let ring_point = ring.center + perpendicular(ring.axis, rng) * ring.major;
        let origin = rng.in_ball(ring_point, 0.95 * ring.minor);
        TestRay { origin, direction: as_f32(rng.direction() * rng.log_between(0.1, 10.0)) }
    };
    (ring.shape(), rays(|| ray(rng)))
}
