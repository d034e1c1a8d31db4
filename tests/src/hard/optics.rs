//! Light at and beyond the critical angle.

use super::case::{HardCase, HardCaseTally, Solver, ULP, as_f32, aside, length};
use crate::textbook;
use crate::vector::{DVec3, dvec3};
use crate::{SplitMix64, rounded};

pub(super) const CASES: [HardCase; 2] = [
    HardCase::own(
        "refraction",
        "300 ulps to both sides of the critical angle",
        "the root of less than nothing",
        4.0,
        |rng| refracted(rng, critical),
    ),
    HardCase::own("refraction", "any angle, in and out", "the root of less than nothing", 4.0, |rng| {
        refracted(rng, any)
    }),
];

/// A sine near that of the critical angle, and any.
fn critical(ratio: f64, rng: &mut SplitMix64) -> f64 {
    (1.0 + (f64::from(rng.below(601)) - 300.0) * ULP) / ratio
}

fn any(_: f64, rng: &mut SplitMix64) -> f64 {
    rng.log_between(1e-6, 1.0)
}

/// The answer of a solver.
#[derive(Clone, Copy)]
struct RefractionAnswer {
    direction: DVec3,
    mirrored: f64,
}

fn answer(solver: Solver, d: DVec3, n: DVec3, ratio: f64) -> Option<RefractionAnswer> {
    let narrow = |v: DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let wide = |v: strahl_core::Vec3| dvec3(v.x.into(), v.y.into(), v.z.into());
    match solver {
        Solver::Textbook => {
            let (direction, mirrored) = textbook::refracted(narrow(d), narrow(n), ratio as f32);
            Some(RefractionAnswer { direction: wide(direction), mirrored: mirrored.into() })
        }
        Solver::Single => strahl_core::shade::refract(narrow(d), narrow(n), ratio as f32)
            .map(|out| RefractionAnswer { direction: wide(out.direction), mirrored: out.reflectance.into() }),
        Solver::Double => strahl_core_double::shade::refract(d, n, ratio).map(|out| RefractionAnswer {
            direction: as_f32(out.direction),
            mirrored: rounded(out.reflectance),
        }),
    }
}

/// Light that comes in under an angle of the given sine: its direction, the normal, and the ratio
/// of the indices.
fn light(rng: &mut SplitMix64, sine: fn(f64, &mut SplitMix64) -> f64) -> (DVec3, DVec3, f64) {
    let ratio = if rng.below(4) == 0 { 1.0 / rng.between(1.01, 2.5) } else { rng.between(1.01, 2.5) };
    let ratio = rounded(ratio);
    let n = rng.direction();
    let sine = sine(ratio, rng);
    let cosine = (1.0 - (sine * sine).min(1.0)).sqrt();
    (as_f32(aside(n, rng) * sine - n / length(n) * cosine), n, ratio)
}

/// Refracts light whose angle of incidence has the given sine, with each solver.
fn refracted(rng: &mut SplitMix64, sine: fn(f64, &mut SplitMix64) -> f64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..20_000 {
        let (d, n, ratio) = light(rng, sine);

        // What is true of what the numbers are.
        let (unit_d, unit_n) = (d / length(d), n / length(n));
        let cos = -unit_d.dot(unit_n);
        let flat = unit_d + unit_n * cos;
        let room = 1.0 - ratio * ratio * flat.dot(flat);
        let behind = room.max(0.0).sqrt();
        let truth = RefractionAnswer {
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
                Some(RefractionAnswer { direction, mirrored }) => {
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
