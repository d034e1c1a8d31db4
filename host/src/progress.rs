//! How far the work is, and whether it should go on.

use std::time::{Duration, Instant};

use indicatif::{HumanCount, ProgressBar, ProgressState, ProgressStyle};

use crate::signals::Signals;
use crate::stop::Stop;
use crate::wrap::width_of_stderr;

/// Somebody who is told of every piece of work that is done, and says when to stop.
#[derive(Clone, Debug)]
pub struct Watch {
    signals: Signals,
    bar: ProgressBar,
    until: Option<Instant>,
}

impl Watch {
    /// Shows nothing, and stops only for `signals`.
    pub fn silent(signals: Signals) -> Self {
        Watch { signals, bar: ProgressBar::hidden(), until: None }
    }

    /// Shows a bar with rate and time left on the standard error, if that is a terminal.
    pub fn on_terminal(signals: Signals) -> Self {
        // indicatif draws on a terminal only. No colours: the bar has nothing to say by them.
        let bar = ProgressBar::no_length();
        let rate = |state: &ProgressState, text: &mut dyn std::fmt::Write| {
            let _ = write!(text, "{}", HumanCount(state.per_sec() as u64));
        };
        // As long as what stands behind it leaves room for, in a row that must not be broken.
        let length = width_of_stderr().saturating_sub(40).clamp(8, 32);
        let template = format!("{{bar:{length}}} {{percent:>3}} %  {{rate}} pixels/s  {{eta}} left");
        let style = ProgressStyle::with_template(&template)
            .map(|style| style.with_key("rate", rate).progress_chars("━━─"));
        if let Ok(style) = style {
            bar.set_style(style);
        }
        Watch { signals, bar, until: None }
    }

    /// The same, but work that lasts longer than until then is given up.
    pub fn until(self, end: Instant) -> Self {
        Watch { until: Some(end), ..self }
    }

    /// Work on this many pixels begins.
    pub fn begin(&self, pixels: usize) {
        self.bar.reset();
        self.bar.set_length(pixels as u64);
        self.bar.enable_steady_tick(Duration::from_millis(200));
    }

    /// This many of them are done.
    pub fn done(&self, pixels: usize) {
        self.bar.inc(pixels as u64);
    }

    /// All of it is done, or given up: the bar is gone.
    pub fn end(&self) {
        self.bar.disable_steady_tick();
        self.bar.finish_and_clear();
    }

    /// `Err` once a signal has come, or the time is over.
    pub fn check(&self) -> Result<(), Stop> {
        match self.until {
            Some(end) if Instant::now() >= end => Err(Stop::Late),
            _ => self.signals.check(),
        }
    }
}
