//! Reports of `compare`.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::Cursor;

use image::{DynamicImage, ImageBuffer, ImageFormat, Rgb, RgbImage, RgbaImage};
use serde_json::{Value, json};
use strahl_core::Resolution;
use strahl_picture::{Picture, PictureFormat};

use crate::program::{BALL, EMPTY, Folder};

/// A picture as a file.
fn file(picture: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    picture.into().write_to(&mut file, format).unwrap();
    file.into_inner()
}

fn png(picture: &RgbImage) -> Vec<u8> {
    file(picture.clone(), ImageFormat::Png)
}

/// Grey, 4 x 3.
fn gray() -> RgbImage {
    RgbImage::from_pixel(4, 3, Rgb([100; 3]))
}

/// With another colour at one place.
fn changed(x: u32, y: u32, color: [u8; 3]) -> RgbImage {
    let mut picture = gray();
    picture.put_pixel(x, y, Rgb(color));
    picture
}

/// Linear floats as an EXR file, in one row.
fn exr(colors: &[[f32; 3]]) -> Vec<u8> {
    let colors = colors.iter().map(|c| strahl_core::Rgb::new(c[0], c[1], c[2])).collect::<Vec<_>>();
    let size = Resolution::new(colors.len() as u32, 1).unwrap();
    PictureFormat::Exr.encode(&Picture { size, colors }).unwrap()
}

/// A folder with these in `a` and `b`; what they are stands inside them.
fn pair(a: &[u8], b: &[u8]) -> Folder {
    let folder = Folder::with(EMPTY);
    folder.write("a", a);
    folder.write("b", b);
    folder
}

/// What `compare a b --json` says, and its exit status.
fn compared(a: &[u8], b: &[u8], words: &str) -> (Value, Option<i32>) {
    let ran = pair(a, b).run(&format!("compare a b --json {words}"));
    assert_eq!(ran.stderr, "");
    (serde_json::from_slice(&ran.stdout).unwrap(), ran.status)
}

fn assert_near(value: &Value, expected: f64) {
    // Sums of a few numbers of 16 digits.
    let it = value.as_f64().unwrap();
    assert!((it - expected).abs() <= 1e-12 * expected.abs(), "{it} is not {expected}");
}

#[test]
fn one_pixel_that_differs_has_the_measures_on_paper() {
    // 51 of 255 is a fifth; twelve pixels have 36 channels.
    let (it, status) = compared(&png(&gray()), &png(&changed(2, 1, [100, 151, 100])), "");
    assert_eq!(status, Some(1));
    assert_eq!((&it["identical"], &it["equal"]), (&json!(false), &json!(false)));
    assert_eq!(it["largest"], json!({ "difference": 0.2, "x": 2, "y": 1, "channel": "green" }));
    assert_near(&it["mean_absolute"], 0.2 / 36.0);
    assert_near(&it["rmse"], 0.2 / 6.0);
    assert_near(&it["psnr"], 20.0 * 30.0_f64.log10());
    let one = json!({ "pixels": 1, "share": 1.0 / 12.0 });
    assert_eq!((&it["differing"], &it["beyond"], &it["over_limit"]), (&one, &one, &one));
    let ssim = it["ssim"].as_f64().unwrap();
    assert!(ssim > 0.5 && ssim < 0.99, "{ssim}");
    assert_eq!(it["largest_linear"], Value::Null);
}

#[test]
fn a_picture_is_identical_to_itself() {
    let (it, status) = compared(&png(&gray()), &png(&gray()), "");
    assert_eq!(status, Some(0));
    let none = json!({ "pixels": 0, "share": 0.0 });
    assert_eq!(
        it,
        json!({
            "first": "a", "second": "b", "width": 4, "height": 3, "identical": true, "equal": true,
            "limit": 0.0, "limit_share": 0.0, "largest": null, "mean_absolute": 0.0, "rmse": 0.0,
            "psnr": null, "ssim": 1.0, "differing": none, "beyond": none, "over_limit": none,
            "largest_linear": null,
        })
    );
}

