//! Each remedy alone: what it costs, and what goes wrong without it.
//!
//! The core's tests are written here again with a switch for each remedy. With all of them on they
//! are the core's own method; what the core does besides to be quick (a box asked first, an early
//! miss) is left out. A test holds that they are not wrong for any hard ray, and that without the
//! remedy they are, or are less exact. Both forms are run through the same rays, so that the
//! difference is what the remedy costs.

// As in the core: comparisons that are false for NaN are written as they are meant.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod flat;
mod light;
mod round;
mod torus;

use strahl_core::{
    Axis, Cone, Cuboid, Disc, ItemId, Plane, Polygon, Sphere, Torus, TurnedCuboid, Vec3, unit, vec3,
};

use super::cost::{Work, scenes};
use super::{Aimed, Answer, Mesh, aimed_at, bounds, held, judged, towards};
use crate::oracle::Truth;
use crate::thing::{Kind, Line, Thing, Vector, vector};
use crate::{Core, Random, single};

/// A remedy for something that goes wrong in single precision.
pub struct Remedy {
    /// The shape or the room that it is about.
    pub family: &'static str,
    /// What is done.
    pub name: &'static str,
    /// What is done without it.
    pub without: &'static str,
    /// Whether the criteria need it; else another remedy does what it was for.
    pub is_needed: bool,
    trial: fn() -> Trial,
}

/// What is found of a remedy: each with it and without it.
pub struct Trial {
    /// Hard rays tried.
    pub rays: usize,
    /// Of these, answered wrongly.
    pub faults: [usize; 2],
    /// The worst error of the others, in the unit of the family's cases; none where there is none.
    pub worst: Option<[f64; 2]>,
    /// The same rays, to measure the time.
    pub hard: [Work; 2],
    /// Ordinary ones, to count instructions.
    pub ordinary: [Work; 2],
}

impl Remedy {
    /// Tries it.
    pub fn trial(&self) -> Trial {
        (self.trial)()
    }
}

/// All remedies.
pub fn remedies() -> Vec<Remedy> {
    macro_rules! remedies {
        ($($family:literal: $name:literal, not $without:literal $($spare:ident)?: $trial:expr;)*) => {
            vec![$(Remedy {
                family: $family,
                name: $name,
                without: $without,
                is_needed: remedies!(@ $($spare)?),
                trial: || $trial,
            },)*]
        };
        (@) => { true };
        (@ spare) => { false };
    }
    const T: bool = true;
    const F: bool = false;
    remedies! {
        "sphere": "discriminant from the foot of the perpendicular", not "`b^2 - ac`":
            shaped("sphere", Kind::Sphere, as_sphere, round::sphere::<T, T>, round::sphere::<F, T>);
        "sphere": "roots without cancellation", not "`(b -+ root) / a`" spare:
            shaped("sphere", Kind::Sphere, as_sphere, round::sphere::<T, T>, round::sphere::<T, F>);
        "sphere": "direction brought to about one by a power of two", not "the direction as it is":
            shaped("sphere", Kind::Sphere, as_sphere, round::sphere_any_length::<T>, round::sphere_any_length::<F>);
        "sphere": "normal brought to length one", not "divided by the radius":
            shaped("sphere", Kind::Sphere, as_sphere, round::sphere_normal::<T>, round::sphere_normal::<F>);
        "cone, cylinder": "from where the ray is nearest to its middle", not "from the eye":
            shaped("cone, cylinder", Kind::CappedCone, as_cone, round::cone::<T, T, T>, round::cone::<F, T, T>);
        "cone, cylinder": "discriminant as a difference of two squares", not "`b^2 - ac`":
            shaped("cone, cylinder", Kind::CappedCone, as_cone, round::cone::<T, T, T>, round::cone::<T, F, T>);
        "cone, cylinder": "roots without cancellation", not "`(b -+ root) / a`":
            shaped("cone, cylinder", Kind::CappedCone, as_cone, round::cone::<T, T, T>, round::cone::<T, T, F>);
        "torus": "from where the ray is nearest to its middle", not "from the eye":
            shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<F, T, T, T>);
        "torus": "roots parted by turning points and bracketed", not "Ferrari's formulas":
            shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<T, F, T, T>);
        "torus": "roots of the distance to the tube", not "of the quartic":
            shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<T, T, F, T>);
        "torus": "turning points refined for thin tubes", not "as the cubic gives them" spare:
            shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<T, T, T, F>);
        "triangle": "edge functions shared by neighbours (Woop)", not "each by itself (Möller, Trumbore)":
            meshes(flat::triangle::<T>, flat::triangle_by_itself);
        "triangle": "edge functions exact where they cancel", not "rounded":
            shaped("triangle", Kind::Triangle, as_triangle, flat::triangle::<T>, flat::triangle::<F>);
        "triangle": "distance moved into its own box", not "as computed":
            in_box(flat::triangle_in_box::<T>, flat::triangle_in_box::<F>);
        "polygon": "an edge contains one of its ends", not "both":
            shaped("polygon", Kind::Polygon, as_polygon, flat::polygon::<T, T>, flat::polygon::<T, F>);
        "polygon": "plane through a point near its corners", not "by its distance from the origin":
            shaped("polygon", Kind::Polygon, as_polygon, flat::polygon::<T, T>, flat::polygon::<F, T>);
        "plane": "through its point", not "by its distance from the origin":
            shaped("plane", Kind::Plane, as_plane, flat::plane::<T>, flat::plane::<F>);
        "disc": "everything as the eye sees it", not "from the origin":
            shaped("disc", Kind::Disc, as_disc, flat::disc::<T>, flat::disc::<F>);
        "box": "walls by quotients", not "products with the reciprocal":
            shaped("box", Kind::Cuboid, as_cuboid, flat::cuboid::<T, T>, flat::cuboid::<F, T>);
        "box": "order of walls by the reciprocal's sign", not "`d >= 0`":
            shaped("box", Kind::Cuboid, as_cuboid, flat::cuboid::<T, T>, flat::cuboid::<T, F>);
        "turned box": "centre subtracted, then turned", not "turned, then subtracted":
            shaped("turned box", Kind::TurnedCuboid, as_turned, flat::turned::<T>, flat::turned::<F>);
        "slab test": "far end widened", not "as computed":
            slabs(flat::span::<T>, flat::span::<F>);
        "leaving": "a step that follows the error", not "1e-4 along the normal":
            light::leaving();
        "refraction": "sine from the part along the surface", not "`1 - cos^2`":
            light::refraction(light::refracted::<T, T>, light::refracted::<F, T>);
        "refraction": "total reflection before any root", not "the root of less than nothing":
            light::refraction(light::refracted::<T, T>, light::refracted::<T, F>);
    }
}

