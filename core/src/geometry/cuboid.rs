//! Box: upright on the axes, or turned.
//!
//! The slabs are intersected by division: products with the reciprocal are faster but less exact, and an
//! accelerator makes this test rare.

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::{Aabb, Ray, ShapeFault, Surface, check_point, check_unit, ray::LEAVING};
use crate::math::{Axis, Real, Vec3, abs, gamma, unit};

/// A solid box with its faces upright on the axes; its normal points outward.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Cuboid {
    /// The smallest coordinates.
    pub min: Vec3,
    /// The largest coordinates; none below those of `min`.
    pub max: Vec3,
}

/// A solid box turned in space; its normal points outward.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct TurnedCuboid {
    /// The middle.
    pub center: Vec3,
    /// Half of its length along each of its axes; none below zero.
    pub half: Vec3,
    /// Its axes: of length one, upright on each other.
    pub axes: [Vec3; 3],
}

/// Where a ray goes through the wall of a box: how far, and the wall's outward normal.
struct Wall {
    t: Real,
    axis: Axis,
    outward: Real,
}

impl Wall {
    fn normal(&self) -> Vec3 {
        self.outward
            * match self.axis {
                Axis::X => Vec3::X,
                Axis::Y => Vec3::Y,
                Axis::Z => Vec3::Z,
            }
    }
}

/// The nearest wall in front of the ray's origin: where it comes in, or goes out when it
/// starts inside.
///
/// A wall's distance that is NaN (the ray runs in it) takes part in no comparison: such a ray
/// is inside that pair of walls.
fn nearest_wall(min: Vec3, max: Vec3, ray: &Ray) -> Option<Wall> {
    // Quotients and not products with the reciprocal, whose rounding would move the wall.
    let low = (min - ray.origin) / ray.direction;
    let high = (max - ray.origin) / ray.direction;
    let mut enter = Wall { t: Real::NEG_INFINITY, axis: Axis::X, outward: 1.0 };
    let mut leave = Wall { t: Real::INFINITY, axis: Axis::X, outward: 1.0 };
    for (axis, inverse, low, high) in [
        (Axis::X, ray.inverse.x, low.x, high.x),
        (Axis::Y, ray.inverse.y, low.y, high.y),
        (Axis::Z, ray.inverse.z, low.z, high.z),
    ] {
        let (near, far, onward) = if inverse >= 0.0 { (low, high, 1.0) } else { (high, low, -1.0) };
        if near > enter.t {
            enter = Wall { t: near, axis, outward: -onward };
        }
        if far < leave.t {
            leave = Wall { t: far, axis, outward: onward };
        }
    }
    if enter.t > leave.t {
        None
    } else if enter.t > 0.0 {
        Some(enter)
    } else {
        Some(leave)
    }
}

impl Cuboid {
    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_point(self.min)?;
        check_point(self.max)?;
        if self.min.cmple(self.max).all() { Ok(()) } else { Err(ShapeFault::Size) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        nearest_wall(self.min, self.max, ray).map(|wall| wall.t)
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Option<Surface> {
        let wall = nearest_wall(self.min, self.max, ray)?;
        let point = ray.at(t);
        let face = if wall.outward > 0.0 { self.max } else { self.min };
        let point = match wall.axis {
            Axis::X => Vec3::new(face.x, point.y, point.z),
            Axis::Y => Vec3::new(point.x, face.y, point.z),
            Axis::Z => Vec3::new(point.x, point.y, face.z),
        };
        // Along the normal the point is exact; the step must only outgrow the next test's rounding.
        Some(Surface::flat(point, abs(point) * gamma(4 + LEAVING), wall.normal()))
    }
}

impl TurnedCuboid {
    /// A box round `center`, `half` of its lengths along its axes: the third is `third`, the
    /// first is the part of `first` upright on it.
    ///
    /// None when the two are parallel or no directions.
    pub fn new(center: Vec3, half: Vec3, first: Vec3, third: Vec3) -> Option<Self> {
        let third = unit(third)?;
        let first = unit(first)?;
        let second = unit(third.cross(first))?;
        Some(TurnedCuboid { center, half, axes: [second.cross(third), second, third] })
    }

    pub(super) fn check(&self) -> Result<(), ShapeFault> {
        check_point(self.center)?;
        check_point(self.half)?;
        let [x, y, z] = self.axes;
        for axis in [x, y, z] {
            check_unit(axis)?;
        }
        if abs(Vec3::new(x.dot(y), y.dot(z), z.dot(x))).max_element() > 1e-5 {
            return Err(ShapeFault::Axes);
        }
        if self.half.cmpge(Vec3::ZERO).all() { Ok(()) } else { Err(ShapeFault::Size) }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let [x, y, z] = self.axes;
        let reach = abs(x) * self.half.x + abs(y) * self.half.y + abs(z) * self.half.z;
        Aabb::round(self.center, reach * (1.0 + gamma(8)))
    }

    /// The ray in the box's own frame: the centre is subtracted first, so that errors follow
    /// the distance between both and not their place.
    fn turned(&self, ray: &Ray) -> Ray {
        let [x, y, z] = self.axes;
        let own = |v: Vec3| Vec3::new(v.dot(x), v.dot(y), v.dot(z));
        Ray::new(own(ray.origin - self.center), own(ray.direction))
    }

    pub(super) fn hit(&self, ray: &Ray) -> Option<Real> {
        nearest_wall(-self.half, self.half, &self.turned(ray)).map(|wall| wall.t)
    }

    pub(super) fn surface(&self, ray: &Ray, t: Real) -> Option<Surface> {
        let wall = nearest_wall(-self.half, self.half, &self.turned(ray))?;
        let [x, y, z] = self.axes;
        let (axis, half) = match wall.axis {
            Axis::X => (x, self.half.x),
            Axis::Y => (y, self.half.y),
            Axis::Z => (z, self.half.z),
        };
        let normal = axis * wall.outward;
        let p = ray.at_from(t, self.center);
        let point = self.center + (p - normal * (p.dot(normal) - half));
        let error = (abs(self.center) + Vec3::splat(self.half.max_element())) * gamma(16 + LEAVING);
        Some(Surface::flat(point, error, normal))
    }
}
