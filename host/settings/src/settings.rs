//! The declaration of all settings.
//!
//! To add a setting, add it to the list at the end: everything that reads, writes or shows settings goes through
//! [`SETTINGS`].

use strahl_core::{Limits, Resolution, Tile};

use crate::accelerator::{Accel, AccelKind, AccelSettings, Bounds, HEAP_ENTRIES, MAILBOX_SLOTS, Walk};
use crate::attributes::{Affects, CommandOption, Group, Scope};
use crate::choice::Choice as _;
use crate::domain::{Domain, Value};
use crate::effect::Effect;
use crate::precision::Precision;
use crate::sampling::{Filter, SamplerSettings, SelectionSettings};

/// The size of a picture where nothing sets one.
pub const DEFAULT_SIZE: Resolution = Resolution::new(640, 480).unwrap();

/// The most levels of rays.
pub const MAX_LEVELS: usize = 64;

/// The most threads.
const MAX_THREADS: u32 = 1024;

/// One setting, as it is declared below.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The name of its field in [`Settings`], which is its key in the `[render]` table of a scene.
    pub name: &'static str,
    /// The lines of its documentation.
    doc: &'static str,
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
        /// What a render is asked for. Everything has a value; [`default`](Settings::default) are those that nobody
        /// has set.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Settings {
            $( $(#[doc = $doc])+ pub $name: $Type, )+
        }

        /// Some settings: those of a scene, or those of a command line.
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
            /// These, and where they are not set, the others.
            pub fn or(self, others: SettingsOverrides) -> Self {
                SettingsOverrides { $($name: self.$name.or(others.$name),)+ }
            }

            /// These, and where they are not set, the defaults.
            pub(crate) fn or_default(self) -> Settings {
                let default = Settings::default();
                Settings { $($name: self.$name.unwrap_or(default.$name),)+ }
            }
        }

        /// All settings.
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

