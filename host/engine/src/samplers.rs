//! The sampler that the settings ask for.
//!
//! One type for all of them, so that the loop that calls it is compiled once for each tracer
//! and not once for each sampler: a sampler is asked once for a pixel, and calls the tracer
//! once for a ray.

use strahl_core::Real;
use strahl_core::image::{
    Adaptive, Corners, Kept, Lattice, Loose, Parting, Pixel, Regular, Sampler, Selection, Stochastic,
};
use strahl_core::trace::{PixelSample, RayTracer};
use strahl_settings::{Sampling, Settings};

/// Any of the samplers.
pub enum Any<'m> {
    /// Of a fixed raster.
    Regular(Regular),
    /// Of no raster.
    Stochastic(Stochastic),
    /// Of the corners, and more.
    Adaptive(Adaptive<'m, Shared<'m>>),
}

/// Where corners come from.
#[derive(Clone, Copy)]
pub enum Shared<'m> {
    /// From all of them, traced before.
    Lattice(Lattice<'m>),
    /// From the sampler's memory.
    Loose,
}

impl Corners for Shared<'_> {
    fn corners(&mut self, cell: Pixel, find: &mut impl FnMut(Pixel) -> PixelSample) -> [PixelSample; 4] {
        match self {
            Shared::Lattice(lattice) => lattice.corners(cell, find),
            Shared::Loose => Loose.corners(cell, find),
        }
    }
}

impl Sampler for Any<'_> {
    fn sample_pixel<R: RayTracer + ?Sized>(&mut self, pixel: Pixel, tracer: &mut R) -> PixelSample {
        match self {
            Any::Regular(it) => it.sample_pixel(pixel, tracer),
            Any::Stochastic(it) => it.sample_pixel(pixel, tracer),
            Any::Adaptive(it) => it.sample_pixel(pixel, tracer),
        }
    }

    fn begin(&mut self) {
        match self {
            Any::Regular(it) => it.begin(),
            Any::Stochastic(it) => it.begin(),
            Any::Adaptive(it) => it.begin(),
        }
    }
}

impl<'m> Any<'m> {
    /// The sampler that the settings ask for. `corners` and `lent` are for one that shares corners.
    ///
    /// Numbers out of range, which the command line refuses, become one ray in each pixel.
    pub fn of(settings: &Settings, corners: Shared<'m>, lent: &'m mut [Kept]) -> Self {
        let (filter, seed) = (filter(settings.filter), settings.seed);
        let regular = |n| Regular::new(n).unwrap_or(Regular::ONE).filtered(filter).seeded(seed);
        match settings.sampler {
            Sampling::Single => Any::Regular(regular(1)),
            Sampling::Regular(n) => Any::Regular(regular(n)),
            Sampling::Adaptive { .. } => match parting(settings) {
                Some(parting) => Any::Adaptive(Adaptive::new(parting, corners, lent)),
                None => Any::Regular(regular(1)),
            },
            Sampling::Stochastic { least, most, confidence } => {
                #[allow(clippy::unnecessary_cast)] // in double precision
                let ends = strahl_core::image::Confidence {
                    errors: confidence.errors() as Real,
                    tolerance: Real::from(confidence.tolerance),
                };
                match Stochastic::between(least, most, ends) {
                    Some(it) => Any::Stochastic(it.filtered(filter).seeded(seed)),
                    None => Any::Regular(regular(1)),
                }
            }
        }
    }
}

/// How pixels are parted, where they are.
pub fn parting(settings: &Settings) -> Option<Parting> {
    match settings.sampler {
        Sampling::Adaptive { depth, agreement: it } => {
            Some(Parting::new(depth, agreement(it)?)?.seeded(settings.seed))
        }
        _ => None,
    }
}

/// Which pixels are traced, where not all are.
pub fn selection(settings: &Settings) -> Option<Selection> {
    let it = settings.select?;
    Selection::new(it.step, agreement(it.agreement)?)
}

fn agreement(it: strahl_settings::Agreement) -> Option<strahl_core::image::Agreement> {
    let colors = strahl_core::image::Agreement::of_colors(Real::from(it.threshold))?;
    Some(if it.items { colors.and_items() } else { colors })
}

fn filter(filter: strahl_settings::Filter) -> strahl_core::image::Filter {
    match filter {
        strahl_settings::Filter::Box => strahl_core::image::Filter::Box,
        strahl_settings::Filter::Tent => strahl_core::image::Filter::Tent,
        strahl_settings::Filter::Gaussian => strahl_core::image::Filter::Gaussian,
    }
}
