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
//! | [`study`] | the command `study` |
//! | [`info`] | the command `info` |
//! | [`explain`] | the command `explain` |
//! | [`compare`] | the command `compare` |
//! | [`generate`] | the command `generate` |
//! | [`manual`] | the commands `completions` and `man` |
//! | [`procedural`] | scenes that formulas make |
//! | [`load`] | scene files to a [`description`] |
//! | [`description`] | a scene in neutral numbers |
//! | [`stock`] | the owned tables of a scene, for either precision |
//! | [`frame`] | from a description to a picture |
//! | [`studio`] | where pictures of one scene are traced: what is asked there, and answered |
//! | [`wanted`] | what picture is wanted, and how the work is done |
//! | [`precision`] | what is computed with |
//! | [`mask`] | which pixels are wanted, where not all are |
//! | [`finding`] | how items are found: what can be asked for, and what there is |
//! | [`accelerators`] | the accelerators: what is asked for becomes a type |
//! | [`sampling`] | which rays make a pixel, in the words of the command line |
//! | [`samplers`] | the samplers: what is asked for becomes a type |
//! | [`choose`] | values become types, once, around the whole render |
//! | [`draw`] | from a scene to linear colours |
//! | [`job`] | a picture to be traced by a tracer whose type is still to be chosen |
//! | [`rays`] | rays as lines of text, and their way there and back |
//! | [`hits`] | what rays hit |
//! | [`workers`] | tiles and threads |
//! | [`passes`] | a picture that becomes better pass by pass |
//! | [`pace`] | what a picture that becomes better pass by pass is to do next |
//! | [`aim`] | the settings that keep an error or a time |
//! | [`cost`] | what was counted, in instructions |
//! | [`sheet`] | what each pixel costs |
//! | [`heat`] | costs as a picture |
//! | [`double`] | `accelerators`, `draw`, `hits`, `job`, `passes` and `workers` for the twin in double precision |
//! | [`draft`] | a coarse picture before the full one |
//! | [`pixels`] | picture files that a command reads |
//! | [`output`] | files that are complete or absent |
//! | [`plan`] | what a scene asks to be simulated, and why |
//! | [`stats`] | what was counted and measured |
//! | [`settings`] | what is in force, and who has set it |
//! | [`progress`] | how far the work is |
//! | [`summary`] | what was done, for a person |
//! | [`amount`] | numbers with their nouns |
//! | [`wrap`] | text that fits the screen |
//! | [`signals`] | when to stop |
//! | [`stop`] | why work ends before it is done |
//! | [`faults`] | what is wrong in a text, shown as a compiler would |
//! | [`failure`] | what went wrong, and the exit status for it |

// The rooms that are compiled for either precision find the core and the tables for it by these
// names one floor above them: here, and in `double`.
use strahl_core as strahl;

use stock::single as tables;

pub mod accelerators;
pub mod aim;
pub mod amount;
pub mod args;
pub mod bake;
pub mod cast;
pub mod choose;
pub mod compare;
pub mod cost;
pub mod description;
pub mod double;
pub mod draft;
pub mod draw;
pub mod explain;
pub mod failure;
pub mod faults;
pub mod finding;
pub mod frame;
pub mod generate;
pub mod heat;
pub mod hits;
pub mod info;
pub mod job;
pub mod load;
pub mod manual;
pub mod mask;
pub mod output;
pub mod pace;
pub mod passes;
pub mod pixels;
pub mod plan;
pub mod precision;
pub mod procedural;
pub mod progress;
pub mod rays;
pub mod render;
pub mod samplers;
pub mod sampling;
pub mod settings;
pub mod sheet;
pub mod signals;
pub mod stats;
pub mod stock;
pub mod stop;
pub mod studio;
pub mod study;
pub mod summary;
pub mod wanted;
pub mod watch;
pub mod workers;
pub mod wrap;
