//! The quality of the samplers at equal cost, as the tables of `tests/reports/quality.md`:
//!
//! ```text
//! cargo run --profile test -p strahl-tests --example quality > tests/reports/quality.md
//! ```
//!
//! Each of four scenes is traced with about 16 camera rays per pixel by every sampler, and compared with a
//! reference of 4096 rays per pixel with another seed. The exit status is 1 if stochastic supersampling has a
//! larger error than regular supersampling on any of them, if adaptive supersampling has one on the scene of
//! edges, or if pixel-selected tracing does not save half of the rays.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use strahl_core::image::{Pixel, Sampler};
use strahl_core::math::SobolSequence;
use strahl_core::scene::CameraSample;
use strahl_core::tally::RayKind;
use strahl_core::trace::{PixelSample, RayTracer};
use strahl_core::{
    AllEffects, Camera, ListWithoutBounds, Resolution, Rgb, Tile, Tracer, Worker, World, render,
};
use strahl_engine::{NoProgress, RenderOptions};
use strahl_picture::PixelValues;
use strahl_picture::difference::Pair;
use strahl_settings::{ContrastSettings, SamplerSettings, SelectionSettings, Settings};

/// The scenes, and what is hard about them.
const SCENES: [(&str, &str); 4] = [
    ("zoneplate", "texture finer than pixels"),
    ("penumbra", "sphere and rectangle lights"),
    ("lens", "depth of field"),
    ("stained", "edges, colored shadows"),
];

/// Rays per pixel.
const RAYS: u32 = 16;
/// Rays per pixel of the reference.
const SAMPLES: u32 = 4096;
/// Seeds of the measured pictures; the reference has another one.
const SEEDS: [u32; 4] = [0, 2, 3, 4];
/// Maximum depth of adaptive subdivision.
const DEPTH: u8 = 4;

/// Rays per pixel of a picture, and its error.
struct QualityResult {
    rays: f64,
    rmse: f64,
    ssim: f64,
}

impl QualityResult {
    /// The mean over several seeds.
    fn mean(
        one: impl Fn(u32) -> Result<QualityResult, Box<dyn Error>>,
    ) -> Result<QualityResult, Box<dyn Error>> {
        let mut mean = QualityResult { rays: 0.0, rmse: 0.0, ssim: 0.0 };
        for seed in SEEDS {
            let it = one(seed)?;
            let part = 1.0 / SEEDS.len() as f64;
            mean.rays += part * it.rays;
            mean.rmse += part * it.rmse * it.rmse;
            mean.ssim += part * it.ssim;
        }
        Ok(QualityResult { rmse: mean.rmse.sqrt(), ..mean })
    }
}

/// Jittered sampling of n times n cells, for comparison with the low-discrepancy sequence.
struct JitteredSampler {
    n: u32,
    seed: u32,
}

impl Sampler for JitteredSampler {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let n = self.n;
        let mut sum = Rgb::BLACK;
        for index in 0..n * n {
            // Independent random numbers for each cell.
            let random = SobolSequence::new(pixel.x, pixel.y, self.seed, index + 1)
                .sample_2d(strahl_core::math::Dimension::PIXEL);
            let point = strahl_core::scene::FilmPoint {
                x: pixel.x as f32 + ((index % n) as f32 + random[0]) / n as f32,
                y: pixel.y as f32 + ((index / n) as f32 + random[1]) / n as f32,
            };
            sum += tracer
                .trace(CameraSample {
                    point,
                    sequence: SobolSequence::new(pixel.x, pixel.y, index, self.seed),
                })
                .color;
        }
        PixelSample { color: sum * (1.0 / (n * n) as f32), ..PixelSample::BLACK }
    }
}

struct QualityScene {
    description: strahl_scene::description::LoadedScene,
    size: Resolution,
    reference: Vec<Rgb>,
}

