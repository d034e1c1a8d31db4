//! Numbers, roots, colours, and what stands in place of chance.

use strahl_core::*;

use crate::any::{any, color, number, slice, used, vector};

pub fn doors() {
    used((vec3(number(), number(), number()), unit(vector()), sqrt(number()), gamma(any(3))));
    let roots: CubicRoots = cubic_roots([number(); 4], number(), number());
    CubicRoots::iter(&roots).for_each(used);
    used(root_between(|x| (x, number()), number(), number(), any(true)));
    used(difference_of_products(number(), number(), number(), number()));
    used((FARTHEST, PI, ROUNDOFF, Rgb::BLACK, Rgb::BRIGHTEST));

    let c = Rgb::new(number(), number(), number());
    used((Rgb::largest(c), Rgb::is_black(c), Rgb::is_within(c, number()), Rgb::at_most(c, number())));
    used((Rgb::toward(c, Rgb::gray(number()), number()), Rgb::map(c, any), Rgb::to_srgb8(c), Rgb::default()));
    used(Rgb::contrast(slice(&[Rgb::WHITE]).iter().copied()));
    let mut sum = c + color();
    sum += c * color();
    sum *= c * number();
    used(sum);

    used(Axis::to_third(Axis::largest_of(vector()), vector()));
    used(Stream::pair(Stream::new(any(0), any(0), any(0), any(0)), Dimension::PIXEL));
    used((Dimension::LENS, Dimension::SHUTTER, Dimension::lobe(any(1)), Dimension::light(any(1), any(1))));
}
