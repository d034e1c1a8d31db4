//! What the firmware is made of beside its programs: the golden scene, and two instruments.

#![no_std]

pub mod count;
pub mod peer;
pub mod scene;
pub mod stack;
