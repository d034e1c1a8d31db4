//! strahl's core: a Whitted ray tracer that needs no operating system, no heap and no recursion.
//!
//! # Modules
//!
//! The root has the names that a first program needs; everything else is in the module of its layer. A
//! module uses only those below it.
//!
//! | module | contents |
//! |---|---|
//! | [`render`](mod@render) | [`render()`], and pictures of which only some pixels are traced |
//! | [`image`] | pixels, samplers, where pixels go |
//! | [`trace`] | [`Tracer`], [`Worker`], [`RayTracer`](trace::RayTracer), [`Limits`] |
//! | [`shade`] | reflection, refraction, media |
//! | [`baked`] | scenes in bytes, traced where they lie (feature `baked`) |
//! | [`scene`] | [`Scene`], [`Camera`], materials, lights, textures, effects, [`World`] |
//! | [`accel`] | accelerators: lists, grid, octree, bounding volume hierarchy |
//! | [`tally`] | reports of the tracer's work, and what counts them |
//! | [`geometry`] | shapes, rays, bounds, hits |
//! | [`math`] | [`Real`], [`Vec3`], [`Rgb`], roots, random numbers |
//!
//! # Rules
//!
//! 1. *Memory buys time, never truth.* Accelerator, worker, order of pixels: each may change
//!    how long a picture takes, none may change one bit of it.
//! 2. *The same bits everywhere.* Only IEEE 754's basic operations and libm, in one order.
//! 3. *Pay only for what the scene calls for.* [`Effects`](scene::Effects) is a constant of a tracer's type:
//!    what is outside is compiled away.
//! 4. *The tracing loop cannot fail.* Errors are returned by [`Scene::new`],
//!    [`Camera::new`], [`Tracer::new`] and builders of accelerators.
//! 5. *`t_max` has one owner*, the [`Query`](accel::Query).
//!
//! # Features
//!
//! * `alloc`: [`scene::SceneTables`], a scene that owns its tables.
//! * `baked`: [`baked`], scenes in bytes.
//! * `display`: [`image::DrawTargetSink`], which draws on every target of `embedded-graphics`.
//!
//! The names of the root stand beside `embedded_graphics::prelude`:
//!
#![cfg_attr(feature = "display", doc = "```")]
#![cfg_attr(not(feature = "display"), doc = "```ignore")]
//! use embedded_graphics::mock_display::MockDisplay;
//! use embedded_graphics::pixelcolor::Rgb565;
//! use embedded_graphics::prelude::*;
//! use strahl_core::image::{Dither, DrawTargetSink};
//! use strahl_core::*;
//!
//! let scene = Scene::new(SceneDescriptor { background: Background::Color(Rgb::WHITE), ..SceneDescriptor::EMPTY })?;
//! let world = World::new(scene, BareList(0));
//! let projection = Projection::Perspective { field_of_view: 1.0 };
//! let view = CameraDescriptor { position: Vec3::ZERO, target: vec3(0.0, 0.0, -1.0), up: Vec3::Y, projection };
//! let resolution = Resolution::new(2, 1).unwrap();
//! let tracer = Tracer::<_, AllEffects, 1>::new(
//!     &world,
//!     Camera::new(&view, resolution)?,
//!     Limits { levels: 1, ..Limits::DEFAULT },
//! )?;
//!
//! let mut screen = MockDisplay::<Rgb565>::new();
//! Pixel(Point::new(3, 0), Rgb565::RED).draw(&mut screen)?;
//! let mut display = DrawTargetSink::new(&mut screen, Point::zero(), Dither::None);
//! let pixels = Tile::full(resolution).pixels();
//! render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, pixels, &mut display)?;
//! screen.assert_pattern(&["WW R"]);
//! assert_eq!(screen.affected_area().size, Size::new(4, 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Double precision
//!
//! The package `strahl-core-double` compiles these sources with `Real = f64`. Types that hold no [`Real`] are
//! one type for both.

#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
// Comparisons that are false for NaN are written as they are meant: `!(x > 0.0)`.
#![allow(clippy::neg_cmp_op_on_partial_ord)]
// Law 4. The panic proof checks what is reachable; these lints name the line.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::todo,
        clippy::unimplemented,
        clippy::indexing_slicing,
        clippy::dbg_macro
    )
)]

#[cfg(feature = "alloc")]
extern crate alloc;

pub mod math;
#[cfg(not(feature = "double"))]
mod set;

pub mod geometry;

pub mod tally;

pub mod accel;

pub mod scene;

#[cfg(feature = "baked")]
pub mod baked;

pub mod shade;

pub mod trace;

pub mod image;

pub mod render;

pub use accel::BareList;
pub use geometry::{Geometry, Plane, Shape, Sphere};
pub use image::{CenterSampler, Tile};
pub use math::{Real, Rgb, Vec3, vec3};
pub use render::render;
#[cfg(feature = "alloc")]
pub use scene::SceneTables;
pub use scene::{
    AllEffects, Background, Camera, CameraDescriptor, Falloff, Light, LightSource, Material, MaterialId,
    Projection, Resolution, Scene, SceneDescriptor, World,
};
pub use trace::{Limits, Tracer, Worker};
