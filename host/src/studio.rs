//! Where pictures of one scene are traced: what is asked there, and what is answered, whatever the
//! precision and the tracer.

use std::error::Error;
use std::fmt;
use std::time::Duration;

use strahl_core::{Counters, Rgb};

use crate::finding::Facts;
use crate::pace::Pace;
use crate::progress::Watch;
use crate::stop::Stop;
use crate::wanted::Wanted;

/// A scene with its accelerator, of which pictures can be traced one after another.
///
/// Precision and finding are those for which it was opened, whatever else is wanted.
pub trait Studio {
    /// Traces a picture.
    fn trace(&self, wanted: &Wanted, watch: &Watch) -> Result<Drawn, NoFrame>;

    /// Traces a picture that becomes better pass by pass, as `pace` says; the last that was
    /// completed.
    fn refine(&self, wanted: &Wanted, watch: &Watch, pace: &mut dyn Pace) -> Result<Drawn, NoFrame>;
}

/// What comes of tracing.
#[derive(Debug)]
pub struct Drawn {
    /// Linear colours, row by row.
    pub colors: Vec<Rgb>,
    /// How items were found.
    pub accelerator: Facts,
    /// The work, where it was counted.
    pub counts: Option<Counters>,
    /// Wall-clock time of tracing.
    pub trace: Duration,
    /// Processor time of tracing, the sum over all threads.
    pub trace_cpu: Duration,
}

/// Why there is no picture.
#[derive(Debug)]
pub enum NoFrame {
    /// What is described cannot be traced.
    Wrong(Box<dyn Error + Send + Sync>),
    /// A signal came.
    Stopped(Stop),
}

impl NoFrame {
    /// Because of what one of the cores says.
    pub(crate) fn wrong(error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        NoFrame::Wrong(error.into())
    }
}

impl fmt::Display for NoFrame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoFrame::Wrong(error) => error.fmt(f),
            NoFrame::Stopped(stop) => stop.fmt(f),
        }
    }
}

impl Error for NoFrame {}
