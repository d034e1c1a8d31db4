//! Loading of texts as NFF files.

use std::io::Write;

use strahl_scene::LoadError;
use strahl_scene::description::LoadedScene;
use tempfile::NamedTempFile;

/// Every entity, in every form that it has.
pub const ALL: &str = "\
# a scene with everything
b 0.125 0.25 0.5
v
from 0 -8 1
at 0 0 0.5
up 0 0 1
angle 40
hither 1
resolution 40 30
l 4 -3 2   # without a colour
l -4 -3 2 1 0.5 0.25
f 1 0.75 0.5 0.5 0.25 8 0 0
s 0 0 0 1
c
0 0 1 0.5
0 0 2 0
p 3
-1 0 0
1 0 0
0 0 1
p 5
0 0 0
4 0 0
4 4 0
2 1 0
0 4 0
f 1 1 1 0 0 100000 0.5 1.5
pp 3
-1 0 0 0 -1 0
1 0 0 1 -1 0
0 0 1 0 -1 1
pp 4
0 0 0 0 0 1
1 0 0 0 0 1
1 1 0 0 1 1
0 1 0 0 1 1
";

/// A temporary file with these bytes.
pub fn file_of(bytes: &[u8]) -> NamedTempFile {
    let mut file = tempfile::Builder::new().suffix(".nff").tempfile().unwrap();
    file.write_all(bytes).unwrap();
    file
}

/// The scene in a file with this text.
pub fn loaded(text: &str) -> LoadedScene {
    strahl_scene::load(file_of(text.as_bytes()).path()).unwrap_or_else(|failure| panic!("{failure}\n{text}"))
}

/// The line and the message of the error of a file with these bytes.
pub fn refused(bytes: &[u8]) -> (usize, String) {
    let file = file_of(bytes);
    let text = String::from_utf8_lossy(bytes);
    let failure = strahl_scene::load(file.path()).expect_err(&text);
    assert!(matches!(failure, LoadError::Invalid { .. } | LoadError::Diagnostics(_)), "{failure}\n{text}");
    match failure {
        LoadError::Invalid { path, line: Some(line), reason } if path == file.path() => (line, reason),
        other => panic!("{other:?}\n{text}"),
    }
}
