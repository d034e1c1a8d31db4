//! The tables of the format and their keys; `scenes/FORMAT.md` describes them at length.
//!
//! The doc comments of tables and keys are the descriptions in the JSON Schema, which editors show. An `Option` has a
//! default, named in its description; all other keys are required.

mod file;
mod lights;
mod material;
mod material_ref;
mod objects;
mod render;

pub use file::{BackgroundTable, CameraTable, SceneFile};
pub use lights::{RectangleLightTable, SpotLightTable};
pub use material::MaterialTable;
pub use material_ref::MaterialRef;
pub use objects::{
    BoxTable, ConeTable, CylinderTable, DiscTable, MeshTable, PlaneTable, PolygonTable, SphereTable,
    TorusTable, TriangleTable,
};
pub use render::RenderTable;
