//! What is in the pictures.

use image::{DynamicImage, ImageFormat, RgbImage};

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
fn every_format_without_loss_holds_the_same_pixels() {
    let folder = Folder::with(BALL);
    folder.done("render scene.nff -o a.png");
    let expected = png(&folder.read("a.png"));
    for (name, other, format, begins) in [
        ("a.ppm", "b.PPM", ImageFormat::Pnm, b"P6".as_slice()),
        ("a.qoi", "b.Qoi", ImageFormat::Qoi, b"qoif"),
        ("a.tif", "b.TIFF", ImageFormat::Tiff, b"II*\0"),
    ] {
        folder.done(&format!("render scene.nff -o {name}"));
        folder.done(&format!("render scene.nff -o {other}"));
        let file = folder.read(name);
        assert!(file.starts_with(begins), "{name}");
        assert!(folder.read(other) == file, "{other}");
        assert_eq!(
            image::load_from_memory_with_format(&file, format).unwrap().into_rgb8(),
            expected,
            "{name}"
        );
    }
}

#[test]
fn a_jpeg_is_near_and_keeps_the_colours_of_single_pixels() {
    // A red and a blue half, so that the edge is between two pixels that JPEG might share.
    let red_and_blue = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 resolution 15 9\nb 0 0 1\n\
        f 1 0 0 0 0 0 0 0\nl 0 0 9 3 0 0\np 4 0 -9 0 0 9 0 -9 9 0 -9 -9 0\n";
    let folder = Folder::with(red_and_blue);
    for name in ["a.png", "a.jpg", "b.JPEG"] {
        folder.done(&format!("render scene.nff -o {name}"));
    }
    assert!(folder.read("a.jpg").starts_with(b"\xff\xd8"));
    assert!(folder.read("a.jpg") == folder.read("b.JPEG"));
    let jpeg = image::load_from_memory_with_format(&folder.read("a.jpg"), ImageFormat::Jpeg).unwrap();
    for (a, b) in png(&folder.read("a.png")).pixels().zip(jpeg.into_rgb8().pixels()) {
        let far = a.0.into_iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap();
        // Shared colours would be off by a hundred.
        assert!(far <= 12, "{a:?} {b:?}");
    }
}

#[test]
fn an_exr_file_holds_the_bits_of_the_linear_floats() {
    let folder = Folder::with(BALL);
    let words = "--stats json --stats-file a.json";
    for sampler in ["single", "regular:3"] {
        folder.done(&format!("render scene.nff -o a.exr --sampler {sampler} {words}"));
        let DynamicImage::ImageRgb32F(floats) = image::load_from_memory(&folder.read("a.exr")).unwrap()
        else {
            panic!("other than three floats for each pixel");
        };
        assert_eq!(floats.dimensions(), (40, 30));
        // The digest is that of the bits, row by row, little endian.
        let bytes: Vec<u8> = floats.as_raw().iter().flat_map(|v| v.to_le_bytes()).collect();
        let stats: serde_json::Value = serde_json::from_slice(&folder.read("a.json")).unwrap();
        assert_eq!(stats["digest"], blake3::hash(&bytes).to_hex().as_str(), "{sampler}");
    }
}

#[test]
fn an_exr_file_holds_every_float_that_there_is() {
    let smallest = f32::from_bits(1);
    let colors = [
        [0.0, -0.0, smallest],
        [f32::MIN, f32::MAX, f32::EPSILON],
        [f32::INFINITY, f32::NEG_INFINITY, 1e6],
        [f32::NAN, -f32::NAN, f32::from_bits(0x7f80_0001)],
    ];
    let picture = strahl_picture::Picture {
        size: strahl_core::Resolution::new(2, 2).unwrap(),
        colors: colors.map(|[r, g, b]| strahl_core::Rgb::new(r, g, b)).to_vec(),
    };
    let file = strahl_picture::PictureFormat::Exr.encode(&picture).unwrap();
    let floats = image::load_from_memory(&file).unwrap().into_rgb32f();
    let bits = |values: &[f32]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(floats.as_raw()), bits(colors.as_flattened()));
}

#[test]
fn a_second_run_makes_the_same_file_in_every_format() {
    let folder = Folder::with(BALL);
    for extension in ["png", "ppm", "qoi", "jpg", "tif", "exr"] {
        folder.done(&format!("render scene.nff -q -o a.{extension}"));
        folder.done(&format!("render scene.nff -q -o b.{extension} --threads 1"));
        assert!(
            folder.read(&format!("a.{extension}")) == folder.read(&format!("b.{extension}")),
            "{extension}"
        );
    }
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
