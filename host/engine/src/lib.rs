//! Renders scenes of the ray tracer strahl on a workstation, with all cores.
//!
//! A [`SceneEngine`] holds one scene with the accelerator that the settings ask for. For each picture it chooses the ray
//! tracer that is compiled for the scene's effects, and traces the picture tile by tile. It also answers single rays.
//!
//! | module | what it does |
//! |---|---|
//! | [`engine`] | the trait [`Engine`]: a scene to be rendered, whatever its precision |
//! | [`scene_engine`] | [`SceneEngine`]: a scene with its accelerator |
//! | [`accelerators`] | builds the accelerator that the settings ask for |
//! | [`world`] | a scene with an accelerator of any type |
//! | [`effects`] | which ray tracer a scene gets: its effect set, and what it counts |
//! | `prepared` | the prepared effect sets |
//! | [`ray_tracer`] | one ray tracer for each tile |
//! | [`samplers`] | the sampler that the settings ask for |
//! | [`tiles`] | tiles and threads |
//! | [`passes`] | a picture that becomes better pass by pass |
//! | [`cost_counting`] | charges every camera ray to its pixel |
//! | [`hits`] | the nearest hit along single rays |
//! | [`options`] | what else a render is asked for beside its settings |
//! | [`output`] | what comes of rendering, or why nothing does |
//! | [`progress`] | how far the work is, and whether it should go on |
//! | [`scheduler`] | what comes next in a picture that becomes better pass by pass |
//! | [`cost_map`], [`mask`], [`ray_query`] | costs of pixels, some pixels, single rays |
//!
//! ```
//! use strahl_core::{CameraDescriptor, Material, Projection, Resolution, SceneTables, Sphere, vec3};
//! use strahl_engine::{AccelMemory, Engine, NoProgress, RenderOptions, SceneEngine};
//! use strahl_settings::{AccelSettings, Settings};
//!
//! let mut tables = SceneTables::new();
//! let matte = tables.add_material(Material::matte(Rgb::WHITE));
//! tables.add_sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 }, matte);
//! let view = CameraDescriptor {
//!     position: vec3(0.0, 0.0, 0.0),
//!     target: vec3(0.0, 0.0, -1.0),
//!     up: vec3(0.0, 1.0, 0.0),
//!     projection: Projection::Perspective { field_of_view: 1.0 },
//! };
//!
//! let mut memory = AccelMemory::default();
//! let engine = SceneEngine::new(tables.scene()?, view, &AccelSettings::DEFAULT, &mut memory)?;
//! let settings = Settings { size: Resolution::new(32, 24).unwrap(), ..Settings::default() };
//! let rendered = engine.render(&settings, &RenderOptions::default(), &NoProgress)?;
//! assert_eq!(rendered.colors.len(), 32 * 24);
//! assert!(rendered.counters.camera_hits > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! This package knows no scene file, no command line and no terminal. It is compiled once more, for double precision, as
//! `strahl-engine-double`: there `strahl_core` is the package `strahl-core-double`, and the modules that hold no `Real` are
//! those of this package.

#[cfg(not(feature = "double"))]
pub mod cost_map;
#[cfg(not(feature = "double"))]
pub mod engine;
#[cfg(not(feature = "double"))]
pub mod mask;
#[cfg(not(feature = "double"))]
pub mod options;
#[cfg(not(feature = "double"))]
pub mod output;
#[cfg(not(feature = "double"))]
pub mod progress;
#[cfg(not(feature = "double"))]
pub mod ray_query;
#[cfg(not(feature = "double"))]
pub mod scheduler;

pub mod accelerators;
pub mod cost_counting;
pub mod effects;
pub mod hits;
pub mod passes;
#[cfg(not(feature = "double"))]
pub mod prepared;
pub mod ray_tracer;
pub mod samplers;
pub mod scene_engine;
pub mod tiles;
pub mod world;

#[cfg(feature = "double")]
pub use strahl_engine::{cost_map, engine, mask, options, output, progress, ray_query, scheduler};

pub use accelerators::AccelMemory;
pub use cost_map::CostMap;
pub use engine::Engine;
pub use mask::Mask;
pub use options::RenderOptions;
pub use output::{AccelStats, RenderError, Rendered, SceneStats};
pub use progress::{Interrupt, NoProgress, Progress};
pub use ray_query::{RayCaster, RayHit, RayQuery};
pub use scene_engine::SceneEngine;
pub use scheduler::Scheduler;
