//! Files of triangles: OBJ with MTL, PLY and glTF 2.0.
//!
//! Each format has a module that reads its words; what they find is gathered by the same rules:
//!
//! * Polygons are cut into triangles, concave ones too.
//! * Where some corners have normals and others none, or one that is zero, the others get that
//!   of their triangle. Where none has one the mesh stays flat: nothing is smoothed that the
//!   file does not ask for.
//! * A triangle without area keeps its number; one warning counts them.
//! * What has no place in a mesh (lines, textures, colours of corners ...) is counted in a
//!   warning for each kind.
//! * No number in a file is believed before as much data has been seen, so memory is bounded
//!   by a multiple of the sizes of the files, except that glTF may place one mesh many times.

mod builder;
mod default_view;
mod error;
mod gltf;
mod groups;
mod lines;
mod mtl;
mod obj;
mod ply;
mod read;
mod triangulate;

pub use groups::{MaterialGroup, TriangleMesh};
pub use read::{EXTENSIONS, is_mesh, read, read_from};
pub(crate) use read::{default_scene, read_referenced};
