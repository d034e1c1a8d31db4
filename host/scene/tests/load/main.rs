//! NFF files through the door of the library: what they describe, and what is wrong with them.

mod mutations;
mod right;
mod table;
mod text;
mod wrong;
