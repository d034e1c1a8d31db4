//! Properties of settings: option, group, scope and effect.

/// The option of a setting on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommandOption {
    /// An option with the name of the setting and a value, which has this name in the help.
    Value(&'static str),
    /// An option that turns the setting off; it is on by default.
    Off {
        /// The name of the option, without the dashes.
        option: &'static str,
        /// The help text of the option.
        help: &'static str,
    },
    /// No option.
    Never,
}

/// A group of settings that are options of the same commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Size of the picture and depth of the ray tree.
    Frame,
    /// Sampling of a pixel.
    Sampling,
    /// Selection of pixels.
    Pixels,
    /// Rendered effects.
    Effects,
    /// Floating-point precision.
    Precision,
    /// Acceleration structure.
    Acceleration,
    /// Caches.
    Caching,
    /// Threads.
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

/// What a setting affects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Affects {
    /// The bytes of the picture. Two renders have equal pictures if all these settings are equal.
    Picture,
    /// Time and memory, never the picture.
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
