//! What has been read becomes a description.

mod add_to_scene;
mod background;
mod builder;
mod camera;
mod convert;
mod lights;
mod materials;
mod mesh_files;
mod meshes;
mod motion;
mod objects;
mod rotation;
mod settings;

pub use builder::SceneBuilder;
pub use mesh_files::MeshFiles;
