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
use crate::args::{AimArgs, RenderArgs, StatsForm};
use crate::draft;
use crate::failure::{Answer, Failure};
use crate::heat::{self, Costs};
use crate::output::{Guard, Output, refuse_terminal, say, tell};
use crate::pixels;
use crate::settings;
use crate::signals::Signals;
use crate::stats::StatsReport;
use crate::summary::{self, summary};
use crate::terminal::TerminalProgress;
use crate::wrap::{width_of_stderr, wrapped};

/// Renders one scene. No is the answer where an error was aimed at that is not kept.
pub fn run(args: &RenderArgs, aim: &AimArgs) -> Result<Answer, Failure> {
    let begun = Instant::now();
    refuse_terminal(args.output.as_deref().unwrap_or(Path::new("")), "the picture")?;
    let job = Job { aim: aim.clone(), begun, ..Job::of(args)? };
    let progress = job.progress(Signals::listen()?);
    let scene = job.load(&SourceFiles::on_disk())?;
    job.render(&scene, &progress)
}

/// Tells how a scene would be rendered.
pub fn print_settings(args: &RenderArgs) -> Result<(), Failure> {
    let job = Job::of(args)?;
    let scene = job.load(&SourceFiles::on_disk())?;
    let resolved = resolved(args, &scene)?;
    job.format.check_size(resolved.settings.picture_size())?;
    let text = settings::text(args, &resolved, &job.path, &scene.description.setting_lines);
    Output::Stdout.commit(text.as_bytes())
}

/// A picture that is asked for, and where it goes.
pub struct Job<'a> {
    args: &'a RenderArgs,
    aim: AimArgs,
    begun: Instant,
    path: PathBuf,
    format: PictureFormat,
    report: Option<(StatsForm, PathBuf)>,
}

/// A scene with the mask of its picture, and how long it took to load them.
pub struct Loaded {
    description: LoadedScene,
    mask: Option<Mask>,
    /// What was read for it, or named there.
    inputs: Vec<PathBuf>,
    /// What it asked for and is not to be simulated.
    left_out: Vec<PlannedEffect>,
    took: Duration,
}

impl<'a> Job<'a> {
    /// What the command line asks for.
    pub fn of(args: &'a RenderArgs) -> Result<Self, Failure> {
        let report = report(args)?;
        let path = args.output.clone().unwrap_or_else(|| picture_of(&args.scene));
        let format = PictureFormat::from_path(&path)?;
        Ok(Job { args, aim: AimArgs::default(), begun: Instant::now(), path, format, report })
    }

    /// Shows how far the work is, unless that is switched off.
    pub fn progress(&self, signals: Signals) -> TerminalProgress {
        if self.args.quiet {
            TerminalProgress::silent(signals)
        } else {
            TerminalProgress::on_terminal(signals)
        }
    }

    /// Loads the scene and the mask, and says what their user should know of.
    pub fn load(&self, files: &SourceFiles) -> Result<Loaded, Failure> {
        let clock = Instant::now();
        let Job { args, .. } = self;
        let mut description =
            load_from(files, &args.scene, args.settings.given.size.unwrap_or(DEFAULT_SIZE))?;
        for warning in description.warnings.iter().filter(|_| !args.quiet) {
            say(format_args!("{}: warning: {warning}", args.scene.display()));
        }
        let left_out = disable(&mut description, args.settings.given.without.as_deref().unwrap_or_default());
        let mask = args.mask.as_deref().map(|path| mask(files, path)).transpose()?;
        let mut inputs = files.named_paths();
        inputs.extend(args.mask.clone());
        Ok(Loaded { description, mask, inputs, left_out, took: clock.elapsed() })
    }

    /// Traces the picture and writes it, and whatever is to be told of it.
    pub fn render(&self, scene: &Loaded, progress: &TerminalProgress) -> Result<Answer, Failure> {
        let Job { args, path, format, aim, .. } = self;
        // Before the work, so that nothing is traced that cannot be kept.
        let mut guard = Guard::of(&scene.inputs);
        let output = guard.prepare(path)?;
        let report = match &self.report {
            Some((form, path)) => Some((form, guard.prepare(path)?)),
            None => None,
        };
        let heat = aim.cost.as_ref().map(|place| Heat::prepare(place, &mut guard)).transpose()?;

        let Loaded { description, left_out, took: load, .. } = scene;
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
        let (frame, aimed) = self.aimed(description, &resolved, &options, progress)?;
        let clock = Instant::now();
        self.write(&frame.picture, output, progress)?;
        if let (Some(heat), Some(cost_map)) = (heat, &cost_map) {
            heat.write(&Costs::of(cost_map, settings.region_or_all()))?;
        }
        let write = clock.elapsed();

        let mut plan = plan(description);
        plan.extend_from_slice(left_out);
        if let Some((form, output)) = report {
            let mut stats = StatsReport::new(&plan, &frame);
            stats.aim = aimed.clone();
            stats.seconds.load = load.as_secs_f64();
            stats.seconds.write = write.as_secs_f64();
            let text = match form {
                StatsForm::Json => stats.to_json(),
                StatsForm::Text => stats.to_text(),
            };
            output.commit(text.as_bytes())?;
        }
        let taken = aimed.as_ref().map_or(settings, |report| &report.aimed.settings);
        if !args.quiet {
            let mut summary = summary(path, &frame, &plan, taken.sampler, *load, write);
            if let Some(report) = &aimed {
                summary.push_str(&summary::lines(&report.lines()));
            }
            tell(wrapped(&summary, width_of_stderr(), summary::INDENT));
        }
        Ok(if aimed.is_none_or(|report| report.aimed.kept) { Answer::Yes } else { Answer::No })
    }

