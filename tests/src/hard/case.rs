//! A case of hard rays, and its evaluation for each solver.

use crate::oracle::{OracleAnswer, OracleHit, PRECISION, intersect, size};
use crate::textbook::TextbookShape;
use strahl_test_scene as single;
use strahl_test_scene::vector::perpendicular_axes;
use strahl_test_scene::{CoreHit, DVec3, SplitMix64, TestRay, TestShape, TestedCore, dvec3, rounded};
use strahl_test_scene_double as double;

/// Distance between neighboring `f32` in `[1, 2)`.
pub const ULP: f64 = 1.0 / (1 << 23) as f64;

/// What answers the rays of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// The textbook's formula, in single precision.
    Textbook,
    /// The core.
    Single,
    /// The core with double precision inside; its answers are rounded to `f32`.
    Double,
}

impl Solver {
    /// All solvers.
    pub const ALL: [Solver; 3] = [Solver::Textbook, Solver::Single, Solver::Double];
}

/// Number of rays, faults and largest error of one solver on one case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HardCaseTally {
    /// Rays that were traced.
    pub rays: usize,
    /// Rays for which hit and miss are both correct.
    pub unclear: usize,
    /// Other rays that were answered wrongly: hit for miss, miss for hit, an error outside the bound, NaN or
    /// infinity.
    pub faults: usize,
    /// Largest error of a correct hit, in the unit of the case.
    pub worst: f64,
}

/// One group of hard rays.
#[derive(Clone, Copy)]
pub struct HardCase {
    /// Shape or part of the core that is tested.
    pub family: &'static str,
    /// What is hard about the rays.
    pub name: &'static str,
    /// What goes wrong in a naive implementation.
    pub naive: &'static str,
    /// Largest correct error, in units in the last place times the conditioning.
    pub bound: f64,
    /// Whether the textbook's formula is known to fail. If not, the case guards against regressions.
    pub breaks: bool,
    seed: u64,
    rays: CaseRays,
}

/// Source of the rays of a case.
#[derive(Clone, Copy)]
enum CaseRays {
    /// Rays at shapes, compared with the oracle: number of rounds, and the generator of a shape and its rays.
    Aimed(usize, AimFunction),
    /// A function that evaluates all solvers.
    Own(fn(&mut SplitMix64) -> [HardCaseTally; 3]),
}

/// Generates a shape, and rays at it.
pub(super) type AimFunction = fn(&mut SplitMix64) -> (TestShape, Vec<TestRay>);

impl HardCase {
    pub(super) const fn aimed(
        family: &'static str,
        name: &'static str,
        naive: &'static str,
        bound: f64,
        rounds: usize,
        aim: AimFunction,
    ) -> HardCase {
        HardCase {
            family,
            name,
            naive,
            bound,
            breaks: true,
            seed: hash(family, name),
            rays: CaseRays::Aimed(rounds, aim),
        }
    }

    pub(super) const fn own(
        family: &'static str,
        name: &'static str,
        naive: &'static str,
        bound: f64,
        check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
    ) -> HardCase {
        HardCase {
            family,
            name,
            naive,
            bound,
            breaks: true,
            seed: hash(family, name),
            rays: CaseRays::Own(check),
        }
    }

    /// The case, with a textbook formula that makes no faults.
    pub(super) const fn easy(self) -> HardCase {
        HardCase { breaks: false, ..self }
    }

    /// The case with this seed in place of the hash of its names: a renamed case keeps its rays.
    pub(super) const fn seed(self, seed: u64) -> HardCase {
        HardCase { seed, ..self }
    }

    fn rng(&self) -> SplitMix64 {
        SplitMix64::new(self.seed)
    }

    /// The first `rounds` shapes and the rays at them; empty for a case that is not of rays at shapes.
    pub fn aims(&self, rounds: usize) -> Vec<(TestShape, Vec<TestRay>)> {
        let mut rng = self.rng();
        match self.rays {
            CaseRays::Own(_) => Vec::new(),
            CaseRays::Aimed(_, aim) => (0..rounds).map(|_| aim(&mut rng)).collect(),
        }
    }

