//! Tokens of an NFF file, and parsing of numbers.

use strahl_core::Rgb;
use strahl_core::math::MAX_COORDINATE;

use crate::description::Float3;
use crate::quote::quoted;

/// An error at a line.
pub struct NffError {
    pub line: usize,
    pub reason: String,
}

pub type NffResult<T> = Result<T, NffError>;

/// A word of the file, with its position.
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

    /// The token quoted for a message: truncated, without control characters.
    pub fn shown(&self) -> String {
        quoted(self.text)
    }
}

/// The tokens of the file, without comments.
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

    /// The next token; `what` names it, and `of` is the keyword of its entity, for the error at the end of the file.
    fn expect(&mut self, what: &str, keyword: Token<'_>) -> NffResult<Token<'t>> {
        match self.next() {
            Some(word) => Ok(word),
            None => Err(NffError {
                line: self.lines,
                reason: format!(
                    "unexpected end of file; {what} is missing (`{}` in line {})",
                    keyword.text, keyword.line
                ),
            }),
        }
    }

    pub fn number(&mut self, what: &str, keyword: Token<'_>) -> NffResult<f32> {
        let word = self.expect(what, keyword)?;
        // Rounded once, before its range is checked.
        let Ok(number) = word.text.parse::<f32>() else {
            return word.error(format!("{what} must be a number, not {}", word.shown()));
        };
        if !number.is_finite() {
            return word.error(format!("{what} must be finite, not {}", word.shown()));
        }
        Ok(number)
    }

    /// A number in a range.
    pub fn number_in(&mut self, low: f32, high: f32, what: &str, keyword: Token<'_>) -> NffResult<f32> {
        let word = self.peeked;
        let number = self.number(what, keyword)?;
        match word {
            Some(word) if !(number >= low && number <= high) => {
                word.error(format!("{what} must be {low} to {high}, not {number}"))
            }
            _ => Ok(number),
        }
    }

    pub fn coordinate(&mut self, what: &str, keyword: Token<'_>) -> NffResult<f32> {
        self.number_in(-MAX_COORDINATE, MAX_COORDINATE, what, keyword)
    }

    pub fn point(&mut self, what: &str, keyword: Token<'_>) -> NffResult<Float3> {
        Ok([
            self.coordinate(what, keyword)?,
            self.coordinate(what, keyword)?,
            self.coordinate(what, keyword)?,
        ])
    }

    pub fn color(&mut self, what: &str, keyword: Token<'_>) -> NffResult<Rgb> {
        let mut channel = || self.number_in(0.0, Rgb::MAX_CHANNEL, what, keyword);
        Ok(Rgb::new(channel()?, channel()?, channel()?))
    }

    /// An integer in a range.
    pub fn integer(&mut self, low: u32, high: u32, what: &str, keyword: Token<'_>) -> NffResult<u32> {
        let word = self.expect(what, keyword)?;
        match word.text.parse::<u32>() {
            Ok(number) if number >= low && number <= high => Ok(number),
            _ => {
                let shown = word.shown();
                word.error(format!("{what} must be an integer from {low} to {high}, not {shown}"))
            }
        }
    }

    /// Whether the next token is a number.
    pub fn has_number(&self) -> bool {
        self.peeked.is_some_and(|word| {
            word.text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'))
                || word.text.parse::<f32>().is_ok()
        })
    }
}
