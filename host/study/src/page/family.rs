//! Families of settings, distinguished by color and shape.

use maud::{Markup, html};

use strahl_settings::Settings;

/// A family of settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingFamily {
    Single,
    Regular,
    Adaptive,
    Stochastic,
    Selected,
    Without,
    Double,
}

impl SettingFamily {
    /// Every family, in the order of legends.
    pub const ALL: [SettingFamily; 7] = [
        SettingFamily::Single,
        SettingFamily::Regular,
        SettingFamily::Adaptive,
        SettingFamily::Stochastic,
        SettingFamily::Selected,
        SettingFamily::Without,
        SettingFamily::Double,
    ];

    /// The family of some settings.
    pub fn of(settings: &Settings) -> Self {
        if !settings.without.is_empty() {
            SettingFamily::Without
        } else if settings.select.is_some() {
            SettingFamily::Selected
        } else {
            SettingFamily::named(&settings.sampler.to_string())
        }
    }

    /// The family of a sampler.
    pub fn named(sampler: &str) -> Self {
        match sampler.split(':').next() {
            Some("regular") => SettingFamily::Regular,
            Some("adaptive") => SettingFamily::Adaptive,
            Some("stochastic") => SettingFamily::Stochastic,
            _ => SettingFamily::Single,
        }
    }

    /// The name in legends.
    pub fn name(self) -> &'static str {
        match self {
            SettingFamily::Single => "single",
            SettingFamily::Regular => "regular",
            SettingFamily::Adaptive => "adaptive",
            SettingFamily::Stochastic => "stochastic",
            SettingFamily::Selected => "pixel selection",
            SettingFamily::Without => "effect disabled",
            SettingFamily::Double => "double precision",
        }
    }

    /// The CSS class of its color.
    pub fn class(self) -> &'static str {
        match self {
            SettingFamily::Single => "single",
            SettingFamily::Regular => "regular",
            SettingFamily::Adaptive => "adaptive",
            SettingFamily::Stochastic => "stochastic",
            SettingFamily::Selected => "selected",
            SettingFamily::Without => "without",
            SettingFamily::Double => "double",
        }
    }

    /// Its shape, centered at a point.
    pub fn mark(self, x: f64, y: f64, size: f64) -> Markup {
        let path = |points: &[(f64, f64)]| {
            let text: Vec<_> =
                points.iter().map(|(dx, dy)| format!("{:.1},{:.1}", x + dx * size, y + dy * size)).collect();
            text.join(" ")
        };
        html! {
            @match self {
                SettingFamily::Single => { circle cx=(coordinate(x)) cy=(coordinate(y)) r=(coordinate(size)) {} }
                SettingFamily::Regular => {
                    polygon points=(path(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)])) {}
                }
                SettingFamily::Adaptive => { polygon points=(path(&[(0.0, -1.2), (1.15, 0.85), (-1.15, 0.85)])) {} }
                SettingFamily::Stochastic => {
                    polygon points=(path(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)])) {}
                }
                SettingFamily::Selected => {
                    polygon points=(path(&[(0.0, 1.2), (1.15, -0.85), (-1.15, -0.85)])) {}
                }
                SettingFamily::Without | SettingFamily::Double => {
                    circle.hollow cx=(coordinate(x)) cy=(coordinate(y)) r=(coordinate(size)) {}
                }
            }
        }
    }
}

/// A coordinate, rounded to a tenth.
pub fn coordinate(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
