//! The quality of the samplers at equal cost, as the tables of `tests/reports/quality.md`:
//!
//! ```text
//! cargo run --profile test -p strahl-tests --example quality > tests/reports/quality.md
//! ```
//!
//! Each of four scenes is traced with some 16 camera rays in each pixel, by every sampler, and
//! held against a reference of 4096 rays in each pixel, of another seed. The exit status is 1
//! when stochastic supersampling does not beat the regular one on each of them, when adaptive does
//! not beat it on the scene of edges, or when pixel-selected tracing does not save half of the rays.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use strahl_core::image::{Pixel, Sampler};
use strahl_core::math::SobolSequence;
use strahl_core::scene::CameraSample;
use strahl_core::tally::RayKind;
use strahl_core::trace::{PixelSample, RayTracer};
use strahl_core::{AllEffects, BareList, Camera, Resolution, Rgb, Tile, Tracer, Worker, World, render};
use strahl_engine::{NoProgress, RenderOptions};
use strahl_picture::PixelValues;
use strahl_picture::difference::Pair;
use strahl_settings::{ContrastSettings, SamplerSettings, SelectionSettings, Settings};

/// The scenes, and what is hard in them.
const SCENES: [(&str, &str); 4] = [
    ("zoneplate", "texture finer than pixels"),
    ("penumbra", "round and square lights"),
    ("lens", "depth of field"),
    ("stained", "edges, coloured shadows"),
];

/// Rays in a pixel.
const RAYS: u32 = 16;
/// Of the reference.
const MANY: u32 = 4096;
/// Of the pictures that are held against the reference, whose seed is none of them.
const SEEDS: [u32; 4] = [0, 2, 3, 4];
/// How often a pixel may be quartered.
const DEPTH: u8 = 4;

/// What a picture took, and how far it is from the reference.
struct Measured {
    rays: f64,
    rmse: f64,
    ssim: f64,
}

impl Measured {
    /// The mean of pictures of several seeds, of which one could have had luck.
    fn mean(one: impl Fn(u32) -> Result<Measured, Box<dyn Error>>) -> Result<Measured, Box<dyn Error>> {
        let mut mean = Measured { rays: 0.0, rmse: 0.0, ssim: 0.0 };
        for seed in SEEDS {
            let it = one(seed)?;
            let part = 1.0 / SEEDS.len() as f64;
            mean.rays += part * it.rays;
            mean.rmse += part * it.rmse * it.rmse;
            mean.ssim += part * it.ssim;
        }
        Ok(Measured { rmse: mean.rmse.sqrt(), ..mean })
    }
}

/// n times n cells with a ray through a random place of each: what the sequence is held against.
struct Jittered {
    n: u32,
    seed: u32,
}

impl Sampler for Jittered {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        let n = self.n;
        let mut sum = Rgb::BLACK;
        for index in 0..n * n {
            // A place of its own for each cell, so that they have nothing to do with each other.
            let chance = SobolSequence::new(pixel.x, pixel.y, self.seed, index + 1)
                .sample_2d(strahl_core::math::Dimension::PIXEL);
            let place = strahl_core::scene::FilmPoint {
                x: pixel.x as f32 + ((index % n) as f32 + chance[0]) / n as f32,
                y: pixel.y as f32 + ((index / n) as f32 + chance[1]) / n as f32,
            };
            sum += tracer
                .trace(CameraSample {
                    point: place,
                    sequence: SobolSequence::new(pixel.x, pixel.y, index, self.seed),
                })
                .color;
        }
        PixelSample { color: sum * (1.0 / (n * n) as f32), ..PixelSample::BLACK }
    }
}

struct Scene {
    description: strahl_scene::description::LoadedScene,
    size: Resolution,
    reference: Vec<Rgb>,
}

impl Scene {
    fn of(name: &str) -> Result<Self, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
        let description = strahl_scene::load(&path)?;
        let whole = description.settings.size.ok_or("the scene has no size")?;
        // A tenth of the picture's side and more.
        let size = Resolution::new(whole.width() / 8, whole.height() / 8).ok_or("too small")?;
        let mut scene = Scene { description, size, reference: Vec::new() };
        let settings = Settings { seed: 1, ..scene.settings(SamplerSettings::stochastic(MANY)) };
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

    /// Holds colours against the reference, as they are seen.
    fn measured(&self, (colors, rays): (Vec<Rgb>, f64)) -> Measured {
        let pair = Pair::of(PixelValues::Linear(colors), PixelValues::Linear(self.reference.clone()));
        let squares: f64 = match &pair {
            Pair::Floats { encoded: [a, b], .. } => {
                let differences = a.iter().flatten().zip(b.iter().flatten());
                let squares = differences.map(|(a, b)| f64::from((a - b) * (a - b)));
                squares.sum::<f64>() / (3.0 * a.len() as f64)
            }
            _ => f64::NAN,
        };
        Measured { rays, rmse: squares.sqrt(), ssim: pair.ssim(self.size) }
    }

