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
mod shapes;
mod terminator;
mod torus;
mod walks;

use strahl_core::{Axis, Vec3, vec3};

use super::cost::Work;
use crate::thing::{Kind, Line, Thing, Vector, vector};
use crate::{Core, single};
use shapes::{
    as_cone, as_cuboid, as_disc, as_plane, as_polygon, as_sphere, as_torus, as_triangle, as_turned, in_box,
    meshes, shaped, slabs,
};
use walks::{grid::Grid, hierarchy::Hierarchy, octree::Octree, walked};

/// A remedy for something that goes wrong in single precision.
pub struct Remedy {
    /// The shape or the room that it is about.
    pub family: &'static str,
    /// What is done.
    pub name: &'static str,
    /// What is done without it.
    pub without: &'static str,
    /// Where in the project it is.
    pub room: &'static str,
    /// Whether the criteria need it; else another remedy does what it was for.
    pub is_needed: bool,
    trial: fn() -> Trial,
}

/// How a remedy is tried: always with it and without it.
pub struct Trial {
    /// Ordinary rays, to count instructions.
    pub ordinary: [Work; 2],
    /// Asked for only where it is wanted, for the oracle takes its time.
    hard: Box<dyn Fn() -> (Tried, [Work; 2])>,
}

/// What hard rays say of a remedy.
#[derive(Clone, Copy, Debug)]
pub struct Tried {
    /// Hard rays tried.
    pub rays: usize,
    /// Of these, answered wrongly.
    pub faults: [usize; 2],
    /// The worst error of the others, in the unit of the family's cases; none where there is none.
    pub worst: Option<[f64; 2]>,
}

impl Remedy {
    /// The rays that it is tried with.
    pub fn trial(&self) -> Trial {
        (self.trial)()
    }

    /// Tries it with hard rays; and the same rays, or some of them, to measure the time.
    pub fn tried(&self) -> (Tried, [Work; 2]) {
        (self.trial().hard)()
    }
}