    /// All shapes and the rays at them; empty for a case that is not of rays at shapes.
    pub fn all_aims(&self) -> Vec<(TestShape, Vec<TestRay>)> {
        match self.rays {
            CaseRays::Own(_) => Vec::new(),
            CaseRays::Aimed(rounds, _) => self.aims(rounds),
        }
    }

    /// All shapes and rays, with the oracle's answers.
    fn rays(&self) -> Vec<AimedRays> {
        let aims = self.all_aims();
        // In two threads: the oracle is slow.
        let answered = |(shape, rays): &(TestShape, Vec<TestRay>)| AimedRays {
            expected: rays.iter().map(|ray| intersect(shape, ray)).collect(),
            shape: shape.clone(),
            rays: rays.clone(),
            bound: self.bound,
        };
        let (one, other) = aims.split_at(aims.len() / 2);
        std::thread::scope(|scope| {
            let other = scope.spawn(|| other.iter().map(answered).collect::<Vec<_>>());
            let mut all: Vec<AimedRays> = one.iter().map(answered).collect();
            all.extend(other.join().expect("the oracle answers every ray"));
            all
        })
    }

    /// Evaluates the three solvers. Deterministic.
    pub fn run(&self) -> [HardCaseTally; 3] {
        self.run_with_faults(&mut |_| ())
    }

    /// Evaluates the three solvers and reports each fault in a text that begins with the solver's name.
    pub fn run_with_faults(&self, report_fault: &mut dyn FnMut(String)) -> [HardCaseTally; 3] {
        match self.rays {
            CaseRays::Own(check) => check(&mut self.rng()),
            CaseRays::Aimed(..) => {
                let mut tallies = [HardCaseTally::default(); 3];
                self.rays().iter().for_each(|aimed| evaluate(aimed, &mut tallies, report_fault));
                tallies
            }
        }
    }
}

/// A hash of the names of a case (FNV-1a with another start).
const fn hash(family: &str, name: &str) -> u64 {
    const fn add(mut hash: u64, text: &[u8]) -> u64 {
        let mut i = 0;
        while i < text.len() {
            hash = (hash ^ text[i] as u64).wrapping_mul(0x0100_0000_01b3);
            i += 1;
        }
        hash
    }
    add(add(0x5eed_0005, family.as_bytes()), name.as_bytes())
}

/// Rays at a shape, and the oracle's answers.
struct AimedRays {
    shape: TestShape,
    rays: Vec<TestRay>,
    expected: Vec<OracleAnswer>,
    bound: f64,
}

/// A hit, with what all solvers compute.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolverHit {
    pub(super) t: f64,
    pub(super) normal: DVec3,
}

pub(super) fn answers(solver: Solver, shape: &TestShape, rays: &[TestRay]) -> Vec<Option<SolverHit>> {
    let of = |hit: Option<CoreHit>| hit.map(|hit| SolverHit { t: hit.t, normal: hit.normal });
    let shapes = std::slice::from_ref(shape);
    match solver {
        Solver::Textbook => {
            let textbook = TextbookShape::of(shape);
            let wide = |v: strahl_core::Vec3| dvec3(v.x.into(), v.y.into(), v.z.into());
            let hit = |ray: &TestRay| {
                textbook.intersect(ray).map(|hit| SolverHit { t: hit.t.into(), normal: wide(hit.normal) })
            };
            rays.iter().map(hit).collect()
        }
        Solver::Single => single::TestScene::with_shapes(shapes).cast(rays).into_iter().map(of).collect(),
        Solver::Double => double::TestScene::with_shapes(shapes)
            .cast(rays)
            .into_iter()
            .map(|hit| of(hit).map(|answer| SolverHit { t: rounded(answer.t), ..answer }))
            .collect(),
    }
}

