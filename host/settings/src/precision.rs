//! Floating-point precision.

use crate::choices;

choices! {
    /// The floating-point precision of the computation. Numbers of scenes are always rounded to single precision.
    pub enum Precision {
        /// Single precision, 32 bits.
        Single = "single",
        /// Double precision, 64 bits: slower; a reference for single precision.
        Double = "double",
    }
}
