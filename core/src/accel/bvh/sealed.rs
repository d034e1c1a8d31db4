//! What types outside cannot implement.

/// A trait with this bound is implemented in this module only.
pub trait Sealed {}
