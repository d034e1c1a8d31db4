//! Pictures: which rays make a pixel, and where pixels go.

mod corners;
mod pixel;
mod regular;
mod sampler;
mod single;
mod sink;

pub use corners::{Corner, CornerRow, Lattice};
pub use pixel::{Pixel, Tile};
pub use regular::Regular;
pub use sampler::Sampler;
pub use single::Single;
pub use sink::{Frame, Sink};