/// Compares the answers of all solvers with those of the oracle.
fn evaluate(aimed: &AimedRays, tallies: &mut [HardCaseTally; 3], report_fault: &mut dyn FnMut(String)) {
    let AimedRays { shape, rays, expected, bound, .. } = aimed;
    for (solver, tally) in Solver::ALL.into_iter().zip(tallies) {
        for ((ray, expected), answer) in rays.iter().zip(expected).zip(answers(solver, shape, rays)) {
            tally.rays += 1;
            tally.unclear += usize::from(matches!(expected, OracleAnswer::Unclear));
            match judged(shape, ray, expected, answer, *bound) {
                Ok(off) => tally.worst = tally.worst.max(off),
                Err((fault, off)) => {
                    tally.worst = tally.worst.max(off);
                    tally.faults += 1;
                    report_fault(format!(
                        "{solver:?} {fault}: {shape:?}\n{ray:?}\n{expected:?}\n{answer:?}\n"
                    ));
                }
            }
        }
    }
}

/// Returns the error of an answer, or the fault and its error.
pub(super) fn judged(
    shape: &TestShape,
    ray: &TestRay,
    expected: &OracleAnswer,
    answer: Option<SolverHit>,
    bound: f64,
) -> Result<f64, (&'static str, f64)> {
    match (expected, answer) {
        (_, Some(SolverHit { t, normal })) if !(t.is_finite() && normal.is_finite()) => {
            Err(("not finite", 0.0))
        }
        (OracleAnswer::Unclear, _) | (OracleAnswer::Miss, None) => Ok(0.0),
        (OracleAnswer::Hit(contact), Some(answer)) => {
            let off = error(shape, ray, contact, &answer);
            if off <= bound { Ok(off) } else { Err(("outside the bound", off)) }
        }
        (OracleAnswer::Hit(_), None) => Err(("missed", 0.0)),
        (OracleAnswer::Miss, Some(_)) => Err(("hit although the ray misses", 0.0)),
    }
}

/// Error of an answer, in units in the last place times the conditioning.
fn error(shape: &TestShape, ray: &TestRay, expected: &OracleHit, answer: &SolverHit) -> f64 {
    let speed = ray.direction.dot(ray.direction).sqrt();
    let conditioning = size(shape, ray) / expected.slope + expected.distance;
    let unit = ULP.max(PRECISION) * conditioning;
    let distance = (answer.t * speed - expected.distance).abs() / unit;
    let difference = answer.normal - expected.normal;
    let normal = difference.dot(difference).sqrt() / (ULP * (1.0 + conditioning / expected.curvature));
    let is_unit = (answer.normal.dot(answer.normal) - 1.0).abs() <= 1e-6;
    if is_unit { distance.max(normal) } else { f64::INFINITY }
}

// Building blocks of the cases.

pub(super) fn length(v: DVec3) -> f64 {
    v.dot(v).sqrt()
}

/// Each component rounded to what `f32` holds.
pub(super) fn as_f32(v: DVec3) -> DVec3 {
    dvec3(rounded(v.x), rounded(v.y), rounded(v.z))
}

/// The ray from `origin` through `target`, its direction rounded to `f32`.
pub(super) fn towards(origin: DVec3, target: DVec3) -> TestRay {
    TestRay { origin, direction: as_f32(target - origin) }
}

/// A random unit vector perpendicular to `n`.
pub(super) fn perpendicular(n: DVec3, rng: &mut SplitMix64) -> DVec3 {
    let (x, y) = perpendicular_axes(n);
    let angle = rng.between(0.0, std::f64::consts::TAU);
    x * libm::cos(angle) + y * libm::sin(angle)
}

/// A number that differs from 1 by 1e-7 to 0.1, in either direction.
pub(super) fn about_one(rng: &mut SplitMix64) -> f64 {
    let off = rng.log_between(1e-7, 0.1);
    if rng.below(2) == 0 { 1.0 + off } else { 1.0 - off }
}
