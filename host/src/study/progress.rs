//! How far a study is: what is measured now, and how much time is left.

use strahl_engine::{NoProgress, Progress};

/// Told what a study measures and how much time is left; it may stop the study.
pub trait StudyProgress: Progress {
    /// This setting is measured now, in the words of the command line.
    fn measuring(&self, _setting: &str) {}

    /// So many seconds are over, and about so many are left.
    fn time(&self, _elapsed: f64, _left: f64) {}
}

impl StudyProgress for NoProgress {}
