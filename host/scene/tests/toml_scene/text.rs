//! Loading of texts as TOML files.

use std::path::Path;

use strahl_scene::LoadError;
use strahl_scene::description::LoadedScene;
use strahl_scene::diagnostics::Diagnostics;
use strahl_session::tables;

/// Every table, and every key with every form of its value.
pub const ALL: &str = r##"# a scene with everything
background = { below = "#000000", above = [0.5, 0.25, 1.0], up = [0, 0, 2] }

[camera]
from = [0, -8, 1]
at = [0.0, 0.0, 0.5]
up = [0, 0, 1]
angle = 40

[render]
size = [40, 30]
levels = 7
cutoff = 0.25
sampler = "regular:3"

[ambient_light]
color = [0.5, 0.25, 0.125]
intensity = 0.5

[[spot_light]]
name = "lamp"
position = [0, 0, 4]
at = [0, 0, 1]
angle = 60
bright_angle = 30
color = "white"
intensity = 2
falloff = "square"

[[directional_light]]
direction = [1, 2, -3]
color = 0.5
shadows = false

[[point_light]]
position = [4, -3, 2]
color = [1, 0.5, 0.25]
falloff = [1, 0.5, 0.25]

[[sphere]]
center = [0, 0, 1]
radius = 1
material = "glass"

[[plane]]
point = [0, 0, -1]
normal = [0, 0, 2]
material = "floor"

[[disc]]
center = [1, 2, 3]
normal = [0, 3, 0]
radius = 2.5
material = "fading"

[[triangle]]
corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]

[[polygon]]
corners = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]]
normals = [[0, 0, 1], [1, 0, 1], [0, 0, 1], [0, 0, 1], [0, 0, 1]]

[[box]]
min = [-1, -2, -3]
max = [1, 2, 3]

[[sphere]]
radius = 0.5
material = { color = "#ff0000", highlight = 0.25, shininess = 8, ambient = 0.5 }

[[box]]
center = [1, 1, 1]
size = [2, 4, 6]
rotate = [0, 0, 90]

[[cylinder]]
base = [0, 0, 0]
end = [0, 0, 2]
radius = 0.5
open = true

[[cone]]
base = [0, 0, 1]
end = [0, 0, 3]
radius = 1
end_radius = 0.25

[[torus]]
center = [1, 0, 0]
axis = [0, 0, 4]
radius = 2
tube = 0.5

[[triangle]]
corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1]]

[[triangle]]
corners = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]

[[material]]
name = "glass"
color = 0
mirror = 0.125
transmission = [0.75, 0.5, 0.25]
index = 1.25
fresnel = true
clarity = [inf, 2, 0.5]
priority = 3
one_sided = true

[[material]]
name = "floor"
diffuse = 0.5
[material.checker]
even = "white"
odd = [0, 0, 0.5]
origin = [0.5, 0, 0]
size = [2, 2, 0]

[[material]]
name = "fading"
gradient = { from = "black", to = 1, start = [0, 0, 0], end = [0, 0, 2] }
"##;

/// Loads a file with these bytes, in a new folder.
pub fn load(bytes: &[u8]) -> Result<LoadedScene, LoadError> {
    let folder = tempfile::tempdir().unwrap();
    load_in(folder.path(), bytes)
}

/// Loads a file with these bytes in `folder`.
pub fn load_in(folder: &Path, bytes: &[u8]) -> Result<LoadedScene, LoadError> {
    let path = folder.join("a.toml");
    std::fs::write(&path, bytes).unwrap();
    strahl_scene::load(&path)
}

/// The scene in a file with this text, which must be valid in both precisions.
pub fn loaded(text: &str) -> LoadedScene {
    let it = load(text.as_bytes()).unwrap_or_else(|failure| panic!("{failure}\n{text}"));
    assert_eq!(tables::single::scene_tables(&it).scene().err(), None, "{text}");
    assert!(tables::double::scene_tables(&it).scene().is_ok(), "{text}");
    it
}

/// All errors of a file with these bytes.
pub fn diagnostics(bytes: &[u8]) -> Diagnostics {
    let text = String::from_utf8_lossy(bytes);
    match load(bytes).expect_err(&text) {
        LoadError::Diagnostics(diagnostics) => *diagnostics,
        other => panic!("{other}\n{text}"),
    }
}

/// The errors of a file with this text: line, column, underlined text, message and help.
pub fn errors(text: &str) -> Vec<(usize, usize, String, String)> {
    let diagnostics = diagnostics(text.as_bytes());
    let list = diagnostics.list().iter().map(|fault| {
        let (line, column) = diagnostics.line_and_column(fault);
        let message = format!("{}\n{}", fault.message, fault.help.as_deref().unwrap_or_default());
        (line, column, text[fault.span.clone()].to_owned(), message)
    });
    list.collect()
}
