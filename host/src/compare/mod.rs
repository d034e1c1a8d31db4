//! The command `compare`: the differences of two pictures.
//!
//! All measures are differences of sRGB-encoded values, 0 to 1. Two EXR files are compared as sRGB too, and their
//! largest linear difference is reported in addition; an EXR file that is compared with another format is first
//! rounded to the bit depth of that format.
//!
//! [`strahl_picture::difference`] computes the measures; [`report`] prints them.

use std::path::Path;

use strahl_core::Resolution;
use strahl_picture::color_map::{inferno, step_of};
use strahl_picture::difference::Pair;
use strahl_picture::{DecodedPicture, Picture, PictureFormat, srgb};
use strahl_scene::SourceFiles;

use crate::args::CompareArgs;
use crate::error::{CommandError, CommandStatus};
use crate::output::{Output, OutputGuard};
use crate::pixels;
use crate::word_wrap::{stdout_width, wrapped};
use report::ComparisonReport;

pub mod report;

/// Compares two pictures.
pub fn run(args: &CompareArgs) -> Result<CommandStatus, CommandError> {
    let stdin = Path::new("-");
    if args.first == stdin && args.second == stdin {
        return Err(CommandError::Usage("only one picture can be read from standard input".into()));
    }
    if args.output.as_deref() == Some(stdin) {
        return Err(CommandError::Usage(
            "the report is written to standard output; -o needs a file name".into(),
        ));
    }
    let format = args.output.as_deref().map(PictureFormat::from_path).transpose()?;

    let files = SourceFiles::on_disk();
    let first = pixels::read(&files, &args.first)?;
    let second = pixels::read(&files, &args.second)?;
    let size = same_size(args, &first, &second)?;
    let pair = Pair::of(first.values, second.values);
    let report = ComparisonReport::new(args, size, &pair);

    if let (Some(path), Some(format)) = (&args.output, format) {
        write_map(args, path, format, &difference_map(size, &pair))?;
    }
    if !args.quiet {
        let text = if args.json {
            report.to_json()
        } else {
            wrapped(&report.to_text(), stdout_width(), report::INDENT)
        };
        Output::Stdout.commit(text.as_bytes())?;
    }
    Ok(if report.equal { CommandStatus::Success } else { CommandStatus::CheckFailed })
}

fn same_size(
    args: &CompareArgs,
    first: &DecodedPicture,
    second: &DecodedPicture,
) -> Result<Resolution, CommandError> {
    let (a, b) = (first.size, second.size);
    if a == b {
        return Ok(a);
    }
    Err(CommandError::InvalidInput {
        path: args.second.clone(),
        line: None,
        reason: format!(
            "is {}x{} pixels, but {} is {}x{}",
            b.width(),
            b.height(),
            args.first.display(),
            a.width(),
            a.height()
        ),
    })
}

/// The largest difference of each pixel as a color.
fn difference_map(size: Resolution, pair: &Pair) -> Picture {
    let (colors, table) = (inferno(), srgb::decode8());
    let color = |difference| srgb::decode(&table, colors[usize::from(step_of(difference))]);
    Picture { size, colors: pair.differences().into_iter().map(color).collect() }
}

fn write_map(
    args: &CompareArgs,
    path: &Path,
    format: PictureFormat,
    map: &Picture,
) -> Result<(), CommandError> {
    format.check_size(map.size)?;
    let output = OutputGuard::of([&args.first, &args.second]).prepare(path)?;
    let file = format.encode(map).map_err(|error| CommandError::Unwritable {
        path: Some(path.to_owned()),
        error: std::io::Error::other(error),
    })?;
    output.commit(&file)
}
