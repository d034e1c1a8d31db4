//! NFF files through the public API: contents and errors.

mod mutations;
mod right;
mod text;
mod wrong;
