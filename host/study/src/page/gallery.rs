//! Pictures of some settings, with their error maps.

use maud::{Markup, html};

use strahl_picture::color_map::{inferno, step_of};

use super::numbers::{error, percent, seconds};
use super::pieces::options;
use crate::record::{ImageContent, RunRole, Study, StudyImage};

pub fn section(study: &Study) -> Markup {
    let of = |shows: ImageContent| study.pictures.iter().filter(move |it| it.shows == shows);
    html! {
        p {
            "Each picture with its error map: the largest channel difference of each pixel, on a logarithmic scale from 0 (black) "
            "through 1/255 (violet) to 1 (pale yellow)."
        }
        (scale())
        div.gallery {
            @for image in of(ImageContent::Reference) {
                figure {
                    (picture(image, "The reference"))
                    figcaption {
                        strong { "the reference" } br;
                        (options(&study.reference.setting.options)) br;
                        span.soft { "mean of two seeds, " (seconds(study.reference.seconds)) }
                    }
                }
            }
            @for image in of(ImageContent::Picture) {
                @if let Some(run) = image.run.and_then(|place| study.runs.get(place)) {
                    figure {
                        (picture(image, &format!("Rendered with {}", image.title)))
                        @for map in of(ImageContent::Error).filter(|it| it.run == image.run) {
                            (picture(map, &format!("Error map of the picture above; {} of its pixels differ by more than 1/255", percent(run.error.beyond))))
                        }
                        figcaption {
                            strong { (seconds(run.median_cpu_seconds())) " · error " (error(run.error.rmse)) }
                            @if run.role == RunRole::Own { span.tag { "scene's settings" } }
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

/// A picture, embedded in the page.
pub fn picture(image: &StudyImage, alt: &str) -> Markup {
    html! {
        img src=(format!("data:image/png;base64,{}", image.png)) width=(image.width) height=(image.height) alt=(alt);
    }
}

/// The color bar of error maps.
fn scale() -> Markup {
    let at = |difference| f64::from(step_of(difference)) / 2.55;
    let named =
        [("1/255", 1.0 / 255.0), ("1/64", 1.0 / 64.0), ("1/16", 1.0 / 16.0), ("1/4", 0.25), ("1", 1.0)];
    let marks: Vec<(&str, f64)> =
        std::iter::once(("0", 0.0)).chain(named.map(|(name, difference)| (name, at(difference)))).collect();
    color_bar(&marks)
}

/// A color bar with labels at positions in percent.
pub fn color_bar(marks: &[(&str, f64)]) -> Markup {
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
