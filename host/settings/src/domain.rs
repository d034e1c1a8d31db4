//! The values that a setting can have, and their text form.

use std::fmt;

use strahl_core::image::Pixel;
use strahl_core::{Resolution, Tile};

use crate::choice::{Choice, Named};
use crate::effect::OptionalEffect;
use crate::sampling::{SamplerSettings, SelectionSettings};

/// The maximum number of pixels of a picture, whose linear colors take 12 bytes each.
pub const MAX_PIXELS: u64 = 1 << 28;

/// The values that a setting can have.
#[derive(Clone, Copy, Debug)]
pub enum Domain {
    /// True or false.
    Flag,
    /// An integer from the first to the last, inclusive.
    Integer(u32, u32),
    /// One of these integers.
    OneOf(&'static [usize]),
    /// A number from 0 to 1; as an option value also a fraction, as in `1/512`.
    Fraction,
    /// One of these names.
    Name(&'static [Named]),
    /// Some of these names; separated by commas as an option value.
    Names(&'static [Named]),
    /// The width and height of a picture.
    Size,
    /// Text with a syntax of its own.
    Text,
}

impl Domain {
    /// The names of an enumeration.
    pub const fn names_of<T: Choice>() -> Domain {
        Domain::Name(T::NAMES)
    }

    /// Whether it contains an integer.
    pub fn contains(&self, number: u64) -> bool {
        match *self {
            Domain::Integer(first, last) => u64::from(first) <= number && number <= u64::from(last),
            Domain::OneOf(numbers) => numbers.iter().any(|it| *it as u64 == number),
            _ => false,
        }
    }
}

/// Describes the allowed values, as in "must be ...".
impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |words: Vec<String>| match words.split_last() {
            Some((last, [])) => last.clone(),
            Some((last, others)) => format!("{} or {last}", others.join(", ")),
            None => String::new(),
        };
        let names = |names: &[Named]| list(names.iter().map(|it| it.name.to_owned()).collect());
        match *self {
            Domain::Flag => f.write_str("true or false"),
            Domain::Integer(first, last) => write!(f, "an integer from {first} to {last}"),
            Domain::OneOf(numbers) => f.write_str(&list(numbers.iter().map(usize::to_string).collect())),
            Domain::Fraction => f.write_str("a number from 0 to 1"),
            Domain::Name(all) | Domain::Names(all) => f.write_str(&names(all)),
            Domain::Size => f.write_str("a width and a height"),
            Domain::Text => f.write_str("a string"),
        }
    }
}

/// A type of settings, with its text form on the command line and its literals in TOML and JSON.
pub trait Value: Sized {
    /// Parses an option value; the error is a message without the name of the option.
    fn parse(word: &str, domain: &Domain) -> Result<Self, String>;

    /// The option value that parses to this value; `None` if this value is set by omitting the option.
    fn word(&self) -> Option<String>;

