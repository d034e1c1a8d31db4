//! The tables of the format and their keys. `scenes/FORMAT.md` describes the same at length.
//!
//! What is said of a table and of a key here is what an editor shows, by way of the schema.
//! An `Option` has a default, which is told with the key; everything else must be there.

mod file;
mod lights;
mod material;
mod objects;
mod render;
mod surface;

pub use file::{Background, Camera, File};
pub use lights::{RectangleLight, SpotLight};
pub use material::Material;
pub use objects::{Box, Cone, Cylinder, Disc, Mesh, Plane, Polygon, Sphere, Torus, Triangle};
pub use render::Render;
pub use surface::Surface;
