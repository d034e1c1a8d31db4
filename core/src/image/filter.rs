//! Reconstruction filters.

/// Reconstruction filter: the weight of points around a pixel in its color.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// Constant in the pixel, zero outside of it.
    #[default]
    Box,
    /// Linear, from the center of the pixel to zero at the centers of its neighbors.
    Tent,
    /// Gaussian with a standard deviation of 0.5 pixels, truncated at a radius of 1.5 pixels.
    Gaussian,
}
