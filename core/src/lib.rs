//! A Whitted ray tracer for `no_std`: it needs no operating system, no heap and no recursion.
//!
//! A program that renders a red sphere:
//!
//! ```
//! use strahl_core::image::Framebuffer;
//! use strahl_core::*;
//!
//! let shapes = [Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 })];
//! let materials = [Material::matte(Rgb::new(0.8, 0.1, 0.1))];
//! let lights = [Light::point(vec3(3.0, 4.0, 5.0), Rgb::WHITE)];
//! let scene = Scene::new(SceneDescriptor {
//!     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
//!     material_ids: &[MaterialId(0)],
//!     materials: &materials,
//!     lights: &lights,
//!     ..SceneDescriptor::EMPTY
//! })?;
//! let world = World::new(scene, ListWithoutBounds(1));
//! let resolution = Resolution::new(64, 48).unwrap();
//! let camera = CameraDescriptor::perspective(vec3(0.0, 0.0, 5.0), Vec3::ZERO, 0.6);
//! let camera = Camera::new(&camera, resolution)?;
//! let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT)?;
//!
//! let (tile, mut picture) = (Tile::full(resolution), [Rgb::BLACK; 64 * 48]);
//! let mut framebuffer = Framebuffer::new(tile, &mut picture).unwrap();
//! let Ok(()) = render(
//!     &mut tracer.with_worker(&mut Worker::new(())), // (): counts nothing
//!     &mut CenterSampler,
//!     tile.pixels(),
//!     &mut framebuffer,
//! );
//! let [red, green, blue] = picture[24 * 64 + 32].to_srgb8();
//! assert!(red > 150 && green == blue && green < red / 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The steps are always these: describe a scene and check it ([`Scene::new`]), combine it with an accelerator
//! ([`World::new`]), make a camera ([`Camera::new`]) and a tracer for the effects that the scene requires
//! ([`Tracer::new`]), and [`render()`] pixels with a sampler into a sink. Each worker has the mutable state
//! of one thread. With a heap, `SceneTables` (feature `alloc`) is the easiest way to describe a scene; a device
//! with one row of memory [renders row by row](mod@render). An *item* is a shape of a scene with its material: what pbrt calls a primitive.
//!
//! # Modules
//!
//! The root has the names that a first program needs; all others are in the module of their layer: textures,
//! effect sets and glass ([`FresnelModel`](scene::FresnelModel)) in [`scene`], the other shapes and
//! [`ItemId`](geometry::ItemId) in [`geometry`]. A module uses only those below it.
//!
//! | module | contents |
//! |---|---|
//! | [`render`](mod@render) | [`render()`], and rendering of selected pixels and in passes |
//! | [`image`] | pixels, samplers, sinks |
//! | [`trace`] | [`Tracer`], [`Worker`], [`RayTracer`](trace::RayTracer), [`Limits`] |
//! | [`shade`] | local illumination, reflection, refraction, media |
//! | `baked` | scenes in bytes, traced in place (feature `baked`) |
//! | [`scene`] | [`Scene`], [`Camera`], materials, lights, textures, effects, [`World`] |
//! | [`accel`] | accelerators: lists, grid, octree, bounding volume hierarchy |
//! | [`tally`] | events of a trace, and counters of them |
//! | [`geometry`] | shapes, rays, bounds, hits |
//! | [`math`] | [`Real`], [`Vec3`], [`Rgb`], roots, random numbers |
//!
//! # Guarantees
//!
//! 1. *The picture does not depend on memory or speed.* Accelerators, caches, workers and the order of pixels change the
//! rendering time and not one bit of the picture.
//! 2. *Reproducible.* Only the basic operations of IEEE 754 and libm are used, in one order, so all machines
//! compute the same bits.
//! 3. *Effects are compiled in.* [`Effects`](scene::Effects) is a constant of the tracer's type; the code of
//! all other effects is compiled away.
//! 4. *Tracing cannot fail.* Errors are returned by [`Scene::new`], [`Camera::new`], [`Tracer::new`] and the
//! builders of accelerators. No reachable code panics.
//! 5. *The query owns `t_max`.* Only the [`Query`](accel::Query) shortens a ray, so all accelerators find the
//! same hits.
//!
//! # Features
//!
//! All are off by default.
//!
//! * `alloc`: `SceneTables`, an owned scene whose tables grow.
//! * `baked`: the module `baked`, scenes in bytes.
//! * `display`: `image::DrawTargetSink`, which draws to displays of `embedded-graphics`.
//!
//! The names of the root do not clash with `embedded_graphics::prelude`:
//!
#![cfg_attr(feature = "display", doc = "```")]
#![cfg_attr(not(feature = "display"), doc = "```ignore")]
//! use embedded_graphics::mock_display::MockDisplay;
//! use embedded_graphics::pixelcolor::Rgb565;
//! use embedded_graphics::prelude::*;
//! use strahl_core::image::{Dither, DrawTargetSink};
//! use strahl_core::*;
//!
//! let background = Background::Color(Rgb::WHITE);
//! let scene = Scene::new(SceneDescriptor { background, ..SceneDescriptor::EMPTY })?;
//! let world = World::new(scene, ListWithoutBounds(0));
//! let resolution = Resolution::new(2, 1).unwrap();
//! let camera = CameraDescriptor::perspective(Vec3::ZERO, vec3(0.0, 0.0, -1.0), 1.0);
//! let camera = Camera::new(&camera, resolution)?;
//! let tracer = Tracer::<_, AllEffects, 5>::new(&world, camera, Limits::DEFAULT)?;
//!
//! let mut screen = MockDisplay::<Rgb565>::new();
//! Pixel(Point::new(3, 0), Rgb565::RED).draw(&mut screen)?;
//! let mut sink = DrawTargetSink::new(&mut screen, Point::zero(), Dither::None);
//! let pixels = Tile::full(resolution).pixels();
//! render(&mut tracer.with_worker(&mut Worker::new(())), &mut CenterSampler, pixels, &mut sink)?;
//! screen.assert_pattern(&["WW R"]);
//! assert_eq!(screen.affected_area().size, Size::new(4, 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Double precision
//!
//! The package `strahl-core-double` compiles the same sources with `Real = f64`. Types without a [`Real`] are
//! one type for both.

#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
// `!(x > 0.0)` is also true for NaN, unlike `x <= 0.0`.
#![allow(clippy::neg_cmp_op_on_partial_ord)]
// Guarantee 4. The panic proof of the firmware tests checks the reachable code; these lints name the line.
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

pub use accel::ListWithoutBounds;
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

/// Compiles the programs of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
