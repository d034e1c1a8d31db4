//! Progress on the terminal: a bar with rate and time left.

use std::time::Duration;

use indicatif::{HumanCount, ProgressBar, ProgressState, ProgressStyle};
use strahl_engine::{Interrupt, Progress};

use crate::signals::Signals;
use crate::word_wrap::stderr_width;

/// Progress bar of a render, which also checks for signals.
#[derive(Clone, Debug)]
pub struct TerminalProgress {
    signals: Signals,
    bar: ProgressBar,
}

impl TerminalProgress {
    /// Shows nothing, and stops only for `signals`.
    pub fn silent(signals: Signals) -> Self {
        TerminalProgress { signals, bar: ProgressBar::hidden() }
    }

    /// Shows a bar with rate and time left on the standard error, if that is a terminal.
    pub fn on_terminal(signals: Signals) -> Self {
        // indicatif draws on a terminal only. No colors.
        let bar = ProgressBar::no_length();
        let rate = |state: &ProgressState, text: &mut dyn std::fmt::Write| {
            let _ = write!(text, "{}", HumanCount(state.per_sec() as u64));
        };
        // The rest of the row is for the text after the bar; the row must not wrap.
        let length = stderr_width().saturating_sub(40).clamp(8, 32);
        let template = format!("{{bar:{length}}} {{percent:>3}} %  {{rate}} pixels/s  {{eta}} left");
        let style = ProgressStyle::with_template(&template)
            .map(|style| style.with_key("rate", rate).progress_chars("━━─"));
        if let Ok(style) = style {
            bar.set_style(style);
        }
        TerminalProgress { signals, bar }
    }

    /// Removes the bar.
    pub fn end(&self) {
        self.bar.disable_steady_tick();
        self.bar.finish_and_clear();
    }
}

impl Progress for TerminalProgress {
    fn begin(&self, pixels: usize) {
        self.bar.reset();
        self.bar.set_length(pixels as u64);
        self.bar.enable_steady_tick(Duration::from_millis(200));
    }

    fn done(&self, pixels: usize) {
        self.bar.inc(pixels as u64);
    }

    fn check(&self) -> Result<(), Interrupt> {
        self.signals.check()
    }
}
