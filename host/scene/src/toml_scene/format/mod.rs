//! The tables of the format and their keys. `scenes/FORMAT.md` describes the same at length.
//!
//! What is said of a table and of a key here is what an editor shows, by way of the schema.
//! An `Option` has a default, which is told with the key; everything else must be there.

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
