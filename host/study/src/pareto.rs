//! The Pareto front of cost and error.
//!
//! ```
//! use strahl_study::pareto::{CostErrorPoint, cheapest_within, pareto_front};
//!
//! let points = [(1.0, 0.08), (2.0, 0.03), (4.0, 0.05), (9.0, 0.01)].map(|(cost, error)| CostErrorPoint { cost, error });
//! assert_eq!(pareto_front(&points), [0, 1, 3]);
//! assert_eq!(cheapest_within(&points, 0.05), Some(1));
//! ```

/// Errors for which the cheapest settings are recommended.
pub const ERROR_LIMITS: [f64; 5] = [0.05, 0.02, 0.01, 0.005, 0.002];

/// Cost and error of one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CostErrorPoint {
    /// Seconds, or instructions.
    pub cost: f64,
    /// Root mean square error.
    pub error: f64,
}

impl CostErrorPoint {
    /// Pareto dominance: cost and error are at most those of `other`, and one of them is less.
    pub fn dominates(&self, other: &CostErrorPoint) -> bool {
        self.cost <= other.cost && self.error <= other.error && self != other
    }
}

/// Indices of the points that no other point dominates, cheapest first. Of equal points the first is taken.
pub fn pareto_front(points: &[CostErrorPoint]) -> Vec<usize> {
    let mut indices: Vec<usize> = (0..points.len()).collect();
    let key = |index: &usize| (points[*index].cost, points[*index].error);
    indices.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let mut min_error = f64::INFINITY;
    indices.retain(|index| {
        let error = points[*index].error;
        let is_better = error < min_error;
        if is_better {
            min_error = error;
        }
        is_better
    });
    indices
}

/// Index of the cheapest point whose error is at most `limit`; `None` if there is none.
pub fn cheapest_within(points: &[CostErrorPoint], limit: f64) -> Option<usize> {
    pareto_front(points).into_iter().find(|index| points[*index].error <= limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<CostErrorPoint> {
        list.iter().map(|(cost, error)| CostErrorPoint { cost: *cost, error: *error }).collect()
    }

    #[test]
    fn the_front_holds_exactly_the_points_that_are_not_dominated() {
        let all = points(&[(4.0, 1.0), (1.0, 9.0), (2.0, 3.0), (3.0, 3.0), (2.0, 8.0), (5.0, 2.0)]);
        assert_eq!(pareto_front(&all), [1, 2, 0]);
        for (index, point) in all.iter().enumerate() {
            let is_dominated = all.iter().any(|other| other.dominates(point));
            assert_eq!(is_dominated, !pareto_front(&all).contains(&index), "{index}");
        }
    }

    #[test]
    fn of_equal_points_one_is_on_the_front_and_none_dominates_the_other() {
        let all = points(&[(1.0, 1.0), (1.0, 1.0)]);
        assert_eq!(pareto_front(&all), [0]);
        assert!(!all[0].dominates(&all[1]));
        assert!(pareto_front(&[]).is_empty());
    }

    #[test]
    fn the_cheapest_within_a_limit_is_on_the_front() {
        let all = points(&[(4.0, 1.0), (1.0, 9.0), (2.0, 3.0), (3.0, 2.9)]);
        assert_eq!(
            [10.0, 3.0, 2.95, 0.5].map(|limit| cheapest_within(&all, limit)),
            [Some(1), Some(2), Some(3), None]
        );
    }
}
