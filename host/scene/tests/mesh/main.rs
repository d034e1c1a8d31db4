//! Files of triangles through the door of the library: what is in them, what is wrong with them,
//! and how they are looked at.

mod files;
mod gltf;
mod mutations;
mod obj;
mod oracle;
mod ply;
mod polygons;
mod random;
mod view;
mod wrong;
