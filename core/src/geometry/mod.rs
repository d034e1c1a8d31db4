//! Shapes, rays, bounding volumes and intersection tests.
//!
//! All items of a scene are in one slice of [`Shape`]s. A sphere is stored there directly, a triangle as
//! indices into shared tables of vertices and vertex normals, any other shape as an index into a table of
//! its kind ([`Geometry`]). So an item takes 20 bytes in single precision.

mod bounding_sphere;
mod bounds;
mod clamp;
mod cone;
mod cuboid;
mod disc;
#[cfg(not(feature = "double"))]
mod error;
mod hit;
mod intersection;
#[cfg(not(feature = "double"))]
mod item;
#[cfg(not(feature = "double"))]
mod kind;
mod motion;
mod moving;
mod plane;
mod polygon;
mod ranges;
mod ray;
mod shape;
mod sphere;
mod tables;
mod terminator;
mod torus;
mod triangle;
mod triangle4;
mod validate;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::geometry::{self as error, self as item, self as kind};

pub use bounding_sphere::BoundingSphere;
pub(crate) use bounding_sphere::BoundingSphereRay;
pub use bounds::{Aabb, RayInterval};
pub(crate) use bounds::{MAX_FACE_COORDINATE, WIDEN};
pub use cone::Cone;
pub use cuboid::{Cuboid, OrientedCuboid};
pub use disc::Disc;
pub use error::ShapeError;
pub use hit::{Hit, SurfaceInteraction};
pub(crate) use intersection::intersect_triangle;
pub use item::ItemId;
pub use kind::{ShapeKind, ShapeKindSet};
pub use moving::MovingShape;
pub use plane::Plane;
pub use polygon::Polygon;
pub use ray::{Ray, offset_origin};
pub use shape::{Shape, ShapeFeatures};
pub use sphere::Sphere;
pub use tables::Geometry;
pub use torus::Torus;
pub use triangle::has_area;
pub(crate) use triangle4::Triangle4;
