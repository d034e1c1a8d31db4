//! Triangle meshes in OBJ with MTL, PLY and glTF 2.0.
//!
//! Each format has a module that reads it; all of them build the mesh by the same rules:
//!
//! * Polygons, also concave ones, are triangulated.
//! * If only some vertices have normals, the others, and those with a zero normal, get the normal of their triangle. If
//!   no vertex has a normal, the mesh is flat: nothing is smoothed unless the file requests it.
//! * A triangle without area keeps its index; one warning counts them.
//! * Unsupported features (lines, textures, vertex colors ...) are skipped, with one warning for each kind.
//! * A count in a file is trusted only if the file has that much data, so that memory is bounded by a multiple of the
//!   file sizes; only glTF can instantiate one mesh many times.

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
