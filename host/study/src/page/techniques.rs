//! Techniques on and off: what each saves, and what it makes wrong.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::axis::LogAxis;
use super::caveats;
use super::family::round;
use super::numbers::{change, count, error, seconds};
use super::pieces::wide;
use super::scatter::spaced;
use crate::record::{Study, StudyRun, Technique};
use crate::statistics::median;

/// A technique both of whose runs are there.
struct Shown<'s> {
    it: &'s Technique,
    without: &'s StudyRun,
    with: &'s StudyRun,
}

/// A technique without which the picture was given up.
struct Bounded<'s> {
    it: &'s Technique,
    /// Seconds of wall-clock time.
    after: f64,
    with: &'s StudyRun,
}

impl Shown<'_> {
    fn time(&self) -> f64 {
        self.with.median_cpu_seconds() / self.without.median_cpu_seconds().max(1e-12)
    }

    fn tests(&self) -> f64 {
        tests(self.with) / tests(self.without).max(1.0)
    }
}

/// Tests of boxes and of shapes.
fn tests(run: &StudyRun) -> f64 {
    (run.counts.boxes.iter().sum::<u64>() + run.counts.shapes.iter().sum::<u64>()) as f64
}

pub fn part(study: &Study) -> Markup {
    let run = |place: Option<usize>| study.runs.get(place?);
    let shown: Vec<Shown<'_>> = study
        .techniques
        .iter()
        .filter_map(|it| Some(Shown { it, without: run(it.without)?, with: run(it.with)? }))
        .collect();
    let missing: Vec<&Technique> =
        study.techniques.iter().filter(|it| it.without.is_none() || it.with.is_none()).collect();
    // What a large scene cannot do without has a time with it, and one that was not enough without.
    let bounded: Vec<Bounded<'_>> = missing
        .iter()
        .filter_map(|it| Some(Bounded { it, after: it.given_up?, with: run(it.with)? }))
        .collect();
    let is_bounded = |it: &Technique| it.given_up.is_some() && it.with.is_some();
    let unknown: Vec<&str> = missing.iter().filter(|it| !is_bounded(it)).map(|it| it.name.as_str()).collect();
    html! {
        @if !shown.is_empty() || !bounded.is_empty() { (measured(&shown, &bounded)) }
        @if !bounded.is_empty() {
            p.soft { "Where a time without is not known it was given up; what is told then is wall-clock time, and what is saved at least." }
        }
        @if !unknown.is_empty() {
            p.soft { "Not measured to the end: " (caveats::why(study)) " (" (quantity(unknown.len(), "technique")) "): " (unknown.join(", ")) "." }
        }
        (threads(study))
    }
}

/// What is known of techniques, drawn and as a table.
fn measured(shown: &[Shown<'_>], bounded: &[Bounded<'_>]) -> Markup {
    html! {
        p {
            "What a picture takes with a technique, as a share of what it takes without. Left of 1 it saves. All are measured at the scene's "
            "levels and cutoff and, where nothing else is said, with one ray in each pixel, by the same loop."
        }
        ul.legend {
            li { svg viewBox="0 0 16 16" aria-hidden="true" { circle.time cx="8" cy="8" r="5" {} } "processor time" }
            li { svg viewBox="0 0 16 16" aria-hidden="true" { polygon.tests points="8,2 14,8 8,14 2,8" {} } "tests of boxes and shapes" }
        }
        @if !shown.is_empty() {
            figure {
                div.wide { (plot(shown, 900.0, 210.0)) }
                div.narrow { (plot(shown, 350.0, 150.0)) }
            }
        }
        (wide(table(shown, bounded)))
    }
}

