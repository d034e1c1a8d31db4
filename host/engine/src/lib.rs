//! Renders scenes of the ray tracer strahl on a workstation, on all cores.
//!
//! A [`SceneEngine`] holds a scene with an acceleration structure. For each picture it selects the ray tracer that is compiled
//! for the effects of the scene, and renders the picture tile by tile. It also traces single rays. `strahl-session` opens a
//! scene file with this package, in single or double precision.
//!
//! | module | contents |
//! |---|---|
//! | [`engine`] | the trait [`Engine`]: a scene that can be rendered, in any precision |
//! | [`scene_engine`] | [`SceneEngine`]: a scene with its acceleration structure |
//! | [`accelerators`] | construction of acceleration structures |
//! | [`world`] | a scene with an acceleration structure of any type |
//! | [`effects`] | selection of the ray tracer for an effect set, with or without counters |
//! | `prepared` | the effect sets for which ray tracers are compiled |
//! | [`ray_tracer`] | ray tracers of tiles |
//! | [`samplers`] | selection of a sampler |
//! | [`tiles`] | rendering of tiles by all threads |
//! | [`passes`] | progressive rendering |
//! | [`cost_counting`] | cost of each pixel, counted during rendering |
//! | [`hits`] | nearest hits of single rays |
//! | [`options`] | options of a render beside its settings |
//! | [`output`] | rendered pictures, statistics and errors |
//! | [`progress`] | progress reports and cancellation |
//! | [`scheduler`] | schedule of progressive rendering |
//! | [`cost_map`], [`mask`], [`ray_query`] | cost maps, pixel masks, single rays |
//!
//! ```
//! use strahl_core::{CameraDescriptor, Material, Projection, Resolution, Rgb, SceneTables, Sphere, vec3};
//! use strahl_engine::{AccelMemory, Engine, NoProgress, RenderOptions, SceneEngine};
//! use strahl_settings::{AccelSettings, Settings};
//!
//! let mut tables = SceneTables::new();
//! let matte = tables.add_material(Material::matte(Rgb::WHITE));
//! tables.add_sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 }, matte);
//! let camera = CameraDescriptor {
//!     position: vec3(0.0, 0.0, 0.0),
//!     target: vec3(0.0, 0.0, -1.0),
//!     up: vec3(0.0, 1.0, 0.0),
//!     projection: Projection::Perspective { field_of_view: 1.0 },
//! };
//!
//! let mut memory = AccelMemory::default();
//! let engine = SceneEngine::new(tables.scene()?, camera, &AccelSettings::DEFAULT, &mut memory)?;
//! let settings = Settings { size: Resolution::new(32, 24).unwrap(), ..Settings::default() };
//! let rendered = engine.render(&settings, &RenderOptions::default(), &NoProgress)?;
//! assert_eq!(rendered.colors.len(), 32 * 24);
//! assert!(rendered.counters.camera_hits > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The package has no scene files, no command line and no terminal. The same sources are compiled for double precision as
//! `strahl-engine-double`: there `strahl_core` is the package `strahl-core-double`, and modules without `Real` are
//! re-exported from this package.

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
pub use ray_query::{RayCaster, RayHit, RayInput};
pub use scene_engine::SceneEngine;
pub use scheduler::Scheduler;
