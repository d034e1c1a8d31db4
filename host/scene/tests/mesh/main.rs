//! Mesh files through the public API: contents, errors, and the default camera.

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