// The columns: type and default; values, what stands for one in the help; with which others it is an option, where it
// can be set, what it has an effect on, and which option leaves no use for it.
settings! {
    /// Width and height in pixels.
    size: Resolution = DEFAULT_SIZE,
        Domain::Size, With("WxH"), Frame, Scene, Picture;

    /// Levels of rays; 1 sends no ray from a surface, mirrors stay black.
    levels: u8 = Limits::DEFAULT.levels,
        Domain::Integer(1, MAX_LEVELS as u32), With("N"), Frame, Scene, Picture;

    /// A ray is sent when more than this share of what it finds counts in the pixel, 0 to 1.
    cutoff: f32 = Limits::DEFAULT.cutoff,
        Domain::Fraction, With("W"), Frame, Scene, Picture;

    /// Rays in each pixel: `single` through the center; `regular:N` N times N; `adaptive:DEPTH:THRESHOLD` through the
    /// corners, and again through those of its quarters where they differ more than THRESHOLD (sRGB, 0 to 1), up to
    /// DEPTH times, with `:items` also where they meet different objects; `stochastic:N` through places without a
    /// raster; `stochastic:MIN..MAX:CONFIDENCE` until with this confidence (0 to 1) the mean is at most 1/128 off (or
    /// what follows a last `:`).
    sampler: SamplerSettings = SamplerSettings::Single,
        Domain::Text, With("SAMPLER"), Sampling, Scene, Picture;

    /// How much of its surroundings counts in a pixel; not with `adaptive`, which fills the pixel.
    filter: Filter = Filter::Box,
        Domain::names_of::<Filter>(), With("FILTER"), Sampling, Scene, Picture;

    /// Another seed, other random numbers.
    seed: u32 = 0,
        Domain::Integer(0, u32::MAX), With("N"), Sampling, Scene, Picture;

    /// Trace one pixel in STEP times STEP, and those between only where these differ more than THRESHOLD (sRGB, 0 to
    /// 1), or with `:items` where they meet different objects; else interpolate them. STEP is 2, 4, 8, 16, 32 or 64.
    select: Option<SelectionSettings> = None,
        Domain::Text, With("STEP:THRESHOLD"), Pixels, CommandLine, Picture;

    /// Make only this part of the picture: its upper left pixel, and how large it is.
    region: Option<Tile> = None,
        Domain::Text, With("X,Y,WxH"), Pixels, CommandLine, Picture;

    /// Leave out these effects, whatever the scene asks for; the summary says so.
    without: Vec<Effect> = Vec::new(),
        Domain::Names(Effect::NAMES), With("EFFECT"), Effects, CommandLine, Picture;

    /// What is computed with; the numbers of a scene are rounded to single precision either way.
    precision: Precision = Precision::Single,
        Domain::names_of::<Precision>(), With("PRECISION"), Precision, Scene, Picture;

    /// How items are found, which changes the time and nothing else: `auto` takes what suits the scene.
    accel: Accel = AccelSettings::DEFAULT.accel,
        Domain::names_of::<Accel>(), With("KIND"), Acceleration, Scene, Time;

    /// How a hierarchy (bvh) is walked.
    walk: Walk = AccelSettings::DEFAULT.walk,
        Domain::names_of::<Walk>(), With("WALK"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::Bvh]);

    /// Capacity of the heap of that walk: 0, 1, 4 or 64; with less it takes longer.
    heap: usize = AccelSettings::DEFAULT.heap,
        Domain::OneOf(&HEAP_ENTRIES), With("N"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::Bvh]).or(it.walk.rules_out_heap());

    /// What the list puts around items and groups of them.
    bounds: Bounds = AccelSettings::DEFAULT.bounds,
        Domain::names_of::<Bounds>(), With("VOLUME"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::List]);

    /// Size of the mailbox, which remembers the items of grid and octree that a ray has been tested against: 0, 8 or
    /// 64.
    mailbox: usize = AccelSettings::DEFAULT.mailbox,
        Domain::OneOf(&MAILBOX_SLOTS), With("SLOTS"), Acceleration, Scene, Time,
        |it| it.accel.rules_out(&[AccelKind::Grid, AccelKind::Octree]);

    /// Whether the last occluder of a light is tested first, which changes the time and nothing else.
    shadow_cache: bool = true,
        Domain::Flag, Off {
            option: "no-shadow-cache",
            help: "Do not test the last occluder of a light first, which changes the time and nothing else",
        },
        Caching, Scene, Time;

    /// Whether light passes through glass on its way from a light, coloured but not bent; else glass casts shadows
    /// like everything.
    colored_shadows: bool = false,
        Domain::Flag, Never, Effects, Scene, Picture;

    /// Threads [default: one for each core].
    threads: usize = std::thread::available_parallelism().map_or(1, usize::from),
        Domain::Integer(1, MAX_THREADS), With("N"), Work, CommandLine, Time;
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
    pub fn parse(&self, word: &str) -> Result<SettingsOverrides, String> {
        (self.parse)(word)
    }

    /// Whether it is set.
    pub fn is_set(&self, settings: &SettingsOverrides) -> bool {
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

impl Settings {
    /// The defaults for a picture of this size.
    pub fn of_size(size: Resolution) -> Self {
        Settings { size, ..Settings::default() }
    }

    /// Levels and cutoff.
    pub fn limits(&self) -> Limits {
        Limits { levels: self.levels, cutoff: self.cutoff }
    }

    /// How items are found.
    pub fn acceleration(&self) -> AccelSettings {
        let Settings { accel, walk, heap, bounds, mailbox, .. } = *self;
        AccelSettings { accel, walk, heap, bounds, mailbox }
    }

    /// The same with these levels and this cutoff.
    pub fn with_limits(self, limits: Limits) -> Self {
        let Limits { levels, cutoff } = limits;
        Settings { levels, cutoff, ..self }
    }

    /// The same, where items are found this way.
    pub fn with_acceleration(self, acceleration: AccelSettings) -> Self {
        let AccelSettings { accel, walk, heap, bounds, mailbox } = acceleration;
        Settings { accel, walk, heap, bounds, mailbox, ..self }
    }

    /// The pixels of the picture that is made.
    pub fn region_or_all(&self) -> Tile {
        let whole = Tile::full(self.size);
        self.region.map_or(whole, |tile| tile.intersection(whole))
    }

    /// The size of the picture that is made.
    pub fn picture_size(&self) -> Resolution {
        let Tile { width, height, .. } = self.region_or_all();
        Resolution::new(width, height).unwrap_or(self.size)
    }
}
