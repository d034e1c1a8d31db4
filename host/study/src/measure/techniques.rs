//! The techniques of ray tracing, each on and off.
//!
//! All are measured with counting enabled, by the same compiled loop for every accelerator and both precisions, so that two
//! times differ only by the technique.

use strahl_settings::accelerator::DEFAULT_MAILBOX_SLOTS;
use strahl_settings::domain::fraction_text;
use strahl_settings::{
    AccelKind, AccelSettings, Bounds, ContrastSettings, Filter, Precision, SamplerSettings,
    SelectionSettings, Settings,
};

use super::measurements::{Measurements, ReferencePicture};
use super::sweeps;
use crate::error::StudyError;
use crate::record::command_line;
use crate::record::{RunRole, Technique};

/// Settings without and with a technique.
struct TechniquePair {
    name: &'static str,
    lecture_section: &'static str,
    off: String,
    on: String,
    without: Settings,
    with: Settings,
    exact: bool,
}

/// Maximum depth and threshold of adaptive supersampling; regular sampling of the same depth is compared with it.
const ADAPTIVE_SETTINGS: (u8, f32) = (2, 0.05);

/// The common settings of all techniques: levels and cutoff of the scene, one ray per pixel.
fn base(own: &Settings) -> Settings {
    Settings {
        sampler: SamplerSettings::Single,
        select: None,
        precision: Precision::Single,
        shadow_cache: true,
        ..own.clone()
    }
    .with_acceleration(AccelSettings::DEFAULT)
}

/// Measures every technique.
pub(super) fn all(
    measured: &mut Measurements<'_>,
    own: &Settings,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    for pair in pairs(&base(own)) {
        let patience = measured.technique_limit();
        let with = measured.measure(RunRole::Technique, &pair.with, patience, &reference.picture)?;
        let without = measured.measure(RunRole::Technique, &pair.without, patience, &reference.picture)?;
        let error = with.zip(without).and_then(|(with, without)| measured.difference(with, without));
        let given_up = without.is_none().then(|| measured.given_up_after(&pair.without)).flatten();
        let TechniquePair { name, lecture_section: part, off, on, exact, .. } = pair;
        let (name, part) = (name.into(), part.into());
        measured.techniques.push(Technique { name, part, off, on, without, given_up, with, exact, error });
    }
    Ok(())
}

/// Measures both precisions.
pub(super) fn precision(
    measured: &mut Measurements<'_>,
    own: &Settings,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let base = base(own);
    let of = |precision| Settings { precision, ..base.clone() };
    let patience = measured.technique_limit();
    let single =
        measured.measure(RunRole::Technique, &of(Precision::Single), patience, &reference.picture)?;
    let double =
        measured.measure(RunRole::Technique, &of(Precision::Double), patience, &reference.picture)?;
    sweeps::precision(measured, [single, double], command_line(&base));
    Ok(())
}

/// Measures 1, 2, 4 ... threads.
pub(super) fn threads(
    measured: &mut Measurements<'_>,
    own: &Settings,
    reference: &ReferencePicture,
) -> Result<(), StudyError> {
    let mut threads = 1;
    while threads <= own.threads {
        let (patience, options) = (measured.technique_limit(), Settings { threads, ..base(own) });
        let run = measured.measure(RunRole::Threads, &options, patience, &reference.picture)?;
        measured.threads.extend(run);
        threads *= 2;
    }
    Ok(())
}

