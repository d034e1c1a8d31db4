//! Resolution of settings: the command line overrides the scene, which overrides the defaults.

use std::error::Error;
use std::fmt;

use strahl_core::{Resolution, Tile};

use crate::accelerator::Walk;
use crate::effect::OptionalEffect;
use crate::sampling::{Filter, SamplerSettings};
use crate::settings::{SETTINGS, Setting, Settings, SettingsOverrides};

/// The effective settings, and the source of each.
#[derive(Clone, Debug)]
pub struct Resolved {
    /// The effective settings.
    pub settings: Settings,
    command_line: SettingsOverrides,
    scene: SettingsOverrides,
}

/// The source of a setting's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingSource {
    /// The default.
    Default,
    /// The scene.
    Scene,
    /// The command line.
    CommandLine,
}

/// A conflict between settings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SettingsError {
    /// A filter other than box is set together with this sampler, which does not support it.
    FilterNotUsed(SamplerSettings),
    /// An option is given that another one makes unused.
    OptionNotUsed {
        /// The name of the unused option, without the dashes.
        option: &'static str,
        /// The other option, with its dashes and its value.
        by: String,
    },
    /// The region extends beyond a picture of this size.
    RegionOutside(Resolution),
}

impl fmt::Display for SettingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SettingsError::FilterNotUsed(sampling) => {
                write!(f, "`{sampling}` supports only the box filter")
            }
            SettingsError::OptionNotUsed { option, by } if by.as_str() == "--walk stack" => {
                write!(f, "--{option} requires --walk heap")
            }
            SettingsError::OptionNotUsed { option, by } => write!(f, "--{option} cannot be used with {by}"),
            SettingsError::RegionOutside(size) => {
                let (width, height) = (size.width(), size.height());
                write!(f, "the region extends beyond the picture, which is {width}x{height}")
            }
        }
    }
}

impl Error for SettingsError {}

impl Resolved {
    /// Resolves settings in this order: command line, scene, defaults.
    pub fn new(command_line: &SettingsOverrides, scene: &SettingsOverrides) -> Result<Self, SettingsError> {
        let (mut command_line, mut scene) = (command_line.clone(), scene.clone());
        // An unused option is an error. An unused key of the scene is not: the command line may have changed the
        // setting that it belongs to.
        let alone = Settings::from(command_line.clone());
        for setting in SETTINGS.iter().filter(|setting| setting.is_set(&command_line)) {
            if let (Some(option), Some(by)) = (setting.option_name(), setting.ruled_out(&alone)) {
                return Err(SettingsError::OptionNotUsed { option, by });
            }
        }
        // A traversal order or a heap capacity on the command line replaces both.
        if command_line.walk.is_some() {
            scene.heap = None;
        }
        if command_line.heap.is_some() {
            scene.walk = None;
        }
        if command_line
            .without
            .as_ref()
            .is_some_and(|without| without.contains(&OptionalEffect::ColoredShadows))
        {
            command_line.colored_shadows = Some(false);
        }

        let settings = Settings::from(command_line.clone().or(scene.clone()));
        if settings.filter != Filter::Box && !settings.sampler.allows_filter() {
            return Err(SettingsError::FilterNotUsed(settings.sampler));
        }
        if let Some(region) = settings.region
            && region.intersection(Tile::full(settings.size)) != region
        {
            return Err(SettingsError::RegionOutside(settings.size));
        }
        Ok(Resolved { settings, command_line, scene })
    }

    /// The source of a setting.
    pub fn source(&self, setting: &Setting) -> SettingSource {
        if setting.is_set(&self.command_line) {
            SettingSource::CommandLine
        } else if setting.is_set(&self.scene) {
            SettingSource::Scene
        } else {
            SettingSource::Default
        }
    }
}

impl From<SettingsOverrides> for Settings {
    fn from(partial: SettingsOverrides) -> Self {
        // A heap capacity implies the traversal order that uses it.
        let walk = partial.walk.or(partial.heap.map(|_| Walk::Heap));
        SettingsOverrides { walk, ..partial }.or_default()
    }
}

impl Settings {
    /// Resolves settings in this order: command line, scene, defaults.
    pub fn resolve(
        command_line: &SettingsOverrides,
        scene: &SettingsOverrides,
    ) -> Result<Self, SettingsError> {
        Ok(Resolved::new(command_line, scene)?.settings)
    }

    /// The settings that are used, given the others.
    pub fn in_use(&self) -> impl Iterator<Item = &'static Setting> {
        SETTINGS.iter().filter(|setting| setting.ruled_out(self).is_none())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::{Affects, CommandOption};

    /// Parses options.
    fn of(options: &[(&str, &str)]) -> SettingsOverrides {
        let parse = |(name, word): &(&str, &str)| {
            let setting = SETTINGS.iter().find(|setting| setting.name == *name).unwrap();
            setting.parse(word).unwrap()
        };
        options.iter().map(parse).fold(SettingsOverrides::default(), SettingsOverrides::or)
    }

