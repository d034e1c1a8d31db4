//! The command `cast`: rays in as CSV, what they hit out as CSV.
//!
//! What a ray hits is found in [`hits`], which is compiled for either precision; [`rays`](crate::rays)
//! brings the rays there and the answers back.

use std::fs::File;
use std::io::{IsTerminal, Read, stdin};
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::amount::amount;
use crate::args::CastArgs;
use crate::failure::Failure;
use crate::load::{Files, load_from};
use crate::output::{Guard, say};
use crate::precision::Precision;
use crate::rays::{Cast, NoCast, Stream};
use crate::signals::Signals;
use crate::wanted::DEFAULT_SIZE;
use crate::{double, hits, stock};

/// Casts rays into one scene.
pub fn run(args: &CastArgs) -> Result<(), Failure> {
    let signals = Signals::listen()?;
    let clock = Instant::now();
    let files = Files::on_disk();
    let mut description = load_from(&files, &args.scene, DEFAULT_SIZE)?;
    // A ray of the file has no time.
    description.moving.clear();
    for warning in description.warnings.iter().filter(|_| !args.quiet) {
        say(format_args!("{}: warning: {warning}", args.scene.display()));
    }
    let output = Guard::of(files.named().iter().chain([&args.rays])).prepare(&args.output)?;
    let (input, name) = rays(&args.rays, args.quiet)?;

    let precision = args.precision.or(description.settings.precision).unwrap_or_default();
    let finding = args.finding.over(description.settings.finding)?;
    let threads = args.threads.or(std::thread::available_parallelism().ok().map(usize::from)).unwrap_or(1);
    let stream = Stream { input, name, output, precision, threads, signals };
    let cast = match precision {
        Precision::Single => hits::cast(&stock::single::Stock::new(&description), &finding, stream),
        Precision::Double => double::hits::cast(&stock::double::Stock::new(&description), &finding, stream),
    };
    let wrong =
        |error: NoCast| Failure::Input { path: args.scene.clone(), line: None, reason: error.to_string() };
    let (facts, cast) = cast.map_err(wrong)?;
    let Cast { rays, hits } = cast?;
    if !args.quiet {
        let (rays, hits, seconds) = (amount(rays, "ray"), amount(hits, "hit"), clock.elapsed().as_secs_f64());
        say(format_args!("{rays}, {hits}, {seconds:.2} s; {} ({})", facts.choice, facts.choice.reason));
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
