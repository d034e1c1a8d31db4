//! The settings of strahl: what a render is asked for.
//!
//! Each setting is declared once, in [`settings`], with its type, its default, its values, its name and its help.
//! From that declaration come the options of the command line, the keys of a scene's `[render]` table and their JSON
//! Schema, the settings that are printed, and the columns of a study: their code goes through [`SETTINGS`] and names
//! no setting.
//!
//! | module | what it holds |
//! |---|---|
//! | [`settings`] | the declaration: the list of every [`Setting`]; [`Settings`], and [`SettingsOverrides`] as a scene or a command line has them |
//! | [`resolve`] | command line over scene over defaults, and which of them set what |
//! | [`attributes`] | what a setting is like |
//! | [`json`] | their values in JSON, and the JSON Schema of these |
//! | [`domain`] | the values that a setting may have, and the words for them |
//! | [`choice`] | types whose values have names |
//! | [`sampling`], [`accelerator`], [`precision`], [`effect`] | the types of settings |
//!
//! This package knows no command line, no file format and no tracer. It uses plain types of `strahl-core`, whose
//! limits are those of the settings.

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
pub use effect::Effect;
pub use precision::Precision;
pub use resolve::{Resolved, SettingSource, SettingsError};
pub use sampling::{ConfidenceSettings, ContrastSettings, Filter, SamplerSettings, SelectionSettings};
pub use settings::{DEFAULT_SIZE, MAX_LEVELS, SETTINGS, Setting, Settings, SettingsOverrides};