#[test]
fn the_help_names_every_key_of_the_report() {
    let (it, _) = compared(&png(&gray()), &png(&changed(0, 0, [0; 3])), "");
    let help = String::from_utf8(Folder::with(EMPTY).done("compare --help")).unwrap();
    let words: BTreeSet<&str> = help.split(|c: char| !c.is_ascii_alphabetic() && c != '_').collect();
    let inner = ["largest", "over_limit"].into_iter().flat_map(|key| it[key].as_object().unwrap().keys());
    for key in it.as_object().unwrap().keys().chain(inner) {
        assert!(words.contains(key.as_str()), "{key} is not in\n{help}");
    }
}

#[test]
fn one_step_of_eight_bits_is_a_difference_but_not_beyond_1_255() {
    let (it, status) = compared(&png(&gray()), &png(&changed(3, 2, [100, 100, 99])), "");
    assert_eq!(status, Some(1));
    assert_eq!((&it["differing"]["pixels"], &it["beyond"]["pixels"]), (&json!(1), &json!(0)));
    let (it, _) = compared(&png(&gray()), &png(&changed(3, 2, [100, 100, 98])), "");
    assert_eq!(it["beyond"]["pixels"], 1);
}

#[test]
fn the_limits_decide_and_a_difference_of_exactly_the_limit_is_within_it() {
    let mut other = changed(2, 1, [100, 151, 100]);
    other.put_pixel(0, 0, Rgb([101; 3]));
    for (words, equal, over) in [
        ("--limit 0.2", true, 0),
        ("--limit 51/255", true, 0),
        ("--limit 1", true, 0),
        ("--limit 0.1999", false, 1),
        ("--limit 50/255", false, 1),
        ("--limit 1/255", false, 1),
        ("--limit 0", false, 2),
        ("--limit-share 2/12", true, 2),
        ("--limit-share 0.16", false, 2),
        ("--limit 1/255 --limit-share 1/12", true, 1),
        ("--limit 1/255 --limit-share 0.08", false, 1),
        ("--limit-share 1", true, 2),
    ] {
        let (it, status) = compared(&png(&gray()), &png(&other), words);
        assert_eq!((status == Some(0), &it["equal"]), (equal, &json!(equal)), "{words}");
        assert_eq!(it["over_limit"]["pixels"], over, "{words}");
        assert_eq!(it["identical"], false, "{words}");
    }
}

#[test]
fn the_text_has_the_same_contents() {
    let folder = pair(&png(&gray()), &png(&changed(2, 1, [100, 151, 100])));
    let ran = folder.run("compare a b --limit 0.1");
    assert_eq!((ran.status, ran.stderr.as_str()), (Some(1), ""));
    let text = String::from_utf8(ran.stdout).unwrap();
    for said in [
        "a and b  4 x 3, different\n",
        "1 pixel (8.33 %), 1 pixel (8.33 %) by more than 1/255\n",
        "1 pixel (8.33 %) by more than 0.1\n",
        "0.2 (51 of 255) at 2,1 in green\n",
        "0.0333 (PSNR 29.5 dB)\n",
    ] {
        assert!(text.contains(said), "`{said}` is not in\n{text}");
    }
    assert_eq!(folder.done("compare a a"), b"a and a  4 x 3, identical\n");
    let text = String::from_utf8(folder.done("compare a b --limit 0.5")).unwrap();
    assert!(text.starts_with("a and b  4 x 3, equal within the limit\n"), "{text}");
    let quiet = folder.run("compare a b -q");
    assert_eq!((quiet.status, quiet.stdout, quiet.stderr.as_str()), (Some(1), vec![], ""));
}

#[test]
fn a_picture_can_come_from_the_standard_input() {
    let folder = pair(&png(&gray()), &png(&changed(2, 1, [0; 3])));
    let ended = |words: &str, name: &str| {
        let input = File::open(folder.path(name)).unwrap();
        folder.command(words).stdin(input).output().unwrap().status.code()
    };
    assert_eq!(ended("compare a - -q", "a"), Some(0));
    assert_eq!(ended("compare - a -q", "b"), Some(1));
}

