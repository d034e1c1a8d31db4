//! Single or double precision.

use crate::choices;

choices! {
    /// What is computed with. Numbers of scenes are single precision in either case.
    pub enum Precision {
        /// Single precision, 32 bits.
        Single = "single",
        /// Double precision, 64 bits: slower, and a reference for the other.
        Double = "double",
    }
}
