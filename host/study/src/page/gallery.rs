//! Pictures of some settings beside each other, and where each is wrong.

use maud::{Markup, html};

use strahl_picture::color_map::{inferno, step_of};

use super::numbers::{error, percent, seconds};
use super::pieces::options;
use crate::record::{ImageContent, RunRole, Study, StudyImage};

pub fn part(study: &Study) -> Markup {
    let of = |shows: ImageContent| study.pictures.iter().filter(move |it| it.shows == shows);
    html! {
        p {
            "Each picture with its error below: the largest difference of a channel in every pixel, from none (black) over 1/255 "
            "(violet) to all (pale yellow), each doubling as much brighter."
        }
        (scale())
        div.gallery {
            @for image in of(ImageContent::Reference) {
                figure {
                    (picture(image, "The reference"))
                    figcaption {
                        strong { "the reference" } br;
                        (options(&study.reference.setting.options)) br;
                        span.soft { "with two seeds, " (seconds(study.reference.seconds)) }
                    }
                }
            }
            @for image in of(ImageContent::Picture) {
                @if let Some(run) = image.run.and_then(|place| study.runs.get(place)) {
                    figure {
                        (picture(image, &format!("Rendered with {}", image.title)))
                        @for map in of(ImageContent::Error).filter(|it| it.run == image.run) {
                            (picture(map, &format!("Where the picture above is wrong; {} of its pixels by more than 1/255", percent(run.error.beyond))))
                        }
                        figcaption {
                            strong { (seconds(run.median_cpu_seconds())) " · error " (error(run.error.rmse)) }
                            @if run.role == RunRole::Own { span.tag { "the scene's own" } }
                            br;
                            (options(&image.title)) br;
                            span.soft { (percent(run.error.beyond)) " of the pixels beyond 1/255, SSIM " (format!("{:.4}", run.error.ssim)) }
                        }
                    }
                }
            }
        }
    }
}

/// A picture in the page itself.
pub fn picture(image: &StudyImage, alt: &str) -> Markup {
    html! {
        img src=(format!("data:image/png;base64,{}", image.png)) width=(image.width) height=(image.height) alt=(alt);
    }
}

/// The colours of differences.
fn scale() -> Markup {
    let at = |difference| f64::from(step_of(difference)) / 2.55;
    let named =
        [("1/255", 1.0 / 255.0), ("1/64", 1.0 / 64.0), ("1/16", 1.0 / 16.0), ("1/4", 0.25), ("1", 1.0)];
    let marks: Vec<(&str, f64)> =
        std::iter::once(("0", 0.0)).chain(named.map(|(name, difference)| (name, at(difference)))).collect();
    ramp(&marks)
}

/// All colours of maps, and what some of them mean: words at places in percent.
pub fn ramp(marks: &[(&str, f64)]) -> Markup {
    let colors = inferno();
    let stop = |step: usize| {
        let [r, g, b] = colors[step];
        format!("rgb({r} {g} {b})")
    };
    let stops: Vec<String> = (0..=16).map(|index| stop((index * 16).min(255))).collect();
    html! {
        div.scale aria-hidden="true" {
            div.ramp style=(format!("background:linear-gradient(to right,{})", stops.join(","))) {}
            @for (name, place) in marks {
                span style=(format!("left:{place:.1}%")) { (name) }
            }
        }
    }
}
