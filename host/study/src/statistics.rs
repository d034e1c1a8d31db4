//! Median and range of repeated measurements.

/// The median; of an even number of values, the mean of the two central ones. 0 for an empty slice.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let half = sorted.len() / 2;
    match (sorted.get(half), half.checked_sub(1).and_then(|below| sorted.get(below))) {
        (Some(upper), Some(lower)) if sorted.len().is_multiple_of(2) => 0.5 * (lower + upper),
        (Some(center), _) => *center,
        (None, _) => 0.0,
    }
}

/// Minimum and maximum; `[0, 0]` for an empty slice.
pub fn min_max(values: &[f64]) -> [f64; 2] {
    let min = values.iter().copied().fold(f64::INFINITY, |a, b| if b < a { b } else { a });
    let max = values.iter().copied().fold(0.0, |a, b| if b > a { b } else { a });
    if min.is_finite() { [min, max] } else { [0.0, 0.0] }
}

/// The range from minimum to maximum, relative to the median; 0 if the median is 0.
pub fn relative_range(values: &[f64]) -> f64 {
    let [min, max] = min_max(values);
    let median = median(values);
    if median > 0.0 { (max - min) / median } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_does_not_depend_on_the_order() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&[4.0, 1.0, 3.0, 2.0]), 2.5);
        assert_eq!((median(&[7.0]), median(&[])), (7.0, 0.0));
    }

    #[test]
    fn one_slow_repetition_changes_the_range_but_not_the_median() {
        let calm = [1.0, 1.01, 0.99, 1.0, 1.0];
        let disturbed = [1.0, 1.01, 0.99, 1.0, 9.0];
        assert_eq!(median(&calm), median(&disturbed));
        assert!(relative_range(&calm) < 0.03 && relative_range(&disturbed) > 8.0);
        assert_eq!((relative_range(&[2.0]), relative_range(&[])), (0.0, 0.0));
        assert_eq!(min_max(&disturbed), [0.99, 9.0]);
    }
}
