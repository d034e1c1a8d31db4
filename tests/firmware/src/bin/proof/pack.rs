//! Arbitrary bytes, opened and used as a baked scene.

use strahl_core::accel::{Grid, Octree, TraversalStack};
use strahl_core::baked::{BakedAccelerator, BakedScene, BakedSceneError, BakedSection};
use strahl_core::scene::TextureId;
use strahl_core::{AllEffects, World};

use crate::any::{any, slice, used};
use crate::scene::{SpheresOnly, any_size};
use crate::text::displayed;
use crate::trace::traced;

pub fn entry_points() {
    displayed(any(BakedSceneError::Checksum));
    let Ok(pack) = BakedScene::open(slice(&[0_u8])) else { return };
    used((
        BakedScene::resolution(&pack),
        BakedScene::levels(&pack),
        BakedScene::cutoff(&pack),
        BakedScene::camera_descriptor(&pack),
    ));
    used(BakedScene::camera(&pack, any_size()));
    let accelerator: Result<BakedAccelerator<'_>, BakedSceneError> = BakedScene::accelerator(&pack);
    used((accelerator, any(BakedSection::Accelerator), any(TextureId::NONE)));
    traced::<_, AllEffects, _, 5>(
        &World::new(*BakedScene::scene(&pack), BakedScene::list_without_bounds(&pack)),
        (),
    );
    if let Ok(grid) = BakedScene::grid::<8>(&pack) {
        traced::<_, SpheresOnly, _, 2>(
            &World::new(*BakedScene::scene(&pack), Grid::with_mailbox::<16>(grid)),
            (),
        );
    }
    if let Ok(octree) = BakedScene::octree::<8>(&pack) {
        traced::<_, SpheresOnly, _, 2>(
            &World::new(*BakedScene::scene(&pack), Octree::with_mailbox::<16>(octree)),
            (),
        );
    }
    if let Ok(bvh) = BakedScene::bvh::<TraversalStack<8>>(&pack) {
        traced::<_, SpheresOnly, _, 2>(&World::new(*BakedScene::scene(&pack), bvh), ());
    }
}
