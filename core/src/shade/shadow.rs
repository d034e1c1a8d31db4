//! Whether light arrives.

use super::cache::{Memory, Toward};
use super::media::{Crossing, Media, index};
use super::optics::refracted;
use super::passage::{crossing, left_after};
use super::seen::Seen;
use crate::accel::Accelerator;
use crate::geometry::Ray;
use crate::math::{ROUNDOFF, Real, Rgb, Vec3, max_abs_component};
use crate::scene::{Beam, Effects, Interface, LightKind, Material, World};
use crate::tally::{Event, RayKind, Step, Tally};

/// How much of the way to a light is asked for: not the last few roundoffs, so that a surface
/// in which the light lies does not stand in its own light.
const NEARLY_THERE: Real = 1.0 - 16.0 * ROUNDOFF;

/// The most surfaces that light passes on its way; behind more it is dark.
const MOST_SURFACES: u32 = 64;

/// Where the ways to all lights start.
pub(super) struct Start {
    /// On the surface.
    pub(super) point: Vec3,
    /// Beside it, where rays leave it.
    pub(super) from: Vec3,
    /// When.
    pub(super) time: Real,
}

/// The way from a point to a light.
pub(super) struct Way<'b> {
    /// Where it starts.
    pub(super) start: &'b Start,
    /// What would arrive.
    pub(super) beam: &'b Beam,
    /// From which level to which light.
    pub(super) toward: Toward,
}

impl Way<'_> {
    /// The direction of the ray towards the light; none when the light is too near for anything
    /// to stand between.
    fn direction<E: Effects>(&self) -> Option<Vec3> {
        let (start, beam) = (self.start, self.beam);
        if E::SET.lights.contains(LightKind::Directional) && beam.distance == Real::MAX {
            return Some(beam.toward); // of a light without a place, whose rays are parallel
        }
        // Started beside the point, the ray must not end beside the light.
        let aside = start.point - start.from;
        (max_abs_component(aside) < beam.distance).then(|| beam.toward + aside / beam.distance)
    }

    /// How far something may be and still stand in the way.
    fn reach(&self) -> Real {
        self.beam.distance * NEARLY_THERE
    }
}

/// Whether anything stands in the way. What lies behind the light does not count; glass counts
/// as if it were opaque.
#[inline(always)]
pub(super) fn is_dark<A: Accelerator, E: Effects, T: Tally, const SHADOWS: usize>(
    world: &World<'_, A>,
    way: &Way<'_>,
    memory: &mut Memory<A, SHADOWS>,
    tally: &mut T,
) -> bool {
    tally.count(Event::Ray(RayKind::Shadow));
    let Some(direction) = way.direction::<E>() else { return false };
    tally.tell(Step::Asks { origin: way.start.from, direction, reach: way.reach() });
    let ray = Ray::with_near_unit_direction(way.start.from, direction, way.start.time);
    if let Some(last) = memory.shadows.last(way.toward) {
        let still = world.blocks::<E, T>(last, &ray, way.reach(), RayKind::Shadow, tally);
        tally.count(Event::ShadowCache { hit: still });
        if still {
            tally.tell(Step::Blocked { item: last, distance: None });
            return true;
        }
    }
    match world.blocker_sound::<E, T>(&ray, way.reach(), RayKind::Shadow, &mut memory.scratch, tally) {
        Some(item) => {
            tally.tell(Step::Blocked { item, distance: None });
            memory.shadows.remember(way.toward, item);
            true
        }
        None => {
            memory.shadows.forget(way.toward);
            false
        }
    }
}

/// The share of light that comes through, from a point inside of `media`: straight on through
/// everything that transmits, surface by surface up to the light, and nothing through the rest.
///
/// Each surface takes what it does not transmit, with Fresnel's formulas also what light that
/// comes in from the thinner side loses by mirroring; each body takes what it absorbs. Light is
/// not bent, so that no ray has to look for the light.
///
/// Not inlined: few scenes ask for it, and where it stands in the loop the others pay for it.
#[inline(never)]
pub(super) fn passing<A: Accelerator, E: Effects, T: Tally>(
    world: &World<'_, A>,
    way: &Way<'_>,
    media: &Media,
    scratch: &mut A::Scratch,
    tally: &mut T,
) -> Rgb {
    tally.count(Event::Ray(RayKind::Shadow));
    let parts = world.scene().parts();
    let (mut share, mut media) = (Rgb::WHITE, *media);
    let Some(direction) = way.direction::<E>() else { return share };
    let (mut from, mut reach) = (way.start.from, way.reach());
    tally.tell(Step::Asks { origin: from, direction, reach });
    for _ in 0..MOST_SURFACES {
        let ray = Ray::with_near_unit_direction(from, direction, way.start.time);
        let hit = world.nearest::<E, T>(&ray, reach, RayKind::Shadow, scratch, tally);
        let met = hit.and_then(|hit| Some((hit, world.surface::<E>(&ray, hit)?)));
        let Some((hit, surface)) = met else {
            return share * left_after::<E>(parts.materials, media.in_force(parts.materials), reach);
        };
        let material = world.scene().material(hit.item).unwrap_or(&Material::MATTE);
        let seen = Seen::new(surface, direction);
        let Some(crossing) = crossing(parts, hit.item, material, media, seen.outside) else { break };
        share *= left_after::<E>(parts.materials, crossing.before, hit.t);
        if !crossing.hidden {
            share *= material.transmitted * (1.0 - mirrored(&crossing, material, &seen, parts.materials));
        }
        if share.is_black() {
            tally.tell(Step::Blocked { item: hit.item, distance: Some(hit.t) });
            break;
        }
        tally.tell(Step::Passes { hit, share });
        (media, from, reach) = (crossing.media, seen.behind(), reach - hit.t);
    }
    Rgb::BLACK
}

/// The share that is mirrored of light that comes in from the thinner of both sides.
fn mirrored(crossing: &Crossing, material: &Material, seen: &Seen, materials: &[Material]) -> Real {
    if material.interface == Interface::Constant {
        return 0.0;
    }
    let (before, behind) = (index(crossing.before, materials), index(crossing.behind, materials));
    let ratio = if before < behind { before / behind } else { behind / before };
    refracted(seen.along, seen.shading, ratio).map_or(1.0, |refraction| refraction.mirrored)
}
