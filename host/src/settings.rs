//! What `render --print-settings` tells: every setting in force, and who has set it.
//!
//! What is printed is TOML that may stand in a scene; the settings that no scene has, and the
//! command line that asks for all of them, stand in comments.

use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

use strahl_core::{Pixel, Tile};

use crate::args::RenderArgs;
use crate::description::Description;
use crate::finding::{Accel, Finding};
use crate::plan::Effect;
use crate::wanted::Wanted;

/// One setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Its option without the dashes, which is its key in `[render]` too, but for one.
    pub name: &'static str,
    /// What follows the option on the command line, if anything does; none where the command line
    /// cannot ask for it.
    pub word: Option<String>,
    /// As a scene has it, if it can.
    pub value: Option<String>,
    /// Who has set it.
    pub source: Source,
}

/// Who has set something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Nobody.
    Default,
    /// The scene, at this line.
    Scene(usize),
    /// The command line.
    CommandLine,
}

/// The one option that has another name than its key.
const NO_SHADOW_CACHE: &str = "no-shadow-cache";

/// The one key for which there is no option.
const COLORED_SHADOWS: &str = "colored_shadows";

/// The key of an option.
fn key(name: &str) -> &str {
    if name == NO_SHADOW_CACHE { "shadow_cache" } else { name }
}

/// Who has set a key that may stand in a scene, at one of these lines.
fn source(key: &str, is_asked: bool, lines: &BTreeMap<String, usize>) -> Source {
    match lines.get(key) {
        _ if is_asked => Source::CommandLine,
        Some(line) => Source::Scene(*line),
        None => Source::Default,
    }
}

/// Whether shadows are coloured, which the command line can only forbid.
pub fn colored_shadows(args: &RenderArgs, scene: &Description) -> Setting {
    let is_asked = args.without.contains(&Effect::ColoredShadows);
    Setting {
        name: COLORED_SHADOWS,
        word: None,
        value: Some(scene.colored_shadows.is_some().to_string()),
        source: source(COLORED_SHADOWS, is_asked, &scene.setting_lines),
    }
}

/// All settings of a picture that goes to `output`; `lines` are those of the keys in the scene.
pub fn settings(
    args: &RenderArgs,
    wanted: &Wanted,
    output: &Path,
    lines: &BTreeMap<String, usize>,
) -> Vec<Setting> {
    let mut list = Vec::new();
    let mut add = |name: &'static str, is_asked: bool, word: String, value: Option<String>| {
        let source = source(if value.is_some() { key(name) } else { "" }, is_asked, lines);
        list.push(Setting { name, word: Some(word), value, source });
    };
    let picture = &args.picture;
    let (width, height) = (wanted.size.width(), wanted.size.height());
    add(
        "size",
        picture.frame.size.is_some(),
        format!("{width}x{height}"),
        Some(format!("[{width}, {height}]")),
    );
    let number = |number: String| (number.clone(), Some(number));
    let (word, value) = number(wanted.limits.levels.to_string());
    add("levels", picture.frame.levels.is_some(), word, value);
    let (word, value) = number(wanted.limits.cutoff.to_string());
    add("cutoff", picture.frame.cutoff.is_some(), word, value);
    let named = |name: String| (name.clone(), Some(format!("\"{name}\"")));
    let (word, value) = named(wanted.sampling.to_string());
    add("sampler", picture.sampler.is_some(), word, value);
    let (word, value) = named(wanted.filter.name().into());
    add("filter", picture.filter.is_some(), word, value);
    let (word, value) = number(wanted.seed.to_string());
    add("seed", picture.seed.is_some(), word, value);

    let (word, value) = named(wanted.precision.name().into());
    add("precision", args.precision.is_some(), word, value);
    let Finding { accel, walk, heap, bounds, mailbox } = wanted.finding.in_force();
    let (word, value) = named(name_of(accel.unwrap_or(Accel::Auto)));
    add("accel", args.finding.accel.is_some(), word, value);
    // Those that have no meaning for the accelerator are not in force.
    if let Some(walk) = walk {
        let (word, value) = named(name_of(walk));
        add("walk", args.finding.walk.is_some(), word, value);
    }
    if let Some(places) = heap {
        let (word, value) = number(places.to_string());
        add("heap", args.finding.heap.is_some(), word, value);
    }
    if let Some(bounds) = bounds {
        let (word, value) = named(name_of(bounds));
        add("bounds", args.finding.bounds.is_some(), word, value);
    }
    if let Some(slots) = mailbox {
        let (word, value) = number(slots.to_string());
        add("mailbox", args.finding.mailbox.is_some(), word, value);
    }

    if let Some(selecting) = wanted.selecting {
        add("select", true, selecting.to_string(), None);
    }
    if let Some(Tile { first: Pixel { x, y }, width, height }) = wanted.region {
        add("region", true, format!("{x},{y},{width}x{height}"), None);
    }
    if let Some(mask) = &args.mask {
        add("mask", true, quoted(&mask.display().to_string()), None);
    }
    if !args.without.is_empty() {
        let names: Vec<_> = args.without.iter().map(|effect| effect.name()).collect();
        add("without", true, names.join(","), None);
    }
    add(NO_SHADOW_CACHE, args.no_shadow_cache, String::new(), Some(wanted.shadow_cache.to_string()));
    let threads = match wanted.cut.threads {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    add("threads", args.threads.is_some(), threads.to_string(), None);
    add("output", args.output.is_some(), quoted(&output.display().to_string()), None);
    if wanted.shadow_cache {
        // There is no option that turns it on.
        list.iter_mut().filter(|it| it.name == NO_SHADOW_CACHE).for_each(|it| it.word = None);
    }
    list
}

