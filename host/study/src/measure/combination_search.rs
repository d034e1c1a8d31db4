//! Combinations of settings that are worth a measurement.
//!
//! Each setting has been swept alone, so error and work of a combination can be predicted: independent errors add as squares,
//! and savings multiply. The prediction is rough (levels and cutoff discard the same rays), so it only decides what is
//! measured next and is never reported. A combination is skipped if a measured setting would dominate it even if it were
//! much better than predicted.

use crate::pareto::CostErrorPoint;

/// How much better than predicted a combination may be, as factors of work and error.
const PREDICTION_SLACK: CostErrorPoint = CostErrorPoint { cost: 0.75, error: 0.7 };

/// One value of a setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterLevel {
    /// The error that it causes alone.
    pub error: f64,
    /// Its work, relative to that of the most accurate value.
    pub share: f64,
}

/// One value for each setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// Index of the value of each setting.
    pub level_indices: Vec<usize>,
    /// Predicted work and error.
    pub predicted: CostErrorPoint,
}

/// The combinations that may still be worth a measurement.
#[derive(Debug)]
pub struct CombinationSearch {
    candidates: Vec<Combination>,
    /// Number of combinations dropped as dominated.
    pub dominated: usize,
}

impl CombinationSearch {
    /// All combinations that are `is_new`. With the most accurate value of every setting the work is `work`.
    pub fn new(parameters: &[Vec<ParameterLevel>], work: f64, is_new: impl Fn(&[usize]) -> bool) -> Self {
        let none =
            Combination { level_indices: Vec::new(), predicted: CostErrorPoint { cost: work, error: 0.0 } };
        let mut left = vec![none];
        for levels in parameters {
            let with = |combination: &Combination, place: usize, level: &ParameterLevel| {
                let CostErrorPoint { cost, error } = combination.predicted;
                let places = [&combination.level_indices[..], &[place]].concat();
                let error = (error * error + level.error * level.error).sqrt();
                Combination {
                    level_indices: places,
                    predicted: CostErrorPoint { cost: cost * level.share, error },
                }
            };
            let extended = left.iter().flat_map(|combination| {
                levels.iter().enumerate().map(move |(place, level)| with(combination, place, level))
            });
            left = extended.collect();
        }
        left.retain(|combination| is_new(&combination.level_indices));
        CombinationSearch { candidates: left, dominated: 0 }
    }

    /// The combination with the best predicted gain over the measured ones. `None` if there is none left.
    pub fn next(&mut self, measured: &[CostErrorPoint]) -> Option<Combination> {
        let before = self.candidates.len();
        self.candidates.retain(|combination| {
            let optimistic = CostErrorPoint {
                cost: combination.predicted.cost * PREDICTION_SLACK.cost,
                error: combination.predicted.error * PREDICTION_SLACK.error,
            };
            !measured.iter().any(|point| point.dominates(&optimistic))
        });
        self.dominated += before - self.candidates.len();
        // Error relative to the most accurate measured setting that costs no more.
        let gain = |combination: &Combination| {
            let CostErrorPoint { cost, error } = combination.predicted;
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

    const PARAMETERS: [&[(f64, f64)]; 3] = [
        &[(0.2, 0.3), (0.08, 0.5), (0.03, 0.7), (0.01, 0.9), (0.0, 1.0)],
        &[(0.05, 0.6), (0.02, 0.8), (0.004, 0.95), (0.0, 1.0)],
        &[(0.06, 1.0), (0.03, 4.0), (0.015, 16.0), (0.03, 9.0), (0.0075, 64.0), (0.05, 8.0)],
    ];

    fn parameters() -> Vec<Vec<ParameterLevel>> {
        let level = |(error, share): &(f64, f64)| ParameterLevel { error: *error, share: *share };
        PARAMETERS.iter().map(|parameter| parameter.iter().map(level).collect()).collect()
    }

    /// A simulated measurement close to the prediction.
    fn measured(combination: &Combination) -> CostErrorPoint {
        let wobble = |salt: usize| {
            let mixed =
                combination.level_indices.iter().fold(salt, |sum, place| (sum * 31 + place * 7 + 3) % 101);
            0.85 + 0.3 * mixed as f64 / 101.0
        };
        CostErrorPoint {
            cost: combination.predicted.cost * wobble(1),
            error: combination.predicted.error * wobble(2),
        }
    }

    #[test]
    fn the_front_is_found_without_measuring_dominated_combinations() {
        let all: Vec<CostErrorPoint> =
            CombinationSearch::new(&parameters(), 1.0, |_| true).candidates.iter().map(measured).collect();
        assert_eq!(all.len(), 5 * 4 * 6);
        let expected: Vec<CostErrorPoint> = pareto_front(&all).into_iter().map(|place| all[place]).collect();

        let mut search = CombinationSearch::new(&parameters(), 1.0, |_| true);
        let mut found: Vec<CostErrorPoint> = Vec::new();
        while let Some(combination) = search.next(&found) {
            found.push(measured(&combination));
        }
        assert_eq!(pareto_front(&found).into_iter().map(|place| found[place]).collect::<Vec<_>>(), expected);
        assert!(found.len() * 2 < all.len(), "{} of {} were measured", found.len(), all.len());
        assert_eq!((found.len() + search.dominated, search.candidates.len()), (all.len(), 0));
    }

    #[test]
    fn the_first_few_measurements_are_near_the_front() {
        let all: Vec<CostErrorPoint> =
            CombinationSearch::new(&parameters(), 1.0, |_| true).candidates.iter().map(measured).collect();
        let mut search = CombinationSearch::new(&parameters(), 1.0, |_| true);
        let mut found: Vec<CostErrorPoint> = Vec::new();
        for _ in 0..10 {
            let combination = search.next(&found).unwrap();
            found.push(measured(&combination));
        }
        for point in &found {
            let better = all.iter().filter(|other| other.dominates(point)).count();
            assert!(better < all.len() / 6, "{better} beat {point:?}");
        }
    }

    #[test]
    fn settings_of_a_sweep_are_not_measured_again() {
        let best = [4, 3, 0];
        let is_mixed = |places: &[usize]| places.iter().zip(&best).filter(|(a, b)| a != b).count() > 1;
        let search = CombinationSearch::new(&parameters(), 1.0, is_mixed);
        // All but the most accurate one and those that differ from it in one setting.
        assert_eq!(search.candidates.len(), 5 * 4 * 6 - 1 - 4 - 3 - 5);
    }
}
