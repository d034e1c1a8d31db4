//! Light at and beyond the critical angle.

use super::{Case, Solver, Tally, ULP, aside, held, length};
use crate::textbook;
use crate::thing::{Vector, vector};
use crate::{Random, rounded};

pub(super) const CASES: [Case; 2] = [
    Case::own(
        "refraction",
        "300 ulps to both sides of the critical angle",
        "the root of less than nothing",
        4.0,
        |random| {
            refracted(random, |ratio, random| (1.0 + (f64::from(random.below(601)) - 300.0) * ULP) / ratio)
        },
    ),
    Case::own("refraction", "any angle, in and out", "`1 - cos^2` cancels upright", 4.0, |random| {
        refracted(random, |_, random| random.scale(1e-6, 1.0))
    }),
];

/// A refraction, as all solvers can tell it.
#[derive(Clone, Copy)]
struct Broken {
    direction: Vector,
    mirrored: f64,
}

fn answer(solver: Solver, d: Vector, n: Vector, ratio: f64) -> Option<Broken> {
    let narrow = |v: Vector| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let wide = |v: strahl_core::Vec3| vector(v.x.into(), v.y.into(), v.z.into());
    match solver {
        Solver::Textbook => {
            let (direction, mirrored) = textbook::refracted(narrow(d), narrow(n), ratio as f32);
            Some(Broken { direction: wide(direction), mirrored: mirrored.into() })
        }
        Solver::Single => strahl_core::refracted(narrow(d), narrow(n), ratio as f32)
            .map(|out| Broken { direction: wide(out.direction), mirrored: out.mirrored.into() }),
        Solver::Double => strahl_core_double::refracted(d, n, ratio)
            .map(|out| Broken { direction: held(out.direction), mirrored: rounded(out.mirrored) }),
    }
}

/// Light that comes in under an angle of the given sine.
fn refracted(random: &mut Random, sine: fn(f64, &mut Random) -> f64) -> [Tally; 3] {
    let mut tallies = [Tally::default(); 3];
    for _ in 0..20_000 {
        let ratio =
            if random.below(4) == 0 { 1.0 / random.between(1.01, 2.5) } else { random.between(1.01, 2.5) };
        let ratio = rounded(ratio);
        let n = random.direction();
        let sine = sine(ratio, random);
        let cosine = (1.0 - (sine * sine).min(1.0)).sqrt();
        let d = held(aside(n, random) * sine - n / length(n) * cosine);

        // What is true of what the numbers are.
        let (unit_d, unit_n) = (d / length(d), n / length(n));
        let cos = -unit_d.dot(unit_n);
        let flat = unit_d + unit_n * cos;
        let room = 1.0 - ratio * ratio * flat.dot(flat);
        let behind = room.max(0.0).sqrt();
        let truth = Broken {
            direction: flat * ratio - unit_n * behind,
            mirrored: {
                let across = (ratio * cos - behind) / (ratio * cos + behind);
                let along = (cos - ratio * behind) / (cos + ratio * behind);
                0.5 * (across * across + along * along)
            },
        };
        // Direction, normal and ratio are rounded, and the ratio counts twice.
        let is_unclear = room.abs() <= 32.0 * ULP || cos <= 32.0 * ULP;
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            tally.rays += 1;
            tally.unclear += usize::from(is_unclear);
            let is_right = match answer(solver, d, n, ratio) {
                None => is_unclear || room < 0.0,
                Some(Broken { direction, mirrored }) => {
                    // What a rounding of both angles does to the cosine behind, and that to the share.
                    let bent = 1.0 + (1.0 + ratio * ratio * cos) / behind;
                    let sum = ratio * cos + behind;
                    let unit = ULP * (bent + 2.0 * ratio * (behind + cos * bent) / (sum * sum));
                    let off =
                        length(direction - truth.direction).max((mirrored - truth.mirrored).abs()) / unit;
                    let is_share = mirrored >= 0.0 && mirrored <= 1.0 && direction.is_finite();
                    if room > 0.0 && !is_unclear && off.is_finite() {
                        tally.worst = tally.worst.max(off);
                    }
                    is_share && (is_unclear || room > 0.0 && off <= 4.0)
                }
            };
            tally.faults += usize::from(!is_right);
        }
    }
    tallies
}
