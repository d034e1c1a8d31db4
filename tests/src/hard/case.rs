//! A case of hard rays, and what the solvers make of it.

use crate::cast::{Core, Found};
use crate::oracle::{Contact, PRECISION, Truth, meet, size};
use crate::textbook::Form;
use crate::thing::{Line, Thing};
use crate::vector::{Vector, upright, vector};
use crate::{Random, double, rounded, single};

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
pub struct Tally {
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
pub struct Case {
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
    run: Run,
}

/// Where the rays of a case come from.
#[derive(Clone, Copy)]
enum Run {
    /// Rays at a thing, held against the oracle: so many rounds.
    Aimed(usize, Aim),
    /// A check of its own.
    Own(fn(&mut Random) -> [Tally; 3]),
}

/// A thing, and rays at it.
pub(super) type Aim = fn(&mut Random) -> (Thing, Vec<Line>);

impl Case {
    pub(super) const fn aimed(
        family: &'static str,
        name: &'static str,
        naive: &'static str,
        bound: f64,
        rounds: usize,
        aim: Aim,
    ) -> Case {
        Case { family, name, naive, bound, breaks: true, run: Run::Aimed(rounds, aim) }
    }

    pub(super) const fn own(
        family: &'static str,
        name: &'static str,
        naive: &'static str,
        bound: f64,
        check: fn(&mut Random) -> [Tally; 3],
    ) -> Case {
        Case { family, name, naive, bound, breaks: true, run: Run::Own(check) }
    }

    /// The same, where the textbook's formula does no harm.
    pub(super) const fn easy(self) -> Case {
        Case { breaks: false, ..self }
    }