fn plot(shown: &[Shown<'_>], width: f64, names: f64) -> Markup {
    let (row, top) = (24.0, 10.0);
    let bottom = top + row * shown.len() as f64;
    let ratios = shown.iter().flat_map(|it| [it.time(), it.tests(), 1.0]);
    let x = LogAxis::of(ratios, names + 12.0, width - 16.0);
    let ticks = spaced(&x.ticks(), |tick| x.at(tick), 44.0);
    let told: Vec<String> = shown
        .iter()
        .map(|it| {
            format!(
                "{} {}",
                it.it.name,
                change(it.without.median_cpu_seconds(), it.with.median_cpu_seconds())
            )
        })
        .collect();
    html! {
        svg.plot role="img" aria-label=(format!("Time and tests with each technique as a share of those without. Time: {}", told.join("; ")))
            viewBox=(format!("0 0 {width} {}", bottom + 42.0)) {
            @for tick in ticks {
                line.grid x1=(round(x.at(tick))) x2=(round(x.at(tick))) y1=(top) y2=(bottom) {}
                text.tick x=(round(x.at(tick))) y=(bottom + 16.0) text-anchor="middle" { (tick) }
            }
            line.one x1=(round(x.at(1.0))) x2=(round(x.at(1.0))) y1=(top) y2=(bottom) {}
            text.label x=(round(0.5 * (names + width))) y=(bottom + 36.0) text-anchor="middle" { "with it / without it" }
            @for (place, it) in shown.iter().enumerate() {
                @let y = top + row * (place as f64 + 0.5);
                g {
                    title { (it.it.name) ": time " (change(it.without.median_cpu_seconds(), it.with.median_cpu_seconds())) ", tests " (change(tests(it.without), tests(it.with))) }
                    text.name x=(names) y=(round(y + 4.0)) text-anchor="end" { (it.it.name) }
                    line.dumbbell x1=(round(x.at(it.time()))) x2=(round(x.at(it.tests()))) y1=(round(y)) y2=(round(y)) {}
                    @let at = x.at(it.tests());
                    polygon.tests points=(format!("{0},{2} {1},{4} {0},{5} {3},{4}", round(at), round(at + 6.0), round(y - 6.0), round(at - 6.0), round(y), round(y + 6.0))) {}
                    circle.time cx=(round(x.at(it.time()))) cy=(round(y)) r="4.5" {}
                }
            }
        }
    }
}

fn table(shown: &[Shown<'_>], bounded: &[Bounded<'_>]) -> Markup {
    html! {
        table.plain {
            thead { tr {
                th { "technique" } th { "without → with" } th.number { "tests" } th.number { "saved" }
                th.number { "time" } th.number { "saved" } th.number { "error it causes" }
            } }
            tbody {
                @for it in bounded {
                    @let wall = median(&it.with.wall);
                    tr {
                        th scope="row" { (it.it.name) }
                        td { (it.it.off) " → " (it.it.on) }
                        td.number { "– → " (count(tests(it.with))) }
                        td.number { "–" }
                        td.number { "over " (seconds(it.after)) " → " (seconds(wall)) }
                        td.number { @if wall < it.after { "over " (saved(wall / it.after)) } @else { "–" } }
                        td.number { "–" }
                    }
                }
                @for it in shown {
                    tr {
                        th scope="row" { (it.it.name) }
                        td { (it.it.off) " → " (it.it.on) }
                        td.number { (count(tests(it.without))) " → " (count(tests(it.with))) }
                        td.number { (saved(it.tests())) }
                        td.number { (seconds(it.without.median_cpu_seconds())) " → " (seconds(it.with.median_cpu_seconds())) }
                        td.number { (saved(it.time())) }
                        td.number { (caused(it)) }
                    }
                }
            }
        }
    }
}

/// What is saved, in percent; less than nothing where it costs.
fn saved(ratio: f64) -> String {
    let percent = 100.0 * (1.0 - ratio);
    let text = if percent > 99.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") };
    if text == "-0 %" { "0 %".into() } else { text.replace('-', "−") }
}

/// The error, and whether that is as it should be.
fn caused(it: &Shown<'_>) -> Markup {
    let is_same = it.with.digest == it.without.digest;
    html! {
        @match (it.it.exact, is_same, &it.it.error) {
            (true, true, _) => { "0, bit for bit" }
            (true, false, _) => { strong.wrong { "another picture: a fault of strahl" } }
            (false, true, _) => { "0" }
            (false, false, Some(it)) => { (error(it.rmse)) }
            (false, false, None) => { "–" }
        }
    }
}

/// How wall-clock time falls with threads.
fn threads(study: &Study) -> Markup {
    let runs: Vec<&StudyRun> = study.threads.iter().filter_map(|place| study.runs.get(*place)).collect();
    // One alone is compared with nothing.
    let [one, _, ..] = &runs[..] else { return html! {} };
    html! {
        h3 { "Threads" }
        p { "One picture, one ray in each pixel. Other work on the machine shows here first." }
        (wide(html! {
            table.plain {
                thead { tr { th { "threads" } th.number { "wall clock" } th.number { "faster" } th.number { "processor time" } th { "picture" } } }
                tbody {
                    @for run in &runs {
                        tr {
                            td { (run.setting.settings.threads) }
                            td.number { (seconds(median(&run.wall))) }
                            td.number { "× " (format!("{:.2}", median(&one.wall) / median(&run.wall).max(1e-12))) }
                            td.number { (seconds(run.median_cpu_seconds())) }
                            td { @if run.digest == one.digest { "the same, bit for bit" } @else { strong.wrong { "another: a fault of strahl" } } }
                        }
                    }
                }
            }
        }))
    }
}
