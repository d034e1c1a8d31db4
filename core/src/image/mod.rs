//! Pictures: samplers choose the camera rays of each pixel, sinks receive the finished pixels.
//!
//! A [`Sampler`] combines the samples of one pixel: [`CenterSampler`], [`RegularSampler`],
//! [`StochasticSampler`] or [`AdaptiveSampler`]. All but the first smooth edges (antialiasing) with several rays
//! per pixel. A [`PixelSelector`] traces some pixels and interpolates the
//! others. A [`Sink`] receives pixels, such as a [`Framebuffer`].

mod adaptive;
mod center;
mod contrast;
mod corner_cache;
#[cfg(feature = "display")]
mod draw_target;
#[cfg(not(feature = "double"))]
mod filter;
mod filter_sample;
#[cfg(not(feature = "double"))]
mod pixel;
mod pixel_estimate;
mod pixel_selection;
mod pixel_selector;
mod quadtree;
mod regular;
mod sample_cache;
mod sampler;
mod sink;
mod stochastic;

// Without `Real`: one type for both precisions.
#[cfg(feature = "double")]
use strahl_core::image::{self as filter, self as pixel};

pub use adaptive::{AdaptiveSampler, Subdivision, Subpixel, UpperLeftCornerSampler};
pub use center::CenterSampler;
pub use contrast::ContrastThreshold;
pub use corner_cache::{CornerCache, CornerRowCache, PretracedCorners, StridedSampler, UncachedCorners};
#[cfg(feature = "display")]
pub use draw_target::{Dither, DrawTargetSink, FromChannels};
pub use filter::Filter;
pub use pixel::{Pixel, Tile};
pub use pixel_estimate::PixelEstimate;
pub use pixel_selection::PixelSelection;
pub use pixel_selector::PixelSelector;
pub use regular::RegularSampler;
pub use sample_cache::CacheEntry;
pub use sampler::Sampler;
pub use sink::{Framebuffer, FramebufferPixel, Sink};
pub use stochastic::{Confidence, StochasticSampler};
