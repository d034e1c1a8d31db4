//! strahl's core: a Whitted ray tracer that needs no operating system, no heap and no recursion.
//!
//! # The house
//!
//! A floor uses only what lies below it.
//!
//! | floor | rooms |
//! |---|---|
//! | the front door | [`render()`], [`Counters`], [`RayCounters`] |
//! | pictures | pixels, [`Sampler`]s, [`Sink`]s |
//! | rays | the loop ([`Tracer`]), its tasks, the [`Worker`] |
//! | light | the local model, shadows, optics, media |
//! | the scene | [`Scene`], [`Camera`], [`Material`], [`Light`], [`Texture`], [`Effects`], [`World`] |
//! | finding | [`Accelerator`] and [`Query`]: the contract; [`List`], [`Grid`], [`Octree`], the [`Mailbox`] |
//! | reports | [`Tally`], [`Event`], [`Step`] |
//! | things | [`Shape`]s, [`Ray`], [`Aabb`], [`Hit`] and [`SurfaceInteraction`] |
//! | ground | [`Real`], [`Vec3`], [`Rgb`], roots |
//!
//! # The laws
//!
//! 1. *Memory buys time, never truth.* Accelerator, worker, order of pixels: each may change
//!    how long a picture takes, none may change one bit of it.
//! 2. *The same bits everywhere.* Only IEEE 754's basic operations and libm, in one order.
//! 3. *Pay only for what the scene calls for.* [`Effects`] is a constant of a tracer's type:
//!    what is outside is compiled away.
//! 4. *The tracing loop cannot fail.* Errors live at the doors: [`Scene::new`],
//!    [`Camera::new`], [`Tracer::new`], builders of accelerators.
//! 5. *The far limit has one owner*, the [`Query`].
//!
//! # The twin
//!
//! The package `strahl-core-double` compiles these sources with `Real = f64`.

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

mod math;
#[cfg(not(feature = "double"))]
mod set;

mod geometry;

mod tally;

mod accel;

mod scene;

mod shade;

mod trace;

mod image;

mod render;

pub use accel::{
    Accelerator, BareList, Buffer, BuildError, Bvh, BvhBuilder, BvhNode, BvhSize, Grid, GridSize,
    LeafElement, LeafEntry, LeafLayout, List, Mailbox, Octree, OctreeLimits, OctreeNode, OctreeSize, Query,
    StaticGrid, TraversalHeap, TraversalQueue, TraversalStack, TriangleBlock, group_count,
};
pub use geometry::{
    Aabb, BoundingSphere, Cone, Cuboid, Disc, Geometry, Hit, ItemId, MovingShape, OrientedCuboid, Plane,
    Polygon, Ray, RayInterval, Shape, ShapeError, ShapeFeatures, ShapeKind, ShapeSet, Sphere,
    SurfaceInteraction, Torus, has_area, offset_origin,
};
pub use image::{
    Adaptive, Agreement, Confidence, Corner, CornerRow, Corners, Every, Filter, Frame, Gathered, Kept,
    Lattice, Loose, Part, Parting, Pixel, Record, Regular, Sampler, Selected, Selection, Single, Sink,
    Stochastic, Tile,
};
#[cfg(feature = "display")]
pub use image::{Display, Dither, Steps};
pub use math::{
    Axis, CubicRoots, Dimension, MAX_COORDINATE, PI, ROUNDOFF, Real, Rgb, SobolSequence, Vec3,
    bracketed_root, cubic_roots, difference_of_products, gamma, sqrt, try_normalize, vec3,
};
pub use render::{render, render_refined, render_selected};
pub use scene::{
    Background, Camera, CameraSample, EffectSet, Effects, Everything, Falloff, FilmPoint, Interface,
    LastLevel, Light, LightKind, LightSet, Material, MaterialFault, MaterialId, Parts, Projection, Scene,
    SceneError, Size, Source, Texture, TextureId, TextureKind, TextureSet, View, ViewFault, World,
};
#[cfg(feature = "baked")]
pub use scene::{Baking, Finder, Pack, PackError, PackPart};
#[cfg(feature = "alloc")]
pub use scene::{SceneTables, Shading};
pub use shade::{Crossing, Media, Refraction, absorbed, index, reflected, refracted};
pub use tally::{
    Counters, Event, Fate, Lit, PerRayKind, PerShapeKind, RayCounters, RayKind, Step, Tally, UnsentRays,
};
pub use trace::{HitId, Limits, PixelSample, RayTracer, Tracer, TracerError, Worker};
