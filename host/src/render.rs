//! The command `render`: from scene file to picture file.

use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use strahl_engine::{CostMap, Mask, Progress, RenderError, RenderOptions};
use strahl_picture::{Picture, PictureFormat};
use strahl_scene::description::LoadedScene;
use strahl_scene::effects::{PlannedEffect, disable, plan};
use strahl_scene::{SourceFiles, load_from};
use strahl_session::RenderOutput;
use strahl_settings::{DEFAULT_SIZE, Resolved, Settings};
use strahl_study::aim;
use strahl_study::aim::search::{ErrorTarget, FixedSettings};
use strahl_study::aim::time::TimeLimit;

use crate::aim_report::AimReport;
use crate::args::{AimArgs, RenderArgs, StatsFormat};
use crate::error::{CommandError, CommandStatus};
use crate::heat_map::{self, CostRegion};
use crate::output::{Output, OutputGuard, print_message, print_stderr, refuse_terminal};
use crate::pixels;
use crate::preview;
use crate::signals::Signals;
use crate::stats::StatsReport;
use crate::summary::{self, summary};
use crate::terminal::TerminalProgress;
use crate::word_wrap::{stderr_width, wrapped};

/// Renders one scene. Returns [`CommandStatus::CheckFailed`] if no settings reach the target error.
pub fn run(args: &RenderArgs, aim: &AimArgs) -> Result<CommandStatus, CommandError> {
    let start = Instant::now();
    refuse_terminal(args.output.as_deref().unwrap_or(Path::new("")), "the picture")?;
    let job = RenderJob { aim: aim.clone(), start, ..RenderJob::new(args)? };
    let progress = job.progress(Signals::register()?);
    let scene = job.load(&SourceFiles::on_disk())?;
    job.render_and_write(&scene, &progress)
}

/// Prints the effective settings of a picture.
pub fn print_settings(args: &RenderArgs) -> Result<(), CommandError> {
    let job = RenderJob::new(args)?;
    let scene = job.load(&SourceFiles::on_disk())?;
    let resolved = resolved(args, &scene)?;
    job.format.check_size(resolved.settings.picture_size())?;
    let text = crate::print_settings::text(args, &resolved, &job.path, &scene.description.setting_lines);
    Output::Stdout.commit(text.as_bytes())
}

/// One picture with its outputs, as the command line specifies them.
pub struct RenderJob<'a> {
    args: &'a RenderArgs,
    aim: AimArgs,
    start: Instant,
    path: PathBuf,
    format: PictureFormat,
    report: Option<(StatsFormat, PathBuf)>,
}

/// The inputs of a render: the scene and the mask, and the time to load them.
pub struct LoadedInputs {
    description: LoadedScene,
    mask: Option<Mask>,
    /// Files that were read or referenced.
    paths: Vec<PathBuf>,
    /// Effects that the scene requires and the command line disables.
    disabled_effects: Vec<PlannedEffect>,
    load_time: Duration,
}

impl<'a> RenderJob<'a> {
    /// The job of a command line.
    pub fn new(args: &'a RenderArgs) -> Result<Self, CommandError> {
        let report = report(args)?;
        let path = args.output.clone().unwrap_or_else(|| default_output(&args.scene));
        let format = PictureFormat::from_path(&path)?;
        Ok(RenderJob { args, aim: AimArgs::default(), start: Instant::now(), path, format, report })
    }

    /// The progress bar, hidden with `--quiet`.
    pub fn progress(&self, signals: Signals) -> TerminalProgress {
        if self.args.quiet {
            TerminalProgress::silent(signals)
        } else {
            TerminalProgress::on_terminal(signals)
        }
    }

    /// Loads the scene and the mask, and prints warnings.
    pub fn load(&self, files: &SourceFiles) -> Result<LoadedInputs, CommandError> {
        let clock = Instant::now();
        let RenderJob { args, .. } = self;
        let mut description =
            load_from(files, &args.scene, args.settings.given.size.unwrap_or(DEFAULT_SIZE))?;
        for warning in description.warnings.iter().filter(|_| !args.quiet) {
            print_message(format_args!("{}: warning: {warning}", args.scene.display()));
        }
        let disabled_effects =
            disable(&mut description, args.settings.given.without.as_deref().unwrap_or_default());
        let mask = args.mask.as_deref().map(|path| load_mask(files, path)).transpose()?;
        let mut paths = files.named_paths();
        paths.extend(args.mask.clone());
        Ok(LoadedInputs { description, mask, paths, disabled_effects, load_time: clock.elapsed() })
    }

