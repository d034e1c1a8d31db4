//! The techniques of ray tracing one by one, on and off.
//!
//! All of them are measured while everything is counted: by the one loop for that, which every
//! accelerator and both precisions have, so that nothing but the technique is between two times.

use strahl_core::Limits;

use super::conduct::{Conduct, Truth};
use super::error::StudyError;
use super::knobs;
use super::options::{Options, cutoff};
use super::record::{Role, Technique};
use crate::finding::{Bounds, Finding, Kind, MAILBOX};
use crate::precision::Precision;
use crate::sampling::{Agreement, Filter, PixelSelection as Selecting, Sampling};

/// One technique: how it is done without, and with it.
struct Pair {
    name: &'static str,
    part: &'static str,
    off: String,
    on: String,
    without: Options,
    with: Options,
    exact: bool,
}

/// Adaptive supersampling sees a difference of this much, and regular sampling as fine is held
/// against it.
const ADAPTIVE: (u8, f32) = (2, 0.05);

/// What the techniques are measured with: the scene's levels and cutoff, one ray in each pixel.
fn base(own: &Options) -> Options {
    Options {
        sampling: Sampling::Single,
        selecting: None,
        precision: Precision::Single,
        finding: Finding::default(),
        shadow_cache: true,
        ..own.clone()
    }
}

/// Measures every technique.
pub(super) fn all(study: &mut Conduct<'_>, own: &Options, truth: &Truth) -> Result<(), StudyError> {
    for pair in pairs(&base(own)) {
        let patience = study.patience();
        let with = study.take(Role::Technique, &pair.with, patience, &truth.picture)?;
        let without = study.take(Role::Technique, &pair.without, patience, &truth.picture)?;
        let error = with.zip(without).and_then(|(with, without)| study.between(with, without));
        let given_up = without.is_none().then(|| study.given_up_after(&pair.without)).flatten();
        let Pair { name, part, off, on, exact, .. } = pair;
        let (name, part) = (name.into(), part.into());
        study.techniques.push(Technique { name, part, off, on, without, given_up, with, exact, error });
    }
    Ok(())
}

/// Measures both precisions.
pub(super) fn precision(study: &mut Conduct<'_>, own: &Options, truth: &Truth) -> Result<(), StudyError> {
    let base = base(own);
    let of = |precision| Options { precision, ..base.clone() };
    let patience = study.patience();
    let single = study.take(Role::Technique, &of(Precision::Single), patience, &truth.picture)?;
    let double = study.take(Role::Technique, &of(Precision::Double), patience, &truth.picture)?;
    knobs::precision(study, [single, double], base.words());
    Ok(())
}

/// Measures one thread, and twice as many each time.
pub(super) fn threads(study: &mut Conduct<'_>, own: &Options, truth: &Truth) -> Result<(), StudyError> {
    let mut threads = 1;
    while threads <= own.threads {
        let (patience, options) = (study.patience(), Options { threads, ..base(own) });
        let run = study.take(Role::Threads, &options, patience, &truth.picture)?;
        study.threads.extend(run);
        threads *= 2;
    }
    Ok(())
}

