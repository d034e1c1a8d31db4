//! Scenes and drawing without a heap: what firmware, WebAssembly and the tests on the host share.
//!
//! * [`scene`]: the golden scene, as constants.
//! * [`draw`]: draws a world row by row, without a frame buffer.
//! * [`accuracy`]: the golden scene with other levels, cutoffs and samplers.
//! * `flash`: a small scene, traced with growing effect sets; in single precision only.
//!
//! `strahl-device-double` compiles the same sources for `strahl-core-double`.

#![no_std]

pub mod accuracy;
pub mod draw;
#[cfg(not(feature = "double"))]
pub mod flash;
pub mod scene;
