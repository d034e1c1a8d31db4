//! The command `generate`: scenes that formulas make, of any size.
//!
//! They serve for measuring how time and memory grow. Each room makes one scene from its published
//! description and hands it, piece by piece, to a `Pen`, which writes one format; nothing but a
//! landscape's heights is kept in memory. The numbers are computed in double precision with
//! libm, so that a scene is the same file on every machine.

mod knot;
mod mountain;
mod native;
mod nff;
mod pen;
mod ply;
mod rings;
mod sphereflake;
mod stadium;
mod tetra;
mod tree;

use std::ffi::OsStr;
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use indicatif::{HumanBytes, HumanCount};

use crate::args::GenerateArgs;
use crate::failure::Failure;
use crate::output::{Output, say};
use crate::signals::Signals;
use pen::{Mesh, Pen};

/// The most objects of a scene: about a gigabyte of NFF.
pub const MOST_OBJECTS: u64 = 1 << 24;

/// What can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum What {
    /// A mirroring sphere with nine smaller ones round it, and so on; the databases' `balls` (size
    /// 4).
    #[value(alias = "balls")]
    Sphereflake,
    /// A tetrahedron of tetrahedra; the databases' `tetra` (size 6).
    Tetra,
    /// A fractal landscape under four glass balls, after the databases' `mount` (size 6).
    #[value(alias = "mount")]
    Mountain,
    /// A pyramid of interlocked rings; the databases' `rings` (size 7).
    Rings,
    /// A tree whose branches fork in two; the databases' `tree` (size 11).
    Tree,
    /// A smooth torus knot of at least as many triangles as its size says (10000).
    Knot,
    /// A knot as dense as its size says (10000 triangles) in a stadium ten thousand times as wide
    /// as a triangle: little in much space.
    Stadium,
}

impl What {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            What::Sphereflake => "sphereflake",
            What::Tetra => "tetra",
            What::Mountain => "mountain",
            What::Rings => "rings",
            What::Tree => "tree",
            What::Knot => "knot",
            What::Stadium => "stadium",
        }
    }

    /// Its size when none is asked for: where the databases have it, theirs.
    pub fn usual_size(self) -> u32 {
        match self {
            What::Sphereflake => 4,
            What::Tetra | What::Mountain => 6,
            What::Rings => 7,
            What::Tree => 11,
            What::Knot | What::Stadium => 10_000,
        }
    }

    /// The smallest size.
    pub fn least_size(self) -> u32 {
        match self {
            What::Sphereflake | What::Tree => 0,
            What::Tetra | What::Mountain | What::Rings | What::Knot | What::Stadium => 1,
        }
    }

    /// How many objects it has at a size; none when they are more than can be counted.
    pub fn objects(self, size: u32) -> Option<u64> {
        let n = u64::from(size);
        match self {
            // One and nine and eighty-one ..., and the ground.
            What::Sphereflake => Some((9_u64.checked_pow(size.checked_add(1)?)? - 1) / 8 + 1),
            What::Tetra => 4_u64.checked_pow(size),
            What::Mountain => 4_u64.checked_pow(size)?.checked_mul(2)?.checked_add(mountain::BALLS),
            // Squares of groups of six rings of five tubes and five balls, and the ground.
            What::Rings => n.checked_mul(n + 1)?.checked_mul(2 * n + 1)?.checked_mul(10)?.checked_add(1),
            // A tube and a ball for one branch and two and four ..., and the ground.
            What::Tree => Some(2_u64.checked_pow(size.checked_add(2)?)? - 1),
            What::Knot => Some(knot::Knot::of(size).triangles().into()),
            What::Stadium => Some(knot::Knot::of(size).triangles() as u64 + stadium::OBJECTS),
        }
    }

    /// The largest size that is made.
    pub fn most_size(self) -> u32 {
        let fits = |size: u32| self.objects(size).is_some_and(|objects| objects <= MOST_OBJECTS);
        // Objects grow with the size: halve the range that holds the last one that fits.
        let (mut fit, mut unfit) = (self.least_size(), u32::MAX);
        while unfit - fit > 1 {
            let middle = fit + (unfit - fit) / 2;
            if fits(middle) { fit = middle } else { unfit = middle }
        }
        fit
    }

    /// Makes it, piece by piece.
    fn draw(self, size: u32, pen: &mut dyn Pen) -> io::Result<()> {
        match self {
            What::Sphereflake => sphereflake::draw(size, pen),
            What::Tetra => tetra::draw(size, pen),
            What::Mountain => mountain::draw(size, pen),
            What::Rings => rings::draw(size, pen),
            What::Tree => tree::draw(size, pen),
            What::Knot => knot::draw(size, pen),
            What::Stadium => stadium::draw(size, pen),
        }
    }

    /// Its triangles, where they are what it is made of.
    fn mesh(self, size: u32) -> Option<Box<dyn Mesh>> {
        match self {
            What::Tetra => Some(Box::new(tetra::Tetra::of(size))),
            What::Mountain => Some(Box::new(mountain::Mountain::of(size))),
            What::Knot => Some(Box::new(knot::Knot::of(size))),
            What::Stadium => Some(Box::new(stadium::knot(size))),
            What::Sphereflake | What::Rings | What::Tree => None,
        }
    }

    /// Whether nothing but its triangles counts, so that a file of triangles can hold it.
    fn is_mesh(self) -> bool {
        matches!(self, What::Tetra | What::Mountain | What::Knot)
    }
}

