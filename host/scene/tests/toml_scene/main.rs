//! Scenes in TOML through the public API: contents and errors.

mod aliases;
mod defaults;
mod meshes;
mod mutations;
mod right;
mod scenes;
mod shown;
mod syntax;
mod text;
mod wrong;
