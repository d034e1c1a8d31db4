//! A folder with a scene in it, and the program running there.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

/// A ball before a background, small enough to be rendered in no time.
pub const BALL: &str = "\
v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 resolution 40 30
b 0.25 0.5 1
l 5 5 5
l -5 5 5
f 1 0.5 0.25 0.75 0.25 20 0 0
s 0 0 0 1
f 1 1 1 0.25 0 0 0.5 1.5
s 1 0 3 0.5
p 3 -4 -1 -4 4 -1 -4 0 -1 4
";

/// Nothing but a background.
pub const EMPTY: &str = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 resolution 4 3\nb 0.25 0.5 1\n";

/// A folder of its own, in which the program runs. Gone with the value.
pub struct Folder {
    folder: TempDir,
}

impl Folder {
    /// With this text in `scene.nff`.
    pub fn with(scene: &str) -> Self {
        let folder = Folder { folder: tempfile::tempdir().unwrap() };
        folder.write("scene.nff", scene);
        folder
    }

    pub fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).unwrap();
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// All names in the folder, in order.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The program with these words on its command line, ready to run here.
    pub fn command(&self, words: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_strahl"));
        command.current_dir(self.folder.path()).args(words.split(' ').filter(|word| !word.is_empty()));
        command.stdin(Stdio::null());
        command
    }

    /// What the program does with these words.
    pub fn run(&self, words: &str) -> Ran {
        Ran::of(self.command(words).output().unwrap())
    }

    /// What the program writes to the standard output with these words, when all goes well.
    pub fn done(&self, words: &str) -> Vec<u8> {
        let ran = self.run(words);
        assert_eq!(ran.status, Some(0), "{words}: {}", ran.stderr);
        ran.stdout
    }
}

/// How the program ended.
pub struct Ran {
    /// None when a signal ended it.
    pub status: Option<i32>,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

impl Ran {
    fn of(output: Output) -> Self {
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(!stderr.contains("panicked"), "{stderr}");
        Ran { status: output.status.code(), stdout: output.stdout, stderr }
    }

    /// The program failed with this status and said this on the standard error only.
    pub fn failed(&self, status: i32, says: &str) {
        assert_eq!(self.status, Some(status), "{}", self.stderr);
        assert!(self.stderr.contains(says), "`{says}` is not in `{}`", self.stderr);
        assert_eq!(String::from_utf8_lossy(&self.stdout), "");
    }
}

/// A program that runs, and is ended with the value.
pub struct Running(Child);

/// Much longer than anything here takes, and much shorter than a picture that never ends.
const PATIENCE: Duration = Duration::from_secs(60);

impl Running {
    pub fn start(command: &mut Command) -> Self {
        Running(command.spawn().unwrap())
    }

    /// One that has been started.
    pub fn of(child: Child) -> Self {
        Running(child)
    }

    #[cfg(unix)]
    pub fn number(&self) -> u32 {
        self.0.id()
    }

    /// Waits until something is true.
    #[cfg(unix)]
    pub fn until(&mut self, is_true: impl Fn() -> bool) {
        let start = Instant::now();
        while !is_true() {
            assert_eq!(self.0.try_wait().unwrap(), None, "it has ended");
            assert!(start.elapsed() < PATIENCE, "it still is not true");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits until the program ends by itself.
    pub fn end(mut self) -> ExitStatus {
        let start = Instant::now();
        loop {
            if let Some(status) = self.0.try_wait().unwrap() {
                return status;
            }
            assert!(start.elapsed() < PATIENCE, "it still runs");
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended, and then there is nothing to do.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}
