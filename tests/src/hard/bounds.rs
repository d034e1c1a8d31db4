//! Hard rays at bounding boxes, compared with exact integer arithmetic. The slab test must hit every box that
//! the exact ray hits, and no box outside the band of rounding errors.

use super::case::{HardCase, HardCaseTally, Solver};
use crate::textbook;
use strahl_test_scene::{SplitMix64, TestRay, dvec3};

const fn case(
    name: &'static str,
    naive: &'static str,
    evaluate: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own("slab test", name, naive, 0.0, evaluate)
}

pub(super) const CASES: [HardCase; 4] = [
    case("components 0 and -0, origin in a slab plane", "0 times infinity decides", |rng| {
        evaluated(zeros, rng)
    })
    .seed(0xbc09_224d_5b92_4b30),
    case("through corners and along edges", "the far end comes before the near one", |rng| {
        evaluated(corners, rng)
    }),
    case("plates of 0 to 4 ulps", "the far end comes before the near one", |rng| evaluated(plates, rng)),
    case("origin inside, on a face, behind", "`0 < near` excludes the origin", |rng| evaluated(inside, rng))
        .easy()
        .seed(0x9880_4d99_90e5_6d7a),
];

/// Generates a box and a ray in integers that are exact in `f32`.
type IntegerAim = fn(&mut SplitMix64) -> IntegerCase;

#[derive(Clone, Copy)]
struct IntegerCase {
    min: [i64; 3],
    max: [i64; 3],
    origin: [i64; 3],
    direction: [i64; 3],
    /// Sign of the zero components of the direction.
    negative: [bool; 3],
}

/// A box and a ray of the core, and the exact answer.
struct SlabCase {
    aabb: strahl_core::geometry::Aabb,
    ray: TestRay,
    is_hit: bool,
    is_near: bool,
}

impl SlabCase {
    /// Whether the answer is wrong: a miss of a box that the exact ray hits, or a hit of a box that it misses
    /// by more than the band.
    fn is_wrong(&self, answer: bool) -> bool {
        if self.is_hit { !answer } else { answer && !self.is_near }
    }
}

const RAYS: usize = 10_000;

fn evaluated(aim: IntegerAim, rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..RAYS {
        let case = aim(rng).slab_case();
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            tally.rays += 1;
            tally.unclear += usize::from(!case.is_hit && case.is_near);
            tally.faults += usize::from(case.is_wrong(answer(solver, &case)));
        }
    }
    tallies
}

fn answer(solver: Solver, case: &SlabCase) -> bool {
    let TestRay { origin, direction } = case.ray;
    let narrow = |v: strahl_test_scene::DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    match solver {
        Solver::Textbook => textbook::slabs(case.aabb.min, case.aabb.max, narrow(origin), narrow(direction)),
        Solver::Single => {
            case.aabb.intersect(&strahl_core::geometry::Ray::new(narrow(origin), narrow(direction))).is_some()
        }
        Solver::Double => {
            let wide = |v: strahl_core::Vec3| dvec3(v.x.into(), v.y.into(), v.z.into());
            let aabb =
                strahl_core_double::geometry::Aabb { min: wide(case.aabb.min), max: wide(case.aabb.max) };
            aabb.intersect(&strahl_core_double::geometry::Ray::new(origin, direction)).is_some()
        }
    }
}

/// A rational number: numerator and positive denominator.
#[derive(Clone, Copy)]
struct Rational(i128, i128);

impl Rational {
    fn is_greater(self, other: Rational) -> bool {
        self.0 * other.1 > other.0 * self.1
    }
}

impl IntegerCase {
    /// Whether the ray hits the closed box, grown by `by` on each side.
    fn is_hit(&self, by: i64) -> bool {
        let (mut entry, mut exit) = (Rational(0, 1), None::<Rational>);
        for axis in 0..3 {
            let o = self.origin[axis];
            let (low, high) = (self.min[axis] - by - o, self.max[axis] + by - o);
            let d = self.direction[axis];
            if d == 0 {
                if low > 0 || high < 0 {
                    return false;
                }
                continue;
            }
            let (near, far) = if d > 0 { (low, high) } else { (-high, -low) };
            let (near, far) = (Rational(near.into(), d.abs().into()), Rational(far.into(), d.abs().into()));
            if near.is_greater(entry) {
                entry = near;
            }
            if exit.is_none_or(|exit| exit.is_greater(far)) {
                exit = Some(far);
            }
        }
        exit.is_none_or(|exit| !entry.is_greater(exit))
    }

