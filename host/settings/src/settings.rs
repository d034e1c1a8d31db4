//! The declaration of all settings.
//!
//! To add a setting, add it to the list below: all code that reads, writes or shows settings iterates over
//! [`SETTINGS`].

use strahl_core::{Limits, Resolution, Tile};

use crate::accelerator::{Accel, AccelKind, AccelSettings, Bounds, HEAP_ENTRIES, MAILBOX_SLOTS, Walk};
use crate::attributes::{Affects, CommandOption, Group, Scope};
use crate::choice::Choice as _;
use crate::domain::{Domain, Value};
use crate::effect::OptionalEffect;
use crate::precision::Precision;
use crate::sampling::{Filter, SamplerSettings, SelectionSettings};

/// The default resolution of a picture.
pub const DEFAULT_SIZE: Resolution = Resolution::new(640, 480).unwrap();

/// The maximum ray level.
pub const MAX_LEVELS: usize = 64;

/// The maximum number of threads.
const MAX_THREADS: u32 = 1024;

/// The declaration of a setting.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The name of its field in [`Settings`], which is its key in the `[render]` table of a scene.
    pub name: &'static str,
    /// The lines of its documentation.
    doc: &'static str,
    /// The values that it can have.
    pub domain: Domain,
    /// Its option on the command line.
    pub option: CommandOption,
    /// The group of settings that are options of the same commands.
    pub group: Group,
    /// Where it can be set.
    pub scope: Scope,
    /// Whether it affects the picture or only the time.
    pub affects: Affects,
    ruled_out: fn(&Settings) -> Option<String>,
    parse: fn(&str) -> Result<SettingsOverrides, String>,
    is_set: fn(&SettingsOverrides) -> bool,
    word: fn(&Settings) -> Option<String>,
    literal: fn(&Settings) -> Option<String>,
}