impl QualityScene {
    fn of(name: &str) -> Result<Self, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
        let description = strahl_scene::load(&path)?;
        let whole = description.settings.size.ok_or("the scene has no size")?;
        // An eighth of the picture's sides.
        let size = Resolution::new(whole.width() / 8, whole.height() / 8).ok_or("too small")?;
        let mut scene = QualityScene { description, size, reference: Vec::new() };
        let settings = Settings { seed: 1, ..scene.settings(SamplerSettings::stochastic(SAMPLES)) };
        scene.reference = scene.traced(&settings)?.0;
        Ok(scene)
    }

    fn settings(&self, sampler: SamplerSettings) -> Settings {
        let default = Settings::default();
        let levels = self.description.settings.levels.unwrap_or(default.levels);
        Settings { size: self.size, sampler, levels, ..default }
    }

    fn traced(&self, settings: &Settings) -> Result<(Vec<Rgb>, f64), Box<dyn Error>> {
        let options = RenderOptions::COUNT_TESTS;
        let frame = strahl_session::render(&self.description, settings, &options, &NoProgress)?;
        let rays = frame.counters.rays[RayKind::Camera];
        let pixels = u64::from(self.size.width()) * u64::from(self.size.height());
        Ok((frame.picture.colors, rays as f64 / pixels as f64))
    }

    /// Error of colors, sRGB-encoded, compared with the reference.
    fn measured(&self, (colors, rays): (Vec<Rgb>, f64)) -> QualityResult {
        let pair = Pair::of(PixelValues::Linear(colors), PixelValues::Linear(self.reference.clone()));
        let squares: f64 = match &pair {
            Pair::Floats { encoded: [a, b], .. } => {
                let differences = a.iter().flatten().zip(b.iter().flatten());
                let squares = differences.map(|(a, b)| f64::from((a - b) * (a - b)));
                squares.sum::<f64>() / (3.0 * a.len() as f64)
            }
            _ => f64::NAN,
        };
        QualityResult { rays, rmse: squares.sqrt(), ssim: pair.ssim(self.size) }
    }

    fn by(&self, sampling: SamplerSettings) -> Result<QualityResult, Box<dyn Error>> {
        QualityResult::mean(|seed| {
            Ok(self.measured(self.traced(&Settings { seed, ..self.settings(sampling) })?))
        })
    }

    /// Adaptive sampling with the threshold that takes the most rays up to [`RAYS`].
    fn adaptive(&self) -> Result<(f32, QualityResult), Box<dyn Error>> {
        let mut best = None;
        let mut threshold = 0.5;
        for _ in 0..14 {
            threshold *= 0.7;
            let contrast = ContrastSettings { threshold, items: false };
            let measured = self.by(SamplerSettings::Adaptive { max_depth: DEPTH, contrast })?;
            let is_too_much = measured.rays > f64::from(RAYS);
            // If all thresholds take too many, the coarsest is used.
            if best.is_none() || !is_too_much {
                best = Some((threshold, measured));
            }
            if is_too_much {
                break;
            }
        }
        best.ok_or_else(|| "no threshold was tried".into())
    }

    fn jittered(&self) -> Result<QualityResult, Box<dyn Error>> {
        let tables = strahl_session::tables::single::scene_tables(&self.description);
        let scene = tables.scene()?;
        let items = scene.descriptor().geometry.shapes.len() as u32;
        let world = World::new(scene, ListWithoutBounds(items));
        let camera = Camera::new(
            &strahl_session::tables::single::camera_descriptor(&self.description.camera),
            self.size,
        )?;
        let limits = self.settings(SamplerSettings::Single).limits();
        let tracer = Tracer::<_, AllEffects, 64>::new(&world, camera, limits)?;
        QualityResult::mean(|seed| {
            let mut colors = Vec::new();
            let mut sink = |_: Pixel, color: Rgb| colors.push(color);
            let mut sampler = JitteredSampler { n: RAYS.isqrt(), seed };
            let pixels = Tile::full(self.size).pixels();
            let Ok(()) =
                render(&mut tracer.with_worker(&mut Worker::new(())), &mut sampler, pixels, &mut sink);
            Ok(self.measured((colors, f64::from(RAYS))))
        })
    }
}

fn row(name: &str, measured: &QualityResult) {
    println!("| {name} | {:.2} | {:.4} | {:.4} |", measured.rays, measured.rmse, measured.ssim);
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    println!("# Quality of the samplers at equal cost\n");
    println!(
        "Generated by\n\n    cargo run --profile test -p strahl-tests --example quality > tests/reports/quality.md\n"
    );
    println!(
        "Camera rays per pixel, root mean square error of sRGB-encoded values (0 to 1) and structural similarity\n\
         (1 is equal; both as in `strahl compare`), compared with {SAMPLES} rays per pixel. Means over {1} pictures\n\
         with other seeds than the reference. Adaptive is `adaptive:{DEPTH}:T` with the threshold that takes the\n\
         most rays up to {RAYS}; the zone plate, which has an edge in every pixel, takes more with any threshold, and\n\
         shows the coarsest. Jittered is not a sampler of strahl: it has random points in {0} x {0} cells, where\n\
         stochastic has a scrambled low-discrepancy sequence. Pictures have an eighth of their usual sides.",
        RAYS.isqrt(),
        SEEDS.len()
    );
    let mut passed = true;
    for (name, what) in SCENES {
        let scene = QualityScene::of(name)?;
        println!("\n## `{name}.toml`: {what}\n");
        println!("| sampler | rays | RMSE | SSIM |\n|---|---|---|---|");
        let regular = scene.by(SamplerSettings::Regular(RAYS.isqrt() as u16))?;
        row("`single`", &scene.by(SamplerSettings::Single)?);
        row("`regular:4`", &regular);
        let (threshold, adaptive) = scene.adaptive()?;
        row(&format!("`adaptive:{DEPTH}:{threshold:.3}`"), &adaptive);
        row("jittered", &scene.jittered()?);
        let stochastic = scene.by(SamplerSettings::stochastic(RAYS))?;
        row("`stochastic:16`", &stochastic);
        row("`stochastic:4..64:0.9:0.06`", &scene.by("stochastic:4..64:0.9:0.06".parse()?)?);
        passed &= stochastic.rmse < regular.rmse;
        passed &= name != "stained" || adaptive.rmse < regular.rmse;
    }

    println!("\n## Pixel-selected tracing\n");
    println!(
        "Rays per pixel and error compared with the same picture with every pixel traced (`single`), 640 x 400.\n\n\
         | scene | `--select` | rays | RMSE | SSIM |\n|---|---|---|---|---|"
    );
    for (name, step, threshold) in [("stained", 4, 0.03), ("stained", 8, 0.03), ("stained", 8, 0.1)] {
        let mut scene = QualityScene::of_all_pixels(name)?;
        let select = Some(SelectionSettings { step, contrast: ContrastSettings { threshold, items: true } });
        let settings = Settings { select, ..scene.settings(SamplerSettings::Single) };
        scene.reference = scene.traced(&scene.settings(SamplerSettings::Single))?.0;
        let it = scene.measured(scene.traced(&settings)?);
        println!(
            "| `{name}.toml` | `{step}:{threshold}:items` | {:.2} | {:.4} | {:.4} |",
            it.rays, it.rmse, it.ssim
        );
        passed &= it.rays < 0.5;
    }
    Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl QualityScene {
    /// A scene at its own size, without a reference.
    fn of_all_pixels(name: &str) -> Result<Self, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
        let description = strahl_scene::load(&path)?;
        let size = description.settings.size.ok_or("the scene has no size")?;
        Ok(QualityScene { description, size, reference: Vec::new() })
    }
}
