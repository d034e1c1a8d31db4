//! Golden pictures: small renderings of the project's scenes must not change, bit for bit.
//!
//! Each scene is rendered with every accelerator, mailbox, heap and stack.
//!
//! For each picture `tests/golden/` has the PNG, and `tests/golden/digests` the BLAKE3 digest of its linear
//! floats. Accept an intended change of a picture with
//!
//! ```text
//! STRAHL_ACCEPT=1 cargo test -p strahl-tests --test picture
//! ```
//!
//! and look at the difference in git. If a picture differs, the new picture and the difference (brighter is
//! more different) are written to `target/golden/`, and the failure message names them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use strahl_core::accel::List;
use strahl_core::image::Framebuffer;
use strahl_core::scene::Effects;
use strahl_core::{
    AllEffects, Camera, CenterSampler, Resolution, Rgb, Scene, Tile, Tracer, Worker, World, render,
};
use strahl_device::scene as golden_scene;
use strahl_engine::{NoProgress, RenderOptions};
use strahl_picture::{Picture, PictureFormat};
use strahl_settings::{AccelSettings, Bounds, ContrastSettings, SamplerSettings, Settings};

/// The scenes, and the sizes and samplers of their golden pictures.
const SCENES: [(&str, u32, u32, SamplerSettings); 19] = [
    ("classic.toml", 96, 72, SamplerSettings::Regular(2)),
    ("first.toml", 96, 72, SamplerSettings::Regular(2)),
    ("fjord.toml", 100, 60, SamplerSettings::Single),
    ("glass.toml", 96, 72, SamplerSettings::Single),
    ("gloss.toml", 96, 54, SamplerSettings::stochastic(8)),
    ("knot.toml", 80, 60, SamplerSettings::Single),
    ("lens.toml", 96, 54, SamplerSettings::stochastic(8)),
    ("marbles.toml", 96, 72, SamplerSettings::Single),
    ("motion.toml", 96, 54, SamplerSettings::stochastic(8)),
    ("paper.toml", 96, 72, SamplerSettings::Single),
    ("penumbra.toml", 96, 60, SamplerSettings::stochastic(8)),
    ("pyramid.toml", 80, 60, SamplerSettings::Single),
    ("rotunda.nff", 160, 100, SamplerSettings::Single),
    ("shapes.toml", 96, 72, SamplerSettings::Single),
    ("sphereflake.toml", 96, 72, SamplerSettings::Single),
    ("stage.toml", 96, 72, SamplerSettings::Regular(2)),
    (
        "stained.toml",
        96,
        60,
        SamplerSettings::Adaptive {
            max_depth: 2,
            contrast: ContrastSettings { threshold: 0.05, items: false },
        },
    ),
    ("still-life.toml", 80, 60, SamplerSettings::Single),
    ("zoneplate.toml", 64, 64, SamplerSettings::stochastic(8)),
];

