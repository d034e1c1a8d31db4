//! Light inside bodies: surface crossings and attenuation.

use super::medium_stack::{Crossing, MediumStack};
use super::optics::transmittance;
use crate::geometry::ItemId;
use crate::math::{Real, Rgb};
use crate::scene::{Effects, Material, MaterialId, SceneDescriptor};

/// The media on both sides of the surface of `item` for a ray with the stack `media`.
///
/// `entering`: whether the ray arrives on the outside of the item, the side of its geometric normal. `None`
/// if the item has no material.
pub(crate) fn cross_surface(
    scene: &SceneDescriptor<'_>,
    item: ItemId,
    material: &Material,
    media: MediumStack,
    entering: bool,
) -> Option<Crossing> {
    // A clear material that does not refract bounds no body: a pane may have a single surface.
    let is_body = material.is_transmitting() && (material.refractive_index != 1.0 || material.is_absorbing());
    if !is_body {
        let medium = media.current(scene.materials);
        return Some(Crossing {
            medium_before: medium,
            medium_behind: medium,
            stack_behind: media,
            is_hidden: false,
            is_stack_full: false,
        });
    }
    let body = scene.material_ids.get(item.0 as usize).copied()?;
    Some(if entering { media.enter(body, scene.materials) } else { media.exit(body, scene.materials) })
}

/// Transmittance of a medium over `distance` scene lengths; 1 in empty space (`None`).
pub(crate) fn medium_transmittance<E: Effects>(
    materials: &[Material],
    medium: Option<MaterialId>,
    distance: Real,
) -> Rgb {
    if !E::SET.absorption {
        return Rgb::WHITE;
    }
    match medium.and_then(|medium| materials.get(usize::from(medium.0))) {
        Some(material) => transmittance(material.attenuation_length, distance),
        None => Rgb::WHITE,
    }
}
