//! The command `cast`: rays in as CSV, what they hit out as CSV.
//!
//! A [`Session`] finds what a ray hits; [`rays`](crate::rays) brings the rays there and the answers back.

use std::fs::File;
use std::io::{IsTerminal, Read, stdin};
use std::path::{Path, PathBuf};
use std::time::Instant;

use strahl_engine::RenderError;
use strahl_scene::quantity::quantity;
use strahl_scene::{SourceFiles, load_from};
use strahl_settings::{DEFAULT_SIZE, Settings};

use crate::args::CastArgs;
use crate::failure::Failure;
use crate::output::{Guard, say};
use crate::rays::{Cast, Stream};
use crate::session::{SceneStorage, Session};
use crate::signals::Signals;

/// Casts rays into one scene.
pub fn run(args: &CastArgs) -> Result<(), Failure> {
    let signals = Signals::listen()?;
    let clock = Instant::now();
    let files = SourceFiles::on_disk();
    let mut description = load_from(&files, &args.scene, DEFAULT_SIZE)?;
    // A ray of the file has no time.
    description.motions.clear();
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        say(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let output = Guard::of(files.named_paths().iter().chain([&args.rays])).prepare(&args.output)?;
    let (input, name) = rays(&args.rays, args.quiet)?;

    let settings = Settings::resolve(&args.settings.given, &description.settings)?;
    let (precision, threads, finding) = (settings.precision, settings.threads, settings.acceleration());
    let stream = Stream { input, name, output, precision, threads, signals };
    let wrong = |error: RenderError| Failure::input(&args.scene, error.to_string());
    let mut storage = SceneStorage::new(&description, precision);
    let session = Session::new(&mut storage, &finding).map_err(wrong)?;
    let Cast { rays, hits } = stream.run(|| session.ray_caster())?;
    if !args.quiet {
        let choice = &session.accelerator().choice;
        let (rays, hits, seconds) =
            (quantity(rays, "ray"), quantity(hits, "hit"), clock.elapsed().as_secs_f64());
        say(format_args!("{rays}, {hits}, {seconds:.2} s; {} ({})", choice, choice.reason));
    }
    Ok(())
}

/// Where rays come from, and its name in messages.
fn rays(path: &Path, quiet: bool) -> Result<(Box<dyn Read + Send>, PathBuf), Failure> {
    if path == Path::new("-") {
        if stdin().is_terminal() && !quiet {
            say("rays are expected, one in each line: ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax");
        }
        return Ok((Box::new(stdin()), PathBuf::from("<stdin>")));
    }
    let unreadable = |error| Failure::Unreadable { path: path.to_owned(), error };
    Ok((Box::new(File::open(path).map_err(unreadable)?), path.to_owned()))
}
