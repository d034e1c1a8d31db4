//! Hard rays at boxes round things, held against whole numbers: the slab test must never miss a
//! box that the exact ray meets, and meet none that is farther away than rounding reaches.

use super::case::{HardCase, HardCaseTally, Solver};
use crate::SplitMix64;
use crate::test_shape::TestRay;
use crate::textbook;
use crate::vector::dvec3;

const fn case(
    name: &'static str,
    naive: &'static str,
    check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
) -> HardCase {
    HardCase::own("slab test", name, naive, 0.0, check)
}

pub(super) const CASES: [HardCase; 4] = [
    case("components 0 and -0, eye in a wall", "0 times infinity decides", |rng| check(zeros, rng)),
    case("through corners and along edges", "the far end comes before the near one", |rng| {
        check(corners, rng)
    }),
    case("plates of 0 to 4 ulps", "the far end comes before the near one", |rng| check(plates, rng)),
    case("eye inside, on a wall, behind", "`0 < near` leaves out where the eye is", |rng| check(inside, rng))
        .easy(),
];

/// A box and a ray in whole numbers, which `f32` holds exactly.
type IntegerAim = fn(&mut SplitMix64) -> IntegerCase;

#[derive(Clone, Copy)]
struct IntegerCase {
    min: [i64; 3],
    max: [i64; 3],
    origin: [i64; 3],
    direction: [i64; 3],
    /// Which components of the direction, if they are zero, are `-0`.
    negative: [bool; 3],
}

/// A box and a ray as the core takes them, and what is true of them.
struct SlabCase {
    aabb: strahl_core::geometry::Aabb,
    ray: TestRay,
    is_hit: bool,
    is_near: bool,
}

impl SlabCase {
    /// Whether the answer is wrong: a box that the exact ray meets must not be missed, and one that
    /// it misses by more than the band must not be met.
    fn is_wrong(&self, answer: bool) -> bool {
        if self.is_hit { !answer } else { answer && !self.is_near }
    }
}

const RAYS: usize = 10_000;

fn check(aim: IntegerAim, rng: &mut SplitMix64) -> [HardCaseTally; 3] {
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
    let narrow = |v: crate::DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
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

/// A quotient of whole numbers; what is below is more than zero.
#[derive(Clone, Copy)]
struct Rational(i128, i128);

impl Rational {
    fn is_beyond(self, other: Rational) -> bool {
        self.0 * other.1 > other.0 * self.1
    }
}

impl IntegerCase {
    /// Whether the ray meets the box, walls included, grown by `by`.
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
            if near.is_beyond(entry) {
                entry = near;
            }
            if exit.is_none_or(|exit| exit.is_beyond(far)) {
                exit = Some(far);
            }
        }
        exit.is_none_or(|exit| !entry.is_beyond(exit))
    }

    fn slab_case(&self) -> SlabCase {
        let reach = (0..3)
            .map(|axis| {
                let o = self.origin[axis];
                (self.min[axis] - o).abs().max((self.max[axis] - o).abs())
            })
            .max()
            .unwrap_or(0);
        // 32 roundoffs of the largest difference.
        let band = 1 + 2 * reach * 32 / (1 << 24);
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

/// Up to so much to both sides of zero.
fn about(most: u32, rng: &mut SplitMix64) -> i64 {
    i64::from(rng.below(2 * most + 1)) - i64::from(most)
}

/// Any box, and any ray that is aimed at a point of it.
fn whole(rng: &mut SplitMix64) -> IntegerCase {
    let most = [1 << 10, 1 << 16, 1 << 21][rng.below(3) as usize];
    let (a, b) = ([(); 3].map(|()| about(most, rng)), [(); 3].map(|()| about(most, rng)));
    let (min, max) = (std::array::from_fn(|i| a[i].min(b[i])), std::array::from_fn(|i| a[i].max(b[i])));
    let origin = [(); 3].map(|()| about(1 << 21, rng));
    let negative = [(); 3].map(|()| rng.below(2) == 0);
    let whole = IntegerCase { min, max, origin, direction: [1, 1, 1], negative };
    whole.aimed_at(std::array::from_fn(|i| min[i] + (max[i] - min[i]) * about(3, rng).abs() / 3))
}

impl IntegerCase {
    fn aimed_at(self, target: [i64; 3]) -> IntegerCase {
        let direction = std::array::from_fn(|i| target[i] - self.origin[i]);
        IntegerCase { direction: if direction == [0; 3] { [1, 0, 0] } else { direction }, ..self }
    }

    /// The plane of one of both walls.
    fn slab_plane(&self, axis: usize, rng: &mut SplitMix64) -> i64 {
        if rng.below(2) == 0 { self.min[axis] } else { self.max[axis] }
    }
}

fn zeros(rng: &mut SplitMix64) -> IntegerCase {
    let mut whole = whole(rng);
    for _ in 0..1 + rng.below(2) {
        let axis = rng.below(3) as usize;
        whole.direction[axis] = 0;
        whole.origin[axis] = match rng.below(4) {
            0 => whole.origin[axis],
            1 => (whole.min[axis] + whole.max[axis]) / 2,
            _ => whole.slab_plane(axis, rng),
        };
    }
    if whole.direction == [0; 3] { IntegerCase { direction: [1, 0, 0], ..whole } } else { whole }
}

fn corners(rng: &mut SplitMix64) -> IntegerCase {
    let whole = whole(rng);
    let mut target = [0, 1, 2].map(|axis| whole.slab_plane(axis, rng));
    if rng.below(2) == 0 {
        // A point of an edge.
        let axis = rng.below(3) as usize;
        target[axis] = whole.min[axis] + (whole.max[axis] - whole.min[axis]) / 3;
    }
    whole.aimed_at(target)
}

fn plates(rng: &mut SplitMix64) -> IntegerCase {
    let mut whole = whole(rng);
    let axis = rng.below(3) as usize;
    whole.max[axis] = whole.min[axis] + i64::from(rng.below(3));
    let target = std::array::from_fn(|i| (whole.min[i] + whole.max[i]) / 2);
    whole.aimed_at(target)
}

fn inside(rng: &mut SplitMix64) -> IntegerCase {
    let mut whole = whole(rng);
    let place = |axis: usize, rng: &mut SplitMix64| match rng.below(3) {
        0 => whole.slab_plane(axis, rng),
        _ => whole.min[axis] + (whole.max[axis] - whole.min[axis]) / 2,
    };
    let origin = [0, 1, 2].map(|axis| place(axis, rng));
    whole.direction = [(); 3].map(|()| about(1 << 20, rng));
    if rng.below(4) == 0 {
        // Away from the box.
        whole.origin = std::array::from_fn(|i| whole.max[i] + 1);
        whole.direction = whole.direction.map(|d| d.abs() + 1);
        return whole;
    }
    whole.origin = origin;
    if whole.direction == [0; 3] { IntegerCase { direction: [1, 0, 0], ..whole } } else { whole }
}