/// The command that asks for all settings of the picture of `scene`.
pub fn command(scene: &Path, settings: &[Setting]) -> String {
    let name = quoted(&scene.display().to_string());
    let asked: Vec<String> = settings.iter().filter_map(option).collect();
    format!("strahl render {name} {}", asked.join(" ")).trim_end().to_owned()
}

/// The option that asks for a setting, if there is one.
fn option(Setting { name, word, .. }: &Setting) -> Option<String> {
    let word = word.as_ref()?;
    Some(if word.is_empty() { format!("--{name}") } else { format!("--{name} {word}") })
}

/// The settings of the picture of `scene` as they are printed.
pub fn text(scene: &Path, settings: &[Setting]) -> String {
    let mut lines = vec![("[render]".to_owned(), None)];
    let in_scene = settings.iter().filter_map(|it| Some((it, it.value.as_ref()?)));
    lines.extend(in_scene.map(|(it, value)| (format!("{} = {value}", key(it.name)), Some(it.source))));
    lines.push((String::new(), None));
    lines.push(("# No part of a scene:".into(), None));
    let others = settings.iter().filter(|it| it.value.is_none());
    lines.extend(others.filter_map(|it| Some((format!("# {}", option(it)?), Some(it.source)))));

    let width = lines.iter().map(|(text, _)| text.chars().count()).max().unwrap_or(0);
    let mut text = format!("# {}\n\n", command(scene, settings));
    for (line, source) in lines {
        match source {
            None => text.push_str(&line),
            Some(Source::Scene(number)) => {
                text.push_str(&format!("{line:<width$}  # {}:{number}", scene.display()));
            }
            Some(source) => text.push_str(&format!("{line:<width$}  # {source}")),
        }
        text.push('\n');
    }
    text
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Source::Default => f.write_str("default"),
            Source::Scene(line) => write!(f, "line {line}"),
            Source::CommandLine => f.write_str("command line"),
        }
    }
}

/// The name of a value on the command line.
fn name_of<T: clap::ValueEnum>(value: T) -> String {
    value.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}

/// A word that a shell leaves as it is.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+:,=@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}
