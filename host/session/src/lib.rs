//! Renders scenes of the ray tracer strahl from a program: start here.
//!
//! [`render`] renders one picture of a loaded scene.
//!
//! ```
//! use std::path::PathBuf;
//!
//! use strahl_core::Resolution;
//! use strahl_engine::{NoProgress, RenderOptions};
//! use strahl_scene::{SourceFiles, load_from};
//! use strahl_settings::Settings;
//!
//! // A scene file on disk is loaded with `strahl_scene::load`.
//! let toml = b"sphere = [{ center = [0, 1, 0], radius = 1 }]";
//! let (path, size) = (PathBuf::from("sphere.toml"), Resolution::new(32, 24).unwrap());
//! let files = SourceFiles::from_memory([(path.clone(), toml.to_vec())]);
//! let scene = load_from(&files, &path, size)?;
//!
//! let output = strahl_session::render(&scene, &Settings::of_size(size), &RenderOptions::default(), &NoProgress)?;
//! assert_eq!(output.picture.size, size);
//! assert!(output.counters.camera_hits > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! For several pictures of a scene, or for single rays, open the scene once. A [`SceneStorage`] holds the tables of the
//! scene in single or double precision. A [`Session`] borrows it, builds the accelerator, renders pictures and finds the
//! hits of rays; its methods are the same in both precisions.
//!
//! ```
//! # use std::path::Path;
//! # use strahl_core::Resolution;
//! # use strahl_engine::{NoProgress, RenderOptions};
//! # use strahl_scene::{SourceFiles, load_from};
//! # use strahl_settings::Settings;
//! # let files = SourceFiles::from_memory([("sphere.toml".into(), b"sphere = [{ radius = 1 }]".to_vec())]);
//! # let size = Resolution::new(32, 24).unwrap();
//! # let scene = load_from(&files, Path::new("sphere.toml"), size)?;
//! use strahl_session::{SceneStorage, Session};
//!
//! let settings = Settings::of_size(size);
//! let mut storage = SceneStorage::new(&scene, settings.precision);
//! let session = Session::new(&mut storage, &settings.acceleration())?;
//! let picture = session.render(&settings, &RenderOptions::default(), &NoProgress)?.picture;
//! let fewer_levels = Settings { levels: 1, ..settings };
//! let other = session.render(&fewer_levels, &RenderOptions::default(), &NoProgress)?.picture;
//! assert_eq!(picture.size, other.size);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | contents |
//! |---|---|
//! | [`session`] | [`Session`]: renders pictures, also progressively, and answers ray queries |
//! | [`tables`] | conversion of a loaded scene to the tables of the core, in single and double precision |
//! | [`stats`] | the statistics of a picture, as JSON |
//! | [`scene_info`] | the contents of a scene and its required effects, as JSON |
//! | [`rays`] | rays read and hits written as CSV |
//! | [`explain`] | the ray tree of one pixel |
//!
//! The package has no command line and no terminal.

pub mod explain;
pub mod rays;
pub mod scene_info;
pub mod session;
pub mod stats;
pub mod tables;

pub use session::{RenderOutput, SceneStorage, Session, render};
