//! Where the time goes: by kind of ray, and pixel by pixel.

use maud::{Markup, html};

use super::gallery::{picture, ramp};
use super::numbers::{count, percent};
use super::pieces::{options, wide};
use crate::record::{ImageContent, RunRole, Study, StudyRun};

const KINDS: [&str; 4] = ["camera", "reflected", "transmitted", "shadow"];

pub fn part(study: &Study) -> Markup {
    let own = study.runs.iter().find(|run| run.role == RunRole::Own);
    html! {
        @match own {
            Some(run) => { (by_ray(study, run)) }
            None => { p.soft { "Not measured: no time was left for the scene's own setting." } }
        }
        @let maps: Vec<_> = study.pictures.iter().filter(|it| it.shows == ImageContent::Cost).collect();
        @if !maps.is_empty() {
            h3 { "Pixel by pixel" }
            @let most = maps.first().and_then(|map| map.range).map_or(0.0, |[_, most]| most);
            p {
                "Instructions for each pixel, in all and by the kind of ray, all in the same colours; " (count(most)) " and more are the brightest "
                "(one pixel of two hundred takes more)."
            }
            (ramp(&[("0", 0.0), (&count(0.5 * most), 50.0), (&count(most), 100.0)]))
            div.gallery {
                @for map in maps {
                    figure {
                        (picture(map, &format!("What each pixel costs: {}", map.title)))
                        figcaption { strong { (map.title) } }
                    }
                }
            }
        }
    }
}

fn by_ray(study: &Study, run: &StudyRun) -> Markup {
    let work = study.method.weights.instructions_by_ray_kind(&run.counts, run.setting.accelerator_kind());
    let whole: f64 = work.iter().sum::<f64>().max(1.0);
    let told: Vec<String> =
        KINDS.iter().zip(work).map(|(kind, work)| format!("{kind} {}", percent(work / whole))).collect();
    html! {
        p { "Work by kind of ray at the scene's own setting; what light takes where it falls is with the shadow rays that ask for it: " (options(&run.setting.options)) "." }
        div.stack role="img" aria-label=(format!("Shares of the work: {}", told.join(", "))) {
            @for (kind, work) in KINDS.iter().zip(work) {
                @if work > 0.0 {
                    div.(*kind) style=(format!("flex-grow:{:.4}", work / whole)) {
                        @if work / whole > 0.28 { span { (kind) " " (percent(work / whole)) } }
                        @else if work / whole > 0.09 { span.wide { (kind) " " (percent(work / whole)) } }
                    }
                }
            }
        }
        (wide(html! {
            table.plain {
                thead { tr {
                    th { "rays" } th.number { "number" } th.number { "tests of boxes" } th.number { "of shapes" } th.number { "instructions" }
                    th.number { "share" }
                } }
                tbody {
                    @for kind in 0..4 {
                        tr {
                            td { span.swatch.(KINDS[kind]) {} (KINDS[kind]) }
                            td.number { (count(run.counts.rays[kind] as f64)) }
                            td.number { (count(run.counts.boxes[kind] as f64)) }
                            td.number { (count(run.counts.shapes[kind] as f64)) }
                            td.number { (count(work[kind])) }
                            td.number { (percent(work[kind] / whole)) }
                        }
                    }
                }
            }
        }))
        @if run.counts.cache_asked > 0 {
            p.soft {
                "Shadow caches were asked " (count(run.counts.cache_asked as f64)) " times, and answered "
                (percent(run.counts.cache_hits as f64 / run.counts.cache_asked as f64)) " of them. "
                "The levels cut " (percent(run.cut[0])) " of the light, the cutoff " (percent(run.cut[1])) "."
            }
        }
    }
}
