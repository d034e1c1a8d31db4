//! A case of hard rays, and what the solvers make of it.

use crate::cast::{CoreHit, TestedCore};
use crate::oracle::{OracleAnswer, OracleHit, PRECISION, intersect, size};
use crate::test_shape::{TestRay, TestShape};
use crate::textbook::TextbookShape;
use crate::vector::{DVec3, dvec3, perpendicular_axes};
use crate::{SplitMix64, double, rounded, single};

/// The distance between neighbouring numbers of single precision, for numbers about one.
pub const ULP: f64 = 1.0 / (1 << 23) as f64;

/// Who answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// The formula of the textbooks, in single precision.
    Textbook,
    /// The core.
    Single,
    /// The core with double precision inside; its answers are rounded.
    Double,
}

impl Solver {
    /// All three.
    pub const ALL: [Solver; 3] = [Solver::Textbook, Solver::Single, Solver::Double];
}

/// What a solver has made of a case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HardCaseTally {
    /// Rays tried.
    pub rays: usize,
    /// Of these, rays that may be answered either way.
    pub unclear: usize,
    /// Of the others, rays that were answered wrongly: a hit for a miss or the reverse, outside
    /// the bound, or no number.
    pub faults: usize,
    /// The worst error of a hit that was rightly one, in the unit of the case.
    pub worst: f64,
}

/// One kind of hard rays.
#[derive(Clone, Copy)]
pub struct HardCase {
    /// The shape or the room that it is about.
    pub family: &'static str,
    /// What is hard.
    pub name: &'static str,
    /// What goes wrong in a naive implementation.
    pub naive: &'static str,
    /// The largest error that is right, in units in the last place times the conditioning.
    pub bound: f64,
    /// Whether the textbook's formula is known to fail: else the case guards what is easy.
    pub breaks: bool,
    run: CaseRays,
}

/// Where the rays of a case come from.
#[derive(Clone, Copy)]
enum CaseRays {
    /// Rays at a thing, held against the oracle: so many rounds.
    Aimed(usize, AimFunction),
    /// A check of its own.
    Own(fn(&mut SplitMix64) -> [HardCaseTally; 3]),
}

/// A thing, and rays at it.
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
        HardCase { family, name, naive, bound, breaks: true, run: CaseRays::Aimed(rounds, aim) }
    }

    pub(super) const fn own(
        family: &'static str,
        name: &'static str,
        naive: &'static str,
        bound: f64,
        check: fn(&mut SplitMix64) -> [HardCaseTally; 3],
    ) -> HardCase {
        HardCase { family, name, naive, bound, breaks: true, run: CaseRays::Own(check) }
    }

    /// The same, where the textbook's formula does no harm.
    pub(super) const fn easy(self) -> HardCase {
        HardCase { breaks: false, ..self }
    }

    fn random(&self) -> SplitMix64 {
        let letters = self.family.bytes().chain(self.name.bytes());
        let seed = |seed: u64, byte: u8| (seed ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        SplitMix64::new(letters.fold(0x5eed_0005, seed))
    }

    /// Some of its things, and the rays at them; nothing for a case that is no rays at a thing.
    pub fn aims(&self, rounds: usize) -> Vec<(TestShape, Vec<TestRay>)> {
        let mut rng = self.random();
        match self.run {
            CaseRays::Own(_) => Vec::new(),
            CaseRays::Aimed(_, aim) => (0..rounds).map(|_| aim(&mut rng)).collect(),
        }
    }

    /// All of its things, and the rays at them.
    pub fn all_aims(&self) -> Vec<(TestShape, Vec<TestRay>)> {
        match self.run {
            CaseRays::Own(_) => Vec::new(),
            CaseRays::Aimed(rounds, _) => self.aims(rounds),
        }
    }

    /// All of its rays at things, and what is true of them.
    fn rays(&self) -> Vec<AimedRays> {
        let aims = self.all_aims();
        // Two halves side by side: the oracle is slow.
        let of = |(shape, rays): &(TestShape, Vec<TestRay>)| AimedRays {
            truths: rays.iter().map(|ray| intersect(shape, ray)).collect(),
            shape: shape.clone(),
            rays: rays.clone(),
            bound: self.bound,
        };
        let (one, other) = aims.split_at(aims.len() / 2);
        std::thread::scope(|scope| {
            let other = scope.spawn(|| other.iter().map(of).collect::<Vec<_>>());
            let mut all: Vec<AimedRays> = one.iter().map(of).collect();
            all.extend(other.join().expect("the oracle answers every ray"));
            all
        })
    }

    /// What the three solvers make of it: the same in every run.
    pub fn run(&self) -> [HardCaseTally; 3] {
        self.run_with_faults(&mut |_| ())
    }

    /// The same, and what is wrong with the answers, in words that begin with the solver's name.
    pub fn run_with_faults(&self, report_fault: &mut dyn FnMut(String)) -> [HardCaseTally; 3] {
        match self.run {
            CaseRays::Own(check) => check(&mut self.random()),
            CaseRays::Aimed(..) => {
                let mut tallies = [HardCaseTally::default(); 3];
                self.rays().iter().for_each(|aimed| assert_case(aimed, &mut tallies, report_fault));
                tallies
            }
        }
    }
}

