//! Whether light arrives.

use crate::accel::Accelerator;
use crate::geometry::Ray;
use crate::math::{ROUNDOFF, Real, Vec3, largest};
use crate::scene::{Beam, Effects, World};
use crate::tally::{Event, RayKind, Tally};

/// How much of the way to a light is asked for: not the last few roundoffs, so that a surface
/// in which the light lies does not stand in its own light.
const NEARLY_THERE: Real = 1.0 - 16.0 * ROUNDOFF;

/// Whether anything stands between a point, which its rays leave at `from`, and where the beam
/// comes from. What lies behind the light does not count; glass counts as if it were opaque.
pub(super) fn is_dark<A: Accelerator, E: Effects, T: Tally>(
    world: &World<'_, A>,
    point: Vec3,
    from: Vec3,
    beam: &Beam,
    scratch: &mut A::Scratch,
    tally: &mut T,
) -> bool {
    tally.count(Event::Ray(RayKind::Shadow));
    // Started beside the point, the ray must not end beside the light.
    let aside = (point - from) / beam.distance;
    if !(largest(aside) < 1.0) {
        return false; // the light is nearer than that
    }
    let ray = Ray::near_unit(from, beam.toward + aside);
    let reach = beam.distance * NEARLY_THERE;
    world.blocker::<E, T>(&ray, reach, RayKind::Shadow, scratch, tally).is_some()
}
