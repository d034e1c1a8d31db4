//! The lines of OBJ and MTL files, and the numbers in them.

use std::borrow::Cow;
use std::str::FromStr;

use super::error::LineError;
use crate::quote::quoted;

/// The file as text. What is no UTF-8 is replaced: only names and comments may hold it.
pub fn text_of(bytes: &[u8]) -> Result<Cow<'_, str>, LineError> {
    if let Some(place) = bytes.iter().position(|byte| *byte == 0) {
        let line = 1 + bytes[..place].iter().filter(|byte| **byte == b'\n').count();
        return Err((Some(line), "this is not text".into()));
    }
    Ok(String::from_utf8_lossy(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)))
}

/// A line that says something; a backslash at its end continues it on the next.
#[derive(Clone, Copy)]
pub struct LogicalLine<'t> {
    /// Counted from 1, of its beginning.
    pub number: usize,
    /// Its first word.
    pub keyword: &'t str,
    /// What follows, without white space at either end.
    pub rest: &'t str,
}

/// The lines of `text` that say something.
pub fn lines(text: &str) -> impl Iterator<Item = LogicalLine<'_>> {
    let (mut rest, mut number) = (text, 0);
    std::iter::from_fn(move || {
        loop {
            if rest.is_empty() {
                return None;
            }
            number += 1;
            let first = number;
            let mut end = 0;
            loop {
                end += rest[end..].find('\n').map_or(rest.len() - end, |place| place + 1);
                let line = rest[..end].trim_end_matches(['\r', '\n']);
                if end == rest.len() || !line.ends_with('\\') {
                    break;
                }
                number += 1;
            }
            let line = without_comment(&rest[..end]).trim();
            rest = &rest[end..];
            if let Some(keyword) = line.split_whitespace().next() {
                return Some(LogicalLine { number: first, keyword, rest: line[keyword.len()..].trim() });
            }
        }
    })
}

/// The line up to a word that begins with `#`; inside a word it belongs to a name.
fn without_comment(line: &str) -> &str {
    let begins_word = |place: &usize| !line[..*place].ends_with(|c: char| !c.is_whitespace());
    match line.match_indices('#').map(|(place, _)| place).find(begins_word) {
        Some(place) => &line[..place],
        None => line,
    }
}

impl<'t> LogicalLine<'t> {
    /// An error of this line.
    pub fn error<T>(&self, reason: impl Into<String>) -> Result<T, LineError> {
        Err((Some(self.number), reason.into()))
    }

    /// The words after the keyword.
    pub fn words(&self) -> impl Iterator<Item = &'t str> + use<'t> {
        let is_continued = self.rest.contains('\n');
        let trimmed = move |word: &'t str| if is_continued { word.trim_end_matches('\\') } else { word };
        self.rest.split_whitespace().map(trimmed).filter(|word| !word.is_empty())
    }

    /// The first `N` numbers after the keyword, of `what`.
    pub fn numbers<const N: usize>(&self, what: &str) -> Result<[f32; N], LineError> {
        let mut words = self.words();
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            let Some(word) = words.next() else {
                return self.error(format!("{what} has {N} numbers; one is missing here"));
            };
            *number = self.number(word, what)?;
        }
        Ok(numbers)
    }

    /// The number that `word` is.
    pub fn number<N: FromStr>(&self, word: &str, what: &str) -> Result<N, LineError> {
        match word.parse() {
            Ok(number) => Ok(number),
            Err(_) => self.error(format!("{} is no number; {what} is expected", quoted(word))),
        }
    }
}
