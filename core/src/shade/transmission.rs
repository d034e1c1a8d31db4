//! What bodies do to light on its way through them.

use super::medium_stack::{Crossing, MediumStack};
use super::optics::transmittance;
use crate::geometry::ItemId;
use crate::math::{Real, Rgb};
use crate::scene::{Effects, Material, MaterialId, Parts};

/// What happens to the media where a ray meets an item, whose outside is where the ray comes
/// from, or not.
pub(crate) fn cross_surface(
    parts: &Parts<'_>,
    item: ItemId,
    material: &Material,
    media: MediumStack,
    outside: bool,
) -> Option<Crossing> {
    // Clear stuff that does not break light makes no body: a pane has no other side.
    let is_body = material.is_transmitting() && (material.index != 1.0 || material.is_absorbing());
    if !is_body {
        let medium = media.current(parts.materials);
        return Some(Crossing {
            medium_before: medium,
            medium_behind: medium,
            stack_behind: media,
            is_hidden: false,
            is_stack_full: false,
        });
    }
    let body = parts.made_of.get(item.0 as usize).copied()?;
    Some(if outside { media.enter(body, parts.materials) } else { media.exit(body, parts.materials) })
}

/// What is left of light after a way through a medium.
pub(crate) fn medium_transmittance<E: Effects>(
    materials: &[Material],
    medium: Option<MaterialId>,
    way: Real,
) -> Rgb {
    if !E::SET.absorption {
        return Rgb::WHITE;
    }
    match medium.and_then(|medium| materials.get(usize::from(medium.0))) {
        Some(material) => transmittance(material.clarity, way),
        None => Rgb::WHITE,
    }
}
