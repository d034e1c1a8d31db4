//! Comparison: all contenders answer the same rays, alternating, measured in processor time.

use std::time::Duration;

use strahl_core::geometry::Ray;

/// Nearest hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestTriangle {
    pub t: f32,
    pub item: u32,
}

/// A ray tracing structure that is measured.
pub trait Contender {
    /// Size of tree and triangles, in bytes.
    fn bytes(&self) -> usize;
    fn intersect_nearest(&mut self, ray: &Ray) -> Option<ClosestTriangle>;
    fn occluded(&mut self, ray: &Ray, t_max: f32) -> bool;
}

/// Processor time of this thread.
fn cpu() -> Duration {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(now.tv_sec.unsigned_abs(), now.tv_nsec as u32)
}

/// The result of `work` and its processor time.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, Duration) {
    let start = cpu();
    let result = work();
    (result, cpu() - start)
}

/// Kind of ray query.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QueryKind {
    Nearest,
    AnyHit,
}

/// `t_max` of any-hit queries.
pub const ANY_HIT_T_MAX: f32 = 4.0;

/// Rays per second, the median of `rounds` alternating rounds, and number of hits.
pub fn rates(
    contenders: &mut [(&'static str, Box<dyn Contender + '_>)],
    rays: &[Ray],
    query: QueryKind,
    rounds: usize,
) -> Vec<(f64, usize)> {
    let mut rates = vec![Vec::new(); contenders.len()];
    let mut hits = vec![0; contenders.len()];
    for _ in 0..rounds {
        for (((_, contender), rates), hits) in contenders.iter_mut().zip(&mut rates).zip(&mut hits) {
            let (count, time) = timed(|| match query {
                QueryKind::Nearest => {
                    rays.iter().filter(|ray| contender.intersect_nearest(ray).is_some()).count()
                }
                QueryKind::AnyHit => rays.iter().filter(|ray| contender.occluded(ray, ANY_HIT_T_MAX)).count(),
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