#[test]
fn every_format_that_is_written_is_read_and_only_jpeg_loses_something() {
    let folder = Folder::with(BALL);
    for name in ["a.png", "a.ppm", "a.qoi", "a.jpg", "a.tif", "a.exr"] {
        folder.done(&format!("render scene.nff -q -o {name}"));
    }
    for name in ["a.ppm", "a.qoi", "a.tif", "a.exr"] {
        for words in [format!("compare a.png {name}"), format!("compare {name} a.png")] {
            let text = String::from_utf8(folder.done(&words)).unwrap();
            assert!(text.ends_with("40 x 30, identical\n"), "{text}");
        }
    }
    folder.done("compare a.exr a.exr");
    assert_eq!(folder.run("compare a.png a.jpg").status, Some(1));
    folder.done("compare a.png a.jpg --limit 0.1 --limit-share 0.01");
}

#[test]
fn the_content_says_what_a_file_is_and_not_its_name() {
    let folder = pair(&png(&gray()), &file(gray(), ImageFormat::Qoi));
    std::fs::rename(folder.path("b"), folder.path("b.png")).unwrap();
    folder.done("compare a b.png");
}

#[test]
fn sixteen_bits_hold_eight_exactly_and_are_not_rounded() {
    let mut deep = ImageBuffer::from_pixel(4, 3, Rgb([100 * 257_u16; 3]));
    let (it, status) = compared(&png(&gray()), &file(deep.clone(), ImageFormat::Png), "");
    assert_eq!((status, &it["identical"]), (Some(0), &json!(true)));
    deep.put_pixel(1, 2, Rgb([100 * 257, 100 * 257, 100 * 257 + 1]));
    let (it, _) = compared(&file(deep, ImageFormat::Tiff), &png(&gray()), "");
    assert_eq!(it["largest"], json!({ "difference": 1.0 / 65535.0, "x": 1, "y": 2, "channel": "blue" }));
    // Half of all light is 188 of 255, or 48192 of 65535.
    let half = ImageBuffer::from_pixel(2, 1, Rgb([48192_u16; 3]));
    let (it, _) = compared(&file(half, ImageFormat::Png), &exr(&[[0.5; 3]; 2]), "");
    assert_eq!(it["identical"], true);
}

#[test]
fn transparent_pixels_are_reported_and_not_compared() {
    let mut clear = RgbaImage::from_pixel(4, 3, image::Rgba([100, 100, 100, 255]));
    assert_eq!(compared(&png(&gray()), &file(clear.clone(), ImageFormat::Png), "").1, Some(0));
    clear.get_pixel_mut(3, 0).0[3] = 254;
    pair(&png(&gray()), &file(clear, ImageFormat::Png))
        .run("compare a b")
        .failed(65, "b: some pixels are transparent");
}

#[test]
fn two_exr_files_are_compared_as_encodings_and_their_light_is_reported_too() {
    let (it, status) = compared(&exr(&[[0.0; 3], [0.25; 3]]), &exr(&[[0.0; 3], [0.25, 0.75, 0.25]]), "");
    assert_eq!(status, Some(1));
    let linear = json!({ "difference": 0.5, "x": 1, "y": 0, "channel": "green" });
    assert_eq!(it["largest_linear"], linear);
    // The sRGB encodings of 3/4 and 1/4.
    let encoded = it["largest"]["difference"].as_f64().unwrap();
    assert!((encoded - (0.880_825 - 0.537_099)).abs() <= 1e-6, "{encoded}");
}

#[test]
fn light_that_is_brighter_than_white_differs_only_bit_for_bit() {
    let (a, b) = (exr(&[[2.0; 3]]), exr(&[[5.0; 3]]));
    let (it, status) = compared(&a, &b, "");
    assert_eq!((status, &it["largest"], &it["differing"]["pixels"]), (Some(1), &Value::Null, &json!(1)));
    assert_eq!(it["largest_linear"]["difference"], 3.0);
    assert_eq!(compared(&a, &b, "--limit 1e-9").1, Some(0));
    // So do zeros of two signs.
    assert_eq!(compared(&exr(&[[0.0; 3]]), &exr(&[[-0.0; 3]]), "").1, Some(1));
}