    /// The value as a TOML and JSON literal; `None` if it has none.
    fn literal(&self) -> Option<String> {
        self.word().map(|word| quoted(&word))
    }
}

/// The text as a TOML and JSON string.
fn quoted(word: &str) -> String {
    let mut quoted = String::from('"');
    for c in word.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// Parses a number from 0 to 1, which may be written as a fraction.
pub fn parse_fraction(word: &str) -> Result<f64, String> {
    let value = match word.split_once('/') {
        Some((part, whole)) => part.parse::<f64>().and_then(|part| Ok(part / whole.parse::<f64>()?)),
        None => word.parse::<f64>(),
    };
    match value {
        Ok(share) if share >= 0.0 && share <= 1.0 => Ok(share),
        _ => Err("must be 0 to 1, as in 0.01 or 1/255".into()),
    }
}

/// A number from 0 to 1 as text: as `1/N` if it is exactly that, otherwise in decimal.
pub fn fraction_text(share: f32) -> String {
    let whole = libm::round(1.0 / f64::from(share));
    let is_short = whole > 1.0 && whole <= f64::from(1 << 20);
    if is_short && (1.0 / whole) as f32 == share { format!("1/{whole}") } else { share.to_string() }
}

impl Value for bool {
    fn parse(word: &str, domain: &Domain) -> Result<Self, String> {
        word.parse().map_err(|_| format!("must be {domain}"))
    }

    fn word(&self) -> Option<String> {
        Some(self.to_string())
    }

    fn literal(&self) -> Option<String> {
        self.word()
    }
}

macro_rules! integers {
    ($($Integer:ty),+) => {$(
        impl Value for $Integer {
            fn parse(word: &str, domain: &Domain) -> Result<Self, String> {
                let number = word.parse().ok().filter(|number| domain.contains(*number));
                number.and_then(|number| <$Integer>::try_from(number).ok()).ok_or_else(|| format!("must be {domain}"))
            }

            fn word(&self) -> Option<String> {
                Some(self.to_string())
            }

            fn literal(&self) -> Option<String> {
                self.word()
            }
        }
    )+};
}
integers!(u8, u32, usize);

impl Value for f32 {
    fn parse(word: &str, _: &Domain) -> Result<Self, String> {
        // Rounded once.
        match word.parse::<f32>() {
            Ok(number) if number >= 0.0 && number <= 1.0 => Ok(number),
            _ => parse_fraction(word).map(|share| share as f32),
        }
    }

    fn word(&self) -> Option<String> {
        Some(fraction_text(*self))
    }

    fn literal(&self) -> Option<String> {
        Some(self.to_string())
    }
}

impl<T: Choice> Value for T {
    fn parse(word: &str, domain: &Domain) -> Result<Self, String> {
        T::from_name(word).ok_or_else(|| format!("must be {domain}"))
    }

    fn word(&self) -> Option<String> {
        Some(self.name_of().to_owned())
    }
}

impl Value for Vec<OptionalEffect> {
    fn parse(word: &str, domain: &Domain) -> Result<Self, String> {
        word.split(',').map(|name| OptionalEffect::parse(name, domain)).collect()
    }

    fn word(&self) -> Option<String> {
        let names: Vec<_> = self.iter().map(|effect| effect.name()).collect();
        (!names.is_empty()).then(|| names.join(","))
    }

    fn literal(&self) -> Option<String> {
        let names: Vec<_> = self.iter().map(|effect| quoted(effect.name())).collect();
        Some(format!("[{}]", names.join(", ")))
    }
}

impl<T: Value> Value for Option<T> {
    fn parse(word: &str, domain: &Domain) -> Result<Self, String> {
        T::parse(word, domain).map(Some)
    }

    fn word(&self) -> Option<String> {
        self.as_ref().and_then(T::word)
    }

    fn literal(&self) -> Option<String> {
        self.as_ref().and_then(T::literal)
    }
}

macro_rules! texts {
    ($($Text:ty),+) => {$(
        impl Value for $Text {
            fn parse(word: &str, _: &Domain) -> Result<Self, String> {
                word.parse()
            }

            fn word(&self) -> Option<String> {
                Some(self.to_string())
            }
        }
    )+};
}
texts!(SamplerSettings, SelectionSettings);

impl Value for Resolution {
    fn parse(word: &str, _: &Domain) -> Result<Self, String> {
        let parts = word.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
        let Some((width, height)) = parts else {
            return Err("must be WIDTHxHEIGHT, as in 640x480".into());
        };
        match Resolution::new(width, height) {
            Some(size) if u64::from(width) * u64::from(height) <= MAX_PIXELS => Ok(size),
            Some(_) => Err(format!("must have at most {MAX_PIXELS} pixels")),
            None => Err(format!("width and height must be 1 to {}", Resolution::MAX_SIDE)),
        }
    }

    fn word(&self) -> Option<String> {
        Some(format!("{}x{}", self.width(), self.height()))
    }

    fn literal(&self) -> Option<String> {
        Some(format!("[{}, {}]", self.width(), self.height()))
    }
}

impl Value for Tile {
    fn parse(word: &str, _: &Domain) -> Result<Self, String> {
        let invalid = || "must be X,Y,WxH, as in 100,50,320x200".to_string();
        let mut words = word.splitn(3, ',');
        let mut next = || words.next().ok_or_else(invalid);
        let (x, y, size) = (next()?, next()?, next()?);
        let (width, height) = size.split_once(['x', 'X']).ok_or_else(invalid)?;
        let number = |text: &str| text.parse::<u32>().map_err(|_| invalid());
        let (x, y, width, height) = (number(x)?, number(y)?, number(width)?, number(height)?);
        match Resolution::new(width, height) {
            Some(_) => Ok(Tile { top_left: Pixel { x, y }, width, height }),
            None => Err(format!("width and height must be 1 to {}", Resolution::MAX_SIDE)),
        }
    }

    fn word(&self) -> Option<String> {
        let Tile { top_left: Pixel { x, y }, width, height } = self;
        Some(format!("{x},{y},{width}x{height}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_over_an_integer_is_written_as_a_fraction_that_reads_back_exactly() {
        let words = [0.0, 1.0, 0.5, 0.3, 1.0 / 512.0, 1.0 / 255.0, 1.0 / 65536.0].map(fraction_text);
        assert_eq!(words, ["0", "1", "1/2", "0.3", "1/512", "1/255", "1/65536"]);
        for bits in (0..=1.0_f32.to_bits()).step_by(99_991) {
            let share = f32::from_bits(bits);
            assert_eq!(f32::parse(&fraction_text(share), &Domain::Fraction), Ok(share));
            assert_eq!(f32::parse(&share.literal().unwrap(), &Domain::Fraction), Ok(share));
        }
    }

    #[test]
    fn integers_out_of_range_are_rejected_with_the_range() {
        let levels = Domain::Integer(1, 64);
        assert_eq!(["1", "64"].map(|word| u8::parse(word, &levels)), [Ok(1), Ok(64)]);
        for word in ["0", "65", "-1", "300", "1.5", "", "99999999999999999999999"] {
            assert_eq!(u8::parse(word, &levels), Err("must be an integer from 1 to 64".into()), "{word}");
        }
        let sizes = Domain::OneOf(&[0, 8, 64]);
        assert_eq!(usize::parse("8", &sizes), Ok(8));
        assert_eq!(usize::parse("9", &sizes), Err("must be 0, 8 or 64".into()));
    }

    #[test]
    fn strings_are_quoted_for_toml_and_json() {
        assert_eq!(quoted("a\"b\\c\u{1}ü"), "\"a\\\"b\\\\c\\u0001ü\"");
    }
}
