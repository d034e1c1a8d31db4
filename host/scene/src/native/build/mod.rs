//! What has been read becomes a description.

mod background;
mod builder;
mod camera;
mod lights;
mod materials;
mod mesh_files;
mod meshes;
mod motion;
mod objects;
mod settings;
mod thing;
mod turn;
mod whole;

pub use builder::SceneBuilder;
pub use mesh_files::MeshFiles;
