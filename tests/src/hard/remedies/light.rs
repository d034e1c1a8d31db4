//! Leaving a surface, and light behind one, with and without each remedy.

use strahl_core::{Refraction, Vec3, leave, sqrt};

use super::super::leave::{Seen, left, seen};
use super::super::optics::{Broken, any, critical, light, refracted as tally};
use super::super::{Solver, Tally, answers};
use super::{Trial, Tried, found, narrow};
use crate::hard::cost::Work;
use crate::thing::{Kind, Vector, vector};
use crate::{Found, Random, textbook};

fn wide(v: Vec3) -> Vector {
    vector(v.x.into(), v.y.into(), v.z.into())
}

/// A place where a ray has met something: the point, its error, and the normal on the ray's side.
#[derive(Clone, Copy)]
struct Place {
    point: Vec3,
    error: Vec3,
    normal: Vec3,
}

impl Place {
    fn of(found: &Found, direction: Vector) -> Place {
        let normal = if found.normal.dot(direction) > 0.0 { -found.normal } else { found.normal };
        Place { point: narrow(found.point), error: narrow(found.error), normal: narrow(normal) }
    }
}

#[inline(always)]
fn by_error(place: &Place) -> Vec3 {
    leave(place.point, place.error, place.normal)
}

#[inline(always)]
fn by_constant(place: &Place) -> Vec3 {
    textbook::leave(place.point, place.normal)
}

/// The step off a surface, and nothing else: points, and what is met again, are the core's.
pub fn leaving() -> Trial {
    let works = |places: Vec<Place>| [each(places.clone(), by_error), each(places, by_constant)];
    Trial {
        ordinary: works(tried_leaving().0),
        hard: Box::new(move || {
            let (places, [with, without]) = tried_leaving();
            let faults = [with.faults, without.faults];
            (Tried { rays: with.rays, faults, worst: None }, works(places))
        }),
    }
}

/// Places on all kinds of surfaces, and what both steps make of rays from there.
fn tried_leaving() -> (Vec<Place>, [Tally; 2]) {
    let mut random = Random::new(0x5eed_000b);
    let (mut tallies, mut places) = ([Tally::default(); 2], Vec::new());
    for kind in [Kind::Sphere, Kind::CappedCone, Kind::Torus, Kind::TurnedCuboid, Kind::Disc, Kind::Triangle]
    {
        for _ in 0..10 {
            let Seen { thing, radius, eyes, seeds } = seen(kind, &mut random);
            let here: Vec<Option<Place>> = found(&thing, &eyes)
                .into_iter()
                .zip(&eyes)
                .map(|(found, eye)| Some(Place::of(&found?, eye.direction)))
                .collect();
            places.extend(here.iter().flatten().copied());
            let met = |lines: &[_]| {
                let answers = answers(Solver::Single, &thing, lines);
                answers.into_iter().map(|answer| answer.map(|answer| answer.t)).collect()
            };
            let steps: [fn(&Place) -> Vec3; 2] = [by_error, by_constant];
            for (step, tally) in steps.into_iter().zip(&mut tallies) {
                let start =
                    |place: &Option<Place>| place.map(|place| (wide(step(&place)), wide(place.normal)));
                let starts: Vec<_> = here.iter().map(start).collect();
                left(&thing, radius, &starts, &seeds, met, tally);
            }
        }
    }
    (places, tallies)
}

/// The work of answering every item.
fn each<T: 'static>(items: Vec<T>, answer: impl Fn(&T) -> Vec3 + 'static) -> Work {
    Work::new(items.len(), move || items.iter().map(&answer).map(|v| f64::from(v.x + v.y + v.z)).sum())
}

/// `strahl_core`'s refraction.
///
/// * `FLAT`: the sine behind the surface, and the direction, from the part of the direction along
///   it; else `1 - cos^2`, and the part upright on it put right afterwards.
/// * `TESTED`: total reflection is found before any root.
#[inline(always)]
pub fn refracted<const FLAT: bool, const TESTED: bool>(d: Vec3, n: Vec3, ratio: f32) -> Option<Refraction> {
    if ratio == 1.0 {
        return Some(Refraction { direction: d, mirrored: 0.0 });
    }
    let cos = -d.dot(n);
    let cos = if cos > 0.0 { cos } else { 0.0 };
    let flat = (d + n * cos) * ratio;
    let sin2 = if FLAT { flat.dot(flat) } else { ratio * ratio * (1.0 - cos * cos) };
    if TESTED && !(sin2 < 1.0) {
        return None;
    }
    let cos_behind = sqrt(1.0 - sin2);
    let direction = if FLAT { flat - n * cos_behind } else { d * ratio + n * (ratio * cos - cos_behind) };
    let across = (ratio * cos - cos_behind) / (ratio * cos + cos_behind);
    let along = (cos - ratio * cos_behind) / (cos + ratio * cos_behind);
    Some(Refraction { direction, mirrored: 0.5 * (across * across + along * along) })
}

/// A form of refraction.
trait Break: Fn(Vec3, Vec3, f32) -> Option<Refraction> + Copy + 'static {}
impl<B: Fn(Vec3, Vec3, f32) -> Option<Refraction> + Copy + 'static> Break for B {}

/// A remedy of refraction, tried with light near the critical angle and with any.
pub fn refraction(
    with: impl Fn(Vec3, Vec3, f32) -> Option<Refraction> + Copy + 'static,
    without: impl Fn(Vec3, Vec3, f32) -> Option<Refraction> + Copy + 'static,
) -> Trial {
    let works = move |sine: fn(f64, &mut Random) -> f64| [work(sine, with), work(sine, without)];
    Trial {
        ordinary: works(any),
        hard: Box::new(move || {
            let (mut rays, mut faults, mut worst) = (0, [0; 2], [0.0; 2]);
            for sine in [critical, any] {
                let mut random = Random::new(0x5eed_000c);
                let tallies = tally(&mut random, sine, [answer(with), answer(without)]);
                rays += tallies[0].rays;
                for (i, tally) in tallies.iter().enumerate() {
                    faults[i] += tally.faults;
                    worst[i] = f64::max(worst[i], tally.worst);
                }
            }
            (Tried { rays, faults, worst: Some(worst) }, works(critical))
        }),
    }
}

fn answer(form: impl Break) -> Box<dyn Fn(Vector, Vector, f64) -> Option<Broken>> {
    Box::new(move |d, n, ratio| {
        let out = form(narrow(d), narrow(n), ratio as f32)?;
        Some(Broken { direction: wide(out.direction), mirrored: out.mirrored.into() })
    })
}

fn work(sine: fn(f64, &mut Random) -> f64, form: impl Break) -> Work {
    let mut random = Random::new(0x5eed_000d);
    let light: Vec<(Vec3, Vec3, f32)> = (0..1000)
        .map(|_| light(&mut random, sine))
        .map(|(d, n, ratio)| (narrow(d), narrow(n), ratio as f32))
        .collect();
    each(light, move |(d, n, ratio)| {
        form(*d, *n, *ratio).map_or(Vec3::ZERO, |out| out.direction * out.mirrored)
    })
}
