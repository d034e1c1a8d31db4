//! The render settings of strahl.
//!
//! Each setting is declared once, in [`settings`], with its type, default, range, name and help. The options of the
//! command line, the keys of a scene's `[render]` table and their JSON Schema, printed settings and the columns of a
//! study are derived from the list [`SETTINGS`].
//!
//! ```
//! use strahl_settings::{SETTINGS, Settings, SettingsOverrides};
//!
//! let levels = SETTINGS.iter().find(|setting| setting.name == "levels").unwrap();
//! let command_line = levels.parse("7").unwrap();
//! let settings = Settings::resolve(&command_line, &SettingsOverrides::default()).unwrap();
//! assert_eq!(settings.levels, 7);
//! assert_eq!(levels.option(&settings).as_deref(), Some("--levels 7"));
//! assert!(levels.parse("0").is_err());
//! ```
//!
//! | module | contents |
//! |---|---|
//! | [`settings`] | the declaration: the list of all [`Setting`]s, [`Settings`] with all values, and [`SettingsOverrides`] of a scene or a command line |
//! | [`resolve`] | precedence of command line, scene and defaults, and the source of each value |
//! | [`attributes`] | properties of settings |
//! | [`json`] | values in JSON, and their JSON Schema |
//! | [`domain`] | allowed values, and their text form |
//! | [`choice`] | enumerations with named values |
//! | [`sampling`], [`accelerator`], [`precision`], [`effect`] | types of settings |
//!
//! The package has no command line, no file format and no ray tracer. It uses plain types of `strahl-core`, and their
//! limits.

pub mod accelerator;
pub mod attributes;
pub mod choice;
pub mod domain;
pub mod effect;
pub mod json;
pub mod precision;
pub mod resolve;
pub mod sampling;
pub mod settings;

pub use accelerator::{Accel, AccelKind, AccelSettings, Bounds, ResolvedAccel, Walk};
pub use attributes::{Affects, CommandOption, Group, Scope};
pub use choice::{Choice, Named};
pub use domain::{Domain, Value};
pub use effect::OptionalEffect;
pub use precision::Precision;
pub use resolve::{Resolved, SettingSource, SettingsError};
pub use sampling::{ConfidenceSettings, ContrastSettings, Filter, SamplerSettings, SelectionSettings};
pub use settings::{DEFAULT_SIZE, MAX_LEVELS, SETTINGS, Setting, Settings, SettingsOverrides};
