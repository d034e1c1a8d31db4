//! The command `generate`: one of the [`procedural`](strahl_scene::procedural) scenes, into a file.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use indicatif::{HumanBytes, HumanCount};
use strahl_scene::procedural::{MAX_OBJECTS, ProceduralScene, SceneFormat};
use strahl_scene::quantity::quantity;

use crate::args::GenerateArgs;
use crate::failure::Failure;
use crate::output::{Guard, Output, refuse_terminal, say};
use crate::signals::Signals;
use strahl_engine::Progress as _;

/// Makes one scene.
pub fn run(args: &GenerateArgs) -> Result<(), Failure> {
    let signals =
        Signals::listen().map_err(|error| Failure::Usage(format!("cannot listen for signals: {error}")))?;
    let what = args.what;
    let size = size(what, args.size)?;
    let extension = args.format.unwrap_or(SceneFormat::Nff).extension();
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{what}.{extension}")));
    let form = form(what, &path, args.format)?;
    if form == SceneFormat::Ply {
        refuse_terminal(&path, "the PLY file")?;
    }
    let beside =
        (form == SceneFormat::Toml && what.triangles(size).is_some()).then(|| path.with_extension("ply"));
    if beside.is_some() && path == Path::new("-") {
        let reason = format!(
            "{what}: in TOML its triangles are in a PLY file of their own: name a file, or use --format nff"
        );
        return Err(Failure::Usage(reason));
    }

    let mut guard = Guard::default();
    let output = guard.prepare(&path)?;
    if let Some(ply) = &beside {
        write(guard.prepare(ply)?, &signals, &mut |out| {
            what.write(size, SceneFormat::Ply, args.bare, "", out)
        })?;
    }
    let name = beside.as_deref().and_then(Path::file_name).and_then(OsStr::to_str).unwrap_or_default();
    let bytes = write(output, &signals, &mut |out| what.write(size, form, args.bare, name, out))?;
    if !args.quiet && path != Path::new("-") {
        let beside = beside.map(|ply| format!(" and {}", ply.display())).unwrap_or_default();
        let objects = if form == SceneFormat::Ply { what.triangles(size) } else { what.objects(size) };
        let objects = quantity(objects.unwrap_or(0), "object");
        say(format_args!("{}{beside}: {objects}, {}", path.display(), HumanBytes(bytes)));
    }
    Ok(())
}

/// The size that is asked for, if there is one like that.
fn size(what: ProceduralScene, asked: Option<u32>) -> Result<u32, Failure> {
    let size = asked.unwrap_or(what.default_size());
    if size < what.min_size() {
        return Err(Failure::Usage(format!("{what}: the size must be {} or more", what.min_size())));
    }
    match what.objects(size) {
        Some(objects) if objects <= MAX_OBJECTS => Ok(size),
        objects => {
            let has = objects.map_or("more objects than can be counted".into(), |it| quantity(it, "object"));
            Err(Failure::Usage(format!(
                "{what}: size {size} would be {has}; at most {} are made, which is size {}",
                HumanCount(MAX_OBJECTS),
                what.max_size()
            )))
        }
    }
}

/// How the scene is to be written at `path`.
fn form(what: ProceduralScene, path: &Path, asked: Option<SceneFormat>) -> Result<SceneFormat, Failure> {
    let form = match (asked, SceneFormat::from_path(path)) {
        (Some(form), _) | (None, Some(form)) => form,
        (None, None) if path == Path::new("-") => SceneFormat::Nff,
        (None, None) => {
            let shown = path.display();
            return Err(Failure::Usage(format!(
                "{shown} does not end in .nff, .toml or .ply; or name the --format"
            )));
        }
    };
    if form == SceneFormat::Ply && !what.is_mesh() {
        let reason = format!("{what}: PLY holds triangles only, and it has other shapes: use .nff or .toml");
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
        let write = |()| self.output.write_all(bytes).map_err(|error| self.output.unwritable(error));
        if let Err(failure) = checked.and_then(write) {
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
mod tests {
    use super::*;

    #[test]
    fn the_largest_size_is_made_and_the_next_is_not() {
        for what in ProceduralScene::ALL {
            let most = what.max_size();
            assert!(size(what, Some(most)).is_ok(), "{what} {most}");
            for more in [most + 1, 2 * most, 1 << 30, u32::MAX] {
                let Err(Failure::Usage(reason)) = size(what, Some(more)) else { panic!("{what} {more}") };
                assert!(reason.ends_with(&format!("which is size {most}")), "{reason}");
            }
        }
    }
}
