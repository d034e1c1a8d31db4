//! The program from outside: exit statuses, messages, files.

mod aim;
mod bake;
mod cast;
mod compare;
mod explain;
mod generate;
mod guard;
mod info;
mod manual;
mod outputs;
mod pictures;
mod program;
mod scene;
mod settings;
mod stats;
#[cfg(unix)]
mod stopped;
mod study;
mod usage;
#[cfg(unix)]
mod watch;
