//! No other bytes are a baked scene, and none lead to a panic.

use crate::*;

/// The place of the checksum, and of what it covers.
const SUM: usize = 12;
const COVERED: usize = 16;

/// Makes bytes valid that were changed on purpose: FNV-1a, written once more.
fn seal(bytes: &mut [u8]) {
    let sum = bytes[COVERED..]
        .iter()
        .fold(0x811c_9dc5_u32, |sum, byte| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193));
    bytes[SUM..COVERED].copy_from_slice(&sum.to_le_bytes());
}

fn opened(bytes: &[u8]) -> Option<PackError> {
    let aligned = Aligned::of(bytes);
    Pack::open(aligned.bytes()).err()
}

#[test]
fn what_is_no_pack_is_told_by_its_reason() {
    let scene = fair();
    let bytes = baked(scene.as_scene(), Finder::Bare(BareList(scene.item_count())));
    let with = |place: usize, word: u32| {
        let mut bytes = bytes.clone();
        bytes[place..place + 4].copy_from_slice(&word.to_le_bytes());
        opened(&bytes)
    };
    assert_eq!(opened(&bytes), None);
    assert_eq!(with(0, 7), Some(PackError::NotAPack));
    let found = Pack::VERSION + 1;
    assert_eq!(with(4, found), Some(PackError::Version { found }));
    let (needed, given) = (bytes.len() + 1, bytes.len());
    assert_eq!(with(8, needed as u32), Some(PackError::TooShort { needed, given }));
    assert_eq!(with(20, 99), Some(PackError::Checksum));
    // What follows the pack is not its own.
    assert_eq!(opened(&[bytes.as_slice(), &[1, 2, 3]].concat()), None);

    let aligned = Aligned::of(&[&[0], bytes.as_slice()].concat());
    assert_eq!(Pack::open(&aligned.bytes()[1..]).err(), Some(PackError::Misaligned));
}

#[test]
fn a_pack_that_is_cut_anywhere_is_too_short() {
    let scene = fair();
    let bytes = baked(scene.as_scene(), Finder::Bare(BareList(scene.item_count())));
    for length in 0..bytes.len() {
        let error = opened(&bytes[..length]);
        assert!(matches!(error, Some(PackError::TooShort { .. })), "{length}: {error:?}");
    }
}

#[test]
fn a_bit_that_flips_is_noticed() {
    let scene = fair();
    let bytes = baked(scene.as_scene(), Finder::Bare(BareList(scene.item_count())));
    for place in 0..bytes.len() {
        let mut bytes = bytes.clone();
        bytes[place] ^= 1 << (place % 8);
        assert!(opened(&bytes).is_some(), "{place}");
    }
}

/// Bytes with some changes that somebody meant: words of numbers that matter, and a right sum.
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
        // Half of them in the header, which says where everything is.
        let end = if rng.below(2) == 0 { 400 } else { bytes.len() as u32 / 4 * 4 };
        let place = rng.below(end / 4) as usize * 4;
        if place < COVERED {
            continue;
        }
        let word = match rng.below(3) {
            0 => WORDS[rng.below(WORDS.len() as u32) as usize],
            1 => rng.below(bytes.len() as u32 + 9),
            _ => rng.below(u32::MAX),
        };
        bytes[place..place + 4].copy_from_slice(&word.to_le_bytes());
    }
    seal(&mut bytes);
    bytes
}

/// Everything that a device may ask of bytes that it was given. No answer is expected but an end.
fn used(bytes: &[u8]) -> bool {
    let aligned = Aligned::of(bytes);
    let Ok(pack) = Pack::open(aligned.bytes()) else { return false };
    let (Ok(finder), Ok(camera)) = (pack.finder(), pack.camera(SIZE)) else { return false };
    fn few<A: Accelerator>(scene: Scene<'_>, accelerator: A, camera: Camera) {
        let world = World::new(scene, accelerator);
        let tracer =
            Tracer::<_, AllEffects, 2>::new(&world, camera, Limits { levels: 2, cutoff: 0.1 }).unwrap();
        let mut worker = Worker::new(());
        for place in 0..12 {
            let pixel = Pixel { x: 2 * place, y: place + 2 };
            let mut sink = |_: Pixel, color: Rgb| assert!(color.is_in_range(Real::MAX), "{color:?}");
            let Ok(()) = render(&mut tracer.with_worker(&mut worker), &mut Single, [pixel], &mut sink);
        }
    }
    let scene = *pack.scene();
    match finder {
        Finder::Bare(bare) => few(scene, bare, camera),
        Finder::Grid(grid) => few(scene, grid.with_mailbox::<8>(), camera),
        Finder::Octree(octree) => few(scene, octree.with_mailbox::<8>(), camera),
        Finder::Bvh(bvh) => few(scene, bvh.with_queue::<TraversalHeap<8>>(), camera),
    }
    true
}

#[test]
fn forged_bytes_are_refused_or_traced_but_never_followed_out_of_range() {
    let mut rng = SplitMix64::new(41);
    let (mut refused, mut traced) = (0, 0);
    for bytes in every_pack(&fair()) {
        for _ in 0..1_500 {
            if used(&forged(&bytes, &mut rng)) { traced += 1 } else { refused += 1 }
        }
    }
    // Both happen, or this test would say nothing.
    assert!(refused > 1_000 && traced > 500, "{refused} refused, {traced} traced");
}
