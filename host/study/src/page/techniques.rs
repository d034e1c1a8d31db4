//! Techniques, on and off: what each saves, and the error that it causes.

use maud::{Markup, html};
use strahl_scene::quantity::quantity;

use super::axis::LogAxis;
use super::caveats;
use super::family::coordinate;
use super::numbers::{change, count, error, seconds};
use super::pieces::scrollable;
use super::scatter::spaced;
use crate::record::{Study, StudyRun, Technique};
use crate::statistics::median;

/// A technique with both runs.
struct TechniqueRow<'s> {
    it: &'s Technique,
    without: &'s StudyRun,
    with: &'s StudyRun,
}

/// A technique whose run without it was aborted.
struct AbortedTechnique<'s> {
    it: &'s Technique,
    /// Wall-clock seconds until the abort.
    after: f64,
    with: &'s StudyRun,
}

impl TechniqueRow<'_> {
    fn time(&self) -> f64 {
        self.with.median_cpu_seconds() / self.without.median_cpu_seconds().max(1e-12)
    }

    fn tests(&self) -> f64 {
        tests(self.with) / tests(self.without).max(1.0)
    }
}

/// Number of box and shape tests.
fn tests(run: &StudyRun) -> f64 {
    (run.counts.boxes.iter().sum::<u64>() + run.counts.shapes.iter().sum::<u64>()) as f64
}

pub fn section(study: &Study) -> Markup {
    let run = |place: Option<usize>| study.runs.get(place?);
    let shown: Vec<TechniqueRow<'_>> = study
        .techniques
        .iter()
        .filter_map(|it| Some(TechniqueRow { it, without: run(it.without)?, with: run(it.with)? }))
        .collect();
    let missing: Vec<&Technique> =
        study.techniques.iter().filter(|it| it.without.is_none() || it.with.is_none()).collect();
    // In a large scene the run without a technique may be aborted; its time is a lower bound.
    let bounded: Vec<AbortedTechnique<'_>> = missing
        .iter()
        .filter_map(|it| Some(AbortedTechnique { it, after: it.given_up?, with: run(it.with)? }))
        .collect();
    let is_bounded = |it: &Technique| it.given_up.is_some() && it.with.is_some();
    let unknown: Vec<&str> = missing.iter().filter(|it| !is_bounded(it)).map(|it| it.name.as_str()).collect();
    html! {
        @if !shown.is_empty() || !bounded.is_empty() { (measured(&shown, &bounded)) }
        @if !bounded.is_empty() {
            p.soft { "Runs without a technique that were aborted are shown with their wall-clock time; the saving is a lower bound." }
        }
        @if !unknown.is_empty() {
            p.soft { "Not completed: " (caveats::why(study)) " (" (quantity(unknown.len(), "technique")) "): " (unknown.join(", ")) "." }
        }
        (threads(study))
    }
}

/// Techniques as a plot and as a table.
fn measured(shown: &[TechniqueRow<'_>], bounded: &[AbortedTechnique<'_>]) -> Markup {
    html! {
        p {
            "Cost with a technique relative to the cost without it; below 1 it saves. Measured with the scene's levels and cutoff and, "
            "unless stated otherwise, one ray per pixel, by the same code."
        }
        ul.legend {
            li { svg viewBox="0 0 16 16" aria-hidden="true" { circle.time cx="8" cy="8" r="5" {} } "processor time" }
            li { svg viewBox="0 0 16 16" aria-hidden="true" { polygon.tests points="8,2 14,8 8,14 2,8" {} } "box and shape tests" }
        }
        @if !shown.is_empty() {
            figure {
                div.wide { (plot(shown, 900.0, 210.0)) }
                div.narrow { (plot(shown, 350.0, 150.0)) }
            }
        }
        (scrollable(table(shown, bounded)))
    }
}

