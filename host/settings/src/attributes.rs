//! What a setting is like: how it is asked for, where, and what it has an effect on.

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