/// A ray as the core keeps it.
#[derive(Clone, Copy)]
#[allow(missing_docs)] // as in `strahl_core::Ray`
pub struct Ready {
    pub o: Vec3,
    pub d: Vec3,
    pub inverse: Vec3,
    pub axis: Axis,
    pub third: f32,
    pub across: Vec3,
    pub upward: Vec3,
    pub along: Vec3,
    pub square: f32,
    pub scale: f32,
}

fn narrow(v: Vector) -> Vec3 {
    vec3(v.x as f32, v.y as f32, v.z as f32)
}

/// One over the power of two next below the largest component.
#[inline(always)]
pub fn scale_of(d: Vec3) -> f32 {
    let greatest = |a: f32, b: f32| if a > b { a } else { b };
    let largest = greatest(d.x.abs(), greatest(d.y.abs(), d.z.abs()));
    let power = f32::from_bits(largest.to_bits() & f32::INFINITY.to_bits());
    1.0 / greatest(power, f32::MIN_POSITIVE)
}

impl Ready {
    /// The ray of a line.
    pub fn of(line: &Line) -> Self {
        let (o, d) = (narrow(line.origin), narrow(line.direction));
        let (inverse, axis, scale) = (1.0 / d, Axis::largest_of(d), scale_of(d));
        let (turned, third) = (axis.to_third(d), axis.to_third(inverse).z);
        let back = |v: Vec3| match axis {
            Axis::X => vec3(v.z, v.x, v.y),
            Axis::Y => vec3(v.y, v.z, v.x),
            Axis::Z => v,
        };
        let along = d * scale;
        Ready {
            o,
            d,
            inverse,
            axis,
            third,
            across: back(vec3(1.0, 0.0, -(turned.x * third))),
            upward: back(vec3(0.0, 1.0, -(turned.y * third))),
            along,
            square: along.dot(along),
            scale,
        }
    }
}

/// What a form answers: how far, and a normal where it is about that.
pub trait Reply: Copy {
    /// The distance.
    fn t(&self) -> f32;
    /// The normal; none when the form tells none.
    fn normal(&self) -> Option<Vector>;
    /// All of it in one number, so that nothing can be left out.
    fn sum(&self) -> f32;
}