fn plot(shown: &[TechniqueRow<'_>], width: f64, names: f64) -> Markup {
    let (row, top) = (24.0, 10.0);
    let bottom = top + row * shown.len() as f64;
    let ratios = shown.iter().flat_map(|it| [it.time(), it.tests(), 1.0]);
    let x = LogAxis::of(ratios, names + 12.0, width - 16.0);
    let ticks = spaced(&x.ticks(), |tick| x.at(tick), 44.0);
    let texts: Vec<String> = shown
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
        svg.plot role="img" aria-label=(format!("Time and tests with each technique as a share of those without. Time: {}", texts.join("; ")))
            viewBox=(format!("0 0 {width} {}", bottom + 42.0)) {
            @for tick in ticks {
                line.grid x1=(coordinate(x.at(tick))) x2=(coordinate(x.at(tick))) y1=(top) y2=(bottom) {}
                text.tick x=(coordinate(x.at(tick))) y=(bottom + 16.0) text-anchor="middle" { (tick) }
            }
            line.one x1=(coordinate(x.at(1.0))) x2=(coordinate(x.at(1.0))) y1=(top) y2=(bottom) {}
            text.label x=(coordinate(0.5 * (names + width))) y=(bottom + 36.0) text-anchor="middle" { "with it / without it" }
            @for (place, it) in shown.iter().enumerate() {
                @let y = top + row * (place as f64 + 0.5);
                g {
                    title { (it.it.name) ": time " (change(it.without.median_cpu_seconds(), it.with.median_cpu_seconds())) ", tests " (change(tests(it.without), tests(it.with))) }
                    text.name x=(names) y=(coordinate(y + 4.0)) text-anchor="end" { (it.it.name) }
                    line.dumbbell x1=(coordinate(x.at(it.time()))) x2=(coordinate(x.at(it.tests()))) y1=(coordinate(y)) y2=(coordinate(y)) {}
                    @let at = x.at(it.tests());
                    polygon.tests points=(format!("{0},{2} {1},{4} {0},{5} {3},{4}", coordinate(at), coordinate(at + 6.0), coordinate(y - 6.0), coordinate(at - 6.0), coordinate(y), coordinate(y + 6.0))) {}
                    circle.time cx=(coordinate(x.at(it.time()))) cy=(coordinate(y)) r="4.5" {}
                }
            }
        }
    }
}

fn table(shown: &[TechniqueRow<'_>], bounded: &[AbortedTechnique<'_>]) -> Markup {
    html! {
        table.plain {
            thead { tr {
                th { "technique" } th { "without → with" } th.number { "tests" } th.number { "saved" }
                th.number { "time" } th.number { "saved" } th.number { "error it causes" }
            } }
            tbody {
                @for it in bounded {
                    @let with_seconds = median(&it.with.elapsed_seconds);
                    tr {
                        th scope="row" { (it.it.name) }
                        td { (it.it.off) " → " (it.it.on) }
                        td.number { "– → " (count(tests(it.with))) }
                        td.number { "–" }
                        td.number { "over " (seconds(it.after)) " → " (seconds(with_seconds)) }
                        td.number { @if with_seconds < it.after { "over " (saved(with_seconds / it.after)) } @else { "–" } }
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

/// The saving in percent; negative if the technique costs.
fn saved(ratio: f64) -> String {
    let percent = 100.0 * (1.0 - ratio);
    let text = if percent > 99.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") };
    if text == "-0 %" { "0 %".into() } else { text.replace('-', "−") }
}

/// The error, and whether that is as it should be.
fn caused(it: &TechniqueRow<'_>) -> Markup {
    let is_same = it.with.digest == it.without.digest;
    html! {
        @match (it.it.exact, is_same, &it.it.error) {
            (true, true, _) => { "0, bit for bit" }
            (true, false, _) => { strong.wrong { "pictures differ: please report this bug" } }
            (false, true, _) => { "0" }
            (false, false, Some(it)) => { (error(it.rmse)) }
            (false, false, None) => { "–" }
        }
    }
}

/// Wall-clock time by number of threads.
fn threads(study: &Study) -> Markup {
    let runs: Vec<&StudyRun> = study.threads.iter().filter_map(|place| study.runs.get(*place)).collect();
    // A single run has nothing to compare with.
    let [one, _, ..] = &runs[..] else { return html! {} };
    html! {
        h3 { "Threads" }
        p { "One picture with one ray per pixel. Sensitive to other load on the machine." }
        (scrollable(html! {
            table.plain {
                thead { tr { th { "threads" } th.number { "wall clock" } th.number { "speedup" } th.number { "processor time" } th { "picture" } } }
                tbody {
                    @for run in &runs {
                        tr {
                            td { (run.setting.settings.threads) }
                            td.number { (seconds(median(&run.elapsed_seconds))) }
                            td.number { "× " (format!("{:.2}", median(&one.elapsed_seconds) / median(&run.elapsed_seconds).max(1e-12))) }
                            td.number { (seconds(run.median_cpu_seconds())) }
                            td { @if run.digest == one.digest { "the same, bit for bit" } @else { strong.wrong { "different: please report this bug" } } }
                        }
                    }
                }
            }
        }))
    }
}
