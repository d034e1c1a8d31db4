//! Which settings are worth a measurement, when several knobs are turned.
//!
//! Each knob has been turned alone, so the error and the work of a mixture can be foretold: errors
//! of knobs that have nothing to do with each other add up as squares, and what each saves is a
//! share of the work. That is rough (levels and cutoff cut the same rays), so it only decides what
//! is measured next, and never stands in a report. What would still be beaten by a measured
//! setting if it were a good deal better than foretold is not measured at all.

use crate::pareto::CostErrorPoint;

/// What a mixture may be better than foretold: in work, and in error.
const PREDICTION_SLACK: CostErrorPoint = CostErrorPoint { cost: 0.75, error: 0.7 };

/// One notch of a knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterLevel {
    /// The error that it makes alone.
    pub error: f64,
    /// The work with it, as a share of that of the best notch.
    pub share: f64,
}

/// A notch for each knob.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// The places of the notches.
    pub level_indices: Vec<usize>,
    /// What is foretold.
    pub predicted: CostErrorPoint,
}

/// The mixtures that may still be worth a measurement.
#[derive(Debug)]
pub struct CombinationSearch {
    candidates: Vec<Combination>,
    /// How many were found not to be.
    pub dominated: usize,
}

impl CombinationSearch {
    /// Every mixture of these knobs that `is_new`; at the best notch of every knob the work is `work`.
    pub fn new(knobs: &[Vec<ParameterLevel>], work: f64, is_new: impl Fn(&[usize]) -> bool) -> Self {
        let none =
            Combination { level_indices: Vec::new(), predicted: CostErrorPoint { cost: work, error: 0.0 } };
        let mut left = vec![none];
        for notches in knobs {
            let with = |mix: &Combination, place: usize, notch: &ParameterLevel| {
                let CostErrorPoint { cost, error } = mix.predicted;
                let places = [&mix.level_indices[..], &[place]].concat();
                let error = (error * error + notch.error * notch.error).sqrt();
                Combination {
                    level_indices: places,
                    predicted: CostErrorPoint { cost: cost * notch.share, error },
                }
            };
            let turned = left.iter().flat_map(|mix| {
                notches.iter().enumerate().map(move |(place, notch)| with(mix, place, notch))
            });
            left = turned.collect();
        }
        left.retain(|mix| is_new(&mix.level_indices));
        CombinationSearch { candidates: left, dominated: 0 }
    }

    /// The one that promises most beside those that were measured; none when no other does.
    pub fn next(&mut self, measured: &[CostErrorPoint]) -> Option<Combination> {
        let before = self.candidates.len();
        self.candidates.retain(|mix| {
            let lucky = CostErrorPoint {
                cost: mix.predicted.cost * PREDICTION_SLACK.cost,
                error: mix.predicted.error * PREDICTION_SLACK.error,
            };
            !measured.iter().any(|point| point.dominates(&lucky))
        });
        self.dominated += before - self.candidates.len();
        // How much less wrong it is than the best of those that cost no more.
        let gain = |mix: &Combination| {
            let CostErrorPoint { cost, error } = mix.predicted;
            let others = measured.iter().filter(|point| point.cost <= cost).map(|point| point.error);
            others.fold(1.0, |a, b| if b < a { b } else { a }) / error.max(1e-9)
        };
        let best = (0..self.candidates.len())
            .max_by(|a, b| gain(&self.candidates[*a]).total_cmp(&gain(&self.candidates[*b])))?;
        Some(self.candidates.swap_remove(best))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pareto::pareto_front;

    const KNOBS: [&[(f64, f64)]; 3] = [
        &[(0.2, 0.3), (0.08, 0.5), (0.03, 0.7), (0.01, 0.9), (0.0, 1.0)],
        &[(0.05, 0.6), (0.02, 0.8), (0.004, 0.95), (0.0, 1.0)],
        &[(0.06, 1.0), (0.03, 4.0), (0.015, 16.0), (0.03, 9.0), (0.0075, 64.0), (0.05, 8.0)],
    ];

    fn knobs() -> Vec<Vec<ParameterLevel>> {
        let notch = |(error, share): &(f64, f64)| ParameterLevel { error: *error, share: *share };
        KNOBS.iter().map(|knob| knob.iter().map(notch).collect()).collect()
    }

    /// What would be measured: near what is foretold, but not the same.
    fn measured(mix: &Combination) -> CostErrorPoint {
        let wobble = |salt: usize| {
            let mixed = mix.level_indices.iter().fold(salt, |sum, place| (sum * 31 + place * 7 + 3) % 101);
            0.85 + 0.3 * mixed as f64 / 101.0
        };
        CostErrorPoint { cost: mix.predicted.cost * wobble(1), error: mix.predicted.error * wobble(2) }
    }

    #[test]
    fn the_front_is_found_without_measuring_what_is_beaten() {
        let all: Vec<CostErrorPoint> =
            CombinationSearch::new(&knobs(), 1.0, |_| true).candidates.iter().map(measured).collect();
        assert_eq!(all.len(), 5 * 4 * 6);
        let truth: Vec<CostErrorPoint> = pareto_front(&all).into_iter().map(|place| all[place]).collect();

        let mut hunt = CombinationSearch::new(&knobs(), 1.0, |_| true);
        let mut found: Vec<CostErrorPoint> = Vec::new();
        while let Some(mix) = hunt.next(&found) {
            found.push(measured(&mix));
        }
        assert_eq!(pareto_front(&found).into_iter().map(|place| found[place]).collect::<Vec<_>>(), truth);
        assert!(found.len() * 2 < all.len(), "{} of {} were measured", found.len(), all.len());
        assert_eq!((found.len() + hunt.dominated, hunt.candidates.len()), (all.len(), 0));
    }

    #[test]
    fn the_first_few_measurements_are_near_the_front() {
        let all: Vec<CostErrorPoint> =
            CombinationSearch::new(&knobs(), 1.0, |_| true).candidates.iter().map(measured).collect();
        let mut hunt = CombinationSearch::new(&knobs(), 1.0, |_| true);
        let mut found: Vec<CostErrorPoint> = Vec::new();
        for _ in 0..10 {
            let mix = hunt.next(&found).unwrap();
            found.push(measured(&mix));
        }
        for point in &found {
            let better = all.iter().filter(|other| other.dominates(point)).count();
            assert!(better < all.len() / 6, "{better} beat {point:?}");
        }
    }

    #[test]
    fn what_was_measured_alone_is_not_measured_again() {
        let best = [4, 3, 0];
        let is_mixed = |places: &[usize]| places.iter().zip(&best).filter(|(a, b)| a != b).count() > 1;
        let hunt = CombinationSearch::new(&knobs(), 1.0, is_mixed);
        // All but the best one and those in which one knob is turned.
        assert_eq!(hunt.candidates.len(), 5 * 4 * 6 - 1 - 4 - 3 - 5);
    }
}