/// Rays at a thing, and what is true of them.
struct AimedRays {
    shape: TestShape,
    rays: Vec<TestRay>,
    truths: Vec<OracleAnswer>,
    bound: f64,
}

/// A hit, as all solvers can tell it.
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
            let form = TextbookShape::of(shape);
            let wide = |v: strahl_core::Vec3| dvec3(v.x.into(), v.y.into(), v.z.into());
            let met = |ray: &TestRay| {
                form.met(ray).map(|met| SolverHit { t: met.t.into(), normal: wide(met.normal) })
            };
            rays.iter().map(met).collect()
        }
        Solver::Single => single::TestScene::with_shapes(shapes).cast(rays).into_iter().map(of).collect(),
        Solver::Double => double::TestScene::with_shapes(shapes)
            .cast(rays)
            .into_iter()
            .map(|hit| of(hit).map(|answer| SolverHit { t: rounded(answer.t), ..answer }))
            .collect(),
    }
}

/// Holds the answers of all solvers against the truth.
fn assert_case(aimed: &AimedRays, tallies: &mut [HardCaseTally; 3], report_fault: &mut dyn FnMut(String)) {
    let AimedRays { shape, rays, truths, bound, .. } = aimed;
    for (solver, tally) in Solver::ALL.into_iter().zip(tallies) {
        for ((ray, truth), answer) in rays.iter().zip(truths).zip(answers(solver, shape, rays)) {
            tally.rays += 1;
            tally.unclear += usize::from(matches!(truth, OracleAnswer::Unclear));
            match judged(shape, ray, truth, answer, *bound) {
                Ok(off) => tally.worst = tally.worst.max(off),
                Err((fault, off)) => {
                    tally.worst = tally.worst.max(off);
                    tally.faults += 1;
                    report_fault(format!("{solver:?} {fault}: {shape:?}\n{ray:?}\n{truth:?}\n{answer:?}\n"));
                }
            }
        }
    }
}

/// How far an answer is off, or what is wrong with it.
pub(super) fn judged(
    shape: &TestShape,
    ray: &TestRay,
    truth: &OracleAnswer,
    answer: Option<SolverHit>,
    bound: f64,
) -> Result<f64, (&'static str, f64)> {
    match (truth, answer) {
        (_, Some(SolverHit { t, normal })) if !(t.is_finite() && normal.is_finite()) => {
            Err(("no number", 0.0))
        }
        (OracleAnswer::Unclear, _) | (OracleAnswer::Miss, None) => Ok(0.0),
        (OracleAnswer::Hit(contact), Some(answer)) => {
            let off = error(shape, ray, contact, &answer);
            if off <= bound { Ok(off) } else { Err(("outside the bound", off)) }
        }
        (OracleAnswer::Hit(_), None) => Err(("missed", 0.0)),
        (OracleAnswer::Miss, Some(_)) => Err(("met what is not there", 0.0)),
    }
}

/// How far an answer is off, in units in the last place times the conditioning.
fn error(shape: &TestShape, ray: &TestRay, truth: &OracleHit, answer: &SolverHit) -> f64 {
    let speed = ray.direction.dot(ray.direction).sqrt();
    let conditioning = size(shape, ray) / truth.slope + truth.way;
    let unit = ULP.max(PRECISION) * conditioning;
    let way = (answer.t * speed - truth.way).abs() / unit;
    let turned = answer.normal - truth.normal;
    let normal = turned.dot(turned).sqrt() / (ULP * (1.0 + conditioning / truth.curvature));
    let is_unit = (answer.normal.dot(answer.normal) - 1.0).abs() <= 1e-6;
    if is_unit { way.max(normal) } else { f64::INFINITY }
}

// What the cases aim with.

pub(super) fn length(v: DVec3) -> f64 {
    v.dot(v).sqrt()
}

/// Each component rounded to what `f32` holds.
pub(super) fn as_f32(v: DVec3) -> DVec3 {
    dvec3(rounded(v.x), rounded(v.y), rounded(v.z))
}

/// The ray from one point towards another.
pub(super) fn towards(origin: DVec3, target: DVec3) -> TestRay {
    TestRay { origin, direction: as_f32(target - origin) }
}

/// A direction upright on another.
pub(super) fn aside(n: DVec3, rng: &mut SplitMix64) -> DVec3 {
    let (x, y) = perpendicular_axes(n);
    let angle = rng.between(0.0, std::f64::consts::TAU);
    x * libm::cos(angle) + y * libm::sin(angle)
}

/// One, a little more or a little less: by a tenth down to a ten-millionth.
pub(super) fn about_one(rng: &mut SplitMix64) -> f64 {
    let off = rng.log_between(1e-7, 0.1);
    if rng.below(2) == 0 { 1.0 + off } else { 1.0 - off }
}
