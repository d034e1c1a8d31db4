//! The baked scenes: a host has written them (`tests/examples/chip.rs`), and they are traced
//! where they lie.

#[cfg(target_arch = "arm")]
use core::sync::atomic::{AtomicUsize, Ordering};

use strahl_core::accel::{Accelerator, TraversalStack};
use strahl_core::baked::{BakedAccelerator, BakedScene, BakedSceneError};
use strahl_core::scene::Effects;
use strahl_core::{AllEffects, BareList, Camera, CenterSampler, Limits, Scene, World, include_baked_scene};

use crate::draw::{Bytes, Row, Took, Wanted, bytes, draw};

/// What a host has written.
pub enum Written {
    /// Bytes.
    Bytes(&'static [u8]),
    /// Rust constants: [`constants`].
    Constants,
}

/// A baked scene and its name.
pub struct BakedFixture {
    /// What its picture is called.
    pub name: &'static core::ffi::CStr,
    /// What a host has written.
    pub written: Written,
}

/// The golden scene, which was written as constants, in a grid; then an octree, a grid, a
/// hierarchy over a mesh, and a list; and this as constants that the program wrote.
pub static SCENES: [BakedFixture; 6] = [
    BakedFixture {
        name: c"golden.f32",
        written: Written::Bytes(include_baked_scene!("../target/packs/golden.strahl")),
    },
    BakedFixture {
        name: c"classic.f32",
        written: Written::Bytes(include_baked_scene!("../target/packs/classic.strahl")),
    },
    BakedFixture {
        name: c"rotunda.f32",
        written: Written::Bytes(include_baked_scene!("../target/packs/rotunda.strahl")),
    },
    BakedFixture {
        name: c"mesh.f32",
        written: Written::Bytes(include_baked_scene!("../target/packs/mesh.strahl")),
    },
    BakedFixture {
        name: c"first.f32",
        written: Written::Bytes(include_baked_scene!("../target/packs/first.strahl")),
    },
    BakedFixture { name: c"constants.f32", written: Written::Constants },
];

/// What `strahl bake -o first.rs` writes.
pub mod constants {
    include!("../target/packs/first.rs");
}

/// Levels of rays that there is room for.
pub const LEVELS: usize = 6;

/// The picture that a scene was baked for.
pub fn wanted(pack: &BakedScene<'_>) -> Result<Wanted, &'static str> {
    let limits = Limits { levels: pack.levels(), cutoff: pack.cutoff() };
    let size = pack.resolution();
    Ok(Wanted { size, camera: pack.camera(size).map_err(|_| "the view shows nothing")?, limits })
}

/// As much of a row as the picture is wide.
fn of<'r>(row: &'r mut Row, wanted: &Wanted) -> Result<&'r mut [Bytes], &'static str> {
    row.get_mut(..wanted.size.width() as usize).ok_or("a row is too wide")
}

/// Draws a baked scene by whatever it was baked with; `clock` counts instructions where it can.
pub fn picture(
    baked: &BakedFixture,
    row: &mut Row,
    clock: impl Fn() -> u32,
    take: impl FnMut(&[Bytes]) -> bool,
) -> Result<Took<()>, &'static str> {
    type E = AllEffects;
    const { assert!(E::SET.shadows) };
    let refused = |_: BakedSceneError| "these bytes are no scene";
    let Written::Bytes(written) = baked.written else {
        use constants::{Asked, ITEMS, LIMITS, PARTS, SIZE, VIEW};
        let scene = Scene::new(PARTS).map_err(|_| "its parts make no scene")?;
        let camera = Camera::new(&VIEW, SIZE).map_err(|_| "the view shows nothing")?;
        let wanted = Wanted { size: SIZE, camera, limits: LIMITS };
        let (world, row) = (World::new(scene, BareList(ITEMS)), of(row, &wanted)?);
        return drawn::<_, Asked>(&world, wanted, row, clock, take);
    };
    let pack = BakedScene::open(written).map_err(refused)?;
    let (scene, wanted) = (*pack.scene(), wanted(&pack)?);
    let row = of(row, &wanted)?;
    match pack.accelerator().map_err(refused)? {
        BakedAccelerator::BareList(bare) => drawn::<_, E>(&World::new(scene, bare), wanted, row, clock, take),
        BakedAccelerator::Grid(grid) => {
            let grid = grid.with_mailbox::<64>();
            drawn::<_, E>(&World::new(scene, grid), wanted, row, clock, take)
        }
        BakedAccelerator::Octree(octree) => {
            let octree = octree.with_mailbox::<64>();
            drawn::<_, E>(&World::new(scene, octree), wanted, row, clock, take)
        }
        BakedAccelerator::Bvh(bvh) => {
            let bvh = bvh.with_queue::<TraversalStack<32>>();
            drawn::<_, E>(&World::new(scene, bvh), wanted, row, clock, take)
        }
    }
}

/// Not inlined: each has the stack that it needs, and not that of another beside it.
#[inline(never)]
fn drawn<A: Accelerator, E: Effects>(
    world: &World<'_, A>,
    wanted: Wanted,
    row: &mut [Bytes],
    clock: impl Fn() -> u32,
    take: impl FnMut(&[Bytes]) -> bool,
) -> Result<Took<()>, &'static str> {
    #[cfg(target_arch = "arm")]
    let here = &raw const row as usize;
    let took = draw::<_, E, _, _, _, LEVELS>(world, wanted, &mut CenterSampler, (), row, clock, bytes, take);
    #[cfg(target_arch = "arm")]
    STACK.fetch_max(crate::stack::used_below(here), Ordering::Relaxed);
    took
}

/// The most bytes of stack that a picture took, without what found and opened its scene.
#[cfg(target_arch = "arm")]
pub static STACK: AtomicUsize = AtomicUsize::new(0);
