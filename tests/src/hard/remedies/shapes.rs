//! How remedies of shapes and boxes are tried, and things as the core keeps them.

use strahl_core::{
    Aabb, Cone, Cuboid, Disc, ItemId, Plane, Polygon, Span, Sphere, Torus, TurnedCuboid, Vec3, unit,
};

use super::{Prepared, Ready, Reply, Trial, Tried, flat, narrow, prepared, work};
use crate::Random;
use crate::hard::cost::{Work, scenes};
use crate::hard::{Aimed, Answer, Mesh, aimed_at, bounds, held, judged, towards};
use crate::oracle::Truth;
use crate::thing::{Kind, Line, Thing, Vector, vector};

/// A remedy of a shape, tried with the hard rays of its family.
pub fn shaped<S: 'static, R: Reply + 'static>(
    family: &'static str,
    kind: Kind,
    of: fn(&Thing) -> Option<S>,
    with: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
    without: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
) -> Trial {
    let judge = |aimed: &Aimed, line: &Line, truth: &Truth, reply: Option<R>| {
        let right = match truth {
            Truth::Hit(contact) => contact.normal,
            _ => Vector::X,
        };
        let answer =
            reply.map(|reply| Answer { t: reply.t().into(), normal: reply.normal().unwrap_or(right) });
        judged(&aimed.thing, line, truth, answer, aimed.bound).ok()
    };
    Trial {
        ordinary: ordinary(kind, of, with, without),
        hard: Box::new(move || tried(aimed_at(family), of, judge, with, without)),
    }
}

/// Ordinary rays for both forms.
fn ordinary<S: 'static, R: Reply + 'static>(
    kind: Kind,
    of: fn(&Thing) -> Option<S>,
    with: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
    without: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
) -> [Work; 2] {
    let scenes = scenes(kind);
    [work(prepared(&scenes, of), with), work(prepared(&scenes, of), without)]
}

/// Tries both forms with hard rays.
fn tried<S: 'static, R: Reply + 'static>(
    aimed: &[Aimed],
    of: fn(&Thing) -> Option<S>,
    judge: impl Fn(&Aimed, &Line, &Truth, Option<R>) -> Option<f64>,
    with: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
    without: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
) -> (Tried, [Work; 2]) {
    let (mut rays, mut faults, mut worst) = (0, [0; 2], [0.0; 2]);
    for aimed in aimed {
        let Some(shape) = of(&aimed.thing) else { continue };
        for (line, truth) in aimed.lines.iter().zip(&aimed.truths) {
            let ready = Ready::of(line);
            rays += 1;
            for (i, reply) in [with(&shape, &ready), without(&shape, &ready)].into_iter().enumerate() {
                match judge(aimed, line, truth, reply) {
                    Some(off) => worst[i] = f64::max(worst[i], off),
                    None => faults[i] += 1,
                }
            }
        }
    }
    // To measure the time some are enough.
    let some: Vec<(Thing, Vec<Line>)> =
        aimed.iter().step_by(10).map(|aimed| (aimed.thing.clone(), aimed.lines.clone())).collect();
    let worst = Some(worst).filter(|worst| worst[1] > 0.0);
    let works = [work(prepared(&some, of), with), work(prepared(&some, of), without)];
    (Tried { rays, faults, worst }, works)
}

/// A remedy of triangles, tried with rays at edges and corners of closed meshes from inside: a
/// fault is a ray that gets through.
pub fn meshes(
    with: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
    without: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
) -> Trial {
    Trial {
        ordinary: ordinary(Kind::Triangle, as_triangle, with, without),
        hard: Box::new(move || tried_inside(with, without)),
    }
}

