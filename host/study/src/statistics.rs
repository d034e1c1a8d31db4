//! The middle of repeated measurements, and how far they spread.

/// The median; of an even number the mean of the two in the middle. Of none it is zero.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let half = sorted.len() / 2;
    match (sorted.get(half), half.checked_sub(1).and_then(|below| sorted.get(below))) {
        (Some(upper), Some(lower)) if sorted.len().is_multiple_of(2) => 0.5 * (lower + upper),
        (Some(middle), _) => *middle,
        (None, _) => 0.0,
    }
}

/// The least and the most.
pub fn min_max(values: &[f64]) -> [f64; 2] {
    let least = values.iter().copied().fold(f64::INFINITY, |a, b| if b < a { b } else { a });
    let most = values.iter().copied().fold(0.0, |a, b| if b > a { b } else { a });
    if least.is_finite() { [least, most] } else { [0.0, 0.0] }
}

/// How far they spread: from the least to the most, as a share of the median.
pub fn relative_range(values: &[f64]) -> f64 {
    let [least, most] = min_max(values);
    let middle = median(values);
    if middle > 0.0 { (most - least) / middle } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_whatever_the_order() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&[4.0, 1.0, 3.0, 2.0]), 2.5);
        assert_eq!((median(&[7.0]), median(&[])), (7.0, 0.0));
    }

    #[test]
    fn one_slow_repetition_moves_the_spread_but_not_the_median() {
        let calm = [1.0, 1.01, 0.99, 1.0, 1.0];
        let disturbed = [1.0, 1.01, 0.99, 1.0, 9.0];
        assert_eq!(median(&calm), median(&disturbed));
        assert!(relative_range(&calm) < 0.03 && relative_range(&disturbed) > 8.0);
        assert_eq!((relative_range(&[2.0]), relative_range(&[])), (0.0, 0.0));
        assert_eq!(min_max(&disturbed), [0.99, 9.0]);
    }
}
