//! Accuracy against rendering time: studies of scenes, and settings chosen for a target error or a time limit.
//!
//! [`study()`](study::study) renders a scene with many settings and measures each against a reference of high quality. The
//! result is a [`Study`](record::Study), which is written as `study.json` and `study.csv`, and shown by a page. [`aim`] goes
//! the other way: it finds the settings for a given error or time.
//!
//! | module | contents |
//! |---|---|
//! | [`study`](mod@study) | a study of one scene |
//! | [`measure`] | which settings are measured, and how |
//! | [`record`] | the results: `study.json` and `study.csv` |
//! | [`page`] | the report, `report.html` |
//! | [`device`] | measurements made by firmware |
//! | [`aim`] | settings for a target error or a time limit |
//! | [`cost_model`] | event counts in instructions |
//! | [`pareto`] | the Pareto front of cost and error |
//! | [`statistics`] | medians and ranges |
//! | [`error`] | why a study fails |
//!
//! ```
//! use strahl_study::pareto::{CostErrorPoint, cheapest_within, pareto_front};
//!
//! let points = [(1.0, 0.08), (2.0, 0.03), (4.0, 0.05), (9.0, 0.01)].map(|(cost, error)| CostErrorPoint { cost, error });
//! assert_eq!(pareto_front(&points), [0, 1, 3]);
//! assert_eq!(cheapest_within(&points, 0.05), Some(1));
//! ```
//!
//! This package knows no command line and no terminal.

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
