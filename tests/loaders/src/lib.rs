//! Checks of the loaders and of the opening of baked scenes, shared by tests and fuzz targets.
//!
//! A program that links this library counts its memory: see [`memory`].

pub mod baked;
pub mod invalid_nff;
pub mod invalid_toml;
pub mod loading;
pub mod memory;