/// All remedies.
pub fn remedies() -> Vec<Remedy> {
    macro_rules! remedies {
        ($($family:literal in $room:literal {
            $($name:literal, not $without:literal $($spare:ident)?: $trial:expr;)*
        })*) => {
            vec![$($(Remedy {
                family: $family,
                name: $name,
                without: $without,
                room: $room,
                is_needed: remedies!(@ $($spare)?),
                trial: || $trial,
            },)*)*]
        };
        (@) => { true };
        (@ spare) => { false };
    }
    const T: bool = true;
    const F: bool = false;
    remedies! {
        "sphere" in "core/src/geometry/sphere.rs" {
            "discriminant from the foot of the perpendicular", not "`b^2 - ac`":
                shaped("sphere", Kind::Sphere, as_sphere, round::sphere::<T, T>, round::sphere::<F, T>);
            "roots without cancellation", not "`(b -+ root) / a`" spare:
                shaped("sphere", Kind::Sphere, as_sphere, round::sphere::<T, T>, round::sphere::<T, F>);
            "direction brought to about one by a power of two", not "the direction as it is":
                shaped("sphere", Kind::Sphere, as_sphere, round::sphere_any_length::<T>, round::sphere_any_length::<F>);
            "normal brought to length one", not "divided by the radius":
                shaped("sphere", Kind::Sphere, as_sphere, round::sphere_normal::<T>, round::sphere_normal::<F>);
        }
        "cone, cylinder" in "core/src/geometry/cone.rs" {
            "from where the ray is nearest to its middle", not "from the eye":
                shaped("cone, cylinder", Kind::CappedCone, as_cone, round::cone::<T, T, T>, round::cone::<F, T, T>);
            "discriminant as a difference of two squares", not "`b^2 - ac`":
                shaped("cone, cylinder", Kind::CappedCone, as_cone, round::cone::<T, T, T>, round::cone::<T, F, T>);
            "roots without cancellation", not "`(b -+ root) / a`":
                shaped("cone, cylinder", Kind::CappedCone, as_cone, round::cone::<T, T, T>, round::cone::<T, T, F>);
        }
        "torus" in "core/src/geometry/torus.rs" {
            "from where the ray is nearest to its middle", not "from the eye":
                shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<F, T, T, T>);
            "roots parted by turning points and bracketed", not "Ferrari's formulas":
                shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<T, F, T, T>);
            "roots of the distance to the tube", not "of the quartic":
                shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<T, T, F, T>);
            "turning points refined for thin tubes", not "as the cubic gives them" spare:
                shaped("torus", Kind::Torus, as_torus, torus::torus::<T, T, T, T>, torus::torus::<T, T, T, F>);
        }
        "triangle" in "core/src/geometry/triangle.rs" {
            "edge functions shared by neighbours (Woop)", not "each by itself (Möller, Trumbore)":
                meshes(flat::triangle::<T>, flat::triangle_by_itself);
            "edge functions exact where they cancel", not "rounded":
                shaped("triangle", Kind::Triangle, as_triangle, flat::triangle::<T>, flat::triangle::<F>);
            "distance moved into its own box", not "as computed":
                in_box(flat::triangle_in_box::<T>, flat::triangle_in_box::<F>);
        }
        "polygon" in "core/src/geometry/polygon.rs" {
            "an edge contains one of its ends", not "both":
                shaped("polygon", Kind::Polygon, as_polygon, flat::polygon::<T, T>, flat::polygon::<T, F>);
            "plane through a point near its corners", not "by its distance from the origin":
                shaped("polygon", Kind::Polygon, as_polygon, flat::polygon::<T, T>, flat::polygon::<F, T>);
        }
        "plane" in "core/src/geometry/plane.rs" {
            "through its point", not "by its distance from the origin":
                shaped("plane", Kind::Plane, as_plane, flat::plane::<T>, flat::plane::<F>);
        }
        "disc" in "core/src/geometry/disc.rs" {
            "everything as the eye sees it", not "from the origin":
                shaped("disc", Kind::Disc, as_disc, flat::disc::<T>, flat::disc::<F>);
        }
        "box" in "core/src/geometry/cuboid.rs" {
            "walls by quotients", not "products with the reciprocal":
                shaped("box", Kind::Cuboid, as_cuboid, flat::cuboid::<T, T>, flat::cuboid::<F, T>);
            "order of walls by the reciprocal's sign", not "`d >= 0`":
                shaped("box", Kind::Cuboid, as_cuboid, flat::cuboid::<T, T>, flat::cuboid::<T, F>);
        }
        "turned box" in "core/src/geometry/cuboid.rs" {
            "centre subtracted, then turned", not "turned, then subtracted":
                shaped("turned box", Kind::TurnedCuboid, as_turned, flat::turned::<T>, flat::turned::<F>);
        }
        "slab test" in "core/src/geometry/bounds.rs" {
            "far end widened", not "as computed":
                slabs(flat::span::<T>, flat::span::<F>);
        }
        "grid" in "core/src/accel/grid/walk.rs" {
            "distances of walls computed from their numbers", not "summed up":
                walked([Grid::of::<T>; 2], Grid::nearest::<T, T, T, T>, Grid::nearest::<F, T, T, T>);
            "close to an edge, the cells on both sides", not "one cell after the other":
                walked([Grid::of::<T>; 2], Grid::nearest::<T, T, T, T>, Grid::nearest::<T, F, T, T>);
            "first cell held against its walls", not "by the point where the ray comes in":
                walked([Grid::of::<T>; 2], Grid::nearest::<T, T, T, T>, Grid::nearest::<T, T, F, T>);
            "along walls no wall is ahead", not "`d >= 0` goes up":
                walked([Grid::of::<T>; 2], Grid::nearest::<T, T, T, T>, Grid::nearest::<T, T, T, F>);
            "boxes listed on both sides of walls that they touch", not "from the cell of one corner to that of the other":
                walked([Grid::of::<T>, Grid::of::<F>], Grid::nearest::<T, T, T, T>, Grid::nearest::<T, T, T, T>);
        }
        "octree" in "core/src/accel/octree/smart.rs" {
            "steps decided by numbers of cells", not "by a point moved beyond the wall":
                walked([Octree::of; 2], Octree::nearest::<T, T, T>, Octree::moved);
            "distances of walls computed from their numbers", not "carried on from node to node":
                walked([Octree::of; 2], Octree::nearest::<T, T, T>, Octree::nearest::<F, T, T>);
            "close to an edge, the cells on both sides", not "one cell after the other":
                walked([Octree::of; 2], Octree::nearest::<T, T, T>, Octree::nearest::<T, F, T>);
            "a ray in a wall walked on both sides", not "on one":
                walked([Octree::of; 2], Octree::nearest::<T, T, T>, Octree::nearest::<T, T, F>);
        }
        "hierarchy" in "core/src/accel/bvh/walk.rs" {
            "far ends of boxes widened", not "as computed":
                walked([Hierarchy::of; 2], Hierarchy::nearest::<T, T, T>, Hierarchy::nearest::<F, T, T>);
            "what is no number changes nothing, -0 is not 0", not "it decides, `d >= 0`":
                walked([Hierarchy::of; 2], Hierarchy::nearest::<T, T, T>, Hierarchy::nearest::<T, F, T>);
            "of two as near the lower number", not "the first that is asked":
                walked([Hierarchy::of; 2], Hierarchy::nearest::<T, T, T>, Hierarchy::nearest::<T, T, F>);
        }
        "shadow terminator" in "core/src/geometry/terminator.rs" {
            "under the horizon, from the round surface meant", not "from the flat one":
                terminator::lifting();
        }
        "leaving" in "core/src/geometry/ray.rs" {
            "a step that follows the error", not "1e-4 along the normal":
                light::leaving();
        }
        "refraction" in "core/src/shade/optics.rs" {
            "sine from the part along the surface", not "`1 - cos^2`":
                light::refraction(light::refracted::<T, T>, light::refracted::<F, T>);
            "total reflection before any root", not "the root of less than nothing":
                light::refraction(light::refracted::<T, T>, light::refracted::<T, F>);
        }
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

/// What the core finds of each line.
fn found(thing: &Thing, lines: &[Line]) -> Vec<Option<crate::Found>> {
    single::Stage::with(std::slice::from_ref(thing)).cast(lines)
}