    /// Renders the picture and writes it with the statistics, the cost map and the summary.
    pub fn render_and_write(
        &self,
        scene: &LoadedInputs,
        progress: &TerminalProgress,
    ) -> Result<CommandStatus, CommandError> {
        let RenderJob { args, path, format, aim, .. } = self;
        // Outputs are opened before tracing starts.
        let mut guard = OutputGuard::of(&scene.paths);
        let output = guard.prepare(path)?;
        let report = match &self.report {
            Some((form, path)) => Some((form, guard.prepare(path)?)),
            None => None,
        };
        let heat = aim.cost.as_ref().map(|path| HeatMapOutput::prepare(path, &mut guard)).transpose()?;

        let LoadedInputs { description, disabled_effects, load_time: load, .. } = scene;
        let resolved = resolved(args, scene)?;
        let settings = &resolved.settings;
        format.check_size(settings.picture_size())?;
        let cost_map = heat.is_some().then(|| CostMap::new(settings.size));
        let options = RenderOptions {
            mask: scene.mask.as_ref(),
            count_tests: report.is_some(),
            cost_map: cost_map.as_ref(),
            ..RenderOptions::default()
        };
        let (rendered, aim_report) = self.render_picture(description, &resolved, &options, progress)?;
        let clock = Instant::now();
        self.write(&rendered.picture, output, progress)?;
        if let (Some(heat), Some(cost_map)) = (heat, &cost_map) {
            heat.write(&CostRegion::of(cost_map, settings.region_or_all()))?;
        }
        let write = clock.elapsed();

        let mut plan = plan(description);
        plan.extend_from_slice(disabled_effects);
        if let Some((form, output)) = report {
            let mut stats = StatsReport::new(&plan, &rendered);
            stats.aim = aim_report.clone();
            stats.seconds.load = load.as_secs_f64();
            stats.seconds.write = write.as_secs_f64();
            let text = match form {
                StatsFormat::Json => stats.to_json(),
                StatsFormat::Text => stats.to_text(),
            };
            output.commit(text.as_bytes())?;
        }
        let used = aim_report.as_ref().map_or(settings, |report| &report.result.settings);
        if !args.quiet {
            let mut summary = summary(path, &rendered, &plan, used.sampler, *load, write);
            if let Some(report) = &aim_report {
                summary.push_str(&summary::lines(&report.lines()));
            }
            print_stderr(wrapped(&summary, stderr_width(), summary::INDENT));
        }
        Ok(if aim_report.is_none_or(|report| report.result.is_met) {
            CommandStatus::Success
        } else {
            CommandStatus::CheckFailed
        })
    }

    /// Renders the picture: with the resolved settings, or with settings for a target error or a time limit, which a
    /// report describes.
    fn render_picture(
        &self,
        description: &LoadedScene,
        resolved: &Resolved,
        options: &RenderOptions<'_>,
        progress: &TerminalProgress,
    ) -> Result<(RenderOutput, Option<AimReport>), CommandError> {
        let (RenderJob { args, aim, start, format, .. }, settings) = (self, &resolved.settings);
        let result = if let Some(error) = aim.target_error {
            let given = &args.settings.given;
            let fixed = FixedSettings {
                levels: given.levels.is_some(),
                cutoff: given.cutoff.is_some(),
                sampler: given.sampler.is_some(),
                select: given.select.is_some(),
            };
            let goal = ErrorTarget { max_error: error, fixed, verify: aim.verify };
            aim::error::render_to_error(description, settings, options, goal, progress)
        } else if let Some(time) = aim.time_limit {
            let limit = TimeLimit { start: *start, duration: time, format: *format };
            aim::time::render_in_time(description, settings, options, limit, progress)
        } else {
            return Ok((self.render_with(description, settings, options, progress)?, None));
        };
        progress.end();
        let (rendered, result) = result.map_err(|error| self.failure(error))?;
        Ok((rendered, Some(AimReport::new(args, resolved, result, &self.path))))
    }

    /// Renders and writes a coarse preview, unless the picture is small.
    pub fn write_preview(
        &self,
        scene: &LoadedInputs,
        progress: &TerminalProgress,
    ) -> Result<(), CommandError> {
        let Resolved { settings, .. } = resolved(self.args, scene)?;
        self.format.check_size(settings.size)?;
        let Some(coarse) = preview::preview_settings(&settings).filter(|_| scene.mask.is_none()) else {
            return Ok(());
        };
        let output = OutputGuard::of(&scene.paths).prepare(&self.path)?;
        let rendered = self.render_with(&scene.description, &coarse, &RenderOptions::default(), progress)?;
        self.write(&preview::upscaled(&rendered.picture, settings.size), output, progress)
    }

