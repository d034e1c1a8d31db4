//! Bytes that may be a baked scene, and are used as whatever they say they are.

use strahl_core::*;

use crate::any::{any, slice, used};
use crate::scene::{Few, any_size};
use crate::text::displayed;
use crate::trace::traced;

pub fn doors() {
    displayed(any(PackError::Checksum));
    let Ok(pack) = Pack::open(slice(&[0_u8])) else { return };
    used((pack.size(), pack.levels(), pack.cutoff(), pack.view(), pack.camera(any_size()), pack.bare()));
    let finder: Result<Finder<'_>, PackError> = pack.finder();
    used((finder, any(PackPart::Finder), any(TextureId::NONE)));
    traced::<_, Everything, _, 5>(&World::new(*pack.scene(), pack.bare()), ());
    if let Ok(grid) = pack.grid::<8>() {
        traced::<_, Few, _, 2>(&World::new(*pack.scene(), grid.with_mailbox::<16>()), ());
    }
    if let Ok(octree) = pack.octree::<8>() {
        traced::<_, Few, _, 2>(&World::new(*pack.scene(), octree.with_mailbox::<16>()), ());
    }
    if let Ok(bvh) = pack.bvh::<TraversalStack<8>>() {
        traced::<_, Few, _, 2>(&World::new(*pack.scene(), bvh), ());
    }
}
