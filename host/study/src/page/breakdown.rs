//! The time by ray kind, and per pixel.

use maud::{Markup, html};

use super::gallery::{color_bar, picture};
use super::numbers::{count, percent};
use super::pieces::{options, scrollable};
use crate::record::{ImageContent, RunRole, Study, StudyRun};

const KINDS: [&str; 4] = ["camera", "reflected", "transmitted", "shadow"];

pub fn section(study: &Study) -> Markup {
    let own = study.runs.iter().find(|run| run.role == RunRole::Own);
    html! {
        @match own {
            Some(run) => { (by_ray(study, run)) }
            None => { p.soft { "Not measured: no time was left for the scene's settings." } }
        }
        @let maps: Vec<_> = study.pictures.iter().filter(|it| it.shows == ImageContent::Cost).collect();
        @if !maps.is_empty() {
            h3 { "Per pixel" }
            @let most = maps.first().and_then(|map| map.range).map_or(0.0, |[_, most]| most);
            p {
                "Instructions per pixel, in total and by ray kind, on one color scale; " (count(most)) " or more is the brightest color "
                "(0.5 % of the pixels are above)."
            }
            (color_bar(&[("0", 0.0), (&count(0.5 * most), 50.0), (&count(most), 100.0)]))
            div.gallery {
                @for map in maps {
                    figure {
                        (picture(map, &format!("Cost of each pixel: {}", map.title)))
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
    let shares: Vec<String> =
        KINDS.iter().zip(work).map(|(kind, work)| format!("{kind} {}", percent(work / whole))).collect();
    html! {
        p { "Work by ray kind with the scene's settings; direct lighting is counted with its shadow rays: " (options(&run.setting.options)) "." }
        div.stack role="img" aria-label=(format!("Shares of the work: {}", shares.join(", "))) {
            @for (kind, work) in KINDS.iter().zip(work) {
                @if work > 0.0 {
                    div.(*kind) style=(format!("flex-grow:{:.4}", work / whole)) {
                        @if work / whole > 0.28 { span { (kind) " " (percent(work / whole)) } }
                        @else if work / whole > 0.09 { span.wide { (kind) " " (percent(work / whole)) } }
                    }
                }
            }
        }
        (scrollable(html! {
            table.plain {
                thead { tr {
                    th { "rays" } th.number { "number" } th.number { "box tests" } th.number { "shape tests" } th.number { "instructions" }
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
                "Shadow caches were queried " (count(run.counts.cache_asked as f64)) " times with a hit rate of "
                (percent(run.counts.cache_hits as f64 / run.counts.cache_asked as f64)) ". "
                "The level limit discards " (percent(run.cut[0])) " of the light, the cutoff " (percent(run.cut[1])) "."
            }
        }
    }
}
