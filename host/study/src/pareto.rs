//! Settings that no other beats: the Pareto front.

/// Errors for which the cheapest setting is recommended.
pub const ERROR_LIMITS: [f64; 5] = [0.05, 0.02, 0.01, 0.005, 0.002];

/// What a setting takes, and how wrong it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CostErrorPoint {
    /// Seconds, or instructions.
    pub cost: f64,
    /// The root of the mean square error.
    pub error: f64,
}

impl CostErrorPoint {
    /// Whether nobody would want `other` who can have this: no worse in either, better in one.
    pub fn dominates(&self, other: &CostErrorPoint) -> bool {
        self.cost <= other.cost && self.error <= other.error && self != other
    }
}

/// The places of those that no other beats, the cheapest first. Of equals the first counts.
pub fn pareto_front(points: &[CostErrorPoint]) -> Vec<usize> {
    let mut places: Vec<usize> = (0..points.len()).collect();
    let key = |place: &usize| (points[*place].cost, points[*place].error);
    places.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let mut least = f64::INFINITY;
    places.retain(|place| {
        let error = points[*place].error;
        let is_better = error < least;
        if is_better {
            least = error;
        }
        is_better
    });
    places
}

/// The place of the cheapest whose error is at most `limit`.
pub fn cheapest_within(points: &[CostErrorPoint], limit: f64) -> Option<usize> {
    pareto_front(points).into_iter().find(|place| points[*place].error <= limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<CostErrorPoint> {
        list.iter().map(|(cost, error)| CostErrorPoint { cost: *cost, error: *error }).collect()
    }

    #[test]
    fn the_front_is_what_no_other_beats() {
        let all = points(&[(4.0, 1.0), (1.0, 9.0), (2.0, 3.0), (3.0, 3.0), (2.0, 8.0), (5.0, 2.0)]);
        assert_eq!(pareto_front(&all), [1, 2, 0]);
        for (place, point) in all.iter().enumerate() {
            let beaten = all.iter().any(|other| other.dominates(point));
            assert_eq!(beaten, !pareto_front(&all).contains(&place), "{place}");
        }
    }

    #[test]
    fn of_equals_one_is_on_the_front_and_none_beats_the_other() {
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
