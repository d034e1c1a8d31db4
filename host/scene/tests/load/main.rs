//! NFF files through the public API: contents and errors.

mod mutations;
mod right;
mod table;
mod text;
mod wrong;
