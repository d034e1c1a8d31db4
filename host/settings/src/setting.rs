//! What is known of one setting.

use crate::domain::Domain;
use crate::settings::{PartialSettings, Settings};

/// One setting, as it is declared in [`settings`](crate::settings).
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The name of its field in [`Settings`], which is its key in the `[render]` table of a scene.
    pub name: &'static str,
    /// The lines of its documentation.
    pub(crate) doc: &'static str,
    /// The values that it may have.
    pub domain: Domain,
    /// How the command line asks for it.
    pub option: CommandOption,
    /// Those with which it is an option of the same commands.
    pub group: Group,
    /// Where it can be set.
    pub scope: Scope,
    /// What it has an effect on.
    pub affects: Affects,
    pub(crate) ruled_out: fn(&Settings) -> Option<String>,
    pub(crate) parse: fn(&str) -> Result<PartialSettings, String>,
    pub(crate) is_set: fn(&PartialSettings) -> bool,
    pub(crate) word: fn(&Settings) -> Option<String>,
    pub(crate) literal: fn(&Settings) -> Option<String>,
}

/// How the command line asks for a setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommandOption {
    /// By an option of its name, which has a value; what stands for it in the help.
    Value(&'static str),
    /// It is on, and an option turns it off.
    Off {
        /// The name of that, without the dashes.
        option: &'static str,
        /// Its help.
        help: &'static str,
    },
    /// Not at all.
    Never,
}

/// Settings that are options of the same commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// How large the picture is, and how deep its rays go.
    Frame,
    /// Which rays make a pixel.
    Sampling,
    /// Which pixels are traced.
    Pixels,
    /// What is simulated.
    Effects,
    /// What is computed with.
    Precision,
    /// How items are found.
    Acceleration,
    /// What is kept from one ray to the next.
    Caching,
    /// How the work is divided.
    Work,
}

/// Where a setting can be set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// In a scene, and on the command line if it has an option.
    Scene,
    /// On the command line only.
    CommandLine,
}

/// What a setting has an effect on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Affects {
    /// The bytes of the picture: two pictures are known to be the same only if all these are.
    Picture,
    /// Time and memory, and no byte of the picture.
    Time,
}

impl Group {
    /// Every group.
    pub const ALL: &'static [Group] = &[
        Group::Frame,
        Group::Sampling,
        Group::Pixels,
        Group::Effects,
        Group::Precision,
        Group::Acceleration,
        Group::Caching,
        Group::Work,
    ];
}

impl Setting {
    /// What it is, in one line without a full stop at its end.
    pub fn about(&self) -> &'static str {
        self.doc.trim().trim_end_matches('.')
    }

    /// The name of its option, without the dashes.
    pub fn option_name(&self) -> Option<&'static str> {
        match self.option {
            CommandOption::Value(_) => Some(self.name),
            CommandOption::Off { option, .. } => Some(option),
            CommandOption::Never => None,
        }
    }

    /// Whether it can be set in a scene.
    pub fn is_in_scenes(&self) -> bool {
        self.scope == Scope::Scene
    }

    /// The settings in which this one has the value of a word and nothing else is set.
    pub fn parse(&self, word: &str) -> Result<PartialSettings, String> {
        (self.parse)(word)
    }

    /// Whether it is set.
    pub fn is_set(&self, settings: &PartialSettings) -> bool {
        (self.is_set)(settings)
    }

    /// Its value as a word, where it has one.
    pub fn word(&self, settings: &Settings) -> Option<String> {
        (self.word)(settings)
    }

    /// Its value as TOML and JSON have it, where it has one.
    pub fn literal(&self, settings: &Settings) -> Option<String> {
        (self.literal)(settings)
    }

    /// The options that ask for its value; none where no option does, or without any it is the same.
    pub fn option(&self, settings: &Settings) -> Option<String> {
        let (name, word) = (self.option_name()?, self.word(settings)?);
        match self.option {
            CommandOption::Off { .. } => (word == "false").then(|| format!("--{name}")),
            _ => Some(format!("--{name} {word}")),
        }
    }

    /// The option that leaves no use for it, where one of these settings does.
    pub fn ruled_out(&self, settings: &Settings) -> Option<String> {
        (self.ruled_out)(settings)
    }
}
