//! The program strahl: loads scenes, renders them on all cores, and writes pictures and reports. The ray tracer itself is
//! the package `strahl-core`.
//!
//! | module | contents |
//! |---|---|
//! | [`args`] | the options of every command |
//! | [`render`] | the command `render`; `watch` renders through it too |
//! | [`watch`] | the command `watch`: waits for changes of the scene's files |
//! | [`cast`] | the command `cast`: rays from a CSV file |
//! | [`bake`] | the command `bake`: a scene as bytes or Rust code for firmware, with its stack and instructions |
//! | [`study_command`] | the command `study` |
//! | [`info`] | the command `info` |
//! | [`explain`] | the command `explain`: the ray tree of a pixel as text, JSON or SVG |
//! | [`compare`] | the command `compare`: the difference of two pictures |
//! | [`generate`] | the command `generate` |
//! | [`manual`] | the commands `completions` and `man` |
//! | [`print_settings`] | the option `--print-settings`: every effective setting and its source |
//! | [`preview`] | the coarse preview that `watch` writes first |
//! | [`aim_report`] | the result of `--target-error` and `--time-limit` |
//! | [`stats`] | the statistics of `--stats`, as JSON or text |
//! | [`heat_map`] | the cost per pixel of `--cost`, as a picture or as EXR channels |
//! | [`summary`] | the lines that `render` prints after a picture |
//! | [`pixels`] | reading of picture files |
//! | [`output`] | output files, which are complete or absent, and messages |
//! | [`terminal`] | the progress bar |
//! | [`word_wrap`] | word wrapping at the width of the terminal |
//! | [`signals`] | interruption by signals |
//! | [`error`] | errors of commands, and exit statuses |

pub mod aim_report;
pub mod args;
pub mod bake;
pub mod cast;
pub mod compare;
pub mod error;
pub mod explain;
pub mod generate;
pub mod heat_map;
pub mod info;
pub mod manual;
pub mod output;
pub mod pixels;
pub mod preview;
pub mod print_settings;
pub mod render;
pub mod signals;
pub mod stats;
pub mod study_command;
pub mod summary;
pub mod terminal;
pub mod watch;
pub mod word_wrap;
