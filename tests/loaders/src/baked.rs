//! Checks of the opening of baked scenes, for any bytes: no panic, no read out of bounds, and a picture of
//! finite colors if the bytes are accepted.

use strahl_core::accel::{Accelerator, TraversalStack};
use strahl_core::baked::{BakedAccelerator, BakedScene};
use strahl_core::{AllEffects, CenterSampler, Limits, Resolution, Rgb, Tile, Tracer, Worker, World, render};

/// Checks bytes as they are, and with a valid header, so that the checksum does not reject all of them.
pub fn pack(bytes: &[u8]) {
    let mut aligned = AlignedPack::of(bytes);
    draw(aligned.bytes());
    if repair(aligned.bytes_mut()) {
        draw(aligned.bytes());
    }
}

/// Bytes at an address that is a multiple of four, as in a device's flash.
struct AlignedPack {
    held: Vec<u8>,
    start: usize,
    length: usize,
}

impl AlignedPack {
    fn of(bytes: &[u8]) -> Self {
        let mut held = vec![0; bytes.len() + 3];
        let start = held.as_ptr().align_offset(4);
        held[start..start + bytes.len()].copy_from_slice(bytes);
        AlignedPack { held, start, length: bytes.len() }
    }

    fn bytes(&self) -> &[u8] {
        &self.held[self.start..self.start + self.length]
    }

    fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.held[self.start..self.start + self.length]
    }
}

/// Corrects version, length and checksum. Returns false if the bytes are too short for a header.
fn repair(bytes: &mut [u8]) -> bool {
    const UNCHECKED: usize = 16;
    let Some((header, covered)) = bytes.split_at_mut_checked(UNCHECKED) else { return false };
    // FNV-1a.
    let checksum =
        covered.iter().fold(0x811c_9dc5_u32, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193));
    let length = (UNCHECKED + covered.len()) as u32;
    for (slot, word) in
        header.as_chunks_mut::<4>().0[1..].iter_mut().zip([BakedScene::VERSION, length, checksum])
    {
        *slot = word.to_le_bytes();
    }
    true
}

fn draw(bytes: &[u8]) {
    let Ok(pack) = BakedScene::open(bytes) else { return };
    let Ok(accelerator) = pack.accelerator() else { return };
    let scene = *pack.scene();
    match accelerator {
        BakedAccelerator::ListWithoutBounds(list) => trace(&pack, World::new(scene, list)),
        BakedAccelerator::Grid(grid) => trace(&pack, World::new(scene, grid.with_mailbox::<8>())),
        BakedAccelerator::Octree(octree) => trace(&pack, World::new(scene, octree.with_mailbox::<8>())),
        BakedAccelerator::Bvh(bvh) => trace(&pack, World::new(scene, bvh.with_queue::<TraversalStack<8>>())),
    }
}

fn trace<A: Accelerator>(pack: &BakedScene<'_>, world: World<'_, A>) {
    const LEVELS: u8 = 4;
    let tile = Tile::full(Resolution::new(6, 4).expect("a valid resolution"));
    let Ok(camera) = pack.camera(Resolution::new(6, 4).expect("a valid resolution")) else { return };
    let limits = Limits { levels: pack.levels().min(LEVELS), cutoff: pack.cutoff() };
    let Ok(tracer) = Tracer::<_, AllEffects, { LEVELS as usize }>::new(&world, camera, limits) else {
        return;
    };
    let mut sink = |_, color: Rgb| assert!(color.r.is_finite() && color.g.is_finite() && color.b.is_finite());
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, tile.pixels(), &mut sink);
}
