//! Numbers, roots, colors and random numbers.

use strahl_core::math::{
    Axis, CubicRoots, Dimension, MAX_COORDINATE, PI, ROUNDOFF, SobolSequence, bracketed_root, cubic_roots,
    difference_of_products, gamma, sqrt, try_normalize,
};
use strahl_core::{Rgb, vec3};

use crate::any::{any, color, number, slice, used, vector};

pub fn entry_points() {
    used((vec3(number(), number(), number()), try_normalize(vector()), sqrt(number()), gamma(any(3))));
    let roots: CubicRoots = cubic_roots([number(); 4], number(), number());
    CubicRoots::iter(&roots).for_each(used);
    used(bracketed_root(|x| (x, number()), number(), number(), any(true)));
    used(difference_of_products(number(), number(), number(), number()));
    used((MAX_COORDINATE, PI, ROUNDOFF, Rgb::BLACK, Rgb::MAX_CHANNEL));

    let c = Rgb::new(number(), number(), number());
    used((
        Rgb::max_component(c),
        Rgb::is_black(c),
        Rgb::is_in_range(c, number()),
        Rgb::clamp_max(c, number()),
    ));
    used((Rgb::lerp(c, Rgb::gray(number()), number()), Rgb::map(c, any), Rgb::to_srgb8(c), Rgb::default()));
    used(Rgb::contrast(slice(&[Rgb::WHITE]).iter().copied()));
    let mut sum = c + color();
    sum += c * color();
    sum *= c * number();
    used(sum);

    used(Axis::permute_to_z(Axis::dominant(vector()), vector()));
    used(SobolSequence::sample_2d(SobolSequence::new(any(0), any(0), any(0), any(0)), Dimension::PIXEL));
    used((
        Dimension::LENS,
        Dimension::SHUTTER,
        Dimension::microfacet(any(1)),
        Dimension::light(any(1), any(1)),
    ));
}