    fn source(resolved: &Resolved, name: &str) -> SettingSource {
        resolved.source(SETTINGS.iter().find(|setting| setting.name == name).unwrap())
    }

    #[test]
    fn the_command_line_wins_over_the_scene_and_the_scene_over_defaults() {
        let (command_line, scene) = (of(&[("levels", "7")]), of(&[("levels", "3"), ("size", "8x6")]));
        let resolved = Resolved::new(&command_line, &scene).unwrap();
        assert_eq!((resolved.settings.levels, resolved.settings.size), (7, Resolution::new(8, 6).unwrap()));
        let sources = ["levels", "size", "cutoff"].map(|name| source(&resolved, name));
        assert_eq!(sources, [SettingSource::CommandLine, SettingSource::Scene, SettingSource::Default]);
    }

    #[test]
    fn every_option_value_reads_back_equal_and_sets_nothing_else() {
        let all = of(&[
            ("size", "8x6"),
            ("levels", "7"),
            ("cutoff", "1/3"),
            ("sampler", "stochastic:4..16:0.9:0.01"),
            ("filter", "tent"),
            ("seed", "9"),
            ("select", "8:0.05:items"),
            ("region", "1,2,3x4"),
            ("without", "lens,motion"),
            ("colored_shadows", "true"),
            ("precision", "double"),
            ("accel", "bvh"),
            ("walk", "heap"),
            ("heap", "4"),
            ("bounds", "none"),
            ("mailbox", "8"),
            ("shadow_cache", "false"),
            ("threads", "3"),
        ]);
        let settings = Settings::from(all);
        for setting in SETTINGS {
            let word = setting.word(&settings).unwrap();
            let parsed = setting.parse(&word).unwrap();
            assert_eq!(SETTINGS.iter().filter(|other| other.is_set(&parsed)).count(), 1, "{word}");
            assert_eq!(setting.word(&Settings::from(parsed)), Some(word));
            assert_ne!(
                setting.word(&settings),
                setting.word(&Settings { threads: 1, ..Settings::default() })
            );
        }
    }

    #[test]
    fn a_heap_capacity_implies_its_traversal_and_another_traversal_discards_the_scenes_capacity() {
        let walked = |command_line: &[(&str, &str)], scene: &[(&str, &str)]| {
            let settings = Settings::resolve(&of(command_line), &of(scene)).unwrap();
            (settings.walk, settings.heap)
        };
        assert_eq!(walked(&[("heap", "4")], &[]), (Walk::Heap, 4));
        assert_eq!(walked(&[("heap", "4")], &[("walk", "stack")]), (Walk::Heap, 4));
        assert_eq!(walked(&[("walk", "heap")], &[("heap", "4")]), (Walk::Heap, 64));
        assert_eq!(walked(&[("walk", "stack")], &[("heap", "4")]), (Walk::Stack, 64));
        assert_eq!(walked(&[], &[("heap", "4")]), (Walk::Heap, 4));
    }

    #[test]
    fn conflicting_options_are_rejected() {
        let refused = |options: &[(&str, &str)]| {
            Settings::resolve(&of(options), &SettingsOverrides::default()).unwrap_err().to_string()
        };
        assert_eq!(
            refused(&[("accel", "grid"), ("walk", "heap")]),
            "--walk cannot be used with --accel grid"
        );
        assert_eq!(refused(&[("walk", "stack"), ("heap", "4")]), "--heap requires --walk heap");
        assert_eq!(
            refused(&[("accel", "bvh"), ("bounds", "box")]),
            "--bounds cannot be used with --accel bvh"
        );
        assert!(
            refused(&[("sampler", "adaptive:2:0.1"), ("filter", "tent")])
                .contains("supports only the box filter")
        );
        assert!(
            refused(&[("size", "4x3"), ("region", "1,0,4x3")]).contains("beyond the picture, which is 4x3")
        );
        // A key of the scene may be unused because of the command line.
        assert!(Settings::resolve(&of(&[("accel", "list")]), &of(&[("mailbox", "8")])).is_ok());
    }

    #[test]
    fn colored_shadows_that_are_disabled_have_the_command_line_as_their_source() {
        let resolved =
            Resolved::new(&of(&[("without", "colored-shadows")]), &of(&[("colored_shadows", "true")]));
        let resolved = resolved.unwrap();
        assert!(!resolved.settings.colored_shadows);
        assert_eq!(source(&resolved, "colored_shadows"), SettingSource::CommandLine);
    }

    #[test]
    fn every_setting_can_be_set_and_has_a_help_text() {
        for setting in SETTINGS {
            assert!(setting.is_in_scenes() || setting.option != CommandOption::Never, "{}", setting.name);
            assert!(setting.option_name().is_none_or(|name| !name.contains('_')), "{}", setting.name);
            assert!(!setting.about().is_empty() && !setting.about().ends_with('.'), "{}", setting.name);
        }
        let time: Vec<_> =
            SETTINGS.iter().filter(|it| it.affects == Affects::Time).map(|it| it.name).collect();
        assert_eq!(time, ["accel", "walk", "heap", "bounds", "mailbox", "shadow_cache", "threads"]);
    }
}
