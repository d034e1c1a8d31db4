//! What is turned in a study: everything that decides about a picture and its time.

use strahl_core::{Limits, Size};

use super::record;
use crate::finding::{Choice, Finding, Kind, Walk};
use crate::plan::Effect;
use crate::precision::Precision;
use crate::render_request::RenderRequest;
use strahl_settings::{Filter, PixelSelection as Selecting, Sampling, Settings};

/// Everything that decides about a picture and its time.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Levels and cutoff.
    pub limits: Limits,
    /// Rays in a pixel.
    pub sampling: Sampling,
    /// How much of its surroundings counts in a pixel.
    pub filter: Filter,
    /// Which pixels are traced, where not all are.
    pub selecting: Option<Selecting>,
    /// What is left out of the scene.
    pub without: Vec<Effect>,
    /// What is computed with.
    pub precision: Precision,
    /// How items are found.
    pub finding: Finding,
    /// Whether who last stood in a light is asked first.
    pub shadow_cache: bool,
    /// Threads.
    pub threads: usize,
    /// The seed of what is left to chance.
    pub seed: u32,
}

impl Options {
    /// Those of a render.
    pub fn of(settings: &Settings) -> Self {
        Options {
            limits: settings.limits(),
            sampling: settings.sampler,
            filter: settings.filter,
            selecting: settings.select,
            without: Vec::new(),
            precision: settings.precision,
            finding: settings.acceleration(),
            shadow_cache: settings.shadow_cache,
            threads: settings.threads,
            seed: settings.seed,
        }
    }

    /// The same levels and cutoff with one ray in each pixel, and nothing else that changes the picture.
    pub(super) fn coarse(&self) -> Self {
        Options {
            sampling: Sampling::Single,
            selecting: None,
            precision: Precision::Single,
            seed: 0,
            ..self.clone()
        }
    }

    /// What is to be rendered.
    pub fn request(&self, size: Size) -> RenderRequest {
        let settings = Settings {
            sampler: self.sampling,
            filter: self.filter,
            seed: self.seed,
            select: self.selecting,
            precision: self.precision,
            shadow_cache: self.shadow_cache,
            threads: self.threads,
            ..Settings::of_size(size)
        };
        RenderRequest::new(settings.with_limits(self.limits).with_acceleration(self.finding))
    }

    /// As `study.json` has it; items were found by `choice`.
    pub fn record(&self, choice: &Choice) -> record::Setting {
        record::Setting {
            levels: self.limits.levels,
            cutoff: self.limits.cutoff,
            sampler: self.sampling.to_string(),
            filter: self.filter.name().into(),
            select: self.selecting.map(|it| it.to_string()),
            without: self.without.iter().map(|effect| effect.name().into()).collect(),
            precision: self.precision.name().into(),
            accelerator: choice.to_string(),
            shadow_cache: self.shadow_cache,
            threads: self.threads,
            seed: self.seed,
            options: self.words(),
        }
    }

    /// What the command line says for it. What is usual and changes the time only is not said.
    pub fn words(&self) -> String {
        let mut words = format!(
            "--levels {} --cutoff {} --sampler {}",
            self.limits.levels,
            cutoff(self.limits.cutoff),
            self.sampling
        );
        let mut add = |word: String| {
            words.push_str(" --");
            words.push_str(&word);
        };
        if self.filter != Filter::Box {
            add(format!("filter {}", self.filter.name()));
        }
        if let Some(selecting) = self.selecting {
            add(format!("select {selecting}"));
        }
        if !self.without.is_empty() {
            let names: Vec<_> = self.without.iter().map(|effect| effect.name()).collect();
            add(format!("without {}", names.join(",")));
        }
        if self.precision != Precision::Single {
            add(format!("precision {}", self.precision.name()));
        }
        let Finding { accel, walk, heap, bounds, mailbox } = self.finding;
        let usual = Finding::default();
        if let Some(kind) = accel.kind() {
            add(format!("accel {kind}"));
        }
        let kind = accel.kind();
        let is_one_of = |kinds: &[Kind]| kind.is_none_or(|kind| kinds.contains(&kind));
        if bounds != usual.bounds && is_one_of(&[Kind::List]) {
            add(format!("bounds {bounds}"));
        }
        if walk == Walk::Heap && is_one_of(&[Kind::Bvh]) {
            add("walk heap".into());
            add(format!("heap {heap}"));
        }
        if mailbox != usual.mailbox && is_one_of(&[Kind::Grid, Kind::Octree]) {
            add(format!("mailbox {mailbox}"));
        }
        if !self.shadow_cache {
            add("no-shadow-cache".into());
        }
        if self.seed != 0 {
            add(format!("seed {}", self.seed));
        }
        words
    }
}

/// A cutoff as one divided by a whole number where it is that, as the command line takes it.
pub fn cutoff(value: f32) -> String {
    let whole = 1.0 / value;
    if value > 0.0 && value < 1.0 && whole == (whole as u32) as f32 {
        format!("1/{whole}")
    } else {
        value.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cutoffs_are_told_as_people_say_them() {
        let told = [0.0, 1.0, 0.3, 1.0 / 512.0, 1.0 / 65536.0].map(cutoff);
        assert_eq!(told, ["0", "1", "0.3", "1/512", "1/65536"]);
    }
}
