//! How far a study is: what is measured now, and how much time is left.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::options::Options;
use crate::wrap::width_of_stderr;

/// Parts of the bar.
const PARTS: u64 = 1000;

/// A bar over the time that a study is expected to take.
#[derive(Debug)]
pub struct Meter {
    bar: ProgressBar,
    begun: Instant,
    /// Letters that have room behind the bar.
    room: usize,
}

impl Meter {
    /// Shows nothing.
    pub fn silent() -> Self {
        Meter { bar: ProgressBar::hidden(), begun: Instant::now(), room: 0 }
    }

    /// Shows a bar on the standard error, if that is a terminal.
    pub fn on_terminal() -> Self {
        let bar = ProgressBar::new(PARTS);
        let width = width_of_stderr();
        let length = width.saturating_sub(70).clamp(8, 32);
        let template = format!("{{bar:{length}}} {{percent:>3}} %  {{prefix}}  {{msg}}");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style.progress_chars("━━─"));
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Meter { bar, begun: Instant::now(), room: width.saturating_sub(length + 24) }
    }

    /// The same, but the time is counted from `begun`.
    pub fn since(self, begun: Instant) -> Self {
        Meter { begun, ..self }
    }

    /// Seconds since it began.
    pub fn elapsed(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }

    /// Now this is measured.
    pub fn about(&self, options: &Options) {
        let short: String = options.words().replace("--", "").chars().take(self.room).collect();
        self.bar.set_message(short);
    }

    /// About so many seconds are left.
    pub fn left(&self, seconds: f64) {
        let elapsed = self.elapsed();
        let whole = elapsed + seconds.max(0.0);
        self.bar.set_position((PARTS as f64 * elapsed / whole.max(1e-9)) as u64);
        self.bar.set_prefix(if seconds < 100.0 {
            format!("{:.0} s left", seconds.max(0.0))
        } else {
            format!("{:.0} min left", (seconds / 60.0).ceil())
        });
    }

    /// It is over: the bar is gone.
    pub fn end(&self) {
        self.bar.disable_steady_tick();
        self.bar.finish_and_clear();
    }
}