fn pairs(base: &Settings) -> Vec<TechniquePair> {
    let by = |accelerator| base.clone().with_acceleration(accelerator);
    let list = |bounds| by(AccelSettings { bounds, ..AccelSettings::with_kind(AccelKind::List) });
    let remembering = |kind, mailbox| by(AccelSettings { mailbox, ..AccelSettings::with_kind(kind) });
    let heap = |places| by(AccelSettings::with_heap(places));
    let boxes = || list(Bounds::Box);
    let exact = |name, part, (off, without): (&str, Settings), (on, with): (&str, Settings)| TechniquePair {
        name,
        lecture_section: part,
        off: off.into(),
        on: on.into(),
        without,
        with,
        exact: true,
    };
    let every_box = "a list with boxes";
    let mut pairs = vec![
        exact("bounding volumes", "5.1", ("no bounding volumes", list(Bounds::None)), (every_box, boxes())),
        exact(
            "bounding spheres",
            "5.1",
            ("no bounding volumes", list(Bounds::None)),
            ("a list with spheres", list(Bounds::Sphere)),
        ),
        exact(
            "regular grid",
            "5.2",
            (every_box, boxes()),
            ("a grid", remembering(AccelKind::Grid, DEFAULT_MAILBOX_SLOTS)),
        ),
        exact(
            "octree",
            "5.3",
            (every_box, boxes()),
            ("an octree", remembering(AccelKind::Octree, DEFAULT_MAILBOX_SLOTS)),
        ),
        exact("BVH", "5.4", (every_box, boxes()), ("BVH with a heap", heap(64))),
        exact(
            "BVH with a stack",
            "5.4",
            ("with a heap", heap(64)),
            ("with a stack", by(AccelSettings::with_kind(AccelKind::Bvh))),
        ),
        exact("heap capacity", "5.4", ("none", heap(0)), ("64 entries", heap(64))),
    ];
    for (name, kind) in
        [("mailbox of the grid", AccelKind::Grid), ("mailbox of the octree", AccelKind::Octree)]
    {
        let (none, some) = (remembering(kind, 0), remembering(kind, DEFAULT_MAILBOX_SLOTS));
        pairs.push(exact(name, "5.5", ("none", none), ("64 slots", some)));
    }
    let no_cache = Settings { shadow_cache: false, ..base.clone() };
    pairs.push(exact("shadow cache", "5.6", ("off", no_cache), ("on", base.clone())));

    let cut = if base.cutoff > 0.0 { base.cutoff } else { Settings::default().cutoff };
    let limited = |cutoff| Settings { cutoff, ..base.clone() };
    let sampled = |sampler| Settings { sampler, ..base.clone() };
    let (depth, threshold) = ADAPTIVE_SETTINGS;
    let contrast = ContrastSettings { threshold, items: false };
    let adaptive = SamplerSettings::Adaptive { max_depth: depth, contrast };
    let regular = SamplerSettings::Regular(1 << depth);
    let selecting =
        SelectionSettings { step: 4, contrast: ContrastSettings { threshold: 0.05, items: true } };
    let selected = Settings { select: Some(selecting), ..base.clone() };
    let stopping: SamplerSettings = "stochastic:4..16:0.9:0.02".parse().unwrap_or(SamplerSettings::Single);
    let inexact = [
        (
            "adaptive depth",
            "5.7",
            "cutoff 0".into(),
            format!("cutoff {}", fraction_text(cut)),
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
            "adaptive sample count",
            "4.3",
            SamplerSettings::stochastic(16).to_string(),
            stopping.to_string(),
            sampled(SamplerSettings::stochastic(16)),
            sampled(stopping),
        ),
    ];
    pairs.extend(inexact.into_iter().filter(|it| base.filter == Filter::Box || it.1 != "4.2").map(
        |(name, part, off, on, without, with)| TechniquePair {
            name,
            lecture_section: part,
            off,
            on,
            without,
            with,
            exact: false,
        },
    ));
    pairs
}

#[cfg(test)]
mod tests {
    use strahl_settings::{Affects, SETTINGS};

    use super::*;

    #[test]
    fn exact_techniques_differ_only_in_settings_that_do_not_change_the_picture() {
        let all = pairs(&base(&Settings::default()));
        assert!(all.len() >= 12);
        for TechniquePair { name, without, with, exact, .. } in all {
            assert_ne!(without, with, "{name}");
            let picture = |it: &Settings| {
                SETTINGS
                    .iter()
                    .filter(|setting| setting.affects == Affects::Picture)
                    .map(|setting| setting.word(it))
                    .collect::<Vec<_>>()
            };
            assert_eq!(picture(&without) == picture(&with), exact, "{name}");
        }
    }
}
