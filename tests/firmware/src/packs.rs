//! The baked scenes: written by the host (`tests/examples/chip.rs`), and traced in place.

#[cfg(target_arch = "arm")]
use core::sync::atomic::{AtomicUsize, Ordering};

use strahl_core::accel::{Accelerator, TraversalStack};
use strahl_core::baked::{BakedAccelerator, BakedScene, BakedSceneError};
use strahl_core::scene::Effects;
use strahl_core::{
    AllEffects, Camera, CenterSampler, Limits, ListWithoutBounds, Scene, World, include_baked_scene,
};
use strahl_device::draw::{DrawCost, DrawSettings, PixelBytes, PixelRow, bytes, draw};

/// Source of a scene, written by the host.
pub enum SceneSource {
    /// A baked scene.
    Bytes(&'static [u8]),
    /// Rust constants, in [`constants`].
    Constants,
}

/// A scene and its name.
pub struct FirmwareScene {
    /// File name of its picture.
    pub name: &'static core::ffi::CStr,
    /// Source of a scene, written by the host.
    pub source: SceneSource,
}

/// The golden scene with a grid; scenes with an octree, a grid, a BVH over a mesh, and a list; and the last
/// one as Rust constants.
pub static SCENES: [FirmwareScene; 6] = [
    FirmwareScene {
        name: c"golden.f32",
        source: SceneSource::Bytes(include_baked_scene!("../target/packs/golden.strahl")),
    },
    FirmwareScene {
        name: c"classic.f32",
        source: SceneSource::Bytes(include_baked_scene!("../target/packs/classic.strahl")),
    },
    FirmwareScene {
        name: c"rotunda.f32",
        source: SceneSource::Bytes(include_baked_scene!("../target/packs/rotunda.strahl")),
    },
    FirmwareScene {
        name: c"mesh.f32",
        source: SceneSource::Bytes(include_baked_scene!("../target/packs/mesh.strahl")),
    },
    FirmwareScene {
        name: c"first.f32",
        source: SceneSource::Bytes(include_baked_scene!("../target/packs/first.strahl")),
    },
    FirmwareScene { name: c"constants.f32", source: SceneSource::Constants },
];

/// Output of `strahl bake -o first.rs`.
pub mod constants {
    include!("../target/packs/first.rs");
}

/// Capacity of levels.
pub const LEVELS: usize = 6;

/// The settings that a scene was baked with.
pub fn draw_settings(pack: &BakedScene<'_>) -> Result<DrawSettings, &'static str> {
    let limits = Limits { levels: pack.levels(), cutoff: pack.cutoff() };
    let size = pack.resolution();
    Ok(DrawSettings { size, camera: pack.camera(size).map_err(|_| "invalid camera")?, limits })
}

/// The part of a row that the picture uses.
fn row_of<'r>(row: &'r mut PixelRow, settings: &DrawSettings) -> Result<&'r mut [PixelBytes], &'static str> {
    row.get_mut(..settings.size.width() as usize).ok_or("the picture is too wide")
}

/// Draws a scene with its accelerator. `clock` counts instructions, or returns 0 if it cannot.
pub fn picture(
    baked: &FirmwareScene,
    row: &mut PixelRow,
    clock: impl Fn() -> u32,
    take: impl FnMut(&[PixelBytes]) -> bool,
) -> Result<DrawCost<()>, &'static str> {
    type E = AllEffects;
    const { assert!(E::SET.shadows) };
    let refused = |_: BakedSceneError| "invalid baked scene";
    let SceneSource::Bytes(source) = baked.source else {
        use constants::{CAMERA, ITEMS, LIMITS, SCENE, SIZE, SceneEffects};
        let scene = Scene::new(SCENE).map_err(|_| "invalid scene")?;
        let camera = Camera::new(&CAMERA, SIZE).map_err(|_| "invalid camera")?;
        let settings = DrawSettings { size: SIZE, camera, limits: LIMITS };
        let (world, row) = (World::new(scene, ListWithoutBounds(ITEMS)), row_of(row, &settings)?);
        return draw_result::<_, SceneEffects>(&world, settings, row, clock, take);
    };
    let pack = BakedScene::open(source).map_err(refused)?;
    let (scene, settings) = (*pack.scene(), draw_settings(&pack)?);
    let row = row_of(row, &settings)?;
    match pack.accelerator().map_err(refused)? {
        BakedAccelerator::ListWithoutBounds(list) => {
            draw_result::<_, E>(&World::new(scene, list), settings, row, clock, take)
        }
        BakedAccelerator::Grid(grid) => {
            let grid = grid.with_mailbox::<64>();
            draw_result::<_, E>(&World::new(scene, grid), settings, row, clock, take)
        }
        BakedAccelerator::Octree(octree) => {
            let octree = octree.with_mailbox::<64>();
            draw_result::<_, E>(&World::new(scene, octree), settings, row, clock, take)
        }
        BakedAccelerator::Bvh(bvh) => {
            let bvh = bvh.with_queue::<TraversalStack<32>>();
            draw_result::<_, E>(&World::new(scene, bvh), settings, row, clock, take)
        }
    }
}

/// Not inlined, so that each instance has its own stack frame.
#[inline(never)]
fn draw_result<A: Accelerator, E: Effects>(
    world: &World<'_, A>,
    settings: DrawSettings,
    row: &mut [PixelBytes],
    clock: impl Fn() -> u32,
    take: impl FnMut(&[PixelBytes]) -> bool,
) -> Result<DrawCost<()>, &'static str> {
    #[cfg(target_arch = "arm")]
    let here = &raw const row as usize;
    let cost =
        draw::<_, E, _, _, _, LEVELS>(world, settings, &mut CenterSampler, (), row, clock, bytes, take);
    #[cfg(target_arch = "arm")]
    STACK.fetch_max(crate::stack::used_below(here), Ordering::Relaxed);
    cost
}

/// Maximum stack of a picture, in bytes, without opening its scene.
#[cfg(target_arch = "arm")]
pub static STACK: AtomicUsize = AtomicUsize::new(0);
