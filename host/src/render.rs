//! The command `render`: from scene file to picture file.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use strahl_core::{Aabb, Camera, Limits, List, Size, groups_of};

use crate::args::{RenderArgs, StatsForm};
use crate::choose::{self, NotTraced, Wanted};
use crate::failure::Failure;
use crate::load::load;
use crate::output::Output;
use crate::picture::{Format, Picture};
use crate::signals::Signals;
use crate::stats::{AcceleratorStats, Seconds, Stats};
use crate::stock::single::{self, Stock};
use crate::workers::Cut;

/// Of scenes that name no size.
const DEFAULT_SIZE: (u32, u32) = (640, 480);

/// Renders one scene.
pub fn run(args: &RenderArgs) -> Result<(), Failure> {
    let signals = Signals::listen()
        .map_err(|error| Failure::Usage(format!("cannot listen for signals: {error}")))?;
    let report = report(args)?;
    let path = args.output.clone().unwrap_or_else(|| beside(&args.scene));
    let format = Format::of(&path)?;
    let mut seconds = Seconds::default();

    let clock = Instant::now();
    let description = load(&args.scene)?;
    for warning in &description.warnings {
        if !args.quiet {
            eprintln!("strahl: {}: warning: {warning}", args.scene.display());
        }
    }
    seconds.load = clock.elapsed().as_secs_f64();

    // Both before the work, so that nothing is traced that cannot be kept.
    let output = Output::prepare(&path)?;
    let report = report.map(|(form, path)| Ok((form, Output::prepare(&path)?))).transpose()?;

    let clock = Instant::now();
    let wrong = |reason: String| Failure::Input { path: args.scene.clone(), line: None, reason };
    let stock = Stock::new(&description);
    let scene = stock.scene().map_err(|error| wrong(error.to_string()))?;
    let default = || Size::new(DEFAULT_SIZE.0, DEFAULT_SIZE.1);
    let size = args.size.or(description.size).or_else(default).ok_or_else(|| wrong("no size".into()))?;
    let camera = Camera::new(&single::view(&description.view), size).map_err(|fault| wrong(fault.to_string()))?;
    let boxes: Vec<Aabb> = scene.parts().geometry.all_bounds().collect();
    let mut groups = vec![Aabb::EMPTY; groups_of(boxes.len())];
    let list = List::boxed(&boxes, &mut groups).map_err(|error| wrong(error.to_string()))?;
    seconds.build = clock.elapsed().as_secs_f64();

    let wanted = Wanted {
        size,
        limits: Limits { levels: args.levels, cutoff: args.cutoff.unwrap_or(Limits::DEFAULT.cutoff) },
        sampling: args.sampler,
        cut: Cut::threads(args.threads.unwrap_or(0)),
        counted: report.is_some(),
    };
    let (clock, cpu) = (Instant::now(), cpu_time());
    let traced = choose::trace(scene, list, camera, &wanted, &signals).map_err(|error| match error {
        NotTraced::Tracer(error) => wrong(error.to_string()),
        NotTraced::Stopped(stop) => Failure::Stopped(stop),
    })?;
    seconds.trace = clock.elapsed().as_secs_f64();
    seconds.trace_cpu = (cpu_time() - cpu).as_secs_f64();

    let clock = Instant::now();
    let picture = Picture { size, colors: traced.colors };
    let file = format.encode(&picture).map_err(|error| Failure::Unwritable {
        path: Some(path.clone()),
        error: std::io::Error::other(error),
    })?;
    signals.check().map_err(Failure::Stopped)?;
    output.commit(&file)?;
    seconds.write = clock.elapsed().as_secs_f64();

    if let (Some((form, output)), Some(counters)) = (report, traced.counters) {
        let accelerator = AcceleratorStats {
            kind: "list",
            bytes: list.bytes(),
            regions: groups_of(boxes.len()),
            mailbox_skips: 0,
        };
        let digest = picture.digest().to_hex().to_string();
        let mut stats = Stats::new(&description, &scene, size, &counters, accelerator, digest);
        stats.seconds = seconds;
        let text = match form {
            StatsForm::Json => stats.to_json(),
            StatsForm::Text => stats.to_text(),
        };
        output.commit(text.as_bytes())?;
    }
    if !args.quiet {
        let (w, h) = (size.width(), size.height());
        eprintln!("strahl: {}: {w} x {h} pixels in {:.2} s", path.display(), seconds.trace);
    }
    Ok(())
}

/// The scene's name with .png, in the current folder.
fn beside(scene: &std::path::Path) -> PathBuf {
    let mut name = PathBuf::from(scene.file_stem().unwrap_or(std::ffi::OsStr::new("picture")));
    name.as_mut_os_string().push(".png");
    name
}

/// Which report is wanted, and where it goes.
fn report(args: &RenderArgs) -> Result<Option<(StatsForm, PathBuf)>, Failure> {
    let stdout = PathBuf::from("-");
    let form = match (args.stats, &args.stats_file) {
        (None, None) => return Ok(None),
        (form, _) => form.unwrap_or(StatsForm::Json),
    };
    let place = args.stats_file.clone().unwrap_or(stdout.clone());
    if place == stdout && args.output.as_ref() == Some(&stdout) {
        return Err(Failure::Usage(
            "the picture goes to the standard output, so the report needs a --stats-file".into(),
        ));
    }
    Ok(Some((form, place)))
}

/// The processor time that this process has used on all threads.
#[cfg(unix)]
fn cpu_time() -> Duration {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(now.tv_sec.unsigned_abs(), now.tv_nsec.unsigned_abs() as u32)
}

/// Not known here.
#[cfg(not(unix))]
fn cpu_time() -> Duration {
    Duration::ZERO
}
