//! Library of the firmware programs: baked scenes, and measurement of instructions and stack.

#![no_std]

#[cfg(target_arch = "arm")]
pub mod count;
#[cfg(target_arch = "arm")]
pub mod flash;
#[cfg(feature = "packs")]
pub mod packs;
pub mod peer;
#[cfg(target_arch = "arm")]
pub mod stack;
#[cfg(target_arch = "arm")]
pub mod write;
