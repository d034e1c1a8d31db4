//! Invalid bytes are refused, and no bytes cause a panic.

use crate::*;

/// Offsets of the checksum, and of the bytes that it covers.
const CHECKSUM: usize = 12;
const COVERED: usize = 16;

/// Corrects the checksum (FNV-1a) of modified bytes.
fn seal(bytes: &mut [u8]) {
    let sum = bytes[COVERED..]
        .iter()
        .fold(0x811c_9dc5_u32, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193));
    bytes[CHECKSUM..COVERED].copy_from_slice(&sum.to_le_bytes());
}

fn opened(bytes: &[u8]) -> Option<BakedSceneError> {
    let aligned = AlignedBytes::of(bytes);
    BakedScene::open(aligned.bytes()).err()
}

#[test]
fn invalid_bytes_are_refused_with_the_reason() {
    let scene = mixed_scene();
    let bytes =
        baked(scene.as_scene(), BakedAccelerator::ListWithoutBounds(ListWithoutBounds(scene.item_count())));
    let with = |offset: usize, word: u32| {
        let mut bytes = bytes.clone();
        bytes[offset..offset + 4].copy_from_slice(&word.to_le_bytes());
        opened(&bytes)
    };
    assert_eq!(opened(&bytes), None);
    assert_eq!(with(0, 7), Some(BakedSceneError::BadMagic));
    let found = BakedScene::VERSION + 1;
    assert_eq!(with(4, found), Some(BakedSceneError::Version { found }));
    let (needed, given) = (bytes.len() + 1, bytes.len());
    assert_eq!(with(8, needed as u32), Some(BakedSceneError::TooShort { needed, provided: given }));
    assert_eq!(with(20, 99), Some(BakedSceneError::Checksum));
    // Bytes after the baked scene are ignored.
    assert_eq!(opened(&[bytes.as_slice(), &[1, 2, 3]].concat()), None);

    let aligned = AlignedBytes::of(&[&[0], bytes.as_slice()].concat());
    assert_eq!(BakedScene::open(&aligned.bytes()[1..]).err(), Some(BakedSceneError::Misaligned));
}

#[test]
fn a_truncated_baked_scene_is_too_short() {
    let scene = mixed_scene();
    let bytes =
        baked(scene.as_scene(), BakedAccelerator::ListWithoutBounds(ListWithoutBounds(scene.item_count())));
    for length in 0..bytes.len() {
        let error = opened(&bytes[..length]);
        assert!(matches!(error, Some(BakedSceneError::TooShort { .. })), "{length}: {error:?}");
    }
}

#[test]
fn a_flipped_bit_is_detected() {
    let scene = mixed_scene();
    let bytes =
        baked(scene.as_scene(), BakedAccelerator::ListWithoutBounds(ListWithoutBounds(scene.item_count())));
    for index in 0..bytes.len() {
        let mut bytes = bytes.clone();
        bytes[index] ^= 1 << (index % 8);
        assert!(opened(&bytes).is_some(), "{index}");
    }
}

/// Modified bytes with a correct checksum: some words are replaced by critical or random numbers.
fn forged(bytes: &[u8], rng: &mut SplitMix64) -> Vec<u8> {
    const WORDS: [u32; 14] = [
        0,
        1,
        2,
        7,
        9,
        0x7f,
        255,
        0xffff,
        0x7f80_0000,
        0x7fc0_0000,
        0x8000_0000,
        0xff80_0000,
        0x3f80_0000,
        u32::MAX,
    ];
    let mut bytes = bytes.to_vec();
    for _ in 0..1 + rng.below(3) {
        // Half of them in the header, which contains the offsets.
        let end = if rng.below(2) == 0 { 400 } else { bytes.len() as u32 / 4 * 4 };
        let offset = rng.below(end / 4) as usize * 4;
        if offset < COVERED {
            continue;
        }
        let word = match rng.below(3) {
            0 => WORDS[rng.below(WORDS.len() as u32) as usize],
            1 => rng.below(bytes.len() as u32 + 9),
            _ => rng.below(u32::MAX),
        };
        bytes[offset..offset + 4].copy_from_slice(&word.to_le_bytes());
    }
    seal(&mut bytes);
    bytes
}

/// Opens bytes and traces a few pixels, as a device does. Returns whether the bytes were accepted.
fn open_and_trace(bytes: &[u8]) -> bool {
    let aligned = AlignedBytes::of(bytes);
    let Ok(pack) = BakedScene::open(aligned.bytes()) else { return false };
    let (Ok(accelerator), Ok(camera)) = (pack.accelerator(), pack.camera(SIZE)) else { return false };
    fn trace_pixels<A: Accelerator>(scene: Scene<'_>, accelerator: A, camera: Camera) {
        let world = World::new(scene, accelerator);
        let tracer =
            Tracer::<_, AllEffects, 2>::new(&world, camera, Limits { levels: 2, cutoff: 0.1 }).unwrap();
        let mut worker = Worker::new(());
        for i in 0..12 {
            let pixel = Pixel { x: 2 * i, y: i + 2 };
            let mut sink = |_: Pixel, color: Rgb| assert!(color.is_in_range(Real::MAX), "{color:?}");
            let Ok(()) = render(&mut tracer.with_worker(&mut worker), &mut CenterSampler, [pixel], &mut sink);
        }
    }
    let scene = *pack.scene();
    match accelerator {
        BakedAccelerator::ListWithoutBounds(list) => trace_pixels(scene, list, camera),
        BakedAccelerator::Grid(grid) => trace_pixels(scene, grid.with_mailbox::<8>(), camera),
        BakedAccelerator::Octree(octree) => trace_pixels(scene, octree.with_mailbox::<8>(), camera),
        BakedAccelerator::Bvh(bvh) => trace_pixels(scene, bvh.with_queue::<TraversalHeap<8>>(), camera),
    }
    true
}

#[test]
fn forged_bytes_are_refused_or_traced_and_never_read_out_of_bounds() {
    let mut rng = SplitMix64::new(41);
    let (mut refused, mut traced) = (0, 0);
    for bytes in baked_with_every_accelerator(&mixed_scene()) {
        for _ in 0..1_500 {
            if open_and_trace(&forged(&bytes, &mut rng)) { traced += 1 } else { refused += 1 }
        }
    }
    // Both must happen, or the test checks nothing.
    assert!(refused > 1_000 && traced > 500, "{refused} refused, {traced} traced");
}
