//! The lines of OBJ and MTL files, and the numbers in them.

use std::borrow::Cow;
use std::str::FromStr;

use super::error::LineError;
use crate::quote::quoted;

/// The file as text. Invalid UTF-8 is replaced: it can only be in names and comments.
pub fn text_of(bytes: &[u8]) -> Result<Cow<'_, str>, LineError> {
    if let Some(position) = bytes.iter().position(|byte| *byte == 0) {
        let line = 1 + bytes[..position].iter().filter(|byte| **byte == b'\n').count();
        return Err((Some(line), "not a text file".into()));
    }
    Ok(String::from_utf8_lossy(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)))
}

/// A line that is neither empty nor a comment; a backslash at its end continues it on the next.
#[derive(Clone, Copy)]
pub struct LogicalLine<'t> {
    /// The number of its first line, counted from 1.
    pub number: usize,
    /// Its first word.
    pub keyword: &'t str,
    /// The text after the keyword, trimmed.
    pub rest: &'t str,
}

/// The logical lines of `text`.
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
                end += rest[end..].find('\n').map_or(rest.len() - end, |position| position + 1);
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

/// The line up to a word that starts with `#`; inside a word it is part of a name.
fn without_comment(line: &str) -> &str {
    let begins_word = |position: &usize| !line[..*position].ends_with(|c: char| !c.is_whitespace());
    match line.match_indices('#').map(|(position, _)| position).find(begins_word) {
        Some(position) => &line[..position],
        None => line,
    }
}

impl<'t> LogicalLine<'t> {
    /// An error at this line.
    pub fn error<T>(&self, reason: impl Into<String>) -> Result<T, LineError> {
        Err((Some(self.number), reason.into()))
    }

    /// The words after the keyword.
    pub fn words(&self) -> impl Iterator<Item = &'t str> + use<'t> {
        let is_continued = self.rest.contains('\n');
        let trimmed = move |word: &'t str| if is_continued { word.trim_end_matches('\\') } else { word };
        self.rest.split_whitespace().map(trimmed).filter(|word| !word.is_empty())
    }

    /// The first `N` numbers after the keyword; `what` names them in errors.
    pub fn numbers<const N: usize>(&self, what: &str) -> Result<[f32; N], LineError> {
        let mut words = self.words();
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            let Some(word) = words.next() else {
                return self.error(format!("{what} needs {N} numbers"));
            };
            *number = self.number(word, what)?;
        }
        Ok(numbers)
    }

    /// Parses a number; `what` names it in errors.
    pub fn number<N: FromStr>(&self, word: &str, what: &str) -> Result<N, LineError> {
        match word.parse() {
            Ok(number) => Ok(number),
            Err(_) => self.error(format!("{what} must be a number, not {}", quoted(word))),
        }
    }
}
