//! Output of `render --print-settings`: every effective setting and its source.
//!
//! The output is TOML for a scene; settings that a scene cannot have, and the equivalent command line, are comments.

use std::collections::BTreeMap;
use std::path::Path;

use strahl_settings::{Resolved, Setting, SettingSource, Settings};

use crate::args::RenderArgs;

/// The line of each settings key in the scene file.
pub type KeyLines = BTreeMap<&'static str, usize>;

/// The output of `--print-settings` for a picture that is written to `output`.
pub fn text(args: &RenderArgs, resolved: &Resolved, output: &Path, lines: &KeyLines) -> String {
    let settings = &resolved.settings;
    let source = |setting: &Setting| match resolved.source(setting) {
        SettingSource::Default => "default".to_owned(),
        SettingSource::CommandLine => "command line".to_owned(),
        SettingSource::Scene => {
            let line = lines.get(setting.name).map(|line| format!(":{line}")).unwrap_or_default();
            format!("{}{line}", args.scene.display())
        }
    };
    let mut rows = vec![("[render]".to_owned(), None)];
    for setting in settings.in_use().filter(|setting| setting.is_in_scenes()) {
        if let Some(literal) = setting.literal(settings) {
            rows.push((format!("{} = {literal}", setting.name), Some(source(setting))));
        }
    }
    rows.push((String::new(), None));
    rows.push(("# Command-line options only:".into(), None));
    let others = settings.in_use().filter(|setting| !setting.is_in_scenes());
    rows.extend(others.filter_map(|it| Some((format!("# {}", it.option(settings)?), Some(source(it))))));
    for (name, is_given, word) in files(args, output) {
        let source = if is_given { "command line" } else { "default" };
        rows.push((format!("# --{name} {word}"), Some(source.to_owned())));
    }

    let width = rows.iter().map(|(text, _)| text.chars().count()).max().unwrap_or(0);
    let options = settings.in_use().filter_map(|setting| setting.option(settings)).collect();
    let mut text = format!("# {}\n\n", command(args, options, output));
    for (row, source) in rows {
        match source {
            None => text.push_str(&row),
            Some(source) => text.push_str(&format!("{row:<width$}  # {source}")),
        }
        text.push('\n');
    }
    text
}

/// The command that renders the picture with `settings` in place of the resolved ones. Its options are those of the
/// command line and those that differ.
pub fn command_with(args: &RenderArgs, resolved: &Resolved, settings: &Settings, output: &Path) -> String {
    let is_option = |setting: &&Setting| {
        let differs = setting.word(settings) != setting.word(&resolved.settings);
        differs || resolved.source(setting) == SettingSource::CommandLine
    };
    let options = settings.in_use().filter(is_option);
    command(args, options.filter_map(|setting| setting.option(settings)).collect(), output)
}

/// The command with these options.
fn command(args: &RenderArgs, options: Vec<String>, output: &Path) -> String {
    let scene = quoted(&args.scene.display().to_string());
    let files = files(args, output).map(|(name, _, word)| format!("--{name} {word}"));
    let words: Vec<String> =
        ["strahl render".into(), scene].into_iter().chain(options).chain(files).collect();
    words.join(" ")
}

/// The options that name files: the name, whether the command line has it, and the value.
fn files(args: &RenderArgs, output: &Path) -> impl Iterator<Item = (&'static str, bool, String)> {
    let word = |path: &Path| quoted(&path.display().to_string());
    let mask = args.mask.as_deref().map(|mask| ("mask", true, word(mask)));
    mask.into_iter().chain([("output", args.output.is_some(), word(output))])
}

/// The word, quoted for a shell if necessary.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+:,=@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}
