//! Nested dielectrics: the stack of bodies that a ray is inside.
//!
//! Each ray carries up to four entered bodies, identified by their materials. Where bodies overlap, the one
//! with the highest [`Material::priority`] is the medium, of equals the last one entered. The surface of a
//! body with lower priority is hidden there (a false intersection): the ray goes on unchanged.
//!
//! Source: Schmidt and Budge, "Simple Nested Dielectrics in Ray Traced Images", JGT 2002.

use crate::math::Real;
use crate::scene::{Material, MaterialId};

/// Largest number of bodies that a ray can be inside.
const CAPACITY: usize = 4;

/// The bodies that a ray is inside, in the order in which it entered them; at most four.
///
/// A body is identified by its material. Empty space is not on the stack. Where bodies overlap, the medium
/// of the ray is that of the highest [`Material::priority`]; of equal priorities, that of the body entered
/// last.
///
/// The surface of a body inside a body of higher priority is hidden ([`Crossing::is_hidden`]): the medium
/// does not change there, and the ray goes on straight. It still enters the body: the stack of the ray
/// behind the surface ([`Crossing::stack_behind`]) contains it.
///
/// ```
/// use strahl_core::shade::MediumStack;
/// use strahl_core::{Material, MaterialId};
///
/// let (water, glass) = (MaterialId(0), MaterialId(1));
/// let materials = [Material::MATTE, Material { priority: 1, ..Material::MATTE }];
///
/// let inside = MediumStack::EMPTY.enter(glass, &materials).stack_behind;
/// assert_eq!(inside.current(&materials), Some(glass));
///
/// // The surface of the water is hidden inside the glass.
/// let crossing = inside.enter(water, &materials);
/// assert!(crossing.is_hidden);
/// assert_eq!(crossing.stack_behind.current(&materials), Some(glass));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MediumStack {
    /// The first `count` are valid; the rest is zero.
    entered: [MaterialId; CAPACITY],
    count: u8,
}

/// What a ray finds where it crosses the surface of a body: the media on both sides, and its stack behind
/// the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Medium on the side that the ray comes from, by its material; `None` is empty space.
    pub medium_before: Option<MaterialId>,
    /// Medium on the far side, by its material; `None` is empty space.
    pub medium_behind: Option<MaterialId>,
    /// Stack of a ray on the far side, such as a refracted one; a reflected ray keeps the stack that it
    /// has.
    pub stack_behind: MediumStack,
    /// Whether the surface is inside a body of higher priority: the ray goes on as if it did not exist.
    pub is_hidden: bool,
    /// Whether the stack was full, so that the body was not entered: the stack behind the surface is the
    /// same.
    pub is_stack_full: bool,
}

impl MediumStack {
    /// The stack of a ray in empty space.
    pub const EMPTY: MediumStack = MediumStack { entered: [MaterialId(0); CAPACITY], count: 0 };

    /// The entered bodies, the last one entered last.
    fn as_slice(&self) -> &[MaterialId] {
        self.entered.get(..usize::from(self.count)).unwrap_or_default()
    }

    /// The medium that the ray is in; `None` is empty space.
    ///
    /// `materials`: those of the scene; a material outside of them has priority 0.
    pub fn current(self, materials: &[Material]) -> Option<MaterialId> {
        // Common case: at most one body.
        if self.count <= 1 {
            return self.as_slice().first().copied();
        }
        // `max_by_key` returns the last of equals.
        self.as_slice().iter().copied().max_by_key(|material| priority(*material, materials))
    }

    /// The crossing of a ray that enters `body` through its front side.
    ///
    /// If the stack is full, the body is not entered, and [`Crossing::is_stack_full`] is true.
    pub fn enter(self, body: MaterialId, materials: &[Material]) -> Crossing {
        if self.count == 0 {
            let unused = MaterialId(0);
            return Crossing {
                medium_before: None,
                medium_behind: Some(body),
                stack_behind: MediumStack { entered: [body, unused, unused, unused], count: 1 },
                is_hidden: false,
                is_stack_full: false,
            };
        }
        let medium_before = self.current(materials);
        let mut stack_behind = self;
        let is_stack_full = match stack_behind.entered.get_mut(usize::from(self.count)) {
            Some(top) => {
                *top = body;
                stack_behind.count += 1;
                false
            }
            None => true,
        };
        let medium_behind = stack_behind.current(materials);
        let is_hidden = has_higher_priority(medium_before, body, materials);
        Crossing { medium_before, medium_behind, stack_behind, is_hidden, is_stack_full }
    }

