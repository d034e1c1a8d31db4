//! From values to positions along an axis.
//!
//! Plots are written as SVG with CSS variables as colors, so that they follow light and dark mode.

/// A logarithmic axis.
#[derive(Clone, Copy, Debug)]
pub struct LogAxis {
    least: f64,
    most: f64,
    from: f64,
    to: f64,
}

impl LogAxis {
    /// An axis for the positive values, from position `from` to position `to`.
    pub fn of(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (mut least, mut most) = (f64::INFINITY, 0.0);
        for value in values.filter(|value| *value > 0.0 && value.is_finite()) {
            least = if value < least { value } else { least };
            most = if value > most { value } else { most };
        }
        if !least.is_finite() {
            (least, most) = (0.1, 1.0);
        }
        // A margin at both ends, and at least half a decade.
        let room = libm::pow(most / least, 0.06) * 1.12;
        let (mut least, mut most) = (least / room, most * room);
        while most / least < 3.2 {
            (least, most) = (least / 1.2, most * 1.2);
        }
        LogAxis { least, most, from, to }
    }

    /// The position of a value, clamped to the axis.
    pub fn at(&self, value: f64) -> f64 {
        let share = libm::log(value.max(1e-300) / self.least) / libm::log(self.most / self.least);
        self.from + (self.to - self.from) * share.clamp(0.0, 1.0)
    }

    /// Round values on the axis, at most about eight: powers of ten, and multiples of them if there are few.
    pub fn ticks(&self) -> Vec<f64> {
        let decades = libm::log10(self.most / self.least);
        let steps: &[f64] = if decades < 0.8 {
            &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0]
        } else if decades < 1.7 {
            &[1.0, 2.0, 5.0]
        } else if decades < 3.2 {
            &[1.0, 3.0]
        } else {
            &[1.0]
        };
        let first = libm::floor(libm::log10(self.least)) as i32;
        let last = libm::ceil(libm::log10(self.most)) as i32;
        let all = (first..=last).flat_map(|decade| steps.iter().map(move |step| power(*step, decade)));
        all.filter(|tick| *tick >= self.least && *tick <= self.most).collect()
    }
}

/// `step` times ten to a power, as its decimal text reads.
fn power(step: f64, decade: i32) -> f64 {
    format!("{step}e{decade}").parse().unwrap_or(step)
}

/// A linear axis from zero.
#[derive(Clone, Copy, Debug)]
pub struct LinearAxis {
    most: f64,
    from: f64,
    to: f64,
}

impl LinearAxis {
    /// From zero at `from` to the largest value at `to`.
    pub fn of(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let most = values.filter(|value| value.is_finite()).fold(0.0, |a, b| if b > a { b } else { a });
        LinearAxis { most: if most > 0.0 { most } else { 1.0 }, from, to }
    }

    /// The place of a value.
    pub fn at(&self, value: f64) -> f64 {
        self.from + (self.to - self.from) * (value / self.most).clamp(0.0, 1.0)
    }

    /// Zero and some round values above it.
    pub fn ticks(&self, about: f64) -> Vec<f64> {
        let rough = self.most / about;
        let decade = libm::floor(libm::log10(rough)) as i32;
        let step =
            [1.0, 2.0, 5.0, 10.0].into_iter().map(|step| power(step, decade)).find(|step| *step >= rough);
        let step = step.unwrap_or(rough);
        (0..=20).map(|index| f64::from(index) * step).take_while(|tick| *tick <= self.most * 1.0001).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_factor_is_as_long_as_any_other() {
        let axis = LogAxis::of([0.001, 1.0].into_iter(), 0.0, 300.0);
        let decades = [0.001, 0.01, 0.1, 1.0].map(|value| axis.at(value));
        for pair in decades.windows(2) {
            assert!((pair[1] - pair[0] - (decades[1] - decades[0])).abs() < 1e-9);
        }
        assert!(decades[0] > 0.0 && decades[3] < 300.0);
        assert_eq!((axis.at(0.0), axis.at(1e9)), (0.0, 300.0));
    }

    #[test]
    fn ticks_are_round_and_few_whatever_the_values() {
        for (least, most) in [(0.001, 1.0), (0.02, 0.03), (1e-7, 1e3), (5.0, 5.0)] {
            let ticks = LogAxis::of([least, most].into_iter(), 0.0, 1.0).ticks();
            assert!((1..=14).contains(&ticks.len()), "{least}..{most}: {ticks:?}");
        }
        assert_eq!(LinearAxis::of([7.3].into_iter(), 0.0, 1.0).ticks(4.0), [0.0, 2.0, 4.0, 6.0]);
        assert_eq!(LinearAxis::of(std::iter::empty(), 0.0, 1.0).ticks(2.0), [0.0, 0.5, 1.0]);
    }

    #[test]
    fn nothing_to_show_makes_an_axis_all_the_same() {
        assert!(LogAxis::of([0.0, f64::NAN].into_iter(), 0.0, 1.0).at(0.5).is_finite());
    }
}