fn tried_inside(
    with: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
    without: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
) -> (Tried, [Work; 2]) {
    const RAYS: usize = 4000;
    let far = vector(2e5, -1.3e5, 0.7e5);
    let meshes = [
        Mesh::icosphere(3, Vector::ZERO, 1.0),
        Mesh::icosphere(3, far, 100.0),
        Mesh::cube(Vector::ZERO, 1.0),
        Mesh::fan(100, Vector::ZERO, 1.0),
        Mesh::sheet(20, far, 100.0),
    ];
    let mut random = Random::new(0x5eed_000a);
    let mut asked: Vec<(Ready, Vec<[Vec3; 3]>)> = Vec::new();
    for mesh in &meshes {
        for _ in 0..RAYS {
            let (line, near) = mesh.aim(&mut random);
            let corners = |number: u32| {
                mesh.triangles[number as usize].map(|corner| narrow(mesh.points[corner as usize]))
            };
            asked.push((Ready::of(&line), near.into_iter().map(corners).collect()));
        }
    }
    let through = |form: &dyn Fn(&[Vec3; 3], &Ready) -> Option<f32>| {
        asked.iter().filter(|(ray, near)| !near.iter().any(|corners| form(corners, ray).is_some())).count()
    };
    let faults = [through(&with), through(&without)];
    // Some of the triangles round the place, whether or not the first is met.
    let hard = || -> Prepared<[Vec3; 3]> {
        let some = |(ray, near): &(Ready, Vec<[Vec3; 3]>)| -> Prepared<[Vec3; 3]> {
            near.iter().take(4).map(|corners| (*corners, vec![*ray])).collect()
        };
        asked.iter().flat_map(some).collect()
    };
    (Tried { rays: asked.len(), faults, worst: None }, [work(hard(), with), work(hard(), without)])
}

/// A remedy of triangles, tried with rays that graze level ones: a fault is a distance that lies outside
/// the box, which an accelerator that leaves out the box would not find.
pub fn in_box(
    with: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
    without: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
) -> Trial {
    let judge = |aimed: &Aimed, line: &Line, _: &Truth, reply: Option<f32>| {
        let Some((corners, t)) = as_triangle(&aimed.thing).zip(reply) else { return Some(0.0) };
        let span = flat::span::<true>(&Aabb::around(corners), &Ready::of(line))?;
        (span.entry <= t && t <= span.exit).then_some(0.0)
    };
    Trial {
        ordinary: ordinary(Kind::Triangle, as_triangle, with, without),
        hard: Box::new(move || {
            let (tried, works) = tried(&level_triangles(), as_triangle, judge, with, without);
            (Tried { worst: None, ..tried }, works)
        }),
    }
}

/// Triangles whose boxes have no thickness, and rays that graze them.
fn level_triangles() -> Vec<Aimed> {
    let mut random = Random::new(0x5eed_000f);
    let random = &mut random;
    let mut level = || {
        let (place, axis) = (random.near(Vector::ZERO, 3.0), random.below(3) as usize);
        let mut corner = || {
            let mut corner = random.near(place, 1.0);
            corner[axis] = place[axis];
            corner
        };
        let corners = [corner(), corner(), corner()];
        let mut line = || {
            let share = random.unit();
            let target =
                corners[0] + (corners[1] + (corners[2] - corners[1]) * random.unit() - corners[0]) * share;
            let mut way = random.direction();
            way[axis] *= random.scale(1e-4, 1.0);
            towards(held(target - way * random.scale(0.3, 10.0)), target)
        };
        let lines: Vec<Line> = (0..25).map(|_| line()).collect();
        let truths = vec![Truth::Unclear; lines.len()];
        Aimed { case: "level", thing: Thing::Triangle { corners }, lines, truths, bound: 0.0 }
    };
    (0..400).map(|_| level()).collect()
}

