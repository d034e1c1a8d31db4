//! What bodies do to light on its way through them.

use super::media::{Crossing, Media};
use super::optics::absorbed;
use crate::geometry::ItemId;
use crate::math::{Real, Rgb};
use crate::scene::{Effects, Material, MaterialId, Parts};

/// What happens to the media where a ray meets an item, whose outside is where the ray comes
/// from, or not.
pub(crate) fn crossing(
    parts: &Parts<'_>,
    item: ItemId,
    material: &Material,
    media: Media,
    outside: bool,
) -> Option<Crossing> {
    // Clear stuff that does not break light makes no body: a pane has no other side.
    let is_body = material.is_transmitting() && (material.index != 1.0 || material.is_absorbing());
    if !is_body {
        let medium = media.in_force(parts.materials);
        return Some(Crossing { before: medium, behind: medium, media, hidden: false, full: false });
    }
    let body = parts.made_of.get(item.0 as usize).copied()?;
    Some(if outside { media.entering(body, parts.materials) } else { media.leaving(body, parts.materials) })
}

/// What is left of light after a way through a medium.
pub(crate) fn left_after<E: Effects>(materials: &[Material], medium: Option<MaterialId>, way: Real) -> Rgb {
    if !E::SET.absorption {
        return Rgb::WHITE;
    }
    match medium.and_then(|medium| materials.get(usize::from(medium.0))) {
        Some(material) => absorbed(material.clarity, way),
        None => Rgb::WHITE,
    }
}