    /// Renders a picture with these settings.
    fn render_with(
        &self,
        description: &LoadedScene,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &TerminalProgress,
    ) -> Result<RenderOutput, CommandError> {
        let rendered = strahl_session::render(description, settings, options, progress);
        progress.end();
        rendered.map_err(|error| self.failure(error))
    }

    /// The error of the command for an error of the renderer.
    fn failure(&self, error: RenderError) -> CommandError {
        match error {
            RenderError::Interrupted(interrupt) => CommandError::Stopped(interrupt),
            error => CommandError::input(&self.args.scene, error.to_string()),
        }
    }

    /// Encodes the picture and completes the output file.
    fn write(
        &self,
        picture: &Picture,
        output: Output,
        progress: &TerminalProgress,
    ) -> Result<(), CommandError> {
        let file = self.format.encode(picture).map_err(|error| CommandError::Unwritable {
            path: Some(self.path.clone()),
            error: std::io::Error::other(error),
        })?;
        progress.check().map_err(CommandError::Stopped)?;
        output.commit(&file)
    }
}

/// Output of the cost map.
struct HeatMapOutput<'h> {
    path: &'h Path,
    format: PictureFormat,
    output: Output,
}

impl<'h> HeatMapOutput<'h> {
    fn prepare(path: &'h Path, guard: &mut OutputGuard) -> Result<Self, CommandError> {
        if path == Path::new("-") {
            return Err(CommandError::Usage("--cost needs a file name, not `-`".into()));
        }
        let (format, output) = (PictureFormat::from_path(path)?, guard.prepare(path)?);
        Ok(HeatMapOutput { path, format, output })
    }

    fn write(self, costs: &CostRegion) -> Result<(), CommandError> {
        let HeatMapOutput { path, format, output } = self;
        let unwritable = |error: io::Error| CommandError::Unwritable { path: Some(path.to_owned()), error };
        let file = match format {
            PictureFormat::Exr => {
                heat_map::exr(costs).map_err(|error| unwritable(io::Error::other(error)))?
            }
            _ => {
                let Some(picture) = heat_map::picture(costs) else {
                    let what = "the heat map would be too large; use .exr for the numbers";
                    return Err(CommandError::Usage(what.into()));
                };
                format.check_size(picture.size)?;
                format.encode(&picture).map_err(|error| unwritable(io::Error::other(error)))?
            }
        };
        output.commit(&file)
    }
}

/// Resolves settings in this order: command line, scene, defaults.
fn resolved(args: &RenderArgs, scene: &LoadedInputs) -> Result<Resolved, CommandError> {
    let resolved = Resolved::new(&args.settings.given, &scene.description.settings)?;
    if let (Some(path), Some(mask)) = (&args.mask, &scene.mask)
        && mask.size != resolved.settings.size
    {
        let (actual, expected) = (mask.size, resolved.settings.size);
        let reason = format!(
            "the mask is {}x{} pixels, but the picture is {}x{}",
            actual.width(),
            actual.height(),
            expected.width(),
            expected.height()
        );
        return Err(CommandError::InvalidInput { path: path.clone(), line: None, reason });
    }
    Ok(resolved)
}

/// Reads a mask: the pixels that are white in the picture at `path`.
fn load_mask(files: &SourceFiles, path: &Path) -> Result<Mask, CommandError> {
    let pixels = pixels::read(files, path)?;
    Ok(Mask { size: pixels.size, pixels: pixels.values.are_white() })
}

/// The scene's name with .png, in the current folder.
fn default_output(scene: &Path) -> PathBuf {
    let mut name = PathBuf::from(scene.file_stem().unwrap_or(OsStr::new("picture")));
    name.as_mut_os_string().push(".png");
    name
}

/// Format and path of the statistics; `None` if they are not requested.
fn report(args: &RenderArgs) -> Result<Option<(StatsFormat, PathBuf)>, CommandError> {
    let stdout = PathBuf::from("-");
    let form = match (args.stats, &args.stats_file) {
        (None, None) => return Ok(None),
        (form, _) => form.unwrap_or(StatsFormat::Json),
    };
    let path = args.stats_file.clone().unwrap_or(stdout.clone());
    if path == stdout && args.output.as_ref() == Some(&stdout) {
        return Err(CommandError::Usage(
            "the picture is written to standard output; use --stats-file for the statistics".into(),
        ));
    }
    Ok(Some((form, path)))
}
