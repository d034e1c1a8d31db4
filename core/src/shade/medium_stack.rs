//! The bodies that a ray is inside of.
//!
//! A ray takes with it a short list of the bodies that it has entered and not left. Where they
//! overlap, one of them fills space: the one of the highest priority, and of equals the one
//! that was entered last ("Simple Nested Dielectrics in Ray Traced Images", Schmidt, Budge,
//! JGT 2002). A body of lower priority is invisible inside another: its surface does nothing.

use crate::math::Real;
use crate::scene::{Material, MaterialId};

/// How many bodies a ray can be inside of at once.
const CAPACITY: usize = 4;

/// The bodies that a ray is inside of, in the order in which it entered them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MediumStack {
    entered: [MaterialId; CAPACITY],
    count: u8,
}

/// What happens to the media where a ray meets the surface of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// What fills space before the surface; none is empty space.
    pub medium_before: Option<MaterialId>,
    /// What fills space behind it.
    pub medium_behind: Option<MaterialId>,
    /// The list behind it.
    pub stack_behind: MediumStack,
    /// Whether a body of higher priority goes on through the surface, which then is not there.
    pub is_hidden: bool,
    /// Whether the list was full, so that the body was not entered.
    pub is_stack_full: bool,
}

impl MediumStack {
    /// Outside of everything.
    pub const EMPTY: MediumStack = MediumStack { entered: [MaterialId(0); CAPACITY], count: 0 };

    fn as_slice(&self) -> &[MaterialId] {
        self.entered.get(..usize::from(self.count)).unwrap_or_default()
    }

    /// What fills space; none is empty space.
    pub fn current(self, materials: &[Material]) -> Option<MaterialId> {
        // Few rays are inside of more than one.
        if self.count <= 1 {
            return self.as_slice().first().copied();
        }
        // The last of equals.
        self.as_slice().iter().copied().max_by_key(|material| priority(*material, materials))
    }

    /// The ray goes in through the surface of a body.
    pub fn enter(self, body: MaterialId, materials: &[Material]) -> Crossing {
        if self.count == 0 {
            let nothing = MaterialId(0);
            let (behind, media) =
                (Some(body), MediumStack { entered: [body, nothing, nothing, nothing], count: 1 });
            return Crossing {
                medium_before: None,
                medium_behind: behind,
                stack_behind: media,
                is_hidden: false,
                is_stack_full: false,
            };
        }
        let before = self.current(materials);
        let mut media = self;
        let full = match media.entered.get_mut(usize::from(self.count)) {
            Some(slot) => {
                *slot = body;
                media.count += 1;
                false
            }
            None => true,
        };
        let behind = media.current(materials);
        Crossing {
            medium_before: before,
            medium_behind: behind,
            stack_behind: media,
            is_hidden: has_higher_priority(before, body, materials),
            is_stack_full: full,
        }
    }

    /// The ray goes out through the surface of a body.
    ///
    /// A body that is not in the list is left all the same: the ray began inside of it, so that
    /// it filled space before the surface.
    pub fn exit(self, body: MaterialId, materials: &[Material]) -> Crossing {
        if self.as_slice() == [body] {
            let (before, media) = (Some(body), MediumStack::EMPTY);
            return Crossing {
                medium_before: before,
                medium_behind: None,
                stack_behind: media,
                is_hidden: false,
                is_stack_full: false,
            };
        }
        let mut media = self;
        let Some(place) = self.as_slice().iter().rposition(|inside| *inside == body) else {
            let behind = self.current(materials);
            let before = if has_higher_priority(behind, body, materials) { behind } else { Some(body) };
            return Crossing {
                medium_before: before,
                medium_behind: behind,
                stack_behind: media,
                is_hidden: before == behind,
                is_stack_full: false,
            };
        };
        // Close the gap.
        let mut later = self.as_slice().iter().skip(place + 1);
        for slot in media.entered.iter_mut().skip(place) {
            *slot = later.next().copied().unwrap_or(MaterialId(0));
        }
        media.count -= 1;
        let (before, behind) = (self.current(materials), media.current(materials));
        Crossing {
            medium_before: before,
            medium_behind: behind,
            stack_behind: media,
            is_hidden: has_higher_priority(behind, body, materials),
            is_stack_full: false,
        }
    }
}

fn material_of(material: MaterialId, materials: &[Material]) -> Option<&Material> {
    materials.get(usize::from(material.0))
}

fn priority(material: MaterialId, materials: &[Material]) -> u8 {
    material_of(material, materials).map_or(0, |material| material.priority)
}

/// Whether what fills space is of higher priority than a body.
fn has_higher_priority(in_force: Option<MaterialId>, body: MaterialId, materials: &[Material]) -> bool {
    in_force.is_some_and(|in_force| priority(in_force, materials) > priority(body, materials))
}

/// The index of refraction of what fills space.
pub fn refractive_index(medium: Option<MaterialId>, materials: &[Material]) -> Real {
    medium.and_then(|medium| material_of(medium, materials)).map_or(1.0, |material| material.index)
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
        let glass = MediumStack::EMPTY.enter(GLASS, m);
        assert_eq!((glass.medium_before, glass.medium_behind, glass.is_hidden), (None, Some(GLASS), false));
        let both = glass.stack_behind.enter(WATER, m);
        assert_eq!(
            (both.medium_before, both.medium_behind, both.is_hidden),
            (Some(GLASS), Some(GLASS), true)
        );
        let water = both.stack_behind.exit(GLASS, m);
        assert_eq!(
            (water.medium_before, water.medium_behind, water.is_hidden),
            (Some(GLASS), Some(WATER), false)
        );
        let out = water.stack_behind.exit(WATER, m);
        assert_eq!(
            (out.medium_before, out.medium_behind, out.stack_behind),
            (Some(WATER), None, MediumStack::EMPTY)
        );
    }

    #[test]
    fn of_equal_priority_the_body_entered_last_fills_space() {
        let m = &materials();
        let bubble = MediumStack::EMPTY.enter(GLASS, m).stack_behind.enter(AIR, m);
        assert_eq!(
            (bubble.medium_before, bubble.medium_behind, bubble.is_hidden),
            (Some(GLASS), Some(AIR), false)
        );
        let out = bubble.stack_behind.exit(AIR, m);
        assert_eq!((out.medium_before, out.medium_behind), (Some(AIR), Some(GLASS)));
    }

    #[test]
    fn a_body_left_but_never_entered_was_round_the_rays_begin() {
        let out = MediumStack::EMPTY.exit(GLASS, &materials());
        assert_eq!(
            (out.medium_before, out.medium_behind, out.stack_behind),
            (Some(GLASS), None, MediumStack::EMPTY)
        );
    }

    #[test]
    fn a_fifth_body_is_not_entered_and_told() {
        let m = &materials();
        let mut media = MediumStack::EMPTY;
        for _ in 0..CAPACITY {
            let crossing = media.enter(WATER, m);
            assert!(!crossing.is_stack_full);
            media = crossing.stack_behind;
        }
        let crossing = media.enter(GLASS, m);
        assert!(crossing.is_stack_full);
        assert_eq!((crossing.stack_behind, crossing.medium_behind), (media, Some(WATER)));
        for _ in 0..CAPACITY {
            media = media.exit(WATER, m).stack_behind;
        }
        assert_eq!(media, MediumStack::EMPTY);
    }
}
