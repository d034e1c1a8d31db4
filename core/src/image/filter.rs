//! Which reconstruction filters there are.

/// How much of its surroundings counts in a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// The pixel and nothing else, everywhere the same.
    #[default]
    Box,
    /// The less, the farther from the middle, to nothing at the middles of the next pixels.
    Tent,
    /// A round normal distribution of deviation 0.5 pixels, cut off at 1.5.
    Gaussian,
}
