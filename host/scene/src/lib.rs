//! Scenes of strahl: their description, and the formats that they are read from.
//!
//! [`load()`] reads a file of any format into a [`LoadedScene`], which is neutral:
//! nothing is derived, and both precisions see the same numbers.
//!
//! | module | what it does |
//! |---|---|
//! | [`mod@load`] | a file of any format becomes a description |
//! | [`toml_scene`] | scenes in TOML |
//! | `nff` | scenes in NFF |
//! | [`mesh`] | OBJ with MTL, PLY and glTF |
//! | [`procedural`] | scenes that formulas make |
//! | [`effects`] | the effects that a scene calls for, and why |
//! | `bounds`, `framing` | where things are, and from where all of them are seen |
//! | [`source_files`] | the files that a scene is made of |
//! | [`error`], [`diagnostics`] | why a scene could not be loaded, shown as a compiler would |
//! | [`description`] | a scene in neutral numbers |
//! | [`quantity`] | numbers with their nouns |
//!
//! This package knows no command line, no tracer and no threads. It uses plain types of `strahl-core`.

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
