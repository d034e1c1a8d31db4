//! Regular supersampling: each pixel is cut into n times n cells with a ray through each.

use super::pixel::Pixel;
use super::sampler::{Sampler, inside};
use crate::math::{Real, Rgb};
use crate::scene::Place;

/// Rays through the middles of `n` times `n` equal cells; the mean of their colours.
#[derive(Clone, Copy, Debug)]
pub struct Regular {
    n: u16,
}

impl Regular {
    /// One ray through the middle.
    pub const ONE: Regular = Regular { n: 1 };
    /// The most cells along one side.
    pub const MOST: u16 = 256;

    /// `n` times `n` rays; none when `n` is 0 or more than [`Regular::MOST`].
    pub fn new(n: u16) -> Option<Self> {
        (n >= 1 && n <= Self::MOST).then_some(Regular { n })
    }
}

impl Sampler for Regular {
    fn color(&mut self, pixel: Pixel, shoot: &mut impl FnMut(Place) -> Rgb) -> Rgb {
        let n = Real::from(self.n);
        let middle = |cell: u16| (Real::from(cell) + 0.5) / n;
        let mut sum = Rgb::BLACK;
        for y in 0..self.n {
            for x in 0..self.n {
                sum += shoot(inside(pixel, middle(x), middle(y)));
            }
        }
        sum * (1.0 / (n * n))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::Single;

    #[test]
    fn one_cell_is_the_middle_of_the_pixel() {
        let pixel = Pixel { x: 3, y: 2 };
        let mut places = [Place { x: 0.0, y: 0.0 }; 2];
        Single.color(pixel, &mut |place| {
            places[0] = place;
            Rgb::BLACK
        });
        Regular::new(1).unwrap().color(pixel, &mut |place| {
            places[1] = place;
            Rgb::BLACK
        });
        assert_eq!(places, [Place { x: 3.5, y: 2.5 }; 2]);
    }

    #[test]
    fn the_cells_have_the_mean_of_a_slope() {
        let mut rays = 0;
        let mean = Regular::new(4).unwrap().color(Pixel { x: 0, y: 0 }, &mut |place| {
            rays += 1;
            Rgb::new(place.x, place.y, 1.0)
        });
        assert_eq!((rays, mean), (16, Rgb::new(0.5, 0.5, 1.0)));
        assert!(Regular::new(0).is_none() && Regular::new(257).is_none());
    }
}
