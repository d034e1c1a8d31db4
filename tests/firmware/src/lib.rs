//! Library of the firmware programs: scenes, drawing, and measurement of instructions and stack.

#![no_std]

pub mod accuracy;
#[cfg(target_arch = "arm")]
pub mod count;
pub mod draw;
pub mod flash;
#[cfg(feature = "packs")]
pub mod packs;
pub mod peer;
pub mod scene;
#[cfg(target_arch = "arm")]
pub mod stack;
#[cfg(target_arch = "arm")]
pub mod write;
