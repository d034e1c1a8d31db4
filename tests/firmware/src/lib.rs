//! What the firmware is made of beside its programs: the scenes, how they are drawn, and two
//! instruments.

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
