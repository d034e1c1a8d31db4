//! Measures how the accuracy and the rendering time of a scene depend on the settings, and finds settings for a target error
//! or a time limit.
//!
//! [`study()`](study::study) renders a scene with many settings and compares each picture with a reference of high quality.
//! It returns a [`Study`](record::Study): [`record`] writes it as `study.json` and `study.csv`, [`page`] as a report in HTML.
//!
//! [`aim::error`] finds the cheapest settings for a target error, [`aim::time`] renders the best picture within a time limit.
//!
//! | module | contents |
//! |---|---|
//! | [`study`](mod@study) | a study of one scene |
//! | [`measure`] | the settings to measure, and the measurements |
//! | [`record`] | the results: `study.json` and `study.csv` |
//! | [`page`] | the report, `report.html` |
//! | [`device`] | measurements made by firmware |
//! | [`aim`] | settings for a target error or a time limit |
//! | [`cost_model`] | instructions estimated from event counts |
//! | [`pareto`] | the Pareto front of cost and error |
//! | [`statistics`] | medians and ranges |
//! | [`error`] | errors of a study |
//!
//! The package has no command line and no terminal.

pub mod aim;
pub mod cost_model;
pub mod device;
pub mod error;
pub mod measure;
pub mod page;
pub mod pareto;
pub mod record;
pub mod statistics;
pub mod study;
