//! Families of settings, told apart by colour and by shape.

use maud::{Markup, html};

use strahl_settings::Settings;

/// What kind of rays make a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Single,
    Regular,
    Adaptive,
    Stochastic,
    Selected,
    Without,
    Double,
}

impl Family {
    /// Every family, in the order of legends.
    pub const ALL: [Family; 7] = [
        Family::Single,
        Family::Regular,
        Family::Adaptive,
        Family::Stochastic,
        Family::Selected,
        Family::Without,
        Family::Double,
    ];

    /// That of settings.
    pub fn of(settings: &Settings) -> Self {
        if !settings.without.is_empty() {
            Family::Without
        } else if settings.select.is_some() {
            Family::Selected
        } else {
            Family::named(&settings.sampler.to_string())
        }
    }

    /// That of a sampler.
    pub fn named(sampler: &str) -> Self {
        match sampler.split(':').next() {
            Some("regular") => Family::Regular,
            Some("adaptive") => Family::Adaptive,
            Some("stochastic") => Family::Stochastic,
            _ => Family::Single,
        }
    }

    /// For legends.
    pub fn name(self) -> &'static str {
        match self {
            Family::Single => "one ray",
            Family::Regular => "regular",
            Family::Adaptive => "adaptive",
            Family::Stochastic => "stochastic",
            Family::Selected => "pixel-selected",
            Family::Without => "an effect left out",
            Family::Double => "double precision",
        }
    }

    /// The name of its colour in the style.
    pub fn class(self) -> &'static str {
        match self {
            Family::Single => "single",
            Family::Regular => "regular",
            Family::Adaptive => "adaptive",
            Family::Stochastic => "stochastic",
            Family::Selected => "selected",
            Family::Without => "without",
            Family::Double => "double",
        }
    }

    /// Its shape about a place.
    pub fn mark(self, x: f64, y: f64, size: f64) -> Markup {
        let path = |points: &[(f64, f64)]| {
            let text: Vec<_> =
                points.iter().map(|(dx, dy)| format!("{:.1},{:.1}", x + dx * size, y + dy * size)).collect();
            text.join(" ")
        };
        html! {
            @match self {
                Family::Single => { circle cx=(round(x)) cy=(round(y)) r=(round(size)) {} }
                Family::Regular => {
                    polygon points=(path(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)])) {}
                }
                Family::Adaptive => { polygon points=(path(&[(0.0, -1.2), (1.15, 0.85), (-1.15, 0.85)])) {} }
                Family::Stochastic => {
                    polygon points=(path(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)])) {}
                }
                Family::Selected => {
                    polygon points=(path(&[(0.0, 1.2), (1.15, -0.85), (-1.15, -0.85)])) {}
                }
                Family::Without | Family::Double => {
                    circle.hollow cx=(round(x)) cy=(round(y)) r=(round(size)) {}
                }
            }
        }
    }
}

/// A place, to a tenth.
pub fn round(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
