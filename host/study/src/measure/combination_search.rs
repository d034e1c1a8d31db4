//! Which settings are worth a measurement, when several knobs are turned.
//!
//! Each knob has been turned alone, so the error and the work of a mixture can be foretold: errors
//! of knobs that have nothing to do with each other add up as squares, and what each saves is a
//! share of the work. That is rough (levels and cutoff cut the same rays), so it only decides what
//! is measured next, and never stands in a report. What would still be beaten by a measured
//! setting if it were a good deal better than foretold is not measured at all.

use crate::pareto::Point;

/// What a mixture may be better than foretold: in work, and in error.
const LUCK: Point = Point { cost: 0.75, error: 0.7 };

/// One notch of a knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notch {
    /// The error that it makes alone.
    pub error: f64,
    /// The work with it, as a share of that of the best notch.
    pub share: f64,
}

/// A notch for each knob.
#[derive(Clone, Debug, PartialEq)]
pub struct Mix {
    /// The places of the notches.
    pub places: Vec<usize>,
    /// What is foretold.
    pub foretold: Point,
}

/// The mixtures that may still be worth a measurement.
#[derive(Debug)]
pub struct Hunt {
    left: Vec<Mix>,
    /// How many were found not to be.
    pub beaten: usize,
}

impl Hunt {
    /// Every mixture of these knobs that `is_new`; at the best notch of every knob the work is `work`.
    pub fn new(knobs: &[Vec<Notch>], work: f64, is_new: impl Fn(&[usize]) -> bool) -> Self {
        let none = Mix { places: Vec::new(), foretold: Point { cost: work, error: 0.0 } };
        let mut left = vec![none];
        for notches in knobs {
            let with = |mix: &Mix, place: usize, notch: &Notch| {
                let Point { cost, error } = mix.foretold;
                let places = [&mix.places[..], &[place]].concat();
                let error = (error * error + notch.error * notch.error).sqrt();
                Mix { places, foretold: Point { cost: cost * notch.share, error } }
            };
            let turned = left.iter().flat_map(|mix| {
                notches.iter().enumerate().map(move |(place, notch)| with(mix, place, notch))
            });
            left = turned.collect();
        }
        left.retain(|mix| is_new(&mix.places));
        Hunt { left, beaten: 0 }
    }

    /// The one that promises most beside those that were measured; none when no other does.
    pub fn next(&mut self, measured: &[Point]) -> Option<Mix> {
        let before = self.left.len();
        self.left.retain(|mix| {
            let lucky = Point { cost: mix.foretold.cost * LUCK.cost, error: mix.foretold.error * LUCK.error };
            !measured.iter().any(|point| point.beats(&lucky))
        });
        self.beaten += before - self.left.len();
        // How much less wrong it is than the best of those that cost no more.
        let gain = |mix: &Mix| {
            let Point { cost, error } = mix.foretold;
            let others = measured.iter().filter(|point| point.cost <= cost).map(|point| point.error);
            others.fold(1.0, |a, b| if b < a { b } else { a }) / error.max(1e-9)
        };
        let best =
            (0..self.left.len()).max_by(|a, b| gain(&self.left[*a]).total_cmp(&gain(&self.left[*b])))?;
        Some(self.left.swap_remove(best))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pareto::front;

    const KNOBS: [&[(f64, f64)]; 3] = [
        &[(0.2, 0.3), (0.08, 0.5), (0.03, 0.7), (0.01, 0.9), (0.0, 1.0)],
        &[(0.05, 0.6), (0.02, 0.8), (0.004, 0.95), (0.0, 1.0)],
        &[(0.06, 1.0), (0.03, 4.0), (0.015, 16.0), (0.03, 9.0), (0.0075, 64.0), (0.05, 8.0)],
    ];

    fn knobs() -> Vec<Vec<Notch>> {
        let notch = |(error, share): &(f64, f64)| Notch { error: *error, share: *share };
        KNOBS.iter().map(|knob| knob.iter().map(notch).collect()).collect()
    }

    /// What would be measured: near what is foretold, but not the same.
    fn measured(mix: &Mix) -> Point {
        let wobble = |salt: usize| {
            let mixed = mix.places.iter().fold(salt, |sum, place| (sum * 31 + place * 7 + 3) % 101);
            0.85 + 0.3 * mixed as f64 / 101.0
        };
        Point { cost: mix.foretold.cost * wobble(1), error: mix.foretold.error * wobble(2) }
    }

    #[test]
    fn the_front_is_found_without_measuring_what_is_beaten() {
        let all: Vec<Point> = Hunt::new(&knobs(), 1.0, |_| true).left.iter().map(measured).collect();
        assert_eq!(all.len(), 5 * 4 * 6);
        let truth: Vec<Point> = front(&all).into_iter().map(|place| all[place]).collect();

        let mut hunt = Hunt::new(&knobs(), 1.0, |_| true);
        let mut found: Vec<Point> = Vec::new();
        while let Some(mix) = hunt.next(&found) {
            found.push(measured(&mix));
        }
        assert_eq!(front(&found).into_iter().map(|place| found[place]).collect::<Vec<_>>(), truth);
        assert!(found.len() * 2 < all.len(), "{} of {} were measured", found.len(), all.len());
        assert_eq!((found.len() + hunt.beaten, hunt.left.len()), (all.len(), 0));
    }

    #[test]
    fn the_first_few_measurements_are_near_the_front() {
        let all: Vec<Point> = Hunt::new(&knobs(), 1.0, |_| true).left.iter().map(measured).collect();
        let mut hunt = Hunt::new(&knobs(), 1.0, |_| true);
        let mut found: Vec<Point> = Vec::new();
        for _ in 0..10 {
            let mix = hunt.next(&found).unwrap();
            found.push(measured(&mix));
        }
        for point in &found {
            let better = all.iter().filter(|other| other.beats(point)).count();
            assert!(better < all.len() / 6, "{better} beat {point:?}");
        }
    }

    #[test]
    fn what_was_measured_alone_is_not_measured_again() {
        let best = [4, 3, 0];
        let is_mixed = |places: &[usize]| places.iter().zip(&best).filter(|(a, b)| a != b).count() > 1;
        let hunt = Hunt::new(&knobs(), 1.0, is_mixed);
        // All but the best one and those in which one knob is turned.
        assert_eq!(hunt.left.len(), 5 * 4 * 6 - 1 - 4 - 3 - 5);
    }
}
