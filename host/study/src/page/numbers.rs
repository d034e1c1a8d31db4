//! Numbers as people read them.

/// So many digits that are not leading zeros.
fn digits(value: f64, count: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".into();
    }
    let magnitude = libm::floor(libm::log10(value.abs())) as i32;
    let after = (count - 1 - magnitude).clamp(0, 12) as usize;
    format!("{value:.after$}")
}

/// Seconds, in the unit that suits.
pub fn seconds(value: f64) -> String {
    if value == 0.0 {
        "0 s".into()
    } else if value < 1e-3 {
        format!("{} µs", digits(value * 1e6, 3))
    } else if value < 1.0 {
        format!("{} ms", digits(value * 1e3, 3))
    } else if value < 1000.0 {
        format!("{} s", digits(value, 3))
    } else {
        format!("{} min", digits(value / 60.0, 3))
    }
}

/// An error, two digits of it.
pub fn error(value: f64) -> String {
    if value > 0.0 && value < 1e-6 { format!("{value:.0e}") } else { digits(value, 2) }
}

/// A round value of an axis.
pub fn tick(value: f64) -> String {
    if value > 0.0 && value < 1e-3 { format!("{value:e}") } else { value.to_string() }
}

/// A count, or instructions: thousands, millions and more by their letters.
pub fn count(value: f64) -> String {
    let unit = [(1e12, " T"), (1e9, " G"), (1e6, " M"), (1e3, " k")];
    match unit.into_iter().find(|(unit, _)| value.abs() >= *unit) {
        Some((unit, name)) => format!("{}{name}", digits(value / unit, 3)),
        None => digits(value, 3),
    }
}

/// A share, in percent.
pub fn percent(value: f64) -> String {
    let percent = 100.0 * value;
    if percent == 0.0 {
        "0 %".into()
    } else if percent.abs() < 0.01 {
        "< 0.01 %".into()
    } else if percent.abs() >= 99.995 {
        format!("{percent:.0} %")
    } else {
        format!("{} %", digits(percent, 2))
    }
}

/// How much more or less, in percent with its sign; many times as much as a factor.
pub fn change(from: f64, to: f64) -> String {
    if from <= 0.0 {
        return "–".into();
    }
    let ratio = to / from;
    if ratio >= 3.0 {
        format!("× {}", digits(ratio, 2))
    } else {
        let percent = 100.0 * (ratio - 1.0);
        let text = format!("{percent:+.0} %");
        // A minus as long as the plus.
        if text == "+0 %" || text == "-0 %" { "±0 %".into() } else { text.replace('-', "−") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_as_many_digits_as_are_read() {
        assert_eq!(
            [0.0, 1.5e-6, 0.0123, 2.5, 123.4, 4000.0].map(seconds),
            ["0 s", "1.50 µs", "12.3 ms", "2.50 s", "123 s", "66.7 min"]
        );
        assert_eq!([0.0, 0.0123, 0.5, 3e-8].map(error), ["0", "0.012", "0.50", "3e-8"]);
        assert_eq!([0.0, 0.003, 1e-5, 2.0].map(tick), ["0", "0.003", "1e-5", "2"]);
        assert_eq!([0.0, 999.0, 12_345.0, 2.5e9].map(count), ["0", "999", "12.3 k", "2.50 G"]);
        assert_eq!(
            [0.0, 1e-6, 0.123, 0.056, 1.0].map(percent),
            ["0 %", "< 0.01 %", "12 %", "5.6 %", "100 %"]
        );
    }

    #[test]
    fn changes_are_in_percent_or_as_factors() {
        let texts = [1.0, 1.09, 0.5, 2.0, 5.0].map(|to| change(1.0, to));
        assert_eq!(texts, ["±0 %", "+9 %", "−50 %", "+100 %", "× 5.0"]);
        assert_eq!(change(0.0, 1.0), "–");
    }
}
