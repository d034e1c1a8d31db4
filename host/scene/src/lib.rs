//! Loads scene files of strahl in TOML, NFF, OBJ, PLY and glTF, reports their errors, and generates procedural scenes.
//!
//! [`load()`] reads a file of any format. The result, a [`LoadedScene`], is the same plain description for all formats and
//! for both precisions. [`load_from`] reads the files from memory instead of the disk.
//!
//! ```
//! use std::path::Path;
//!
//! use strahl_scene::{SourceFiles, load_from};
//! use strahl_settings::DEFAULT_SIZE;
//!
//! let text = "[[sphere]]\nradius = 2\nmaterial = { color = 'red' }\n";
//! let files = SourceFiles::from_memory([("scene.toml".into(), text.into())]);
//! let scene = load_from(&files, Path::new("scene.toml"), DEFAULT_SIZE).unwrap();
//! assert_eq!(scene.objects[0].shape.name(), "sphere");
//! // The file has no camera and no light, so defaults are added.
//! assert_eq!(scene.lights.len(), 1);
//! ```
//!
//! | module | contents |
//! |---|---|
//! | [`mod@load`] | loading of a file in any format |
//! | [`toml_scene`] | scenes in TOML, and their JSON Schema |
//! | `nff` | scenes in NFF |
//! | [`mesh`] | triangle meshes in OBJ with MTL, PLY and glTF |
//! | [`procedural`] | procedural scenes of any size |
//! | [`effects`] | the effects that a scene requires, with reasons |
//! | `bounds`, `framing` | bounding boxes of objects, and the camera distance that shows them all |
//! | [`source_files`] | source files on disk or in memory |
//! | [`error`], [`diagnostics`] | loading errors, and their display with source excerpts |
//! | [`description`] | the loaded scene |
//! | [`quantity`] | numbers with nouns, for messages |
//!
//! The package has no command line, no ray tracer and no threads. It uses plain types of `strahl-core`.

mod bounds;
pub mod description;
pub mod diagnostics;
pub mod effects;
pub mod error;
mod framing;
mod limits;
pub mod load;
pub mod mesh;
mod nff;
pub mod procedural;
pub mod quantity;
mod quote;
pub mod source_files;
pub mod toml_scene;

pub use description::LoadedScene;
pub use diagnostics::{Diagnostic, Diagnostics};
pub use error::LoadError;
pub use load::{load, load_for_size, load_from};
pub use source_files::SourceFiles;
