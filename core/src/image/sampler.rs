//! Which rays make a pixel.

use super::pixel::Pixel;
use crate::math::{Real, Rgb, Stream};
use crate::scene::{Place, Sample};
use crate::trace::{Met, Sight};

/// Chooses the places of a pixel that rays are sent through, and makes one colour of them.
pub trait Sampler {
    /// What is seen in `pixel`. `shoot` traces one camera ray.
    fn look(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Sample) -> Sight) -> Sight;

    /// A new picture begins: what was kept of another is forgotten.
    fn begin(&mut self) {}
}

/// A sampler that somebody else goes on using.
impl<S: Sampler> Sampler for &mut S {
    fn look(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Sample) -> Sight) -> Sight {
        S::look(self, pixel, shoot)
    }

    fn begin(&mut self) {
        S::begin(self);
    }
}

/// The place `(x, y)` inside a pixel, from its upper left corner; both in `0..=1`.
pub(super) fn inside(pixel: Pixel, x: Real, y: Real) -> Place {
    Place { x: pixel.x as Real + x, y: pixel.y as Real + y }
}

/// The numbers of the sample `index` of a pixel.
pub(super) fn stream(pixel: Pixel, index: u32, seed: u32) -> Stream {
    Stream::new(pixel.x, pixel.y, index, seed)
}

/// The mean of some sights, as they come.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mean {
    sum: Rgb,
    met: Option<Met>,
    pub(super) count: u32,
}

impl Mean {
    pub(super) const NONE: Mean = Mean { sum: Rgb::BLACK, met: None, count: 0 };

    pub(super) fn add(&mut self, sight: Sight) {
        self.sum += sight.color;
        self.met = Some(self.met.map_or(sight.met, |met| met.and(sight.met)));
        self.count += 1;
    }

    /// Of nothing: darkness.
    pub(super) fn sight(&self) -> Sight {
        let share = if self.count > 0 { 1.0 / self.count as Real } else { 0.0 };
        Sight { color: self.sum * share, met: self.met.unwrap_or(Met::Nothing) }
    }
}
