//! Walks through grid, octree and hierarchy, with a switch for each remedy.
//!
//! They offer boxes to a query that meets each at the beginning of its own interval, so that little
//! else is counted than the walk. What is right is what the list of all boxes says, to the last bit.

pub mod grid;
pub mod hierarchy;
mod inside;
pub mod octree;

use strahl_core::{Aabb, Cuboid, Vec3};

use super::flat::span;
use super::{Ready, Reply, Trial, Tried, as_cuboid, work};
use crate::Random;
use crate::hard::cost::Work;
use crate::hard::lattice::{hard_to_cut, lattice, row, uneven};
use crate::hard::{held, towards};
use crate::thing::{Line, Thing, Vector};

/// What is met first, and how far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    t: f32,
    item: u32,
}

impl Reply for Met {
    fn t(&self) -> f32 {
        self.t
    }
    fn normal(&self) -> Option<Vector> {
        None
    }
    fn sum(&self) -> f32 {
        self.t + self.item as f32
    }
}

/// The query for the nearest box, as the core's: of two at one distance the lower number wins.
struct Nearest<'a> {
    boxes: &'a [Aabb],
    ray: &'a Ready,
    reach: f32,
    item: u32,
}

impl<'a> Nearest<'a> {
    fn new(boxes: &'a [Aabb], ray: &'a Ready) -> Self {
        Nearest { boxes, ray, reach: f32::MAX, item: u32::MAX }
    }

    /// `TIES`: else the first that is asked wins.
    #[inline(always)]
    fn test<const TIES: bool>(&mut self, item: u32) {
        let Some(t) = distance(&self.boxes[item as usize], self.ray) else { return };
        if t < self.reach || TIES && t == self.reach && item < self.item {
            (self.reach, self.item) = (t, item);
        }
    }

    fn met(self) -> Option<Met> {
        (self.item != u32::MAX).then_some(Met { t: self.reach, item: self.item })
    }
}

/// Where a ray comes into a box, or goes out of the one that it starts in.
#[inline(always)]
fn distance(aabb: &Aabb, ray: &Ready) -> Option<f32> {
    let span = span::<true>(aabb, ray)?;
    let t = if span.entry > 0.0 { span.entry } else { span.exit };
    (t > 0.0).then_some(t)
}

fn list(boxes: &[Aabb], ray: &Ready) -> Option<Met> {
    let mut nearest = Nearest::new(boxes, ray);
    (0..boxes.len() as u32).for_each(|item| nearest.test::<true>(item));
    nearest.met()
}

/// Boxes, and the rays at them.
type Scene = (Vec<Aabb>, Vec<Ready>);

fn scene((things, lines): (Vec<Thing>, Vec<Line>)) -> Scene {
    let aabb = |thing: &Thing| as_cuboid(thing).map(|Cuboid { min, max }| Aabb { min, max });
    (things.iter().filter_map(aabb).collect(), lines.iter().map(Ready::of).collect())
}

/// Rays in walls, edges and corners of cells, and scenes that are hard to cut.
fn hard() -> Vec<Scene> {
    let mut random = Random::new(0x5eed_0010);
    let mut some = |hard: fn(&mut Random) -> (Vec<Thing>, Vec<Line>)| -> Vec<Scene> {
        (0..40).map(|_| scene(hard(&mut random))).collect()
    };
    [some(lattice), some(uneven), some(row), some(hard_to_cut)].concat()
}

/// Four hundred small boxes evenly spread, and rays through them from outside and inside.
fn ordinary() -> Vec<Scene> {
    let mut random = Random::new(0x5eed_0011);
    let cube = |random: &mut Random| {
        let place = random.near(Vector::ZERO, 1.0);
        let half = Vector::new(random.unit(), random.unit(), random.unit()) * 0.06;
        Thing::Cuboid { min: held(place - half), max: held(place + half) }
    };
    let ray = |random: &mut Random| {
        let eye = held(random.direction() * random.between(0.0, 5.0));
        towards(eye, random.near(Vector::ZERO, 1.0))
    };
    let scene = |random: &mut Random| {
        let things = (0..400).map(|_| cube(random)).collect();
        scene((things, (0..100).map(|_| ray(random)).collect()))
    };
    (0..10).map(|_| scene(&mut random)).collect()
}

/// A remedy of a walk, tried with hard rays: a fault is an answer that is not the list's.
pub fn walked<S: AsRef<[Aabb]> + 'static>(
    build: [fn(Vec<Aabb>) -> S; 2],
    with: impl Fn(&S, &Ready) -> Option<Met> + Copy + 'static,
    without: impl Fn(&S, &Ready) -> Option<Met> + Copy + 'static,
) -> Trial {
    let works = move |scenes: fn() -> Vec<Scene>| -> [Work; 2] {
        let built = |build: fn(Vec<Aabb>) -> S| {
            scenes().into_iter().map(|(boxes, rays)| (build(boxes), rays)).collect::<Vec<_>>()
        };
        [work(built(build[0]), with), work(built(build[1]), without)]
    };
    Trial {
        ordinary: works(ordinary),
        hard: Box::new(move || {
            let (mut rays, mut faults) = (0, [0; 2]);
            for (boxes, asked) in hard() {
                let [one, other] = build.map(|build| build(boxes.clone()));
                for ray in &asked {
                    let truth = list(one.as_ref(), ray);
                    rays += 1;
                    faults[0] += usize::from(with(&one, ray) != truth);
                    faults[1] += usize::from(without(&other, ray) != truth);
                }
            }
            (Tried { rays, faults, worst: None }, works(hard))
        }),
    }
}

/// Planes that cut space into equal cells, as the core's.
#[derive(Clone, Copy)]
struct Walls {
    first: Vec3,
    spacing: Vec3,
}

impl Walls {
    fn new(bounds: Aabb, cells: Vec3) -> Self {
        let spacing = |axis: usize| {
            let (min, max) = (bounds.min[axis], bounds.max[axis]);
            let spacing = (max - min) / cells[axis];
            let is_enough = min + cells[axis] * spacing >= max;
            if is_enough { spacing } else { (spacing * (1.0 + 4.0 * f32::EPSILON)).next_up() }
        };
        Walls { first: bounds.min, spacing: Vec3::from_array([0, 1, 2].map(spacing)) }
    }

    #[inline(always)]
    fn at(&self, number: Vec3) -> Vec3 {
        self.first + number * self.spacing
    }
}

const WIDEN: f32 = 1.0 + 4.0 * f32::EPSILON;