    /// The crossing of a ray that leaves `body`.
    ///
    /// If the body is not on the stack, the ray started inside it: the body was the medium unless one of
    /// higher priority is on the stack.
    pub fn exit(self, body: MaterialId, materials: &[Material]) -> Crossing {
        if self.as_slice() == [body] {
            return Crossing {
                medium_before: Some(body),
                medium_behind: None,
                stack_behind: MediumStack::EMPTY,
                is_hidden: false,
                is_stack_full: false,
            };
        }
        let mut stack_behind = self;
        let Some(index) = self.as_slice().iter().rposition(|entered| *entered == body) else {
            let medium_behind = self.current(materials);
            let is_inside_higher = has_higher_priority(medium_behind, body, materials);
            let medium_before = if is_inside_higher { medium_behind } else { Some(body) };
            let is_hidden = medium_before == medium_behind;
            return Crossing { medium_before, medium_behind, stack_behind, is_hidden, is_stack_full: false };
        };
        // Close the gap.
        let mut later = self.as_slice().iter().skip(index + 1);
        for entry in stack_behind.entered.iter_mut().skip(index) {
            *entry = later.next().copied().unwrap_or(MaterialId(0));
        }
        stack_behind.count -= 1;
        let (medium_before, medium_behind) = (self.current(materials), stack_behind.current(materials));
        let is_hidden = has_higher_priority(medium_behind, body, materials);
        Crossing { medium_before, medium_behind, stack_behind, is_hidden, is_stack_full: false }
    }
}

/// The material, if it exists.
fn material_of(material: MaterialId, materials: &[Material]) -> Option<&Material> {
    materials.get(usize::from(material.0))
}

/// The priority of a material; 0 if it does not exist.
fn priority(material: MaterialId, materials: &[Material]) -> u8 {
    material_of(material, materials).map_or(0, |material| material.priority)
}

/// Whether `medium` has a higher priority than `body`.
fn has_higher_priority(medium: Option<MaterialId>, body: MaterialId, materials: &[Material]) -> bool {
    medium.is_some_and(|medium| priority(medium, materials) > priority(body, materials))
}

/// Refractive index of a medium; 1 in empty space (`None`) and for a material outside of `materials`.
pub fn refractive_index(medium: Option<MaterialId>, materials: &[Material]) -> Real {
    medium.and_then(|medium| material_of(medium, materials)).map_or(1.0, |material| material.refractive_index)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WATER: MaterialId = MaterialId(0);
    const GLASS: MaterialId = MaterialId(1);
    const AIR: MaterialId = MaterialId(2);

    fn materials() -> [Material; 3] {
        [(1.33, 0), (1.5, 1), (1.0, 1)].map(|(index, priority)| Material {
            refractive_index: index,
            priority,
            ..Material::MATTE
        })
    }

    #[test]
    fn the_surface_of_water_is_hidden_inside_a_glass() {
        let materials = &materials();
        let glass = MediumStack::EMPTY.enter(GLASS, materials);
        assert_eq!((glass.medium_before, glass.medium_behind, glass.is_hidden), (None, Some(GLASS), false));
        let both = glass.stack_behind.enter(WATER, materials);
        assert_eq!(
            (both.medium_before, both.medium_behind, both.is_hidden),
            (Some(GLASS), Some(GLASS), true)
        );
        let water = both.stack_behind.exit(GLASS, materials);
        assert_eq!(
            (water.medium_before, water.medium_behind, water.is_hidden),
            (Some(GLASS), Some(WATER), false)
        );
        let out = water.stack_behind.exit(WATER, materials);
        assert_eq!(
            (out.medium_before, out.medium_behind, out.stack_behind),
            (Some(WATER), None, MediumStack::EMPTY)
        );
    }

    #[test]
    fn of_equal_priorities_the_last_body_entered_is_the_medium() {
        let materials = &materials();
        let bubble = MediumStack::EMPTY.enter(GLASS, materials).stack_behind.enter(AIR, materials);
        assert_eq!(
            (bubble.medium_before, bubble.medium_behind, bubble.is_hidden),
            (Some(GLASS), Some(AIR), false)
        );
        let out = bubble.stack_behind.exit(AIR, materials);
        assert_eq!((out.medium_before, out.medium_behind), (Some(AIR), Some(GLASS)));
    }

    #[test]
    fn leaving_a_body_that_was_never_entered_means_the_ray_started_inside() {
        let out = MediumStack::EMPTY.exit(GLASS, &materials());
        assert_eq!(
            (out.medium_before, out.medium_behind, out.stack_behind),
            (Some(GLASS), None, MediumStack::EMPTY)
        );
    }

    #[test]
    fn a_full_stack_rejects_the_body_and_reports_it() {
        let materials = &materials();
        let mut stack = MediumStack::EMPTY;
        for _ in 0..CAPACITY {
            let crossing = stack.enter(WATER, materials);
            assert!(!crossing.is_stack_full);
            stack = crossing.stack_behind;
        }
        let crossing = stack.enter(GLASS, materials);
        assert!(crossing.is_stack_full);
        assert_eq!((crossing.stack_behind, crossing.medium_behind), (stack, Some(WATER)));
        for _ in 0..CAPACITY {
            stack = stack.exit(WATER, materials).stack_behind;
        }
        assert_eq!(stack, MediumStack::EMPTY);
    }
}
