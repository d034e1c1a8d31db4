//! Single or double precision.

/// What is computed with. Numbers of scenes are single precision in either case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Precision {
    /// Single precision, 32 bits.
    #[default]
    Single,
    /// Double precision, 64 bits: slower, and a yardstick for the other.
    Double,
}

impl Precision {
    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Precision::Single => "single",
            Precision::Double => "double",
        }
    }
}
