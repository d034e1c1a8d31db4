//! The baked scenes: a host has written them (`tests/examples/chip.rs`), and they are traced
//! where they lie.

use strahl_core::{Effects, Everything, Finder, LastFirst, Limits, Pack, PackError, World, include_pack};

use crate::draw::{Row, Wanted, draw};

/// A baked scene and its name.
pub struct Baked {
    /// What its picture is called.
    pub name: &'static core::ffi::CStr,
    /// What a host has written.
    pub bytes: &'static [u8],
}

/// The golden scene, which was written as constants, in a grid; then an octree, a grid, a
/// hierarchy over a mesh, and a list.
pub static SCENES: [Baked; 5] = [
    Baked { name: c"golden.f32", bytes: include_pack!("../target/packs/golden.strahl") },
    Baked { name: c"classic.f32", bytes: include_pack!("../target/packs/classic.strahl") },
    Baked { name: c"rotunda.f32", bytes: include_pack!("../target/packs/rotunda.strahl") },
    Baked { name: c"mesh.f32", bytes: include_pack!("../target/packs/mesh.strahl") },
    Baked { name: c"first.f32", bytes: include_pack!("../target/packs/first.strahl") },
];

/// Levels of rays that there is room for.
pub const LEVELS: usize = 6;

/// The picture that a scene was baked for.
pub fn wanted(pack: &Pack<'_>) -> Result<Wanted, &'static str> {
    let limits = Limits { levels: pack.levels(), cutoff: pack.cutoff() };
    let size = pack.size();
    Ok(Wanted { size, camera: pack.camera(size).map_err(|_| "the view shows nothing")?, limits })
}

/// Draws a baked scene by whatever it was baked with.
pub fn picture(
    baked: &Baked,
    row: &mut Row,
    measure: impl FnMut(&mut dyn FnMut()),
    take: impl FnMut(&[u8]) -> bool,
) -> Result<usize, &'static str> {
    type E = Everything;
    const { assert!(E::SET.shadows) };
    let refused = |_: PackError| "these bytes are no scene";
    let pack = Pack::open(baked.bytes).map_err(refused)?;
    let (scene, wanted) = (*pack.scene(), wanted(&pack)?);
    match pack.finder().map_err(refused)? {
        Finder::Bare(bare) => draw::<_, E, LEVELS>(&World::new(scene, bare), wanted, row, measure, take),
        Finder::Grid(grid) => {
            draw::<_, E, LEVELS>(&World::new(scene, grid.with_mailbox::<64>()), wanted, row, measure, take)
        }
        Finder::Octree(octree) => {
            draw::<_, E, LEVELS>(&World::new(scene, octree.with_mailbox::<64>()), wanted, row, measure, take)
        }
        Finder::Bvh(bvh) => {
            let bvh = bvh.walked::<LastFirst<32>>();
            draw::<_, E, LEVELS>(&World::new(scene, bvh), wanted, row, measure, take)
        }
    }
}