impl Reply for f32 {
    fn t(&self) -> f32 {
        *self
    }
    fn normal(&self) -> Option<Vector> {
        None
    }
    fn sum(&self) -> f32 {
        *self
    }
}

impl Reply for (f32, Vec3) {
    fn t(&self) -> f32 {
        self.0
    }
    fn normal(&self) -> Option<Vector> {
        Some(vector(self.1.x.into(), self.1.y.into(), self.1.z.into()))
    }
    fn sum(&self) -> f32 {
        self.0 + self.1.x + self.1.y + self.1.z
    }
}

/// Shapes and rays at them, to be answered again and again.
type Prepared<S> = Vec<(S, Vec<Ready>)>;

fn prepared<S>(rays: &[(Thing, Vec<Line>)], of: fn(&Thing) -> Option<S>) -> Prepared<S> {
    rays.iter()
        .filter_map(|(thing, lines)| Some((of(thing)?, lines.iter().map(Ready::of).collect())))
        .collect()
}

fn work<S: 'static, R: Reply>(
    prepared: Prepared<S>,
    form: impl Fn(&S, &Ready) -> Option<R> + 'static,
) -> Work {
    let rays = prepared.iter().map(|(_, rays)| rays.len()).sum();
    Work::new(rays, move || {
        let of = |(shape, rays): &(S, Vec<Ready>)| -> f64 {
            rays.iter().filter_map(|ray| form(shape, ray)).map(|reply| f64::from(reply.sum())).sum()
        };
        prepared.iter().map(of).sum()
    })
}

/// A remedy of a shape, tried with the hard rays of its family.
fn shaped<S: 'static, R: Reply + 'static>(
    family: &str,
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
    tried(aimed_at(family), kind, of, judge, with, without)
}

/// Tries both forms with hard rays, and prepares the work for both.
fn tried<S: 'static, R: Reply + 'static>(
    aimed: &[Aimed],
    kind: Kind,
    of: fn(&Thing) -> Option<S>,
    judge: impl Fn(&Aimed, &Line, &Truth, Option<R>) -> Option<f64>,
    with: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
    without: impl Fn(&S, &Ready) -> Option<R> + Copy + 'static,
) -> Trial {
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
    let hard: Vec<(Thing, Vec<Line>)> =
        aimed.iter().step_by(10).map(|aimed| (aimed.thing.clone(), aimed.lines.clone())).collect();
    let ordinary = scenes(kind);
    Trial {
        rays,
        faults,
        worst: Some(worst).filter(|worst| worst[1] > 0.0),
        hard: [work(prepared(&hard, of), with), work(prepared(&hard, of), without)],
        ordinary: [work(prepared(&ordinary, of), with), work(prepared(&ordinary, of), without)],
    }
}

/// A remedy of triangles, tried with rays at edges and corners of closed meshes from inside: a
/// fault is a ray that gets through.
fn meshes(
    with: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
    without: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
) -> Trial {
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
    let ordinary = scenes(Kind::Triangle);
    Trial {
        rays: asked.len(),
        faults,
        worst: None,
        hard: [work(hard(), with), work(hard(), without)],
        ordinary: [
            work(prepared(&ordinary, as_triangle), with),
            work(prepared(&ordinary, as_triangle), without),
        ],
    }
}

