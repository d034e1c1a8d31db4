//! The pictures of the firmware `golden`, rendered on the host, and the table of the cost of accuracy on the
//! chip.
//!
//! ```text
//! accuracy FILE                          writes the linear floats of all pictures, one after the other
//! accuracy --table REPORT PICTURES ...   prints reports and pictures of the firmware as CSV; single precision first
//! ```
//!
//! The host uses the alternatives wherever they exist: all effects, a list without boxes, a frame in memory,
//! no cached corners. None of them may change a bit.

use std::error::Error;
use std::ffi::OsStr;
use std::path::PathBuf;

use strahl_core::accel::List;
use strahl_core::image::{
    AdaptiveSampler, ContrastThreshold, Framebuffer, RegularSampler, Sampler, StochasticSampler, Subdivision,
    UncachedCorners,
};
use strahl_core::scene::Effects;
use strahl_core::{
    AllEffects, Camera, CenterSampler, Limits, Rgb, Scene, Tile, Tracer, Worker, World, render,
};
use strahl_device::accuracy::{AccuracyRun, FirmwareSampler, RUNS};
use strahl_device::draw;
use strahl_device::scene::{GoldenEffects, ITEMS, LEVELS, SIZE, VIEW, parts};

type ExampleError = Box<dyn Error>;

/// Settings of the reference picture for errors: many levels, no cutoff, many rays.
const REFERENCE: AccuracyRun =
    AccuracyRun { limits: Limits { levels: 16, cutoff: 0.0 }, sampling: FirmwareSampler::Regular(16) };

fn main() -> Result<(), ExampleError> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    match arguments.as_slice() {
        [table, files @ ..] if table.as_os_str() == OsStr::new("--table") && !files.is_empty() => {
            print!("{}", csv(files)?);
            Ok(())
        }
        [file] => {
            let mut bytes = Vec::new();
            for run in &RUNS {
                bytes.extend(picture(run)?.iter().flat_map(|color| draw::bytes(*color)).flatten());
            }
            Ok(std::fs::write(file, bytes)?)
        }
        _ => Err("usage: accuracy FILE | accuracy --table REPORT PICTURES [REPORT PICTURES]".into()),
    }
}

fn picture(run: &AccuracyRun) -> Result<Vec<Rgb>, ExampleError> {
    let invalid = "invalid sampler settings";
    match run.sampling {
        FirmwareSampler::Single => traced(run.limits, &mut CenterSampler),
        FirmwareSampler::Regular(n) => traced(run.limits, &mut RegularSampler::new(n).ok_or(invalid)?),
        FirmwareSampler::Adaptive(depth, threshold) => {
            let contrast = ContrastThreshold::new(threshold).ok_or(invalid)?;
            let subdivision = Subdivision::new(depth, contrast).ok_or(invalid)?;
            traced(run.limits, &mut AdaptiveSampler::new(subdivision, UncachedCorners, &mut []))
        }
        FirmwareSampler::Stochastic(n) => traced(run.limits, &mut StochasticSampler::new(n).ok_or(invalid)?),
    }
}

fn traced(limits: Limits, sampler: &mut impl Sampler) -> Result<Vec<Rgb>, ExampleError> {
    let scene = Scene::new(parts())?;
    assert_eq!(scene.required_effects(), GoldenEffects::SET);
    let world = World::new(scene, List::without_bounds(ITEMS as u32));
    const { assert!(LEVELS <= 16) };
    let tracer = Tracer::<_, AllEffects, 16>::new(&world, Camera::new(&VIEW, SIZE)?, limits)?;
    let tile = Tile::full(SIZE);
    let mut colors = vec![Rgb::BLACK; tile.len()];
    let mut frame = Framebuffer::new(tile, &mut colors).ok_or("the frame has another size")?;
    let Ok(()) = render(&mut tracer.with_worker(&mut Worker::new(())), sampler, tile.pixels(), &mut frame);
    Ok(colors)
}

/// The table, from pairs of a firmware's report and pictures.
fn csv(files: &[PathBuf]) -> Result<String, ExampleError> {
    let reference = picture(&REFERENCE)?;
    let mut table = "scene,width,height,precision,levels,cutoff,sampler,instructions,rays,rmse\n".to_owned();
    for (pair, precision) in files.chunks(2).zip(["single", "double"]) {
        let [report, pictures] = pair else { return Err("a report without pictures".into()) };
        let (report, pictures) = (std::fs::read_to_string(report)?, std::fs::read(pictures)?);
        let size = reference.len() * size_of::<draw::PixelBytes>();
        let draw_result = pictures.chunks_exact(size);
        let runs: Vec<&str> = report.lines().filter(|line| line.starts_with("run ")).collect();
        if runs.len() != RUNS.len() || pictures.len() != RUNS.len() * size {
            return Err("the pictures do not match the runs".into());
        }
        for (line, draw_result) in runs.into_iter().zip(draw_result) {
            let words: Vec<&str> = line.split(' ').collect();
            let [_, _, levels, cutoff, sampler, instructions, rays] = words[..] else {
                return Err(format!("not a line of a run: {line}").into());
            };
            let (width, height) = (SIZE.width(), SIZE.height());
            let rmse = rmse(draw_result, &reference);
            table += &format!(
                "golden,{width},{height},{precision},{levels},{cutoff},{sampler},{instructions},{rays},{rmse:.6}\n"
            );
        }
    }
    Ok(table)
}

/// Root mean square error of the sRGB-encoded channels, in `[0, 1]`, as in `strahl compare`.
fn rmse(draw_result: &[u8], reference: &[Rgb]) -> f64 {
    let channels = draw_result.as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes));
    let expected = reference.iter().flat_map(|color| [color.r, color.g, color.b]);
    let squares = channels.zip(expected).map(|(a, b)| {
        let error = encoded(a) - encoded(b);
        error * error
    });
    (squares.sum::<f64>() / (3 * reference.len()) as f64).sqrt()
}

/// The sRGB encoding of a channel (IEC 61966-2-1).
fn encoded(channel: f32) -> f64 {
    let x = f64::from(channel).clamp(0.0, 1.0);
    if x > 0.003_130_8 { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 } else { 12.92 * x }
}