#[test]
fn every_scene_has_its_golden_picture() {
    let differences: Vec<String> = SCENES
        .iter()
        .filter_map(|(file, width, height, sampling)| {
            let picture = scene_file(file, *width, *height, None, *sampling);
            golden(stem(file), &picture).err()
        })
        .collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

#[test]
fn every_scene_is_tested_and_has_a_gallery_picture() {
    let mut files: Vec<String> = fs::read_dir(root().join("scenes"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".toml") || name.ends_with(".nff"))
        .collect();
    files.sort();
    assert_eq!(files, SCENES.map(|(file, ..)| file), "the files in scenes/, and the scenes of this test");
    for (file, ..) in SCENES {
        let picture = root().join("scenes/gallery").join(stem(file)).with_extension("png");
        let bytes =
            fs::metadata(&picture).unwrap_or_else(|error| panic!("{}: {error}", picture.display())).len();
        assert!(bytes < 250_000, "{} has {bytes} bytes", picture.display());
    }
}

#[test]
fn the_rotunda_without_secondary_rays_has_its_golden_picture() {
    let picture = scene_file("rotunda.nff", 96, 60, Some(1), SamplerSettings::CORNERS);
    golden("rotunda-level-1", &picture).unwrap();
}

#[test]
fn the_scene_of_the_firmware_has_its_golden_picture() {
    let picture = constants::<golden_scene::GoldenEffects>();
    golden("firmware", &picture).unwrap();
    assert_eq!(constants::<AllEffects>(), picture, "the smallest effect set and all effects");
}

/// The name of a file without its extension.
fn stem(file: &str) -> &str {
    file.split('.').next().unwrap()
}

/// Largest number of objects for a list without bounds.
const MAX_UNBOUNDED: usize = 1000;

/// Renders a scene of the folder `scenes` with its own levels and cutoff. Asserts that every accelerator
/// gives the same picture, at a quarter of the size.
fn scene_file(name: &str, width: u32, height: u32, levels: Option<u8>, sampling: SamplerSettings) -> Picture {
    let path = root().join("scenes").join(name);
    let description = strahl_scene::load(&path).unwrap();
    let (scene, default) = (&description.settings, Settings::default());
    let settings = Settings {
        levels: levels.or(scene.levels).unwrap_or(default.levels),
        cutoff: scene.cutoff.unwrap_or(default.cutoff),
        sampler: sampling,
        ..default
    };
    let rendered = |width, height, accel| {
        let settings = Settings { size: Resolution::new(width, height).unwrap(), ..settings.clone() };
        let settings = settings.with_acceleration(accel);
        strahl_session::render(&description, &settings, &RenderOptions::default(), &NoProgress).unwrap()
    };
    let quarter = |accel| rendered(width / 4, height / 4, accel);
    let output = quarter(AccelSettings::DEFAULT);
    let is_affordable =
        |it: &AccelSettings| it.bounds != Bounds::None || output.scene.objects <= MAX_UNBOUNDED;
    for accel in AccelSettings::all_variants().into_iter().filter(is_affordable) {
        // Without `assert_eq`, which would print both pictures.
        assert!(quarter(accel).picture == output.picture, "{name} by {accel:?} differs");
    }
    rendered(width, height, AccelSettings::DEFAULT).picture
}

/// Renders the constant scene of the firmware.
fn constants<E: Effects>() -> Picture {
    let size = golden_scene::SIZE;
    let world = World::new(
        Scene::new(golden_scene::parts()).unwrap(),
        List::without_bounds(golden_scene::ITEMS as u32),
    );
    let camera = Camera::new(&golden_scene::VIEW, size).unwrap();
    let tracer = Tracer::<_, E, { golden_scene::LEVELS }>::new(&world, camera, golden_scene::LIMITS).unwrap();
    let tile = Tile::full(size);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Framebuffer::new(tile, &mut colors).unwrap();
    let Ok(()) =
        render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, tile.pixels(), &mut frame);
    Picture { size, colors }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// Compares a picture with the golden one, or accepts it as the golden one.
fn golden(name: &str, picture: &Picture) -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let png = folder.join(name).with_extension("png");
    let digest = picture.digest().to_hex().to_string();
    if std::env::var_os("STRAHL_ACCEPT").is_some() {
        fs::create_dir_all(&folder).unwrap();
        fs::write(&png, PictureFormat::Png.encode(picture).unwrap()).unwrap();
        accept(&folder.join("digests"), name, &digest);
        return Ok(());
    }

    let golden = match image::open(&png) {
        Ok(golden) => golden.to_rgb8(),
        Err(error) => return Err(format!("{}: {error}", png.display())),
    };
    let digests = digests(&folder.join("digests"));
    let pixels = picture.to_srgb8();
    let same_pixels = golden.as_raw() == &pixels;
    if digests.get(name) == Some(&digest) && same_pixels {
        return Ok(());
    }
    let output = root().join("target/golden");
    fs::create_dir_all(&output).unwrap();
    let new = output.join(format!("{name}-new.png"));
    fs::write(&new, PictureFormat::Png.encode(picture).unwrap()).unwrap();
    let mut message = format!(
        "{name} is not the golden picture\n  digest of the linear floats: {digest}\n  golden: {:?}\n  8-bit pixels: {}\n  new: {}",
        digests.get(name),
        if same_pixels { "equal" } else { "different" },
        new.display(),
    );
    if golden.dimensions() == (picture.size.width(), picture.size.height()) && !same_pixels {
        let difference = output.join(format!("{name}-difference.png"));
        // A difference of one step must be visible.
        let bytes = golden.as_raw().iter().zip(&pixels).map(|(a, b)| match a.abs_diff(*b) {
            0 => 0,
            steps => steps.saturating_mul(8).saturating_add(63),
        });
        let (w, h) = golden.dimensions();
        image::RgbImage::from_raw(w, h, bytes.collect()).unwrap().save(&difference).unwrap();
        message += &format!("\n  difference: {}", difference.display());
    }
    Err(message)
}

fn digests(path: &Path) -> BTreeMap<String, String> {
    let text = fs::read_to_string(path).unwrap_or_default();
    text.lines().filter_map(|line| line.split_once(' ')).map(|(n, d)| (n.into(), d.into())).collect()
}

/// Stores one digest in the file. Tests run in parallel, so that a lock is needed.
fn accept(path: &Path, name: &str, digest: &str) {
    static LOCK: std::sync::Mutex<()> = std::sync::Mutex::new(());
    let _guard = LOCK.lock().unwrap();
    let mut all = digests(path);
    all.insert(name.into(), digest.into());
    let text: String = all.iter().map(|(name, digest)| format!("{name} {digest}\n")).collect();
    fs::write(path, text).unwrap();
}