impl fmt::Display for What {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// How a scene is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// The neutral file format of the databases.
    Nff,
    /// strahl's own; triangles of a mesh go into a PLY file beside it.
    Toml,
    /// The triangles only, binary.
    Ply,
}

impl Form {
    /// What the extension of a file names.
    fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        Form::from_str(extension, true).ok()
    }
}

/// Makes one scene.
pub fn run(args: &GenerateArgs) -> Result<(), Failure> {
    let signals =
        Signals::listen().map_err(|error| Failure::Usage(format!("cannot listen for signals: {error}")))?;
    let what = args.what;
    let size = size(what, args.size)?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{what}.nff")));
    let form = form(what, &path, args.format)?;
    let beside = (form == Form::Toml && what.mesh(size).is_some()).then(|| path.with_extension("ply"));
    if beside.is_some() && path == Path::new("-") {
        let reason = format!(
            "in TOML the triangles of a {what} are in a PLY file of its own: name a file, or use --format nff"
        );
        return Err(Failure::Usage(reason));
    }

    let output = Output::prepare(&path)?;
    if let (Some(mesh), Some(ply)) = (what.mesh(size), &beside) {
        write(Output::prepare(ply)?, &signals, &mut |out| ply::write(&*mesh, out))?;
    }
    let name = beside.as_deref().and_then(Path::file_name).and_then(OsStr::to_str).unwrap_or_default();
    let bytes = write(output, &signals, &mut |out| {
        let head = format!("Made by strahl generate {what} --size {size}");
        match form {
            Form::Nff if args.bare => what.draw(size, &mut nff::Nff::bare(out)),
            Form::Nff => what.draw(size, &mut nff::Nff::new(&head, out)?),
            Form::Toml if args.bare => what.draw(size, &mut native::Toml::bare(name, out)),
            Form::Toml => what.draw(size, &mut native::Toml::new(&head, name, out)?),
            Form::Ply => what.mesh(size).map_or(Ok(()), |mesh| ply::write(&*mesh, out)),
        }
    })?;
    if !args.quiet && path != Path::new("-") {
        let beside = beside.map(|ply| format!(" and {}", ply.display())).unwrap_or_default();
        let triangles = || what.mesh(size).map(|mesh| mesh.triangles().into());
        let objects = if form == Form::Ply { triangles() } else { what.objects(size) };
        let objects = HumanCount(objects.unwrap_or(0));
        say(format_args!("{}{beside}: {objects} objects, {}", path.display(), HumanBytes(bytes)));
    }
    Ok(())
}

/// The size that is asked for, if there is one like that.
fn size(what: What, asked: Option<u32>) -> Result<u32, Failure> {
    let size = asked.unwrap_or(what.usual_size());
    if size < what.least_size() {
        return Err(Failure::Usage(format!("a {what} has a size of {} or more", what.least_size())));
    }
    match what.objects(size) {
        Some(objects) if objects <= MOST_OBJECTS => Ok(size),
        objects => {
            let has = objects.map_or("more than can be counted".into(), |objects| objects.to_string());
            Err(Failure::Usage(format!(
                "the objects of a {what} of size {size} would be {has}; at most {MOST_OBJECTS} are made, \
                 which is size {}",
                what.most_size()
            )))
        }
    }
}

/// How the scene is to be written at `path`.
fn form(what: What, path: &Path, asked: Option<Form>) -> Result<Form, Failure> {
    let form = match (asked, Form::of(path)) {
        (Some(form), _) | (None, Some(form)) => form,
        (None, None) if path == Path::new("-") => Form::Nff,
        (None, None) => {
            let shown = path.display();
            return Err(Failure::Usage(format!(
                "{shown} does not end in .nff, .toml or .ply; or name the --format"
            )));
        }
    };
    if form == Form::Ply && !what.is_mesh() {
        let reason = format!("PLY holds triangles only, and a {what} has other shapes: use .nff or .toml");
        return Err(Failure::Usage(reason));
    }
    Ok(form)
}

/// Lets something write to a place, and counts the bytes.
fn write(
    output: Output,
    signals: &Signals,
    draw: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> Result<u64, Failure> {
    let mut watched = Watched { output, signals, bytes: 0, failure: None };
    let mut buffered = io::BufWriter::with_capacity(1 << 16, &mut watched);
    let drawn = draw(&mut buffered).and_then(|()| buffered.flush());
    drop(buffered);
    match (drawn, watched.failure) {
        (Ok(()), None) => watched.output.finish().map(|()| watched.bytes),
        (_, Some(failure)) => Err(failure),
        (Err(error), None) => Err(Failure::Unwritable { path: None, error }),
    }
}

/// A writer that ends when a signal has come, and keeps why it failed.
struct Watched<'s> {
    output: Output,
    signals: &'s Signals,
    bytes: u64,
    failure: Option<Failure>,
}

impl Write for Watched<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // A buffer that is dropped after a failure comes once more.
        if let Some(failure) = &self.failure {
            return Err(io::Error::other(failure.to_string()));
        }
        let checked = self.signals.check().map_err(Failure::Stopped);
        if let Err(failure) = checked.and_then(|()| self.output.write(bytes)) {
            let error = io::Error::other(failure.to_string());
            self.failure = Some(failure);
            return Err(error);
        }
        self.bytes += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests;
