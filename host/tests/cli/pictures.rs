//! What is in the pictures.

use image::{ImageFormat, RgbImage};

use crate::program::{BALL, EMPTY, Folder};

fn png(bytes: &[u8]) -> RgbImage {
    image::load_from_memory_with_format(bytes, ImageFormat::Png).unwrap().into_rgb8()
}

fn ppm(bytes: &[u8]) -> RgbImage {
    image::load_from_memory_with_format(bytes, ImageFormat::Pnm).unwrap().into_rgb8()
}

/// The picture of a scene that is rendered with these words.
fn picture(scene: &str, words: &str) -> RgbImage {
    png(&Folder::with(scene).done(&format!("render scene.nff -q -o - {words}")))
}

#[test]
fn png_and_ppm_hold_the_same_pixels() {
    let folder = Folder::with(BALL);
    for name in ["a.png", "a.ppm", "b.PNG", "b.Ppm"] {
        folder.done(&format!("render scene.nff -o {name}"));
    }
    let (png, ppm) = (png(&folder.read("a.png")), ppm(&folder.read("a.ppm")));
    assert_eq!(png.dimensions(), (40, 30));
    assert_eq!(png, ppm);
    assert!(folder.read("a.ppm").starts_with(b"P6"));
    assert_eq!(folder.read("a.png"), folder.read("b.PNG"));
    assert_eq!(folder.read("a.ppm"), folder.read("b.Ppm"));
}

#[test]
fn an_empty_scene_is_its_background() {
    // The sRGB encoding of 0.25, 0.5 and 1.
    let it = picture(EMPTY, "");
    assert_eq!(it.dimensions(), (4, 3));
    assert!(it.pixels().all(|pixel| pixel.0 == [137, 188, 255]), "{it:?}");
}

#[test]
fn a_ball_is_in_the_middle_and_has_the_colour_of_ambient_light_where_no_light_shines() {
    let text = format!("{EMPTY}f 1 1 1 1 0 0 0 0\ns 0 0 0 1\n");
    let it = picture(&text, "--size 41x31");
    // Half of white: no light counts as one.
    assert_eq!(it.get_pixel(20, 15).0, [188; 3]);
    assert_eq!(it.get_pixel(0, 0).0, [137, 188, 255]);
    let mut turned = it.clone();
    image::imageops::rotate180_in_place(&mut turned);
    assert_eq!(turned, it);
}

#[test]
fn the_size_of_the_command_line_wins_over_that_of_the_scene() {
    assert_eq!(picture(BALL, "--size 7x5").dimensions(), (7, 5));
    assert_eq!(picture(BALL, "--size 1X1").dimensions(), (1, 1));
    assert_eq!(picture(BALL, "").dimensions(), (40, 30));
}

#[test]
fn every_run_makes_the_same_file_with_any_number_of_threads() {
    let folder = Folder::with(BALL);
    for sampler in ["single", "regular:2", "adaptive:0:0"] {
        // Some tiles of each size: whole, and cut off at the right and at the bottom.
        let words = format!("render scene.nff -q -o - --size 101x75 --sampler {sampler}");
        let file = folder.done(&words);
        for threads in ["", "--threads 1", "--threads 2", "--threads 7"] {
            assert!(folder.done(&format!("{words} {threads}")) == file, "{sampler} {threads}");
        }
    }
}

#[test]
fn samplers_agree_where_the_picture_is_one_colour() {
    for sampler in ["single", "regular:1", "regular:3", "adaptive:0:0"] {
        assert_eq!(picture(EMPTY, &format!("--sampler {sampler}")), picture(EMPTY, ""), "{sampler}");
    }
    assert_eq!(picture(BALL, "--sampler regular:1"), picture(BALL, ""));
    assert_ne!(picture(BALL, "--sampler regular:2"), picture(BALL, ""));
}

#[test]
fn levels_and_cutoff_choose_the_picture() {
    let whole = picture(BALL, "");
    assert_eq!(picture(BALL, "--levels 5 --cutoff 0.001953125"), whole);
    let first = picture(BALL, "--levels 1");
    assert_ne!(first, whole);
    // No ray counts with more than all.
    assert_eq!(picture(BALL, "--cutoff 1"), first);
    picture(BALL, "--levels 64 --cutoff 0");
}
