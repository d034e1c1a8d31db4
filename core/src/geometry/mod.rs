//! Shapes, rays, bounding volumes and intersection tests.
//!
//! All items of a scene are in one slice of [`Shape`]s. A sphere is stored there directly, a triangle as
//! indices into shared tables of vertices and vertex normals, any other shape as an index into a table of
//! its kind ([`Geometry`]). So an item takes 20 bytes in single precision.

mod ball;
mod bounds;
mod check;
mod clamp;
mod cone;
mod cuboid;
mod disc;
#[cfg(not(feature = "double"))]
mod fault;
mod four;
mod hit;
#[cfg(not(feature = "double"))]
mod item;
#[cfg(not(feature = "double"))]
mod kind;
mod meet;
mod motion;
mod moving;
mod plane;
mod polygon;
mod ray;
mod shape;
mod sphere;
mod tables;
mod terminator;
mod torus;
mod triangle;
mod validate;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::{self as fault, self as item, self as kind};

pub use ball::BoundingSphere;
pub(crate) use ball::BoundingSphereRay;
pub(crate) use bounds::WIDEN;
pub use bounds::{Aabb, RayInterval};
pub use cone::Cone;
pub use cuboid::{Cuboid, OrientedCuboid};
pub use disc::Disc;
pub use fault::ShapeError;
pub(crate) use four::Triangle4;
pub use hit::{Hit, SurfaceInteraction};
pub use item::ItemId;
pub use kind::{ShapeKind, ShapeSet};
pub(crate) use meet::intersect_triangle;
pub use moving::MovingShape;
pub use plane::Plane;
pub use polygon::Polygon;
pub use ray::{Ray, offset_origin};
pub use shape::{Shape, ShapeFeatures};
pub use sphere::Sphere;
pub use tables::Geometry;
pub use torus::Torus;
pub use triangle::has_area;
