//! The command `cast`: rays in as CSV, what they hit out as CSV.
//!
//! A [`Session`] finds the nearest hits; a [`RayStream`] reads the rays and writes the rows.

use std::fs::File;
use std::io::{IsTerminal, Read, stdin};
use std::path::{Path, PathBuf};
use std::time::Instant;

use strahl_engine::RenderError;
use strahl_scene::quantity::quantity;
use strahl_scene::{SourceFiles, load_from};
use strahl_session::rays::{CastCounts, CastError, RayStream};
use strahl_session::{SceneStorage, Session};
use strahl_settings::{DEFAULT_SIZE, Settings};

use crate::args::CastArgs;
use crate::error::CommandError;
use crate::output::{OutputGuard, print_message};
use crate::signals::Signals;

/// Intersects rays with one scene.
pub fn run(args: &CastArgs) -> Result<(), CommandError> {
    let signals = Signals::register()?;
    let clock = Instant::now();
    let files = SourceFiles::on_disk();
    let mut description = load_from(&files, &args.scene, DEFAULT_SIZE)?;
    // A ray of the input has no time.
    description.motions.clear();
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        print_message(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let mut output = OutputGuard::of(files.named_paths().iter().chain([&args.rays])).prepare(&args.output)?;
    let (input, name) = open_rays(&args.rays, args.quiet)?;

    let settings = Settings::resolve(&args.settings.given, &description.settings)?;
    let (precision, threads, finding) = (settings.precision, settings.threads, settings.acceleration());
    let wrong = |error: RenderError| CommandError::input(&args.scene, error.to_string());
    let mut storage = SceneStorage::new(&description, precision);
    let session = Session::new(&mut storage, &finding).map_err(wrong)?;
    let stream = RayStream { input, precision, threads };
    let CastCounts { rays, hits } = match stream.run(&mut output, &signals, || session.ray_caster()) {
        Ok(counts) => output.finish().map(|()| counts),
        // Rows of earlier lines are kept.
        Err(CastError::Line { line, error }) => {
            output.finish().and(Err(CommandError::at(&name, line, error.to_string())))
        }
        Err(CastError::Read(error)) => Err(CommandError::Unreadable { path: name, error }),
        Err(CastError::Write(error)) => Err(output.unwritable(error)),
        Err(CastError::Interrupted(interrupt)) => Err(CommandError::StoppedMidStream(interrupt)),
    }?;
    if !args.quiet {
        let choice = &session.accelerator().choice;
        let (rays, hits, seconds) =
            (quantity(rays, "ray"), quantity(hits, "hit"), clock.elapsed().as_secs_f64());
        print_message(format_args!("{rays}, {hits}, {seconds:.2} s; {} ({})", choice, choice.reason));
    }
    Ok(())
}

/// Opens the input of rays. Returns it and its name in messages.
fn open_rays(path: &Path, quiet: bool) -> Result<(Box<dyn Read + Send>, PathBuf), CommandError> {
    if path == Path::new("-") {
        if stdin().is_terminal() && !quiet {
            print_message(
                "reading rays from the terminal, one per line: ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax",
            );
        }
        return Ok((Box::new(stdin()), PathBuf::from("<stdin>")));
    }
    let unreadable = |error| CommandError::Unreadable { path: path.to_owned(), error };
    Ok((Box::new(File::open(path).map_err(unreadable)?), path.to_owned()))
}
