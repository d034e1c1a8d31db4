//! Scenes in TOML through the door of the library: what they describe, and what is wrong with
//! them.

mod aliases;
mod defaults;
mod meshes;
mod mutations;
mod right;
mod scenes;
mod shown;
mod syntax;
mod table;
mod text;
mod wrong;
