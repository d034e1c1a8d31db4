//! Light at surfaces and in bodies.

use strahl_core::*;

use crate::any::{any, color, number, slice, used, vector};
use crate::scene::MATERIALS;

pub fn doors() {
    let refraction: Option<Refraction> = refracted(vector(), vector(), number());
    used((reflected(vector(), vector()), refraction, absorbed(color(), number())));

    let (materials, body) = (slice(&MATERIALS), any(MaterialId(0)));
    let mut media = Media::NONE;
    while any(true) {
        let crossing: Crossing =
            if any(true) { media.entering(body, materials) } else { media.leaving(body, materials) };
        used((media.in_force(materials), index(crossing.behind, materials), &crossing));
        media = crossing.media;
    }
    // Not only what a way through bodies leads to.
    let media = any(Media::NONE);
    used((media.in_force(materials), media.entering(body, materials), media.leaving(body, materials)));
}