/// Declares the settings: their types, and the list of them.
macro_rules! settings {
    (@ruled_out) => { |_| None };
    (@ruled_out $ruled_out:expr) => { $ruled_out };
    ($(
        $(#[doc = $doc:literal])+
        $name:ident: $Type:ty = $default:expr,
        $domain:expr, $option:expr, $group:ident, $scope:ident, $affects:ident $(, $ruled_out:expr)?;
    )+) => {
        /// All settings of a render, each with a value.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Settings {
            $( $(#[doc = $doc])+ pub $name: $Type, )+
        }

        /// Settings of which only some have a value, such as those of a scene or of a command line.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct SettingsOverrides {
            $( $(#[doc = $doc])+ pub $name: Option<$Type>, )+
        }

        impl Default for Settings {
            fn default() -> Self {
                Settings { $($name: $default,)+ }
            }
        }

        impl SettingsOverrides {
            /// These values, and those of `others` for settings that are not set here.
            pub fn or(self, others: SettingsOverrides) -> Self {
                SettingsOverrides { $($name: self.$name.or(others.$name),)+ }
            }

            /// These values, and the defaults for settings that are not set here.
            pub(crate) fn or_default(self) -> Settings {
                let default = Settings::default();
                Settings { $($name: self.$name.unwrap_or(default.$name),)+ }
            }
        }

        /// All settings, in the order in which they are printed.
        pub static SETTINGS: &[Setting] = &[$(Setting {
            name: stringify!($name),
            doc: concat!($($doc),+),
            domain: $domain,
            option: $option,
            group: Group::$group,
            scope: Scope::$scope,
            affects: Affects::$affects,
            ruled_out: settings!(@ruled_out $($ruled_out)?),
            parse: |word| {
                let $name = Some(<$Type as Value>::parse(word, &$domain)?);
                Ok(SettingsOverrides { $name, ..SettingsOverrides::default() })
            },
            is_set: |settings| settings.$name.is_some(),
            word: |settings| settings.$name.word(),
            literal: |settings| settings.$name.literal(),
        }),+];
    };
}

use CommandOption::{Never, Off, Value as With};

// The columns: type and default; domain, option with the name of its value in the help, group, scope, effect, and the
// option that makes it unused.
settings! {
    /// Width and height in pixels.
    size: Resolution = DEFAULT_SIZE,
        Domain::Size, With("WxH"), Frame, Scene, Picture;

    /// Maximum ray level. The camera ray is level 1: with 1 no reflected or transmitted ray is traced, and mirrors are
    /// black.
    levels: u8 = Limits::DEFAULT.levels,
        Domain::Integer(1, MAX_LEVELS as u32), With("N"), Frame, Scene, Picture;

    /// Minimum ray weight: a secondary ray is traced only if its weight in the pixel is more than this, 0 to 1.
    cutoff: f32 = Limits::DEFAULT.cutoff,
        Domain::Fraction, With("W"), Frame, Scene, Picture;

    /// Sampling pattern of a pixel: `single`, one ray through the center; `regular:N`, an N x N grid;
    /// `adaptive:DEPTH:THRESHOLD`, the four corners, with recursive subdivision, up to DEPTH times, where corners differ
    /// by more than THRESHOLD (sRGB, 0 to 1), or with `:items` also where they hit different objects; `stochastic:N`, N
    /// quasi-random samples; `stochastic:MIN..MAX:CONFIDENCE`, samples until the mean is within 1/128 (or the tolerance
    /// after a last `:`) of the true value with this confidence (0 to 1).
    sampler: SamplerSettings = SamplerSettings::Single,
        Domain::Text, With("SAMPLER"), Sampling, Scene, Picture;

    /// Reconstruction filter of a pixel; `adaptive` supports only box.
    filter: Filter = Filter::Box,
        Domain::names_of::<Filter>(), With("FILTER"), Sampling, Scene, Picture;

    /// Seed of the random numbers.
    seed: u32 = 0,
        Domain::Integer(0, u32::MAX), With("N"), Sampling, Scene, Picture;

    /// Pixel selection: trace one pixel of every STEP x STEP block first; trace those between only where these differ by
    /// more than THRESHOLD (sRGB, 0 to 1), or with `:items` where they hit different objects, and interpolate the
    /// others. STEP is 2, 4, 8, 16, 32 or 64.
    select: Option<SelectionSettings> = None,
        Domain::Text, With("STEP:THRESHOLD"), Pixels, CommandLine, Picture;

    /// Render only this region: its upper left pixel and its size.
    region: Option<Tile> = None,
        Domain::Text, With("X,Y,WxH"), Pixels, CommandLine, Picture;

    /// Disable these effects even if the scene requires them; the summary lists them.
    without: Vec<OptionalEffect> = Vec::new(),
        Domain::Names(OptionalEffect::NAMES), With("EFFECT"), Effects, CommandLine, Picture;

    /// Floating-point precision of the computation; numbers of the scene are always rounded to single precision.
    precision: Precision = Precision::Single,
        Domain::names_of::<Precision>(), With("PRECISION"), Precision, Scene, Picture;

    /// Acceleration structure; changes the time, never the picture. `auto` selects one for the scene.
    accel: Accel = AccelSettings::DEFAULT.accel,
        Domain::names_of::<Accel>(), With("KIND"), Acceleration, Scene, Time;

    /// Traversal order of the BVH.
    walk: Walk = AccelSettings::DEFAULT.walk,
        Domain::names_of::<Walk>(), With("WALK"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::Bvh]);

    /// Entries of the priority queue of --walk heap: 0, 1, 4 or 64; fewer entries are slower.
    heap: usize = AccelSettings::DEFAULT.heap,
        Domain::OneOf(&HEAP_ENTRIES), With("N"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::Bvh]).or(it.walk.rules_out_heap());

    /// Bounding volumes of the list, for items and groups of items.
    bounds: Bounds = AccelSettings::DEFAULT.bounds,
        Domain::names_of::<Bounds>(), With("VOLUME"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::List]);

    /// Slots of the mailbox, which avoids testing an item twice for one ray in grid and octree: 0, 8 or 64.
    mailbox: usize = AccelSettings::DEFAULT.mailbox,
        Domain::OneOf(&MAILBOX_SLOTS), With("SLOTS"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::Grid, AccelKind::Octree]);

    /// Whether the last occluder of a light is tested first.
    shadow_cache: bool = true,
        Domain::Flag, Off {
            option: "no-shadow-cache",
            help: "Do not test the last occluder of a light first; changes the time, never the picture",
        },
        Caching, Scene, Time;

    /// Whether shadow rays pass through transparent objects, attenuated and colored but not refracted; otherwise
    /// transparent objects cast full shadows.
    colored_shadows: bool = false,
        Domain::Flag, Never, Effects, Scene, Picture;

    /// Number of threads [default: one per core].
    threads: usize = std::thread::available_parallelism().map_or(1, usize::from),
        Domain::Integer(1, MAX_THREADS), With("N"), Work, CommandLine, Time;
}