    fn by(&self, sampling: SamplerSettings) -> Result<Measured, Box<dyn Error>> {
        Measured::mean(|seed| Ok(self.measured(self.traced(&Settings { seed, ..self.settings(sampling) })?)))
    }

    /// With the threshold that takes the most rays, but no more than the others.
    fn adaptive(&self) -> Result<(f32, Measured), Box<dyn Error>> {
        let mut best = None;
        let mut threshold = 0.5;
        for _ in 0..14 {
            threshold *= 0.7;
            let agreement = ContrastSettings { threshold, items: false };
            let measured = self.by(SamplerSettings::Adaptive { max_depth: DEPTH, contrast: agreement })?;
            let is_too_much = measured.rays > f64::from(RAYS);
            // Where each takes too many, the coarsest stands for them.
            if best.is_none() || !is_too_much {
                best = Some((threshold, measured));
            }
            if is_too_much {
                break;
            }
        }
        best.ok_or_else(|| "no threshold was tried".into())
    }

    fn jittered(&self) -> Result<Measured, Box<dyn Error>> {
        let stock = strahl_session::tables::single::scene_tables(&self.description);
        let scene = stock.scene()?;
        let items = scene.descriptor().geometry.shapes.len() as u32;
        let world = World::new(scene, BareList(items));
        let camera = Camera::new(&strahl_session::tables::single::view(&self.description.camera), self.size)?;
        let limits = self.settings(SamplerSettings::Single).limits();
        let tracer = Tracer::<_, AllEffects, 64>::new(&world, camera, limits)?;
        Measured::mean(|seed| {
            let mut colors = Vec::new();
            let mut sink = |_: Pixel, color: Rgb| colors.push(color);
            let mut sampler = Jittered { n: RAYS.isqrt(), seed };
            let pixels = Tile::whole(self.size).pixels();
            let Ok(()) =
                render(&mut tracer.with_worker(&mut Worker::new(())), &mut sampler, pixels, &mut sink);
            Ok(self.measured((colors, f64::from(RAYS))))
        })
    }
}

fn row(name: &str, measured: &Measured) {
    println!("| {name} | {:.2} | {:.4} | {:.4} |", measured.rays, measured.rmse, measured.ssim);
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    println!("# Quality of the samplers at equal cost\n");
    println!(
        "Made by\n\n    cargo run --profile test -p strahl-tests --example quality > tests/reports/quality.md\n"
    );
    println!(
        "Camera rays in a pixel, the root of the mean square error of sRGB-encoded values (0 to 1), and the\n\
         structural similarity (1 is equal; `strahl compare` has both), against {MANY} rays in each pixel.\n\
         The means of {1} pictures of other seeds than the reference's, so that none has luck. Adaptive is\n\
         `adaptive:{DEPTH}:T` with the threshold that takes the most rays up to {RAYS}; the zone plate, which has an\n\
         edge everywhere, takes more with any, and shows the coarsest. Jittered is no\n\
         sampler of strahl: it has random places in {0} x {0} cells, where stochastic has a scrambled\n\
         low-discrepancy sequence. Pictures have an eighth of their usual sides.",
        RAYS.isqrt(),
        SEEDS.len()
    );
    let mut holds = true;
    for (name, what) in SCENES {
        let scene = Scene::of(name)?;
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
        holds &= stochastic.rmse < regular.rmse;
        holds &= name != "stained" || adaptive.rmse < regular.rmse;
    }

    println!("\n## Pixel-selected tracing\n");
    println!(
        "Rays in a pixel and error against the same picture with every pixel traced (`single`), 640 x 400.\n\n\
         | scene | `--select` | rays | RMSE | SSIM |\n|---|---|---|---|---|"
    );
    for (name, step, threshold) in [("stained", 4, 0.03), ("stained", 8, 0.03), ("stained", 8, 0.1)] {
        let mut scene = Scene::of_all_pixels(name)?;
        let select = Some(SelectionSettings { step, contrast: ContrastSettings { threshold, items: true } });
        let settings = Settings { select, ..scene.settings(SamplerSettings::Single) };
        scene.reference = scene.traced(&scene.settings(SamplerSettings::Single))?.0;
        let it = scene.measured(scene.traced(&settings)?);
        println!(
            "| `{name}.toml` | `{step}:{threshold}:items` | {:.2} | {:.4} | {:.4} |",
            it.rays, it.rmse, it.ssim
        );
        holds &= it.rays < 0.5;
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl Scene {
    /// At its own size, and still without a reference.
    fn of_all_pixels(name: &str) -> Result<Self, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
        let description = strahl_scene::load(&path)?;
        let size = description.settings.size.ok_or("the scene has no size")?;
        Ok(Scene { description, size, reference: Vec::new() })
    }
}
