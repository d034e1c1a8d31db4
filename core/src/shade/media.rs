//! The bodies that a ray is inside of.
//!
//! A ray takes with it a short list of the bodies that it has entered and not left. Where they
//! overlap, one of them fills space: the one of the highest priority, and of equals the one
//! that was entered last ("Simple Nested Dielectrics in Ray Traced Images", Schmidt, Budge,
//! JGT 2002). A body of lower priority is invisible inside another: its surface does nothing.

use crate::math::Real;
use crate::scene::{Material, MaterialId};

/// How many bodies a ray can be inside of at once.
const DEPTH: usize = 4;

/// The bodies that a ray is inside of, in the order in which it entered them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Media {
    inside: [MaterialId; DEPTH],
    count: u8,
}

/// What happens to the media where a ray meets the surface of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// What fills space before the surface; none is empty space.
    pub before: Option<MaterialId>,
    /// What fills space behind it.
    pub behind: Option<MaterialId>,
    /// The list behind it.
    pub media: Media,
    /// Whether a body of higher priority goes on through the surface, which then is not there.
    pub hidden: bool,
    /// Whether the list was full, so that the body was not entered.
    pub full: bool,
}

impl Media {
    /// Outside of everything.
    pub const NONE: Media = Media { inside: [MaterialId(0); DEPTH], count: 0 };

    fn list(&self) -> &[MaterialId] {
        self.inside.get(..usize::from(self.count)).unwrap_or_default()
    }

    /// What fills space; none is empty space.
    pub fn in_force(self, materials: &[Material]) -> Option<MaterialId> {
        // Few rays are inside of more than one.
        if self.count <= 1 {
            return self.list().first().copied();
        }
        // The last of equals.
        self.list().iter().copied().max_by_key(|material| priority(*material, materials))
    }

    /// The ray goes in through the surface of a body.
    pub fn entering(self, body: MaterialId, materials: &[Material]) -> Crossing {
        if self.count == 0 {
            let nothing = MaterialId(0);
            let (behind, media) = (Some(body), Media { inside: [body, nothing, nothing, nothing], count: 1 });
            return Crossing { before: None, behind, media, hidden: false, full: false };
        }
        let before = self.in_force(materials);
        let mut media = self;
        let full = match media.inside.get_mut(usize::from(self.count)) {
            Some(slot) => {
                *slot = body;
                media.count += 1;
                false
            }
            None => true,
        };
        let behind = media.in_force(materials);
        Crossing { before, behind, media, hidden: hides(before, body, materials), full }
    }

    /// The ray goes out through the surface of a body.
    ///
    /// A body that is not in the list is left all the same: the ray began inside of it, so that
    /// it filled space before the surface.
    pub fn leaving(self, body: MaterialId, materials: &[Material]) -> Crossing {
        if self.list() == [body] {
            let (before, media) = (Some(body), Media::NONE);
            return Crossing { before, behind: None, media, hidden: false, full: false };
        }
        let mut media = self;
        let Some(place) = self.list().iter().rposition(|inside| *inside == body) else {
            let behind = self.in_force(materials);
            let before = if hides(behind, body, materials) { behind } else { Some(body) };
            return Crossing { before, behind, media, hidden: before == behind, full: false };
        };
        // Close the gap.
        let mut later = self.list().iter().skip(place + 1);
        for slot in media.inside.iter_mut().skip(place) {
            *slot = later.next().copied().unwrap_or(MaterialId(0));
        }
        media.count -= 1;
        let (before, behind) = (self.in_force(materials), media.in_force(materials));
        Crossing { before, behind, media, hidden: hides(behind, body, materials), full: false }
    }
}

fn of(material: MaterialId, materials: &[Material]) -> Option<&Material> {
    materials.get(usize::from(material.0))
}

fn priority(material: MaterialId, materials: &[Material]) -> u8 {
    of(material, materials).map_or(0, |material| material.priority)
}

/// Whether what fills space is of higher priority than a body.
fn hides(in_force: Option<MaterialId>, body: MaterialId, materials: &[Material]) -> bool {
    in_force.is_some_and(|in_force| priority(in_force, materials) > priority(body, materials))
}

/// The index of refraction of what fills space.
pub fn index(medium: Option<MaterialId>, materials: &[Material]) -> Real {
    medium.and_then(|medium| of(medium, materials)).map_or(1.0, |material| material.index)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WATER: MaterialId = MaterialId(0);
    const GLASS: MaterialId = MaterialId(1);
    const AIR: MaterialId = MaterialId(2);

    fn materials() -> [Material; 3] {
        [(1.33, 0), (1.5, 1), (1.0, 1)].map(|(index, priority)| Material {
            index,
            priority,
            ..Material::MATTE
        })
    }

    #[test]
    fn a_glass_in_water_hides_the_waters_surface_inside_it() {
        let m = &materials();
        let glass = Media::NONE.entering(GLASS, m);
        assert_eq!((glass.before, glass.behind, glass.hidden), (None, Some(GLASS), false));
        let both = glass.media.entering(WATER, m);
        assert_eq!((both.before, both.behind, both.hidden), (Some(GLASS), Some(GLASS), true));
        let water = both.media.leaving(GLASS, m);
        assert_eq!((water.before, water.behind, water.hidden), (Some(GLASS), Some(WATER), false));
        let out = water.media.leaving(WATER, m);
        assert_eq!((out.before, out.behind, out.media), (Some(WATER), None, Media::NONE));
    }

    #[test]
    fn of_equal_priority_the_body_entered_last_fills_space() {
        let m = &materials();
        let bubble = Media::NONE.entering(GLASS, m).media.entering(AIR, m);
        assert_eq!((bubble.before, bubble.behind, bubble.hidden), (Some(GLASS), Some(AIR), false));
        let out = bubble.media.leaving(AIR, m);
        assert_eq!((out.before, out.behind), (Some(AIR), Some(GLASS)));
    }

    #[test]
    fn a_body_left_but_never_entered_was_round_the_rays_begin() {
        let out = Media::NONE.leaving(GLASS, &materials());
        assert_eq!((out.before, out.behind, out.media), (Some(GLASS), None, Media::NONE));
    }

    #[test]
    fn a_fifth_body_is_not_entered_and_told() {
        let m = &materials();
        let mut media = Media::NONE;
        for _ in 0..DEPTH {
            let crossing = media.entering(WATER, m);
            assert!(!crossing.full);
            media = crossing.media;
        }
        let crossing = media.entering(GLASS, m);
        assert!(crossing.full);
        assert_eq!((crossing.media, crossing.behind), (media, Some(WATER)));
        for _ in 0..DEPTH {
            media = media.leaving(WATER, m).media;
        }
        assert_eq!(media, Media::NONE);
    }
}
