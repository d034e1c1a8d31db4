//! The command `generate`: one of the [`procedural`](strahl_scene::procedural) scenes, into a file.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use indicatif::{HumanBytes, HumanCount};
use strahl_scene::procedural::{MAX_OBJECTS, ProceduralScene, SceneFormat};
use strahl_scene::quantity::quantity;

use crate::args::GenerateArgs;
use crate::error::CommandError;
use crate::output::{Output, OutputGuard, print_message, refuse_terminal};
use crate::signals::Signals;
use strahl_engine::Progress as _;

/// Generates one scene.
pub fn run(args: &GenerateArgs) -> Result<(), CommandError> {
    let signals = Signals::register()
        .map_err(|error| CommandError::Usage(format!("cannot register signal handlers: {error}")))?;
    let scene = args.scene;
    let size = checked_size(scene, args.size)?;
    let extension = args.format.unwrap_or(SceneFormat::Nff).extension();
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{scene}.{extension}")));
    let form = format_for(scene, &path, args.format)?;
    if form == SceneFormat::Ply {
        refuse_terminal(&path, "the PLY file")?;
    }
    let beside =
        (form == SceneFormat::Toml && scene.triangles(size).is_some()).then(|| path.with_extension("ply"));
    if beside.is_some() && path == Path::new("-") {
        let reason = format!(
            "{scene}: TOML output needs a separate PLY file; name an output file, or use --format nff"
        );
        return Err(CommandError::Usage(reason));
    }

    let mut guard = OutputGuard::default();
    let output = guard.prepare(&path)?;
    if let Some(ply) = &beside {
        write_interruptible(guard.prepare(ply)?, &signals, &mut |out| {
            scene.write(size, SceneFormat::Ply, args.bare, "", out)
        })?;
    }
    let name = beside.as_deref().and_then(Path::file_name).and_then(OsStr::to_str).unwrap_or_default();
    let bytes =
        write_interruptible(output, &signals, &mut |out| scene.write(size, form, args.bare, name, out))?;
    if !args.quiet && path != Path::new("-") {
        let beside = beside.map(|ply| format!(" and {}", ply.display())).unwrap_or_default();
        let objects = if form == SceneFormat::Ply { scene.triangles(size) } else { scene.objects(size) };
        let objects = quantity(objects.unwrap_or(0), "object");
        print_message(format_args!("{}{beside}: {objects}, {}", path.display(), HumanBytes(bytes)));
    }
    Ok(())
}

/// The requested size, or an error if it is out of range.
fn checked_size(scene: ProceduralScene, requested: Option<u32>) -> Result<u32, CommandError> {
    let size = requested.unwrap_or(scene.default_size());
    if size < scene.min_size() {
        return Err(CommandError::Usage(format!("{scene}: the size must be {} or more", scene.min_size())));
    }
    match scene.objects(size) {
        Some(objects) if objects <= MAX_OBJECTS => Ok(size),
        objects => {
            let has = objects.map_or("more than 2^64 objects".into(), |it| quantity(it, "object"));
            Err(CommandError::Usage(format!(
                "{scene}: size {size} has {has}; the limit is {}, which is size {}",
                HumanCount(MAX_OBJECTS),
                scene.max_size()
            )))
        }
    }
}

/// The format of a scene at `path`.
fn format_for(
    scene: ProceduralScene,
    path: &Path,
    requested: Option<SceneFormat>,
) -> Result<SceneFormat, CommandError> {
    let form = match (requested, SceneFormat::from_path(path)) {
        (Some(form), _) | (None, Some(form)) => form,
        (None, None) if path == Path::new("-") => SceneFormat::Nff,
        (None, None) => {
            let shown = path.display();
            return Err(CommandError::Usage(format!(
                "{shown} does not end in .nff, .toml or .ply; use --format"
            )));
        }
    };
    if form == SceneFormat::Ply && !scene.is_mesh() {
        let reason =
            format!("{scene} has shapes other than triangles, which PLY cannot store; use .nff or .toml");
        return Err(CommandError::Usage(reason));
    }
    Ok(form)
}

/// Writes to an output until a signal arrives; the number of bytes.
fn write_interruptible(
    output: Output,
    signals: &Signals,
    draw: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> Result<u64, CommandError> {
    let mut watched = InterruptibleWriter { output, signals, bytes: 0, failure: None };
    let mut buffered = io::BufWriter::with_capacity(1 << 16, &mut watched);
    let written = draw(&mut buffered).and_then(|()| buffered.flush());
    drop(buffered);
    match (written, watched.failure) {
        (Ok(()), None) => watched.output.finish().map(|()| watched.bytes),
        (_, Some(failure)) => Err(failure),
        (Err(error), None) => Err(CommandError::Unwritable { path: None, error }),
    }
}

/// A writer that fails once a signal has arrived, and stores the error.
struct InterruptibleWriter<'s> {
    output: Output,
    signals: &'s Signals,
    bytes: u64,
    failure: Option<CommandError>,
}

impl Write for InterruptibleWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // A buffer that is dropped after an error writes again.
        if let Some(failure) = &self.failure {
            return Err(io::Error::other(failure.to_string()));
        }
        let checked = self.signals.check().map_err(CommandError::Stopped);
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
    fn the_largest_size_is_accepted_and_the_next_is_rejected() {
        for scene in ProceduralScene::ALL {
            let most = scene.max_size();
            assert!(checked_size(scene, Some(most)).is_ok(), "{scene} {most}");
            for more in [most + 1, 2 * most, 1 << 30, u32::MAX] {
                let Err(CommandError::Usage(reason)) = checked_size(scene, Some(more)) else {
                    panic!("{scene} {more}")
                };
                assert!(reason.ends_with(&format!("which is size {most}")), "{reason}");
            }
        }
    }
}
