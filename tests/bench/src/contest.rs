//! One contest: the same rays for all, in turns, by processor time.

use std::time::Duration;

use strahl_core::geometry::Ray;

/// The nearest triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    pub t: f32,
    pub item: u32,
}

/// Somebody who can be asked what rays meet.
pub trait Contender {
    /// The memory for tree and triangles.
    fn bytes(&self) -> usize;
    fn closest(&mut self, ray: &Ray) -> Option<Found>;
    fn any(&mut self, ray: &Ray, reach: f32) -> bool;
}

/// The processor time of this thread.
fn cpu() -> Duration {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(now.tv_sec.unsigned_abs(), now.tv_nsec as u32)
}

/// The processor time of `work`, and what it made.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, Duration) {
    let start = cpu();
    let made = work();
    (made, cpu() - start)
}

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    Closest,
    Any,
}

/// How far a ray looks that asks for anything in its way.
pub const WAY: f32 = 4.0;

/// Rays answered per second, the median of `rounds` in which all take turns, and how many of
/// the rays hit.
pub fn rates(
    contenders: &mut [(&'static str, Box<dyn Contender + '_>)],
    rays: &[Ray],
    question: Question,
    rounds: usize,
) -> Vec<(f64, usize)> {
    let mut rates = vec![Vec::new(); contenders.len()];
    let mut hits = vec![0; contenders.len()];
    for _ in 0..rounds {
        for (((_, contender), rates), hits) in contenders.iter_mut().zip(&mut rates).zip(&mut hits) {
            let (count, time) = timed(|| match question {
                Question::Closest => rays.iter().filter(|ray| contender.closest(ray).is_some()).count(),
                Question::Any => rays.iter().filter(|ray| contender.any(ray, WAY)).count(),
            });
            *hits = count;
            rates.push(rays.len() as f64 / time.as_secs_f64());
        }
    }
    let median = |mut all: Vec<f64>| {
        all.sort_by(f64::total_cmp);
        all[all.len() / 2]
    };
    rates.into_iter().map(median).zip(hits).collect()
}
