//! Refraction at and beyond the critical angle.

use super::case::{HardCase, HardCaseTally, Solver, ULP, as_f32, length, perpendicular};
use crate::textbook;
use strahl_test_scene::{DVec3, SplitMix64, dvec3, rounded};

pub(super) const CASES: [HardCase; 2] = [
    HardCase::own(
        "refraction",
        "300 ulps to both sides of the critical angle",
        "the root of a negative number",
        4.0,
        |rng| refracted(rng, critical),
    ),
    HardCase::own("refraction", "any angle, in and out", "the root of a negative number", 4.0, |rng| {
        refracted(rng, any)
    }),
];

/// Sine of an angle within 300 ulps of the critical angle.
fn critical(ratio: f64, rng: &mut SplitMix64) -> f64 {
    (1.0 + (f64::from(rng.below(601)) - 300.0) * ULP) / ratio
}

/// Sine of a random angle.
fn any(_: f64, rng: &mut SplitMix64) -> f64 {
    rng.log_between(1e-6, 1.0)
}

/// Refraction by a solver.
#[derive(Clone, Copy)]
struct RefractionAnswer {
    direction: DVec3,
    reflectance: f64,
}

fn answer(solver: Solver, d: DVec3, n: DVec3, ratio: f64) -> Option<RefractionAnswer> {
    let narrow = |v: DVec3| strahl_core::vec3(v.x as f32, v.y as f32, v.z as f32);
    let wide = |v: strahl_core::Vec3| dvec3(v.x.into(), v.y.into(), v.z.into());
    match solver {
        Solver::Textbook => {
            let (direction, reflectance) = textbook::refracted(narrow(d), narrow(n), ratio as f32);
            Some(RefractionAnswer { direction: wide(direction), reflectance: reflectance.into() })
        }
        Solver::Single => strahl_core::shade::refract(narrow(d), narrow(n), ratio as f32).map(|out| {
            RefractionAnswer { direction: wide(out.direction), reflectance: out.reflectance.into() }
        }),
        Solver::Double => strahl_core_double::shade::refract(d, n, ratio).map(|out| RefractionAnswer {
            direction: as_f32(out.direction),
            reflectance: rounded(out.reflectance),
        }),
    }
}

/// An incident ray whose angle to the normal has the given sine: its direction, the normal, and the ratio of
/// the refractive indices.
fn incident(rng: &mut SplitMix64, sine: fn(f64, &mut SplitMix64) -> f64) -> (DVec3, DVec3, f64) {
    let ratio = if rng.below(4) == 0 { 1.0 / rng.between(1.01, 2.5) } else { rng.between(1.01, 2.5) };
    let ratio = rounded(ratio);
    let n = rng.direction();
    let sine = sine(ratio, rng);
    let cosine = (1.0 - (sine * sine).min(1.0)).sqrt();
    (as_f32(perpendicular(n, rng) * sine - n / length(n) * cosine), n, ratio)
}

/// Refracts rays whose angle of incidence has the given sine, with each solver.
fn refracted(rng: &mut SplitMix64, sine: fn(f64, &mut SplitMix64) -> f64) -> [HardCaseTally; 3] {
    let mut tallies = [HardCaseTally::default(); 3];
    for _ in 0..20_000 {
        let (d, n, ratio) = incident(rng, sine);

        // The exact refraction of the rounded input.
        let (unit_d, unit_n) = (d / length(d), n / length(n));
        let cos = -unit_d.dot(unit_n);
        let tangential = unit_d + unit_n * cos;
        let cos2_behind = 1.0 - ratio * ratio * tangential.dot(tangential);
        let cos_behind = cos2_behind.max(0.0).sqrt();
        let expected = RefractionAnswer {
            direction: tangential * ratio - unit_n * cos_behind,
            reflectance: {
                let across = (ratio * cos - cos_behind) / (ratio * cos + cos_behind);
                let along = (cos - ratio * cos_behind) / (cos + ratio * cos_behind);
                0.5 * (across * across + along * along)
            },
        };
        // Direction, normal and ratio are rounded; the ratio is squared.
        let is_unclear = cos2_behind.abs() <= 32.0 * ULP || cos <= 32.0 * ULP;
        for (solver, tally) in Solver::ALL.into_iter().zip(&mut tallies) {
            tally.rays += 1;
            tally.unclear += usize::from(is_unclear);
            let is_right = match answer(solver, d, n, ratio) {
                None => is_unclear || cos2_behind < 0.0,
                Some(RefractionAnswer { direction, reflectance }) => {
                    // Condition of the cosine behind, and of the reflectance.
                    let condition = 1.0 + (1.0 + ratio * ratio * cos) / cos_behind;
                    let sum = ratio * cos + cos_behind;
                    let unit = ULP * (condition + 2.0 * ratio * (cos_behind + cos * condition) / (sum * sum));
                    let off = length(direction - expected.direction)
                        .max((reflectance - expected.reflectance).abs())
                        / unit;
                    let is_in_range = reflectance >= 0.0 && reflectance <= 1.0 && direction.is_finite();
                    if cos2_behind > 0.0 && !is_unclear && off.is_finite() {
                        tally.worst = tally.worst.max(off);
                    }
                    is_in_range && (is_unclear || cos2_behind > 0.0 && off <= 4.0)
                }
            };
            tally.faults += usize::from(!is_right);
        }
    }
    tallies
}
