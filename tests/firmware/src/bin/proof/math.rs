//! Numbers, roots, colours, and what stands in place of chance.

use strahl_core::*;

use crate::any::{any, color, number, slice, used, vector};

pub fn doors() {
    used((vec3(number(), number(), number()), unit(vector()), sqrt(number()), gamma(any(3))));
    let roots: CubicRoots = cubic_roots([number(); 4], number(), number());
    roots.iter().for_each(used);
    used(root_between(|x| (x, number()), number(), number(), any(true)));
    used(difference_of_products(number(), number(), number(), number()));
    used((FARTHEST, PI, ROUNDOFF, Rgb::BLACK, Rgb::BRIGHTEST));

    let c = Rgb::new(number(), number(), number());
    used((c.largest(), c.is_black(), c.is_within(number()), c.at_most(number())));
    used((c.toward(Rgb::gray(number()), number()), c.map(any), c.to_srgb8(), Rgb::default()));
    used(Rgb::contrast(slice(&[Rgb::WHITE]).iter().copied()));
    let mut sum = c + color();
    sum += c * color();
    sum *= c * number();
    used(sum);

    used(Axis::largest_of(vector()).to_third(vector()));
    used(Stream::new(any(0), any(0), any(0), any(0)).pair(Dimension::PIXEL));
    used((Dimension::LENS, Dimension::SHUTTER, Dimension::lobe(any(1)), Dimension::light(any(1), any(1))));
}
