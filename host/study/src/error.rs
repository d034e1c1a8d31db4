//! Errors of a study and of its files.

use std::error::Error;
use std::fmt;

use strahl_engine::RenderError;
use strahl_settings::SettingsError;

/// Why a scene could not be studied.
#[derive(Debug)]
#[non_exhaustive]
pub enum StudyError {
    /// The settings of the scene contradict each other.
    Settings(SettingsError),
    /// The scene cannot be rendered, or the work was stopped.
    Render(RenderError),
    /// The time limit is too short; the text names one that is long enough.
    TooShort(String),
    /// A picture of the study cannot be encoded.
    Picture(Box<dyn Error + Send + Sync>),
}

impl From<RenderError> for StudyError {
    fn from(error: RenderError) -> Self {
        StudyError::Render(error)
    }
}

impl fmt::Display for StudyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StudyError::Settings(error) => error.fmt(f),
            StudyError::TooShort(reason) => f.write_str(reason),
            StudyError::Render(error) => error.fmt(f),
            StudyError::Picture(error) => error.fmt(f),
        }
    }
}

impl Error for StudyError {}

/// A syntax error in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Line number from 1, if known.
    pub line: Option<usize>,
    /// The reason.
    pub reason: String,
}

impl ParseError {
    /// An error at a line.
    pub(crate) fn at(line: usize, reason: impl Into<String>) -> Self {
        ParseError { line: Some(line), reason: reason.into() }
    }
}

/// An error without a line.
impl From<String> for ParseError {
    fn from(reason: String) -> Self {
        ParseError { line: None, reason }
    }
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.reason),
            None => f.write_str(&self.reason),
        }
    }
}

impl Error for ParseError {}