/// A remedy of triangles, tried with rays that graze level ones: a fault is a distance that lies outside
/// the box, which an accelerator that leaves out the box would not find.
fn in_box(
    with: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
    without: impl Fn(&[Vec3; 3], &Ready) -> Option<f32> + Copy + 'static,
) -> Trial {
    let judge = |aimed: &Aimed, line: &Line, _: &Truth, reply: Option<f32>| {
        let Some((corners, t)) = as_triangle(&aimed.thing).zip(reply) else { return Some(0.0) };
        let span = flat::span::<true>(&strahl_core::Aabb::around(corners), &Ready::of(line))?;
        (span.entry <= t && t <= span.exit).then_some(0.0)
    };
    let mut trial = tried(&level_triangles(), Kind::Triangle, as_triangle, judge, with, without);
    trial.worst = None;
    trial
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
fn slabs(
    with: impl Fn(&strahl_core::Aabb, &Ready) -> Option<strahl_core::Span> + Copy + 'static,
    without: impl Fn(&strahl_core::Aabb, &Ready) -> Option<strahl_core::Span> + Copy + 'static,
) -> Trial {
    let mut asked = Vec::new();
    for case in bounds::CASES {
        asked.extend(bounds::some(&case, 2000));
    }
    let mut faults = [0; 2];
    for asked in &asked {
        let ready = Ready::of(&asked.line);
        faults[0] += usize::from(asked.is_wrong(with(&asked.aabb, &ready).is_some()));
        faults[1] += usize::from(asked.is_wrong(without(&asked.aabb, &ready).is_some()));
    }
    let rays = asked.len();
    let hard: Vec<(strahl_core::Aabb, Vec<Ready>)> =
        asked.iter().map(|asked| (asked.aabb, vec![Ready::of(&asked.line)])).collect();
    let ordinary: Vec<(strahl_core::Aabb, Vec<Ready>)> = scenes(Kind::Cuboid)
        .iter()
        .filter_map(|(thing, lines)| {
            let Cuboid { min, max } = as_cuboid(thing)?;
            Some((strahl_core::Aabb { min, max }, lines.iter().map(Ready::of).collect()))
        })
        .collect();
    let entry = |span: strahl_core::Span| if span.entry > 0.0 { span.entry } else { span.exit };
    let with = move |aabb: &_, ray: &Ready| with(aabb, ray).map(entry);
    let without = move |aabb: &_, ray: &Ready| without(aabb, ray).map(entry);
    Trial {
        rays,
        faults,
        worst: None,
        hard: [work(hard.clone(), with), work(hard, without)],
        ordinary: [work(ordinary.clone(), with), work(ordinary, without)],
    }
}

// Things as the core keeps them.

fn as_sphere(thing: &Thing) -> Option<Sphere> {
    let Thing::Sphere { center, radius } = thing else { return None };
    Some(Sphere { center: narrow(*center), radius: *radius as f32 })
}

fn as_cone(thing: &Thing) -> Option<Cone> {
    let Thing::Cone { base, base_radius, end, end_radius, capped } = thing else { return None };
    Cone::new(narrow(*base), *base_radius as f32, narrow(*end), *end_radius as f32, *capped)
}

fn as_torus(thing: &Thing) -> Option<Torus> {
    let Thing::Torus { center, axis, major, minor } = thing else { return None };
    let axis = unit(narrow(*axis))?;
    Some(Torus { center: narrow(*center), axis, major: *major as f32, minor: *minor as f32 })
}

fn as_triangle(thing: &Thing) -> Option<[Vec3; 3]> {
    let Thing::Triangle { corners } = thing else { return None };
    Some(corners.map(narrow))
}

fn as_polygon(thing: &Thing) -> Option<flat::Outline> {
    let Thing::Polygon { corners } = thing else { return None };
    let corners: Vec<Vec3> = corners.iter().copied().map(narrow).collect();
    let plane = Polygon::new(0, &corners, false)?;
    Some(flat::Outline { level: plane.normal.dot(plane.point), plane, corners })
}

fn as_plane(thing: &Thing) -> Option<flat::Level<Plane>> {
    let Thing::Plane { point, normal } = thing else { return None };
    let (point, normal) = (narrow(*point), unit(narrow(*normal))?);
    Some(flat::Level { it: Plane { point, normal, item: ItemId(0) }, level: normal.dot(point) })
}

fn as_disc(thing: &Thing) -> Option<flat::Level<Disc>> {
    let Thing::Disc { center, normal, radius } = thing else { return None };
    let (center, normal) = (narrow(*center), unit(narrow(*normal))?);
    let it = Disc { center, normal, radius: *radius as f32 };
    Some(flat::Level { it, level: normal.dot(center) })
}

fn as_cuboid(thing: &Thing) -> Option<Cuboid> {
    let Thing::Cuboid { min, max } = thing else { return None };
    Some(Cuboid { min: narrow(*min), max: narrow(*max) })
}

fn as_turned(thing: &Thing) -> Option<flat::Turned> {
    let Thing::TurnedCuboid { center, half, first, third } = thing else { return None };
    let it = TurnedCuboid::new(narrow(*center), narrow(*half), narrow(*first), narrow(*third))?;
    Some(flat::Turned { own: flat::own(it.center, it.axes), it })
}

/// What the core finds of each line.
fn found(thing: &Thing, lines: &[Line]) -> Vec<Option<crate::Found>> {
    single::Stage::with(std::slice::from_ref(thing)).cast(lines)
}
