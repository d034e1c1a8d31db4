//! Options of settings, built from the declarations in `strahl-settings`.

use std::fmt;
use std::marker::PhantomData;

use clap::builder::ValueParser;
use clap::error::ErrorKind;
use clap::{Arg, ArgAction, ArgMatches, Command, Error, FromArgMatches};
use strahl_settings::{CommandOption, Domain, Group, SETTINGS, Setting, Settings, SettingsOverrides};

use super::names;

/// The settings that a command has options for.
pub trait Groups {
    /// The groups of settings.
    const GROUPS: &'static [Group];
}

/// All settings.
pub struct EverySetting;

impl Groups for EverySetting {
    const GROUPS: &'static [Group] = Group::ALL;
}

/// Settings of one pixel, for `explain`.
pub struct OfPixel;

impl Groups for OfPixel {
    const GROUPS: &'static [Group] = strahl_session::explain::tree::SETTING_GROUPS;
}

/// Settings of a picture that a baked scene stores.
pub struct OfFrame;

impl Groups for OfFrame {
    const GROUPS: &'static [Group] = &[Group::Frame];
}

/// Settings of a ray query, for `cast`.
pub struct OfRays;

impl Groups for OfRays {
    const GROUPS: &'static [Group] = &[Group::Precision, Group::Acceleration, Group::Work];
}

/// Settings of the work: threads.
pub struct OfWork;

impl Groups for OfWork {
    const GROUPS: &'static [Group] = &[Group::Work];
}

/// The settings that the command line sets.
pub struct SettingArgs<G> {
    /// The settings with an option on the command line.
    pub given: SettingsOverrides,
    groups: PhantomData<G>,
}

impl<G> Clone for SettingArgs<G> {
    fn clone(&self) -> Self {
        SettingArgs { given: self.given.clone(), groups: PhantomData }
    }
}

impl<G> fmt::Debug for SettingArgs<G> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.given.fmt(f)
    }
}

/// The settings of the groups that have an option, with its name.
fn options<G: Groups>() -> impl Iterator<Item = (&'static Setting, &'static str)> {
    let is_one = |setting: &&Setting| G::GROUPS.contains(&setting.group);
    SETTINGS.iter().filter(is_one).filter_map(|setting| Some((setting, setting.option_name()?)))
}

impl<G: Groups> clap::Args for SettingArgs<G> {
    fn augment_args(command: Command) -> Command {
        command.args(options::<G>().map(|(setting, name)| option(setting, name)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<G: Groups> FromArgMatches for SettingArgs<G> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut given = SettingsOverrides::default();
        for (setting, _) in options::<G>() {
            let word = match setting.option {
                CommandOption::Off { .. } => matches.get_flag(setting.name).then(|| "false".to_owned()),
                _ => matches
                    .get_many::<String>(setting.name)
                    .map(|words| words.cloned().collect::<Vec<_>>().join(",")),
            };
            if let Some(word) = word {
                let parsed =
                    setting.parse(&word).map_err(|reason| Error::raw(ErrorKind::ValueValidation, reason))?;
                given = given.or(parsed);
            }
        }
        Ok(SettingArgs { given, groups: PhantomData })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The option of a setting.
fn option(setting: &'static Setting, name: &'static str) -> Arg {
    let arg = Arg::new(setting.name).long(name);
    let placeholder = match setting.option {
        CommandOption::Off { help, .. } => return arg.help(help).action(ArgAction::SetTrue),
        CommandOption::Value(placeholder) => placeholder,
        CommandOption::Never => "",
    };
    let default = setting.word(&Settings::default()).filter(|_| setting.is_in_scenes());
    let default = default.map(|word| format!(" [default: the scene's, or {word}]")).unwrap_or_default();
    let arg = arg.help(format!("{}{default}", setting.about())).value_name(placeholder);
    // Checked here, so that an error message names the option.
    let checked = move |word: &str| setting.parse(word).map(|_| word.to_owned());
    match setting.domain {
        Domain::Name(all) => arg.value_parser(names::parser(all)),
        Domain::Names(all) => {
            arg.value_parser(names::parser(all)).value_delimiter(',').action(ArgAction::Append)
        }
        Domain::Size | Domain::Text => arg.value_parser(ValueParser::new(checked)).allow_hyphen_values(true),
        _ => arg.value_parser(ValueParser::new(checked)).allow_negative_numbers(true),
    }
}