    fn random(&self) -> Random {
        let letters = self.family.bytes().chain(self.name.bytes());
        let seed = |seed: u64, byte: u8| (seed ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        Random::new(letters.fold(0x5eed_0005, seed))
    }

    /// Some of its things, and the rays at them; nothing for a case that is no rays at a thing.
    pub fn aims(&self, rounds: usize) -> Vec<(Thing, Vec<Line>)> {
        let mut random = self.random();
        match self.run {
            Run::Own(_) => Vec::new(),
            Run::Aimed(_, aim) => (0..rounds).map(|_| aim(&mut random)).collect(),
        }
    }

    /// All of its things, and the rays at them.
    pub fn all_aims(&self) -> Vec<(Thing, Vec<Line>)> {
        match self.run {
            Run::Own(_) => Vec::new(),
            Run::Aimed(rounds, _) => self.aims(rounds),
        }
    }

    /// All of its rays at things, and what is true of them.
    fn rays(&self) -> Vec<Aimed> {
        let aims = self.all_aims();
        // Two halves side by side: the oracle is slow.
        let of = |(thing, lines): &(Thing, Vec<Line>)| Aimed {
            truths: lines.iter().map(|line| meet(thing, line)).collect(),
            thing: thing.clone(),
            lines: lines.clone(),
            bound: self.bound,
        };
        let (one, other) = aims.split_at(aims.len() / 2);
        std::thread::scope(|scope| {
            let other = scope.spawn(|| other.iter().map(of).collect::<Vec<_>>());
            let mut all: Vec<Aimed> = one.iter().map(of).collect();
            all.extend(other.join().expect("the oracle answers every ray"));
            all
        })
    }

    /// What the three solvers make of it: the same in every run.
    pub fn run(&self) -> [Tally; 3] {
        self.run_and_tell(&mut |_| ())
    }

    /// The same, and what is wrong with the answers, in words that begin with the solver's name.
    pub fn run_and_tell(&self, tell: &mut dyn FnMut(String)) -> [Tally; 3] {
        match self.run {
            Run::Own(check) => check(&mut self.random()),
            Run::Aimed(..) => {
                let mut tallies = [Tally::default(); 3];
                self.rays().iter().for_each(|aimed| hold(aimed, &mut tallies, tell));
                tallies
            }
        }
    }
}

/// Rays at a thing, and what is true of them.
struct Aimed {
    thing: Thing,
    lines: Vec<Line>,
    truths: Vec<Truth>,
    bound: f64,
}

/// A hit, as all solvers can tell it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    pub(super) t: f64,
    pub(super) normal: Vector,
}

pub(super) fn answers(solver: Solver, thing: &Thing, lines: &[Line]) -> Vec<Option<Answer>> {
    let of = |found: Option<Found>| found.map(|found| Answer { t: found.t, normal: found.normal });
    let things = std::slice::from_ref(thing);
    match solver {
        Solver::Textbook => {
            let form = Form::of(thing);
            let wide = |v: strahl_core::Vec3| vector(v.x.into(), v.y.into(), v.z.into());
            let met =
                |line: &Line| form.met(line).map(|met| Answer { t: met.t.into(), normal: wide(met.normal) });
            lines.iter().map(met).collect()
        }
        Solver::Single => single::Stage::with(things).cast(lines).into_iter().map(of).collect(),
        Solver::Double => double::Stage::with(things)
            .cast(lines)
            .into_iter()
            .map(|found| of(found).map(|answer| Answer { t: rounded(answer.t), ..answer }))
            .collect(),
    }
}

/// Holds the answers of all solvers against the truth.
fn hold(aimed: &Aimed, tallies: &mut [Tally; 3], tell: &mut dyn FnMut(String)) {
    let Aimed { thing, lines, truths, bound, .. } = aimed;
    for (solver, tally) in Solver::ALL.into_iter().zip(tallies) {
        for ((line, truth), answer) in lines.iter().zip(truths).zip(answers(solver, thing, lines)) {
            tally.rays += 1;
            tally.unclear += usize::from(matches!(truth, Truth::Unclear));
            match judged(thing, line, truth, answer, *bound) {
                Ok(off) => tally.worst = tally.worst.max(off),
                Err((fault, off)) => {
                    tally.worst = tally.worst.max(off);
                    tally.faults += 1;
                    tell(format!("{solver:?} {fault}: {thing:?}\n{line:?}\n{truth:?}\n{answer:?}\n"));
                }
            }
        }
    }
}

/// How far an answer is off, or what is wrong with it.
pub(super) fn judged(
    thing: &Thing,
    line: &Line,
    truth: &Truth,
    answer: Option<Answer>,
    bound: f64,
) -> Result<f64, (&'static str, f64)> {
    match (truth, answer) {
        (_, Some(Answer { t, normal })) if !(t.is_finite() && normal.is_finite()) => Err(("no number", 0.0)),
        (Truth::Unclear, _) | (Truth::Miss, None) => Ok(0.0),
        (Truth::Hit(contact), Some(answer)) => {
            let off = error(thing, line, contact, &answer);
            if off <= bound { Ok(off) } else { Err(("outside the bound", off)) }
        }
        (Truth::Hit(_), None) => Err(("missed", 0.0)),
        (Truth::Miss, Some(_)) => Err(("met what is not there", 0.0)),
    }
}

/// How far an answer is off, in units in the last place times the conditioning.
fn error(thing: &Thing, line: &Line, truth: &Contact, answer: &Answer) -> f64 {
    let speed = line.direction.dot(line.direction).sqrt();
    let conditioning = size(thing, line) / truth.slope + truth.way;
    let unit = ULP.max(PRECISION) * conditioning;
    let way = (answer.t * speed - truth.way).abs() / unit;
    let turned = answer.normal - truth.normal;
    let normal = turned.dot(turned).sqrt() / (ULP * (1.0 + conditioning / truth.curvature));
    let is_unit = (answer.normal.dot(answer.normal) - 1.0).abs() <= 1e-6;
    if is_unit { way.max(normal) } else { f64::INFINITY }
}

// What the cases aim with.

pub(super) fn length(v: Vector) -> f64 {
    v.dot(v).sqrt()
}

/// Each component rounded to what `f32` holds.
pub(super) fn held(v: Vector) -> Vector {
    vector(rounded(v.x), rounded(v.y), rounded(v.z))
}

/// The ray from one point towards another.
pub(super) fn towards(origin: Vector, target: Vector) -> Line {
    Line { origin, direction: held(target - origin) }
}

/// A direction upright on another.
pub(super) fn aside(n: Vector, random: &mut Random) -> Vector {
    let (x, y) = upright(n);
    let angle = random.between(0.0, std::f64::consts::TAU);
    x * libm::cos(angle) + y * libm::sin(angle)
}

/// One, a little more or a little less: by a tenth down to a ten-millionth.
pub(super) fn about_one(random: &mut Random) -> f64 {
    let off = random.scale(1e-7, 0.1);
    if random.below(2) == 0 { 1.0 + off } else { 1.0 - off }
}