#[test]
fn what_is_not_a_number_differs_from_every_number_and_not_from_itself() {
    let holes = exr(&[[0.5, f32::NAN, f32::INFINITY], [0.5; 3]]);
    let (it, status) = compared(&holes, &holes, "");
    assert_eq!((status, &it["identical"], &it["ssim"]), (Some(0), &json!(true), &json!(1.0)));

    let (it, status) = compared(&holes, &exr(&[[0.5, 0.0, 1.0], [0.5; 3]]), "--limit 0.99");
    assert_eq!(status, Some(1));
    assert_eq!(it["largest"], json!({ "difference": 1.0, "x": 0, "y": 0, "channel": "green" }));
    assert_eq!(it["largest_linear"], json!({ "difference": null, "x": 0, "y": 0, "channel": "green" }));
}

#[test]
fn pictures_of_two_sizes_are_reported_with_both() {
    let wide = RgbImage::new(40, 3);
    let folder = pair(&png(&gray()), &png(&wide));
    folder.run("compare a b -o map.png").failed(65, "strahl: b: is 40x3 pixels, but a is 4x3\n");
    assert_eq!(folder.names(), ["a", "b", "scene.nff"]);
}

#[test]
fn what_is_no_picture_is_reported_with_status_65_and_what_cannot_be_read_with_66() {
    let folder = pair(&png(&gray()), b"");
    folder.write("text.png", "not a picture\n");
    std::fs::create_dir(folder.path("folder")).unwrap();
    folder.run("compare a b").failed(65, "strahl: b: not a picture in a supported format");
    folder.run("compare text.png a").failed(65, "text.png: not a picture");
    folder.write("a.bmp", b"BM\x3a\0\0\0\0\0\0\0\x36\0\0\0");
    folder
        .run("compare a.bmp a")
        .failed(65, "a.bmp: BMP is not supported; supported formats: PNG, PPM, QOI, JPEG, TIFF, EXR\n");
    folder.run("compare scene.nff a").failed(65, "scene.nff: not a picture");
    folder.run("compare a missing.png").failed(66, "cannot read missing.png: ");
    folder.run("compare folder a").failed(66, "cannot read folder: ");
}

#[test]
fn a_file_that_ends_too_soon_is_reported_with_status_65() {
    let folder = Folder::with(BALL);
    for name in ["a.png", "a.ppm", "a.qoi", "a.tif", "a.exr", "a.jpg"] {
        folder.done(&format!("render scene.nff -q -o {name}"));
        let whole = folder.read(name);
        folder.write("short", &whole[..whole.len() / 2]);
        // Of half a JPEG one half can be seen: then the two differ.
        let status = folder.run(&format!("compare short {name} -q")).status;
        assert!(status == Some(65) || name == "a.jpg" && status == Some(1), "{name}: {status:?}");
        folder.write("short", &whole[..whole.len().min(20)]);
        folder.run(&format!("compare short {name}")).failed(65, "short: corrupt: ");
    }
}

#[test]
fn a_short_file_that_claims_to_be_huge_is_rejected_before_memory_is_allocated() {
    let huge = |width: u32, height: u32| {
        let size = [width.to_be_bytes(), height.to_be_bytes()].concat();
        [b"qoif", size.as_slice(), &[3, 0], &[0xfd; 9], &[0, 0, 0, 0, 0, 0, 0, 1]].concat()
    };
    let folder = pair(&png(&gray()), &huge(16384, 16384));
    folder.run("compare a b").failed(65, "b: corrupt: 31 bytes cannot hold 16384 x 16384 pixels");
    folder.write("b", huge(65537, 1));
    folder.run("compare a b").failed(65, "b: 65537 x 1 pixels; the limit is 268435456 pixels");
    folder.write("b", huge(65536, 65536));
    folder.run("compare a b").failed(65, "b: corrupt: ");
    folder.write("b", b"P6 16000 16000 255 ");
    folder.run("compare a b").failed(65, "b: corrupt: 19 bytes cannot hold 16000 x 16000 pixels");
}

