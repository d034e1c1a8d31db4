//! The command `compare`: how two pictures differ.
//!
//! All measures are differences of sRGB-encoded values in 0..1, as everywhere on the command
//! line: that is what a person sees. Two EXR files are compared as their encodings too, and
//! their largest linear difference is told beside it; an EXR file beside another format is
//! rounded as it would be if it were written in that format.
//!
//! The measures are those of [`strahl_picture::difference`]; [`report`] is what is told of them.

use std::path::Path;

use strahl_core::Resolution;
use strahl_picture::color_map::{inferno, step_of};
use strahl_picture::difference::Pair;
use strahl_picture::{DecodedPicture, Picture, PictureFormat, srgb};
use strahl_scene::SourceFiles;

use crate::args::CompareArgs;
use crate::failure::{Answer, Failure};
use crate::output::{Guard, Output};
use crate::pixels;
use crate::wrap::{width_of_stdout, wrapped};
use report::Report;

pub mod report;

/// Compares two pictures.
pub fn run(args: &CompareArgs) -> Result<Answer, Failure> {
    let stdin = Path::new("-");
    if args.first == stdin && args.second == stdin {
        return Err(Failure::Usage("only one of the pictures can be the standard input".into()));
    }
    if args.output.as_deref() == Some(stdin) {
        return Err(Failure::Usage("the report goes to the standard output, so the map needs a file".into()));
    }
    let format = args.output.as_deref().map(PictureFormat::from_path).transpose()?;

    let files = SourceFiles::on_disk();
    let first = pixels::read(&files, &args.first)?;
    let second = pixels::read(&files, &args.second)?;
    let size = same_size(args, &first, &second)?;
    let pair = Pair::of(first.values, second.values);
    let report = Report::new(args, size, &pair);

    if let (Some(path), Some(format)) = (&args.output, format) {
        write_map(args, path, format, &map(size, &pair))?;
    }
    if !args.quiet {
        let text = if args.json {
            report.to_json()
        } else {
            wrapped(&report.to_text(), width_of_stdout(), report::INDENT)
        };
        Output::Stdout.commit(text.as_bytes())?;
    }
    Ok(if report.equal { Answer::Yes } else { Answer::No })
}

fn same_size(
    args: &CompareArgs,
    first: &DecodedPicture,
    second: &DecodedPicture,
) -> Result<Resolution, Failure> {
    let (a, b) = (first.size, second.size);
    if a == b {
        return Ok(a);
    }
    Err(Failure::Input {
        path: args.second.clone(),
        line: None,
        reason: format!(
            "{} x {} pixels, but {} has {} x {}",
            b.width(),
            b.height(),
            args.first.display(),
            a.width(),
            a.height()
        ),
    })
}

/// The largest difference of each pixel as a colour.
fn map(size: Resolution, pair: &Pair) -> Picture {
    let (colors, table) = (inferno(), srgb::decode8());
    let color = |difference| srgb::decode(&table, colors[usize::from(step_of(difference))]);
    Picture { size, colors: pair.differences().into_iter().map(color).collect() }
}

fn write_map(args: &CompareArgs, path: &Path, format: PictureFormat, map: &Picture) -> Result<(), Failure> {
    format.check_size(map.size)?;
    let output = Guard::of([&args.first, &args.second]).prepare(path)?;
    let file = format.encode(map).map_err(|error| Failure::Unwritable {
        path: Some(path.to_owned()),
        error: std::io::Error::other(error),
    })?;
    output.commit(&file)
}
