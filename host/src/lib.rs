//! strahl on a workstation: loads scenes, renders them with all cores, writes pictures and
//! reports. The tracing itself is `strahl-core`'s.
//!
//! | module | contents |
//! |---|---|
//! | [`args`] | the command line |
//! | [`render`] | the command `render` |
//! | [`mod@cast`] | the command `cast` |
//! | [`watch`] | the command `watch` |
//! | [`bake`] | the command `bake` |
//! | [`study_command`] | the command `study` |
//! | [`info`] | the command `info` |
//! | [`explain`] | the command `explain` |
//! | [`compare`] | the command `compare` |
//! | [`generate`] | the command `generate` |
//! | [`manual`] | the commands `completions` and `man` |
//! | [`aim_report`] | report on a target error or a time limit |
//! | [`heat_map`] | cost per pixel as a picture |
//! | [`preview`] | coarse preview |
//! | [`pixels`] | picture files that a command reads |
//! | [`output`] | files that are complete or absent |
//! | [`stats`] | statistics of a render |
//! | [`settings`] | effective settings and their sources |
//! | [`terminal`] | progress on the terminal |
//! | [`summary`] | summary of a render |
//! | [`wrap`] | line wrapping |
//! | [`signals`] | interruption by signals |
//! | [`error`] | command errors and exit statuses |

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
pub mod render;
pub mod settings;
pub mod signals;
pub mod stats;
pub mod study_command;
pub mod summary;
pub mod terminal;
pub mod watch;
pub mod wrap;