    /// Traces the picture, with what was found where something is aimed at.
    fn aimed(
        &self,
        description: &LoadedScene,
        resolved: &Resolved,
        options: &RenderOptions<'_>,
        progress: &TerminalProgress,
    ) -> Result<(RenderOutput, Option<AimReport>), Failure> {
        let (Job { args, aim, begun, format, .. }, settings) = (self, &resolved.settings);
        let traced = if let Some(error) = aim.target_error {
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
            let limit = TimeLimit { start: *begun, duration: time, format: *format };
            aim::time::render_in_time(description, settings, options, limit, progress)
        } else {
            return Ok((self.trace(description, settings, options, progress)?, None));
        };
        progress.end();
        let (frame, aimed) = traced.map_err(|error| self.failure(error))?;
        Ok((frame, Some(AimReport::new(args, resolved, aimed, &self.path))))
    }

    /// Traces and writes a coarse picture, where that is quicker.
    pub fn draft(&self, scene: &Loaded, progress: &TerminalProgress) -> Result<(), Failure> {
        let Resolved { settings, .. } = resolved(self.args, scene)?;
        self.format.check_size(settings.size)?;
        let Some(coarse) = draft::of(&settings).filter(|_| scene.mask.is_none()) else { return Ok(()) };
        let output = Guard::of(&scene.inputs).prepare(&self.path)?;
        let frame = self.trace(&scene.description, &coarse, &RenderOptions::default(), progress)?;
        self.write(&draft::enlarged(&frame.picture, settings.size), output, progress)
    }

    fn trace(
        &self,
        description: &LoadedScene,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &TerminalProgress,
    ) -> Result<RenderOutput, Failure> {
        let frame = strahl_session::render(description, settings, options, progress);
        progress.end();
        frame.map_err(|error| self.failure(error))
    }

    fn failure(&self, error: RenderError) -> Failure {
        match error {
            RenderError::Interrupted(interrupt) => Failure::Stopped(interrupt),
            error => Failure::input(&self.args.scene, error.to_string()),
        }
    }

    fn write(&self, picture: &Picture, output: Output, progress: &TerminalProgress) -> Result<(), Failure> {
        let file = self.format.encode(picture).map_err(|error| Failure::Unwritable {
            path: Some(self.path.clone()),
            error: std::io::Error::other(error),
        })?;
        progress.check().map_err(Failure::Stopped)?;
        output.commit(&file)
    }
}

/// Where it is shown what each pixel costs.
struct Heat<'h> {
    path: &'h Path,
    format: PictureFormat,
    output: Output,
}

impl<'h> Heat<'h> {
    fn prepare(path: &'h Path, guard: &mut Guard) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Err(Failure::Usage("what pixels cost needs a file, not `-`".into()));
        }
        let (format, output) = (PictureFormat::from_path(path)?, guard.prepare(path)?);
        Ok(Heat { path, format, output })
    }

    fn write(self, costs: &Costs) -> Result<(), Failure> {
        let Heat { path, format, output } = self;
        let unwritable = |error: io::Error| Failure::Unwritable { path: Some(path.to_owned()), error };
        let file = match format {
            PictureFormat::Exr => heat::exr(costs).map_err(|error| unwritable(io::Error::other(error)))?,
            _ => {
                let Some(picture) = heat::picture(costs) else {
                    let what =
                        "three such pictures side by side are too large; an .exr file holds the numbers";
                    return Err(Failure::Usage(what.into()));
                };
                format.check_size(picture.size)?;
                format.encode(&picture).map_err(|error| unwritable(io::Error::other(error)))?
            }
        };
        output.commit(&file)
    }
}

/// What the command line asks for, else the scene, else the defaults.
fn resolved(args: &RenderArgs, scene: &Loaded) -> Result<Resolved, Failure> {
    let resolved = Resolved::new(&args.settings.given, &scene.description.settings)?;
    if let (Some(path), Some(mask)) = (&args.mask, &scene.mask)
        && mask.size != resolved.settings.size
    {
        let (is, wanted) = (mask.size, resolved.settings.size);
        let reason = format!(
            "the mask has {}x{} pixels, the picture {}x{}",
            is.width(),
            is.height(),
            wanted.width(),
            wanted.height()
        );
        return Err(Failure::Input { path: path.clone(), line: None, reason });
    }
    Ok(resolved)
}

/// The pixels that are white in the picture at `path`.
fn mask(files: &SourceFiles, path: &Path) -> Result<Mask, Failure> {
    let pixels = pixels::read(files, path)?;
    Ok(Mask { size: pixels.size, pixels: pixels.values.are_white() })
}

/// The scene's name with .png, in the current folder.
fn picture_of(scene: &Path) -> PathBuf {
    let mut name = PathBuf::from(scene.file_stem().unwrap_or(OsStr::new("picture")));
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