fn pairs(base: &Options) -> Vec<Pair> {
    let by = |finding| Options { finding, ..base.clone() };
    let list = |bounds| by(Finding { bounds, ..Finding::by(Kind::List) });
    let remembering = |kind, mailbox| by(Finding { mailbox, ..Finding::by(kind) });
    let heap = |places| by(Finding::by_heap(places));
    let boxes = || list(Bounds::Box);
    let exact = |name, part, (off, without): (&str, Options), (on, with): (&str, Options)| Pair {
        name,
        part,
        off: off.into(),
        on: on.into(),
        without,
        with,
        exact: true,
    };
    let every_box = "a list with boxes";
    let mut pairs = vec![
        exact("bounding volumes", "5.1", ("every item", list(Bounds::None)), (every_box, boxes())),
        exact(
            "bounding spheres",
            "5.1",
            ("every item", list(Bounds::None)),
            ("a list with spheres", list(Bounds::Sphere)),
        ),
        exact("regular grid", "5.2", (every_box, boxes()), ("a grid", remembering(Kind::Grid, MAILBOX))),
        exact("octree", "5.3", (every_box, boxes()), ("an octree", remembering(Kind::Octree, MAILBOX))),
        exact("hierarchy", "5.4", (every_box, boxes()), ("a hierarchy, by a heap", heap(64))),
        exact(
            "hierarchy, by a stack",
            "5.4",
            ("by a heap", heap(64)),
            ("by a stack", by(Finding::by(Kind::Bvh))),
        ),
        exact("room in the heap", "5.4", ("none", heap(0)), ("64 nodes", heap(64))),
    ];
    for (name, kind) in [("mailbox of the grid", Kind::Grid), ("mailbox of the octree", Kind::Octree)] {
        let (none, some) = (remembering(kind, 0), remembering(kind, MAILBOX));
        pairs.push(exact(name, "5.5", ("none", none), ("64 slots", some)));
    }
    let no_cache = Options { shadow_cache: false, ..base.clone() };
    pairs.push(exact("shadow cache", "5.6", ("off", no_cache), ("on", base.clone())));

    let cut = if base.limits.cutoff > 0.0 { base.limits.cutoff } else { Limits::DEFAULT.cutoff };
    let limited = |cutoff| Options { limits: Limits { cutoff, ..base.limits }, ..base.clone() };
    let sampled = |sampling| Options { sampling, ..base.clone() };
    let (depth, threshold) = ADAPTIVE;
    let agreement = Agreement { threshold, items: false };
    let adaptive = Sampling::Adaptive { depth, agreement };
    let regular = Sampling::Regular(1 << depth);
    let selecting = Selecting { step: 4, agreement: Agreement { threshold: 0.05, items: true } };
    let selected = Options { selecting: Some(selecting), ..base.clone() };
    let stopping: Sampling = "stochastic:4..16:0.9:0.02".parse().unwrap_or(Sampling::Single);
    let inexact = [
        (
            "adaptive depth",
            "5.7",
            "cutoff 0".into(),
            format!("cutoff {}", cutoff(cut)),
            limited(0.0),
            limited(cut),
        ),
        ("pixel selection", "5.8", "every pixel".into(), selecting.to_string(), base.clone(), selected),
        (
            "adaptive supersampling",
            "4.2",
            regular.to_string(),
            adaptive.to_string(),
            sampled(regular),
            sampled(adaptive),
        ),
        (
            "samples until it is known",
            "4.3",
            Sampling::stochastic(16).to_string(),
            stopping.to_string(),
            sampled(Sampling::stochastic(16)),
            sampled(stopping),
        ),
    ];
    pairs.extend(inexact.into_iter().filter(|it| base.filter == Filter::Box || it.1 != "4.2").map(
        |(name, part, off, on, without, with)| Pair { name, part, off, on, without, with, exact: false },
    ));
    pairs
}

#[cfg(test)]
mod tests {
    use strahl_core::Size;

    use super::*;
    use strahl_settings::Settings;

    #[test]
    fn techniques_that_buy_time_only_differ_in_nothing_that_decides_about_the_picture() {
        let size = Size::new(4, 4).unwrap();
        let own = Options::of(&Settings { threads: 1, ..Settings::of_size(size) });
        let all = pairs(&base(&own));
        assert!(all.len() >= 12);
        for Pair { name, without, with, exact, .. } in all {
            assert_ne!(without, with, "{name}");
            let picture =
                |it: &Options| (it.limits, it.sampling, it.filter, it.selecting, it.seed, it.without.clone());
            assert_eq!(picture(&without) == picture(&with), exact, "{name}");
        }
    }
}