    fn slab_case(&self) -> SlabCase {
        let largest = (0..3)
            .map(|axis| {
                let o = self.origin[axis];
                (self.min[axis] - o).abs().max((self.max[axis] - o).abs())
            })
            .max()
            .unwrap_or(0);
        // 32 roundoffs of the largest difference.
        let band = 1 + 2 * largest * 32 / (1 << 24);
        let number = |x: i64| x as f64;
        let v = |v: [i64; 3]| dvec3(number(v[0]), number(v[1]), number(v[2]));
        let n = |v: [i64; 3]| strahl_core::vec3(v[0] as f32, v[1] as f32, v[2] as f32);
        let d = |axis: usize| {
            let d = number(self.direction[axis]);
            if d == 0.0 && self.negative[axis] { -0.0 } else { d }
        };
        SlabCase {
            aabb: strahl_core::geometry::Aabb { min: n(self.min), max: n(self.max) },
            ray: TestRay { origin: v(self.origin), direction: dvec3(d(0), d(1), d(2)) },
            is_hit: self.is_hit(0),
            is_near: self.is_hit(band),
        }
    }
}

/// A random integer in `-max..=max`.
fn up_to(max: u32, rng: &mut SplitMix64) -> i64 {
    i64::from(rng.below(2 * max + 1)) - i64::from(max)
}

/// A random box, and a ray that is aimed at a random point of it.
fn random_case(rng: &mut SplitMix64) -> IntegerCase {
    let max = [1 << 10, 1 << 16, 1 << 21][rng.below(3) as usize];
    let (a, b) = ([(); 3].map(|()| up_to(max, rng)), [(); 3].map(|()| up_to(max, rng)));
    let (min, max) = (std::array::from_fn(|i| a[i].min(b[i])), std::array::from_fn(|i| a[i].max(b[i])));
    let origin = [(); 3].map(|()| up_to(1 << 21, rng));
    let negative = [(); 3].map(|()| rng.below(2) == 0);
    let case = IntegerCase { min, max, origin, direction: [1, 1, 1], negative };
    case.aimed_at(std::array::from_fn(|i| min[i] + (max[i] - min[i]) * up_to(3, rng).abs() / 3))
}

impl IntegerCase {
    fn aimed_at(self, target: [i64; 3]) -> IntegerCase {
        let direction = std::array::from_fn(|i| target[i] - self.origin[i]);
        IntegerCase { direction: if direction == [0; 3] { [1, 0, 0] } else { direction }, ..self }
    }

    /// Coordinate of one of the two slab planes of an axis, at random.
    fn slab_plane(&self, axis: usize, rng: &mut SplitMix64) -> i64 {
        if rng.below(2) == 0 { self.min[axis] } else { self.max[axis] }
    }
}

fn zeros(rng: &mut SplitMix64) -> IntegerCase {
    let mut case = random_case(rng);
    for _ in 0..1 + rng.below(2) {
        let axis = rng.below(3) as usize;
        case.direction[axis] = 0;
        case.origin[axis] = match rng.below(4) {
            0 => case.origin[axis],
            1 => (case.min[axis] + case.max[axis]) / 2,
            _ => case.slab_plane(axis, rng),
        };
    }
    if case.direction == [0; 3] { IntegerCase { direction: [1, 0, 0], ..case } } else { case }
}

fn corners(rng: &mut SplitMix64) -> IntegerCase {
    let case = random_case(rng);
    let mut target = [0, 1, 2].map(|axis| case.slab_plane(axis, rng));
    if rng.below(2) == 0 {
        // A point of an edge.
        let axis = rng.below(3) as usize;
        target[axis] = case.min[axis] + (case.max[axis] - case.min[axis]) / 3;
    }
    case.aimed_at(target)
}

fn plates(rng: &mut SplitMix64) -> IntegerCase {
    let mut case = random_case(rng);
    let axis = rng.below(3) as usize;
    case.max[axis] = case.min[axis] + i64::from(rng.below(3));
    let target = std::array::from_fn(|i| (case.min[i] + case.max[i]) / 2);
    case.aimed_at(target)
}

fn inside(rng: &mut SplitMix64) -> IntegerCase {
    let mut case = random_case(rng);
    let coordinate = |axis: usize, rng: &mut SplitMix64| match rng.below(3) {
        0 => case.slab_plane(axis, rng),
        _ => case.min[axis] + (case.max[axis] - case.min[axis]) / 2,
    };
    let origin = [0, 1, 2].map(|axis| coordinate(axis, rng));
    case.direction = [(); 3].map(|()| up_to(1 << 20, rng));
    if rng.below(4) == 0 {
        // Away from the box.
        case.origin = std::array::from_fn(|i| case.max[i] + 1);
        case.direction = case.direction.map(|d| d.abs() + 1);
        return case;
    }
    case.origin = origin;
    if case.direction == [0; 3] { IntegerCase { direction: [1, 0, 0], ..case } } else { case }
}
