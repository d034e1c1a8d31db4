//! Bytes that may be a baked scene, and are used as whatever they say they are.

use strahl_core::accel::{Grid, Octree, TraversalStack};
use strahl_core::baked::{Finder, Pack, PackError, PackPart};
use strahl_core::scene::TextureId;
use strahl_core::{AllEffects, World};

use crate::any::{any, slice, used};
use crate::scene::{Few, any_size};
use crate::text::displayed;
use crate::trace::traced;

pub fn doors() {
    displayed(any(PackError::Checksum));
    let Ok(pack) = Pack::open(slice(&[0_u8])) else { return };
    used((Pack::size(&pack), Pack::levels(&pack), Pack::cutoff(&pack), Pack::view(&pack)));
    used(Pack::camera(&pack, any_size()));
    let finder: Result<Finder<'_>, PackError> = Pack::finder(&pack);
    used((finder, any(PackPart::Finder), any(TextureId::NONE)));
    traced::<_, AllEffects, _, 5>(&World::new(*Pack::scene(&pack), Pack::bare(&pack)), ());
    if let Ok(grid) = Pack::grid::<8>(&pack) {
        traced::<_, Few, _, 2>(&World::new(*Pack::scene(&pack), Grid::with_mailbox::<16>(grid)), ());
    }
    if let Ok(octree) = Pack::octree::<8>(&pack) {
        traced::<_, Few, _, 2>(&World::new(*Pack::scene(&pack), Octree::with_mailbox::<16>(octree)), ());
    }
    if let Ok(bvh) = Pack::bvh::<TraversalStack<8>>(&pack) {
        traced::<_, Few, _, 2>(&World::new(*Pack::scene(&pack), bvh), ());
    }
}