#[test]
fn no_broken_file_makes_the_reader_panic() {
    let folder = Folder::with(BALL);
    let mut state = 1_u32;
    let mut random = |most: usize| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as usize % most
    };
    let mut broken = 0;
    for name in ["a.png", "a.ppm", "a.qoi", "a.jpg", "a.tif", "a.exr"] {
        folder.done(&format!("render scene.nff -q --size 9x7 -o {name}"));
        let whole = folder.read(name);
        for _ in 0..1000 {
            let mut file = whole.clone();
            // Mostly where a file says what it is.
            for _ in 0..=random(3) {
                let near = if random(3) == 0 { file.len() } else { file.len().min(400) };
                let place = random(near);
                file[place] = [0, 1, 127, 128, 255, random(256) as u8][random(6)];
            }
            file.truncate(if random(4) == 0 { random(file.len()) } else { file.len() });
            broken += usize::from(strahl_picture::decode(&file, 1 << 28).is_err());
        }
    }
    assert!(broken > 1000, "{broken}");
}

#[test]
fn the_map_is_black_where_the_pictures_agree_and_pale_where_they_differ_most() {
    let other = {
        let mut other = changed(2, 1, [101, 100, 100]);
        other.put_pixel(0, 2, Rgb([255, 0, 100]));
        other.put_pixel(3, 0, Rgb([100, 102, 101]));
        other
    };
    let mut a = gray();
    a.put_pixel(0, 2, Rgb([0; 3]));
    let folder = pair(&png(&a), &png(&other));
    for name in ["map.png", "map.qoi", "map.tif"] {
        assert_eq!(folder.run(&format!("compare a b -q -o {name}")).status, Some(1));
        let map = image::load_from_memory(&folder.read(name)).unwrap().into_rgb8();
        assert_eq!(map.dimensions(), (4, 3));
        let inferno = |step: usize| colorous::INFERNO.eval_rational(step, 256).as_array();
        for (x, y, pixel) in map.enumerate_pixels() {
            let step = match (x, y) {
                (0, 2) => 255,
                (2, 1) => 51,
                (3, 0) => 77,
                _ => 0,
            };
            assert_eq!(pixel.0, inferno(step), "{x},{y}");
        }
    }
    folder.done("compare a a -q -o same.png");
    let same = image::load_from_memory(&folder.read("same.png")).unwrap().into_rgb8();
    assert!(same.pixels().all(|pixel| pixel.0 == [0, 0, 4]));
}

#[test]
fn wrong_usage_is_reported_with_status_2_and_changes_no_picture() {
    let folder = pair(&png(&gray()), &png(&gray()));
    for (words, says) in [
        ("compare", "<A>"),
        ("compare a", "<B>"),
        ("compare a b c", "'c'"),
        ("compare a b --limit", "--limit"),
        ("compare a b --limit=-0.1", "0 to 1"),
        ("compare a b --limit 1.5", "0 to 1"),
        ("compare a b --limit nan", "0 to 1"),
        ("compare a b --limit 1/0", "0 to 1"),
        ("compare a b --limit 0/0", "0 to 1"),
        ("compare a b --limit 1/", "0 to 1"),
        ("compare a b --limit-share 2", "0 to 1"),
        ("compare - -", "only one"),
        ("compare a b -o -", "needs a file name"),
        ("compare a b -o map.gif", "map.gif has no known picture extension"),
    ] {
        folder.run(words).failed(2, says);
    }
    folder.write("c.png", png(&gray()));
    folder.run("compare a c.png -o ./c.png").failed(2, "would overwrite");
    assert_eq!(folder.read("c.png"), png(&gray()));
    folder.run("compare a b -o missing/map.png").failed(74, "cannot write missing/map.png");
    assert_eq!(folder.names(), ["a", "b", "c.png", "scene.nff"]);
}
