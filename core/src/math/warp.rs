//! From the unit square to where samples are wanted: without holes, without heaps, neighbours
//! staying neighbours.

use super::{PI, Real, cos, exp, ln, sin, sqrt};

/// A number evenly in `[0, 1)` to one in `(-1, 1)`, the more often the nearer to zero: the
/// height of a tent.
pub fn tent(u: Real) -> Real {
    if u < 0.5 { sqrt(2.0 * u) - 1.0 } else { 1.0 - sqrt(2.0 * (1.0 - u)) }
}

/// A point evenly in the unit square to one by a round normal distribution of deviation one,
/// cut off at `radius` (Box, Muller 1958).
pub fn normal([u, v]: [Real; 2], radius: Real) -> [Real; 2] {
    // What the distribution has inside the radius.
    let inside = 1.0 - exp(-0.5 * radius * radius);
    let r = sqrt(-2.0 * ln(1.0 - u * inside));
    let angle = 2.0 * PI * v;
    [r * cos(angle), r * sin(angle)]
}