/// A remedy of the slab test, tried with the hard rays at boxes.
pub fn slabs(
    with: impl Fn(&Aabb, &Ready) -> Option<Span> + Copy + 'static,
    without: impl Fn(&Aabb, &Ready) -> Option<Span> + Copy + 'static,
) -> Trial {
    let entry = |span: Span| if span.entry > 0.0 { span.entry } else { span.exit };
    let first = move |aabb: &_, ray: &Ready| with(aabb, ray).map(entry);
    let second = move |aabb: &_, ray: &Ready| without(aabb, ray).map(entry);
    let around = |thing: &Thing| as_cuboid(thing).map(|Cuboid { min, max }| Aabb { min, max });
    Trial {
        ordinary: ordinary(Kind::Cuboid, around, first, second),
        hard: Box::new(move || {
            let asked: Vec<_> = bounds::CASES.iter().flat_map(|case| bounds::some(case, 2000)).collect();
            let mut faults = [0; 2];
            for asked in &asked {
                let ready = Ready::of(&asked.line);
                faults[0] += usize::from(asked.is_wrong(with(&asked.aabb, &ready).is_some()));
                faults[1] += usize::from(asked.is_wrong(without(&asked.aabb, &ready).is_some()));
            }
            let hard: Prepared<Aabb> =
                asked.iter().map(|asked| (asked.aabb, vec![Ready::of(&asked.line)])).collect();
            let works = [work(hard.clone(), first), work(hard, second)];
            (Tried { rays: asked.len(), faults, worst: None }, works)
        }),
    }
}

// Things as the core keeps them.

pub fn as_sphere(thing: &Thing) -> Option<Sphere> {
    let Thing::Sphere { center, radius } = thing else { return None };
    Some(Sphere { center: narrow(*center), radius: *radius as f32 })
}

pub fn as_cone(thing: &Thing) -> Option<Cone> {
    let Thing::Cone { base, base_radius, end, end_radius, capped } = thing else { return None };
    Cone::new(narrow(*base), *base_radius as f32, narrow(*end), *end_radius as f32, *capped)
}

pub fn as_torus(thing: &Thing) -> Option<Torus> {
    let Thing::Torus { center, axis, major, minor } = thing else { return None };
    let axis = unit(narrow(*axis))?;
    Some(Torus { center: narrow(*center), axis, major: *major as f32, minor: *minor as f32 })
}

pub fn as_triangle(thing: &Thing) -> Option<[Vec3; 3]> {
    let Thing::Triangle { corners } = thing else { return None };
    Some(corners.map(narrow))
}

pub fn as_polygon(thing: &Thing) -> Option<flat::Outline> {
    let Thing::Polygon { corners } = thing else { return None };
    let corners: Vec<Vec3> = corners.iter().copied().map(narrow).collect();
    let plane = Polygon::new(0, &corners, false)?;
    Some(flat::Outline { level: plane.normal.dot(plane.point), plane, corners })
}

pub fn as_plane(thing: &Thing) -> Option<flat::Level<Plane>> {
    let Thing::Plane { point, normal } = thing else { return None };
    let (point, normal) = (narrow(*point), unit(narrow(*normal))?);
    Some(flat::Level { it: Plane { point, normal, item: ItemId(0) }, level: normal.dot(point) })
}

pub fn as_disc(thing: &Thing) -> Option<flat::Level<Disc>> {
    let Thing::Disc { center, normal, radius } = thing else { return None };
    let (center, normal) = (narrow(*center), unit(narrow(*normal))?);
    let it = Disc { center, normal, radius: *radius as f32 };
    Some(flat::Level { it, level: normal.dot(center) })
}

pub fn as_cuboid(thing: &Thing) -> Option<Cuboid> {
    let Thing::Cuboid { min, max } = thing else { return None };
    Some(Cuboid { min: narrow(*min), max: narrow(*max) })
}

pub fn as_turned(thing: &Thing) -> Option<flat::Turned> {
    let Thing::TurnedCuboid { center, half, first, third } = thing else { return None };
    let it = TurnedCuboid::new(narrow(*center), narrow(*half), narrow(*first), narrow(*third))?;
    Some(flat::Turned { own: flat::own(it.center, it.axes), it })
}
