//! Light at surfaces and in bodies.

use strahl_core::MaterialId;
use strahl_core::shade::{Crossing, Media, Refraction, absorbed, index, reflected, refracted};

use crate::any::{any, color, number, slice, used, vector};
use crate::scene::MATERIALS;

pub fn doors() {
    let refraction: Option<Refraction> = refracted(vector(), vector(), number());
    used((reflected(vector(), vector()), refraction, absorbed(color(), number())));

    let (materials, body) = (slice(&MATERIALS), any(MaterialId(0)));
    let mut media = Media::NONE;
    while any(true) {
        let crossing: Crossing = if any(true) {
            Media::entering(media, body, materials)
        } else {
            Media::leaving(media, body, materials)
        };
        used((Media::in_force(media, materials), index(crossing.behind, materials), &crossing));
        media = crossing.media;
    }
    // Not only what a way through bodies leads to.
    let media = any(Media::NONE);
    used(Media::in_force(media, materials));
    used((Media::entering(media, body, materials), Media::leaving(media, body, materials)));
}
