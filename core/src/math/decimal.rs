//! Numbers in messages.
//!
//! `core` formats floating-point numbers exactly, by code that can panic as far as the compiler knows, and that
//! takes several KB of flash. Six digits are enough for a message.

use core::fmt::{self, Write};

/// Shown as a decimal number with six significant digits: `1.5`, `-2`, `0.001`, `3e8`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decimal(pub(crate) f32);

/// Significant digits.
const DIGITS: usize = 6;

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Decimal(value) = *self;
        if value.is_nan() {
            return f.write_str("NaN");
        }
        if value < 0.0 {
            f.write_char('-')?;
        }
        let magnitude = f64::from(value.abs());
        if magnitude == f64::INFINITY {
            return f.write_str("inf");
        }
        if magnitude == 0.0 {
            return f.write_char('0');
        }

        // An integer of six digits and a power of ten.
        let (mut scaled, mut exponent) = (magnitude, 0_i32);
        while scaled < 99_999.5 {
            scaled *= 10.0;
            exponent -= 1;
        }
        while scaled >= 999_999.5 {
            scaled /= 10.0;
            exponent += 1;
        }
        let mut integer = (scaled + 0.5) as u32;
        let mut digits = [0; DIGITS];
        let mut count = DIGITS;
        for digit in digits.iter_mut().rev() {
            *digit = (integer % 10) as u8;
            integer /= 10;
        }
        while count > 1 && digits.get(count - 1) == Some(&0) {
            count -= 1;
        }
        // The number of digits before the decimal point.
        match exponent + DIGITS as i32 {
            point @ -2..=0 => {
                f.write_str("0.")?;
                (point..0).try_for_each(|_| f.write_char('0'))?;
                write_digits(f, &digits, count, count)
            }
            point @ 1..=7 => write_digits(f, &digits, count, point as usize),
            point => {
                write_digits(f, &digits, count, 1)?;
                write!(f, "e{}", point - 1)
            }
        }
    }
}

/// The first `count` digits, and zeros after them, with a decimal point after `before` of them unless nothing follows it.
fn write_digits(
    f: &mut fmt::Formatter<'_>,
    digits: &[u8; DIGITS],
    count: usize,
    before: usize,
) -> fmt::Result {
    let places = if before > count { before } else { count };
    for place in 0..places {
        if place == before {
            f.write_char('.')?;
        }
        let digit = digits.get(place).copied().unwrap_or(0);
        f.write_char(char::from(b'0' + digit % 10))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::string::ToString;

    use super::*;

    #[test]
    fn numbers_are_shown_with_six_digits() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-2.0, "-2"),
            (1.5, "1.5"),
            (0.1, "0.1"),
            (10.0, "10"),
            (1234.5, "1234.5"),
            (999_999.5, "1000000"),
            (2e6, "2000000"),
            (3e8, "3e8"),
            (1.25e-3, "0.00125"),
            (1.25e-4, "1.25e-4"),
            (1.0 / 3.0, "0.333333"),
            (2.0 / 3.0, "0.666667"),
            (f32::MAX, "3.40282e38"),
            (f32::MIN_POSITIVE, "1.17549e-38"),
            (f32::from_bits(1), "1.4013e-45"),
            (f32::INFINITY, "inf"),
            (f32::NEG_INFINITY, "-inf"),
            (f32::NAN, "NaN"),
        ] {
            assert_eq!(Decimal(value).to_string(), text);
        }
    }
}
