//! Reflection, refraction and participating media.

use strahl_core::MaterialId;
use strahl_core::shade::{
    Crossing, MediumStack, Refraction, reflect, refract, refractive_index, transmittance,
};

use crate::any::{any, color, number, slice, used, vector};
use crate::scene::MATERIALS;

pub fn entry_points() {
    let refraction: Option<Refraction> = refract(vector(), vector(), number());
    used((reflect(vector(), vector()), refraction, transmittance(color(), number())));

    let (materials, body) = (slice(&MATERIALS), any(MaterialId(0)));
    let mut media = MediumStack::EMPTY;
    while any(true) {
        let crossing: Crossing = if any(true) {
            MediumStack::enter(media, body, materials)
        } else {
            MediumStack::exit(media, body, materials)
        };
        used((
            MediumStack::current(media, materials),
            refractive_index(crossing.medium_behind, materials),
            &crossing,
        ));
        media = crossing.stack_behind;
    }
    // Also stacks that no path through bodies produces.
    let media = any(MediumStack::EMPTY);
    used(MediumStack::current(media, materials));
    used((MediumStack::enter(media, body, materials), MediumStack::exit(media, body, materials)));
}
