//! The words of an NFF file, and the numbers among them.

use strahl_core::Rgb;
use strahl_core::math::MAX_COORDINATE;

use crate::description::Float3;
use crate::quote::quoted;

/// What is wrong at a line.
pub struct NffError {
    pub line: usize,
    pub reason: String,
}

pub type NffResult<T> = Result<T, NffError>;

/// A word of the file.
#[derive(Clone, Copy)]
pub struct Token<'t> {
    pub text: &'t str,
    pub line: usize,
    pub begins_line: bool,
}

impl Token<'_> {
    pub fn error<T>(&self, reason: impl Into<String>) -> NffResult<T> {
        Err(NffError { line: self.line, reason: reason.into() })
    }

    /// The word as it may stand in a message: short, and without control characters.
    pub fn shown(&self) -> String {
        quoted(self.text)
    }
}

/// The words of the file, without its comments.
pub struct Tokens<'t> {
    pub peeked: Option<Token<'t>>,
    rest: Box<dyn Iterator<Item = Token<'t>> + 't>,
    pub lines: usize,
}

impl<'t> Tokens<'t> {
    pub fn of(text: &'t str) -> Self {
        let words = text.lines().zip(1..).flat_map(|(content, line)| {
            let content = content.split('#').next().unwrap_or_default();
            let words = content.split_whitespace().enumerate();
            words.map(move |(place, text)| Token { text, line, begins_line: place == 0 })
        });
        let mut words = Tokens { peeked: None, rest: Box::new(words), lines: text.lines().count().max(1) };
        words.peeked = words.rest.next();
        words
    }

    pub fn next(&mut self) -> Option<Token<'t>> {
        std::mem::replace(&mut self.peeked, self.rest.next())
    }

    /// The next word, which must be there: `what` of the entity that begins with `of`.
    fn expect(&mut self, what: &str, of: Token<'_>) -> NffResult<Token<'t>> {
        match self.next() {
            Some(word) => Ok(word),
            None => Err(NffError {
                line: self.lines,
                reason: format!(
                    "the file ends where {what} should follow (`{}` in line {})",
                    of.text, of.line
                ),
            }),
        }
    }

    pub fn number(&mut self, what: &str, of: Token<'_>) -> NffResult<f32> {
        let word = self.expect(what, of)?;
        // Rounded once, and then in range or not.
        let Ok(number) = word.text.parse::<f32>() else {
            return word.error(format!("{} is no number; {what} is expected", word.shown()));
        };
        if !number.is_finite() {
            return word.error(format!("{} is not a finite number; {what} is expected", word.shown()));
        }
        Ok(number)
    }

    /// A number in a range.
    pub fn number_in(&mut self, low: f32, high: f32, what: &str, of: Token<'_>) -> NffResult<f32> {
        let word = self.peeked;
        let number = self.number(what, of)?;
        match word {
            Some(word) if !(number >= low && number <= high) => {
                word.error(format!("{what} must be between {low} and {high}, not {number}"))
            }
            _ => Ok(number),
        }
    }

    pub fn coordinate(&mut self, what: &str, of: Token<'_>) -> NffResult<f32> {
        self.number_in(-MAX_COORDINATE, MAX_COORDINATE, what, of)
    }

    pub fn point(&mut self, what: &str, of: Token<'_>) -> NffResult<Float3> {
        Ok([self.coordinate(what, of)?, self.coordinate(what, of)?, self.coordinate(what, of)?])
    }

    pub fn color(&mut self, what: &str, of: Token<'_>) -> NffResult<Rgb> {
        let mut channel = || self.number_in(0.0, Rgb::MAX_CHANNEL, what, of);
        Ok(Rgb::new(channel()?, channel()?, channel()?))
    }

    /// An integer in a range.
    pub fn integer(&mut self, low: u32, high: u32, what: &str, of: Token<'_>) -> NffResult<u32> {
        let word = self.expect(what, of)?;
        match word.text.parse::<u32>() {
            Ok(number) if number >= low && number <= high => Ok(number),
            _ => {
                let shown = word.shown();
                word.error(format!("{what} must be an integer between {low} and {high}, not {shown}"))
            }
        }
    }

    /// Whether a number follows, and no keyword.
    pub fn has_number(&self) -> bool {
        self.peeked.is_some_and(|word| {
            word.text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'))
                || word.text.parse::<f32>().is_ok()
        })
    }
}
