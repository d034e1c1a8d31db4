//! Scatter plot of cost and error of settings, on two logarithmic axes.

use maud::{Markup, html};

use super::axis::LogAxis;
use super::family::{SettingFamily, coordinate};
use super::numbers;
use crate::pareto::{CostErrorPoint, pareto_front};

/// One setting of the plot.
pub struct ScatterPoint {
    /// Cost and error.
    pub point: CostErrorPoint,
    /// Minimum and maximum of the measured cost.
    pub spread: Option<[f64; 2]>,
    /// Its color and shape.
    pub family: SettingFamily,
    /// Its number in the table beside the plot.
    pub number: Option<usize>,
    /// Whether these are the settings of the scene.
    pub is_own: bool,
    /// The tooltip.
    pub about: String,
}

/// A scatter plot.
pub struct ScatterPlot<'s> {
    /// All points.
    pub dots: &'s [ScatterPoint],
    /// Title of the horizontal axis.
    pub cost: &'s str,
    /// Formats its values.
    pub write: fn(f64) -> String,
    /// Errors below this are not significant.
    pub noise: Option<f64>,
    /// Alternative text.
    pub alt: String,
}

impl ScatterPlot<'_> {
    /// The plot in one size for screens and one for phones.
    pub fn draw(&self) -> Markup {
        html! {
            div.wide { (self.sized(620.0, 430.0)) }
            div.narrow { (self.sized(350.0, 360.0)) }
        }
    }

    fn sized(&self, width: f64, height: f64) -> Markup {
        let (left, right, top, bottom) = (58.0, width - 14.0, 14.0, height - 48.0);
        let costs = self.dots.iter().flat_map(|dot| {
            let [least, most] = dot.spread.unwrap_or([dot.point.cost; 2]);
            [dot.point.cost, least, most]
        });
        let x = LogAxis::of(costs, left, right);
        let errors = self.dots.iter().map(|dot| dot.point.error).chain(self.noise);
        let y = LogAxis::of(errors, bottom, top);
        let points: Vec<CostErrorPoint> = self.dots.iter().map(|dot| dot.point).collect();
        let best = pareto_front(&points);
        let line: Vec<String> = best
            .iter()
            .map(|place| {
                format!(
                    "{},{}",
                    coordinate(x.at(points[*place].cost)),
                    coordinate(y.at(points[*place].error))
                )
            })
            .collect();
        // The front is drawn last, on top.
        let is_best = |place: &usize| best.contains(place);
        let order = (0..self.dots.len()).filter(|place| !is_best(place)).chain(best.iter().copied());
        html! {
            svg.plot role="img" aria-label=(self.alt) viewBox=(format!("0 0 {width} {height}")) {
                @for tick in y.ticks() {
                    line.grid x1=(left) x2=(right) y1=(coordinate(y.at(tick))) y2=(coordinate(y.at(tick))) {}
                    text.tick x=(left - 8.0) y=(coordinate(y.at(tick) + 4.0)) text-anchor="end" { (numbers::tick(tick)) }
                }
                @for tick in spaced(&x.ticks(), |tick| x.at(tick), 52.0) {
                    line.grid x1=(coordinate(x.at(tick))) x2=(coordinate(x.at(tick))) y1=(top) y2=(bottom) {}
                    text.tick x=(coordinate(x.at(tick))) y=(bottom + 18.0) text-anchor="middle" { (trim_zeros((self.write)(tick))) }
                }
                line.axis x1=(left) x2=(right) y1=(bottom) y2=(bottom) {}
                text.label x=(0.5 * (left + right)) y=(height - 8.0) text-anchor="middle" { (self.cost) }
                text.label x="14" y=(0.5 * (top + bottom)) text-anchor="middle"
                    transform=(format!("rotate(-90 14 {})", 0.5 * (top + bottom))) { "error (RMSE, sRGB 0 to 1)" }
                @if let Some(noise) = self.noise {
                    line.noise x1=(left) x2=(right) y1=(coordinate(y.at(noise))) y2=(coordinate(y.at(noise))) {}
                    text.note x=(right - 4.0) y=(coordinate(y.at(noise) - 5.0)) text-anchor="end" { "noise of the reference" }
                }
                polyline.front points=(line.join(" ")) {}
                @for place in order {
                    (self.dot(place, is_best(&place), &x, &y))
                }
            }
        }
    }

    fn dot(&self, place: usize, is_best: bool, x: &LogAxis, y: &LogAxis) -> Markup {
        let ScatterPoint { point, spread, family, number, is_own, about } = &self.dots[place];
        let (at_x, at_y) = (x.at(point.cost), y.at(point.error));
        let strength = if is_best { "best" } else { "dominated" };
        html! {
            g.dot.(family.class()).(strength) data-cost=(point.cost) data-error=(point.error) {
                title { (about) }
                @if let Some([least, most]) = spread {
                    line.spread x1=(coordinate(x.at(*least))) x2=(coordinate(x.at(*most))) y1=(coordinate(at_y)) y2=(coordinate(at_y)) {}
                }
                @if *is_own { circle.own cx=(coordinate(at_x)) cy=(coordinate(at_y)) r="11" {} }
                (family.mark(at_x, at_y, if is_best { 5.5 } else { 4.0 }))
                @if let Some(number) = number {
                    text.number x=(coordinate(at_x + 8.0)) y=(coordinate(at_y - 8.0)) { (number) }
                }
            }
        }
    }
}

/// The legend of the families that occur.
pub fn legend(dots: &[ScatterPoint]) -> Markup {
    let families =
        SettingFamily::ALL.into_iter().filter(|family| dots.iter().any(|dot| dot.family == *family));
    html! {
        ul.legend {
            @for family in families {
                li { svg viewBox="0 0 16 16" aria-hidden="true" { g.dot.best.(family.class()) { (family.mark(8.0, 8.0, 5.0)) } } (family.name()) }
            }
            @if dots.iter().any(|dot| dot.is_own) {
                li { svg viewBox="0 0 24 24" aria-hidden="true" { circle.own cx="12" cy="12" r="9" {} } "scene's settings" }
            }
            li { svg viewBox="0 0 28 16" aria-hidden="true" { polyline.front points="1,4 14,10 27,13" {} } "Pareto front" }
        }
    }
}

/// Ticks whose labels do not overlap.
pub fn spaced(ticks: &[f64], at: impl Fn(f64) -> f64, min_distance: f64) -> Vec<f64> {
    let mut spaced: Vec<f64> = Vec::new();
    for tick in ticks {
        if spaced.last().is_none_or(|last| (at(*tick) - at(*last)).abs() >= min_distance) {
            spaced.push(*tick);
        }
    }
    spaced
}

/// Removes trailing zeros: `10.0 ms` becomes `10 ms`.
pub fn trim_zeros(text: String) -> String {
    match text.split_once(' ') {
        Some((number, unit)) if number.contains('.') => {
            format!("{} {unit}", number.trim_end_matches('0').trim_end_matches('.'))
        }
        _ if text.contains('.') => text.trim_end_matches('0').trim_end_matches('.').into(),
        _ => text,
    }
}
