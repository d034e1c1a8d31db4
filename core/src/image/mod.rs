//! Pictures: which rays make a pixel, and where pixels go.

mod adaptive;
mod agreement;
mod corners;
#[cfg(feature = "display")]
mod display;
#[cfg(not(feature = "double"))]
mod filter;
mod filter_sample;
mod kept;
#[cfg(not(feature = "double"))]
mod pixel;
mod quarter;
mod regular;
mod sampler;
mod selected;
mod single;
mod sink;
mod stochastic;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::image::{self as filter, self as pixel};

pub use adaptive::{Adaptive, Corner, Part, Parting};
pub use agreement::Agreement;
pub use corners::{CornerRow, Corners, Every, Lattice, Loose};
#[cfg(feature = "display")]
pub use display::{Display, Dither, Steps};
pub use filter::Filter;
pub use kept::Kept;
pub use pixel::{Pixel, Tile};
pub use regular::Regular;
pub use sampler::Sampler;
pub use selected::{Selected, Selection};
pub use single::Single;
pub use sink::{Frame, Record, Sink};
pub use stochastic::{Confidence, Gathered, Stochastic};
