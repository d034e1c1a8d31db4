//! The front door of strahl on a workstation: a scene is opened once, in the requested precision, then rendered and queried.
//!
//! A [`SceneStorage`] holds the tables of a scene, a [`Session`] its accelerator. Both engines, for single and for double
//! precision, are behind the same methods.
//!
//! | module | contents |
//! |---|---|
//! | [`session`] | [`Session`]: pictures, pass by pass if requested, and ray queries |
//! | [`tables`] | the tables of a scene, for either core |
//! | [`stats`] | statistics of a picture |
//! | [`scene_info`] | the contents of a scene |
//! | [`rays`] | rays and hits as CSV |
//! | [`explain`] | the ray tree of one pixel |
//!
//! ```
//! use std::path::PathBuf;
//!
//! use strahl_core::Resolution;
//! use strahl_engine::{NoProgress, RenderOptions};
//! use strahl_scene::{SourceFiles, load_from};
//! use strahl_session::{SceneStorage, Session};
//! use strahl_settings::Settings;
//!
//! let toml = b"sphere = [{ center = [0, 1, 0], radius = 1 }]";
//! let (path, size) = (PathBuf::from("ball.toml"), Resolution::new(32, 24).unwrap());
//! let files = SourceFiles::from_memory([(path.clone(), toml.to_vec())]);
//! let description = load_from(&files, &path, size)?;
//!
//! let settings = Settings::of_size(size);
//! let mut storage = SceneStorage::new(&description, settings.precision);
//! let session = Session::new(&mut storage, &settings.acceleration())?;
//! let output = session.render(&settings, &RenderOptions::default(), &NoProgress)?;
//! assert_eq!(output.picture.size, size);
//! assert!(output.counters.camera_hits > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! This package knows no command line and no terminal.

pub mod explain;
pub mod rays;
pub mod scene_info;
pub mod session;
pub mod stats;
pub mod tables;

pub use session::{RenderOutput, SceneStorage, Session, render};
