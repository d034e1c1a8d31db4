//! strahl on a workstation: loads scenes, renders them with all cores, writes pictures and
//! reports. The tracing itself is `strahl-core`'s.
//!
//! | room | what it does |
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
//! | [`aim_report`] | what was aimed at, for the report and for a person |
//! | [`heat`] | costs as a picture |
//! | [`draft`] | a coarse picture before the full one |
//! | [`pixels`] | picture files that a command reads |
//! | [`output`] | files that are complete or absent |
//! | [`stats`] | what was counted and measured |
//! | [`settings`] | what is in force, and who has set it |
//! | [`terminal`] | progress on the terminal |
//! | [`summary`] | what was done, for a person |
//! | [`wrap`] | text that fits the screen |
//! | [`signals`] | when to stop |
//! | [`failure`] | what went wrong, and the exit status for it |

pub mod aim_report;
pub mod args;
pub mod bake;
pub mod cast;
pub mod compare;
pub mod draft;
pub mod explain;
pub mod failure;
pub mod generate;
pub mod heat;
pub mod info;
pub mod manual;
pub mod output;
pub mod pixels;
pub mod render;
pub mod settings;
pub mod signals;
pub mod stats;
pub mod study_command;
pub mod summary;
pub mod terminal;
pub mod watch;
pub mod wrap;
