//! Nearest hits of single rays.
//!
//! Any numbers are accepted. A ray that is invalid in this precision is a miss: non-finite numbers, a zero direction, or an
//! origin outside the coordinate range.

use strahl_core::accel::Accelerator;
use strahl_core::geometry::Ray;
use strahl_core::math::MAX_COORDINATE;
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Real, Vec3, World, vec3};

use crate::ray_query::{RayHit, RayInput};

/// The nearest hit of a query.
///
/// The core expects directions of about unit length: squares of very large or small components overflow or underflow. So
/// the direction is scaled to a largest component in `[1, 2)` by a power of two, which is exact; `t` is scaled back, also
/// exactly.
#[allow(clippy::useless_conversion, clippy::unnecessary_cast)] // in double precision
pub fn nearest<A: Accelerator>(
    world: &World<'_, A>,
    query: &RayInput,
    scratch: &mut A::Scratch,
) -> Option<RayHit> {
    let RayInput { origin, direction, t_max } = *query;
    let is_near = |x: f64| x.abs() <= f64::from(MAX_COORDINATE);
    let size = direction.into_iter().map(f64::abs).fold(0.0, |a, b| if a > b { a } else { b });
    let is_ray = origin.into_iter().all(is_near) && direction.into_iter().all(f64::is_finite) && size > 0.0;
    if !is_ray || t_max.is_nan() || t_max <= 0.0 {
        return None;
    }
    let power = libm::ilogb(size);
    let narrow = |[x, y, z]: [f64; 3]| vec3(x as Real, y as Real, z as Real);
    let ray = Ray::new(narrow(origin), narrow(direction.map(|x| libm::scalbn(x, -power))));

    // Rounded up to a neighboring number; hits beyond `t_max` are rejected below.
    let farthest = (libm::scalbn(t_max, power) as Real).next_up();
    let hit = world.nearest_hit::<AllEffects, _>(&ray, farthest, RayKind::Camera, scratch, &mut ())?;
    let t = libm::scalbn(f64::from(hit.t), -power);
    if !(t > 0.0 && t <= t_max && t.is_finite()) {
        return None;
    }
    let surface = world.surface_interaction::<AllEffects>(&ray, hit)?;
    let wide = |v: Vec3| [f64::from(v.x), f64::from(v.y), f64::from(v.z)];
    Some(RayHit { t, object: hit.item.0, point: wide(surface.point), normal: wide(surface.normal) })
}
