//! The command `explain`: the tree of rays of one pixel.
//!
//! | module | contents |
//! |---|---|
//! | [`text`] | the tree as text |
//! | [`svg`] | the tree as SVG |

use std::path::Path;

use strahl_core::Tile;
use strahl_core::image::Pixel;
use strahl_scene::effects::disable;
use strahl_scene::{SourceFiles, load_from};
use strahl_session::explain::explain;
use strahl_session::explain::tree::PixelExplanation;
use strahl_settings::{DEFAULT_SIZE, Precision, Settings};

use crate::args::ExplainArgs;
use crate::error::CommandError;
use crate::output::{Output, OutputGuard, print_message};
use crate::word_wrap::{stdout_width, wrapped};

pub mod svg;
pub mod text;

/// Explains one pixel.
pub fn run(args: &ExplainArgs) -> Result<(), CommandError> {
    let svg_to_stdout = args.svg.as_deref() == Some(Path::new("-"));
    if svg_to_stdout && args.json {
        return Err(CommandError::Usage("--svg - and --json would both write to standard output".into()));
    }
    let files = SourceFiles::on_disk();
    let explained = explained(args, &files)?;
    let mut guard = OutputGuard::of(files.named_paths());
    let svg = args.svg.as_deref().map(|path| guard.prepare(path)).transpose()?;
    if let Some(output) = svg {
        let sample = explained.samples.get(args.sample.unwrap_or(1) - 1);
        let picture = sample.map(|sample| svg::picture(&explained, sample)).unwrap_or_default();
        output.commit(picture.as_bytes())?;
    }
    let text = if args.json {
        let mut json = serde_json::to_string_pretty(&explained).unwrap_or_default();
        json.push('\n');
        json
    } else if svg_to_stdout || (args.svg.is_some() && args.quiet) {
        return Ok(());
    } else {
        wrapped(&text::text(&explained, args.sample), stdout_width(), text::INDENT)
    };
    Output::Stdout.commit(text.as_bytes())
}

/// Traces the requested pixel.
fn explained(args: &ExplainArgs, files: &SourceFiles) -> Result<PixelExplanation, CommandError> {
    let mut description = load_from(files, &args.scene, args.settings.given.size.unwrap_or(DEFAULT_SIZE))?;
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        print_message(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let settings = Settings::resolve(&args.settings.given, &description.settings)?;
    disable(&mut description, &settings.without);
    if settings.precision == Precision::Double && !args.quiet {
        let scene = args.scene.display();
        print_message(format_args!(
            "{scene}: the scene requires double precision, but explain traces in single precision"
        ));
    }
    let (Pixel { x, y }, size) = (args.pixel, settings.size);
    if Tile::full(size).index_of(args.pixel).is_none() {
        let (width, height) = (size.width(), size.height());
        let what = format!(
            "the pixel {x},{y} is outside the picture of {width}x{height}, whose last pixel is {},{}",
            width - 1,
            height - 1
        );
        return Err(CommandError::Usage(what));
    }
    let explained = explain(&args.scene.display().to_string(), &description, settings, args.pixel);
    let explained = explained.map_err(|error| CommandError::input(&args.scene, error.to_string()))?;
    if let Some(sample) = args.sample
        && sample > explained.samples.len()
    {
        let what = format!("sample {sample} does not exist: the pixel has {}", explained.samples.len());
        return Err(CommandError::Usage(what));
    }
    Ok(explained)
}
