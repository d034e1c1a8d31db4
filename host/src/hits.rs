//! What rays hit, for either precision.
//!
//! Here is the door of rays: their numbers may be anything. What is no ray of this precision is
//! answered by a miss: a number that is not finite, a direction without length, an origin
//! farther away than a scene may reach.

use super::accelerators::{Purpose, build};
use super::strahl::{Accelerator, Everything, FARTHEST, Ray, RayKind, Real, Scene, World, vec3};
use super::tables::Stock;
use crate::failure::Failure;
use crate::finding::{Facts, Finding};
use crate::rays::{Cast, Found, Line, NoCast, Stream};

/// Casts all rays of a stream into the scene of these tables.
pub fn cast(
    stock: &Stock,
    finding: &Finding,
    stream: Stream,
) -> Result<(Facts, Result<Cast, Failure>), NoCast> {
    let scene = stock.scene()?;
    build(&scene, finding, Casting { scene, stream })
}

struct Casting<'s> {
    scene: Scene<'s>,
    stream: Stream,
}

impl Purpose for Casting<'_> {
    type Answer = (Facts, Result<Cast, Failure>);

    fn with<A: Accelerator + Sync>(self, accelerator: A, facts: Facts) -> Self::Answer {
        let world = &World::new(self.scene, accelerator);
        let caster = || {
            let mut scratch = A::Scratch::default();
            move |line: &Line| nearest(world, line, &mut scratch)
        };
        (facts, self.stream.run(caster))
    }
}

/// The nearest hit along the ray of a line.
///
/// The tracer's own directions have length one, and squares of what is much longer or shorter
/// leave the range. So the direction is scaled to a largest component from 1 up to 2, by a power
/// of two, which rounds nothing; `t` is scaled back, also without rounding.
#[allow(clippy::useless_conversion, clippy::unnecessary_cast)] // in double precision
fn nearest<A: Accelerator>(world: &World<'_, A>, line: &Line, scratch: &mut A::Scratch) -> Option<Found> {
    let Line { origin, direction, reach } = *line;
    let is_near = |x: f64| x.abs() <= f64::from(FARTHEST);
    let size = direction.into_iter().map(f64::abs).fold(0.0, |a, b| if a > b { a } else { b });
    let is_ray = origin.into_iter().all(is_near) && direction.into_iter().all(f64::is_finite) && size > 0.0;
    if !is_ray || reach.is_nan() || reach <= 0.0 {
        return None;
    }
    let power = libm::ilogb(size);
    let narrow = |[x, y, z]: [f64; 3]| vec3(x as Real, y as Real, z as Real);
    let ray = Ray::new(narrow(origin), narrow(direction.map(|x| libm::scalbn(x, -power))));

    // Rounded to a neighbour, perhaps a farther one; what is beyond is left out below.
    let farthest = (libm::scalbn(reach, power) as Real).next_up();
    let hit = world.nearest::<Everything, _>(&ray, farthest, RayKind::Camera, scratch, &mut ())?;
    let t = libm::scalbn(f64::from(hit.t), -power);
    if !(t > 0.0 && t <= reach && t.is_finite()) {
        return None;
    }
    let surface = world.surface::<Everything>(&ray, hit)?;
    let wide = |v: super::strahl::Vec3| [f64::from(v.x), f64::from(v.y), f64::from(v.z)];
    Some(Found { t, object: hit.item.0, point: wide(surface.point), normal: wide(surface.normal) })
}
