//! Memory and order buy time, never truth: threads, tiles and tallies change no bit.

use strahl::description::Description;
use strahl::frame::{self, Frame};
use strahl::progress::Watch;
use strahl::signals::Signals;
use strahl::wanted::{Cut, Sampling, Wanted};
use strahl_core::Size;

const SAMPLINGS: [Sampling; 3] = [Sampling::Single, Sampling::Regular(2), Sampling::Corners];

fn scene() -> Description {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/rotunda.nff");
    strahl::load::load(&path).unwrap()
}

fn traced(scene: &Description, sampling: Sampling, cut: Cut, counted: bool) -> Frame {
    // Neither side a multiple of a tile.
    let size = Size::new(61, 37).unwrap();
    let wanted = Wanted { sampling, cut, counted, ..Wanted::of(size) };
    frame::trace(scene, &wanted, &Watch::silent(Signals::default())).unwrap()
}

#[test]
fn threads_change_neither_picture_nor_counts() {
    let scene = scene();
    for sampling in SAMPLINGS {
        let one = traced(&scene, sampling, Cut::threads(1), true);
        for threads in [2, 7] {
            let many = traced(&scene, sampling, Cut::threads(threads), true);
            assert_eq!(many.picture, one.picture, "{sampling:?}, {threads} threads");
            assert_eq!(many.counters, one.counters, "{sampling:?}, {threads} threads");
        }
    }
}

#[test]
fn tiles_do_not_change_the_picture() {
    let scene = scene();
    for sampling in SAMPLINGS {
        let truth = traced(&scene, sampling, Cut { threads: 1, tile: 1000 }, true);
        for tile in [1, 5, 32] {
            let cut = traced(&scene, sampling, Cut { threads: 2, tile }, true);
            assert_eq!(cut.picture, truth.picture, "{sampling:?}, tiles of {tile}");
            assert_eq!(cut.counters, truth.counters, "{sampling:?}, tiles of {tile}");
        }
    }
}

#[test]
fn counting_changes_nothing() {
    let scene = scene();
    let counted = traced(&scene, Sampling::Single, Cut::threads(0), true);
    let silent = traced(&scene, Sampling::Single, Cut::threads(0), false);
    assert_eq!(counted.picture, silent.picture);
    assert!(counted.counters.is_some() && silent.counters.is_none());
}

#[test]
fn a_digest_tells_pictures_apart_by_one_bit() {
    let mut picture = traced(&scene(), Sampling::Single, Cut::threads(0), false).picture;
    let digest = picture.digest();
    assert_eq!(picture.clone().digest(), digest);
    picture.colors[100].g = picture.colors[100].g.next_up();
    assert_ne!(picture.digest(), digest);
}