impl Setting {
    /// Its help text, in one line without a full stop at its end.
    pub fn about(&self) -> &'static str {
        self.doc.trim().trim_end_matches('.')
    }

    /// The name of its option without the dashes; `None` if it has no option.
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

    /// Parses the value of its option; in the result only this setting is set.
    pub fn parse(&self, word: &str) -> Result<SettingsOverrides, String> {
        (self.parse)(word)
    }

    /// Whether it has a value in `settings`.
    pub fn is_set(&self, settings: &SettingsOverrides) -> bool {
        (self.is_set)(settings)
    }

    /// The value of its option; `None` if the value cannot be written as an option.
    pub fn word(&self, settings: &Settings) -> Option<String> {
        (self.word)(settings)
    }

    /// Its value as a TOML and JSON literal; `None` if it has none.
    pub fn literal(&self, settings: &Settings) -> Option<String> {
        (self.literal)(settings)
    }

    /// Its option with its value; `None` if no option sets this value, or if it is set without any option.
    pub fn option(&self, settings: &Settings) -> Option<String> {
        let (name, word) = (self.option_name()?, self.word(settings)?);
        match self.option {
            CommandOption::Off { .. } => (word == "false").then(|| format!("--{name}")),
            _ => Some(format!("--{name} {word}")),
        }
    }

    /// The option in `settings` that makes it unused, if any.
    pub fn ruled_out(&self, settings: &Settings) -> Option<String> {
        (self.ruled_out)(settings)
    }
}

impl Settings {
    /// The defaults, for a picture of this size.
    pub fn of_size(size: Resolution) -> Self {
        Settings { size, ..Settings::default() }
    }

    /// The maximum level and the cutoff.
    pub fn limits(&self) -> Limits {
        Limits { levels: self.levels, cutoff: self.cutoff }
    }

    /// The settings of the acceleration structure.
    pub fn acceleration(&self) -> AccelSettings {
        let Settings { accel, walk, heap, bounds, mailbox, .. } = *self;
        AccelSettings { accel, walk, heap, bounds, mailbox }
    }

    /// Replaces the maximum level and the cutoff.
    pub fn with_limits(self, limits: Limits) -> Self {
        let Limits { levels, cutoff } = limits;
        Settings { levels, cutoff, ..self }
    }

    /// Replaces the settings of the acceleration structure.
    pub fn with_acceleration(self, acceleration: AccelSettings) -> Self {
        let AccelSettings { accel, walk, heap, bounds, mailbox } = acceleration;
        Settings { accel, walk, heap, bounds, mailbox, ..self }
    }

    /// The pixels that are rendered: the region, or the whole picture.
    pub fn region_or_all(&self) -> Tile {
        let whole = Tile::full(self.size);
        self.region.map_or(whole, |tile| tile.intersection(whole))
    }

    /// The size of the rendered picture: that of the region, or of the whole.
    pub fn picture_size(&self) -> Resolution {
        let Tile { width, height, .. } = self.region_or_all();
        Resolution::new(width, height).unwrap_or(self.size)
    }
}
