//! NFF files through the door of the library: what they describe, and what is wrong with them.

mod mutations;
mod right;
mod text;
mod wrong;
