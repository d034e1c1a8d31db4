//! Row chart: a name, the error as a dot on a logarithmic axis, the cost as a bar from zero.

use maud::{Markup, html};

use super::axis::{LinearAxis, LogAxis};
use super::family::{SettingFamily, coordinate};
use super::numbers;
use super::scatter::{spaced, trim_zeros};

/// One row.
pub struct SweepRow {
    /// The label.
    pub name: String,
    /// The error. Zero is drawn beside the axis.
    pub error: f64,
    /// Processor seconds.
    pub cost: f64,
    /// Minimum and maximum of the measured cost.
    pub spread: [f64; 2],
    /// Color and shape of the dot.
    pub family: SettingFamily,
}

/// Whether each row is finer than the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowOrder {
    Ascending,
    None,
}

/// The chart in one size for screens and one for phones.
pub fn draw(rows: &[SweepRow], order: RowOrder, alt: &str) -> Markup {
    html! {
        div.wide { (sized(rows, order, alt, 560.0, 170.0, 84.0)) }
        div.narrow { (sized(rows, order, alt, 350.0, 112.0, 58.0)) }
    }
}

/// Height of a row.
const HEIGHT: f64 = 24.0;
/// Width of a letter.
const LETTER: f64 = 6.8;
/// Space above the rows.
const TOP: f64 = 24.0;
/// Space between errors and bars, for half a tick label of each axis.
const BETWEEN: f64 = 34.0;

fn sized(rows: &[SweepRow], order: RowOrder, alt: &str, width: f64, most: f64, values: f64) -> Markup {
    // As wide as the longest name, within the maximum.
    let longest = rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0);
    let names = (LETTER * longest as f64 + 6.0).min(most);
    let whole = TOP + HEIGHT * rows.len() as f64;
    let height = whole + 40.0;
    // Names, zero, errors, bars, values of the bars.
    let zero = names + 14.0;
    let center = zero + 16.0 + 0.44 * (width - zero - values);
    let first = center + BETWEEN;
    let errors = LogAxis::of(rows.iter().map(|row| row.error), zero + 18.0, center);
    let bars = LinearAxis::of(rows.iter().flat_map(|row| [row.cost, row.spread[1]]), first, width - values);
    let y = |place: usize| TOP + HEIGHT * (place as f64 + 0.5);
    let has_zero = rows.iter().any(|row| row.error <= 0.0);
    let at = |row: &SweepRow| if row.error > 0.0 { errors.at(row.error) } else { zero };
    let line: Vec<String> = rows
        .iter()
        .enumerate()
        .filter(|(_, row)| row.error > 0.0)
        .map(|(place, row)| format!("{},{}", coordinate(at(row)), coordinate(y(place))))
        .collect();
    let mut error_ticks = spaced(&errors.ticks(), |tick| errors.at(tick), 48.0);
    if rows.iter().all(|row| row.error <= 0.0) {
        // An axis without points needs no ticks.
        error_ticks.clear();
    }
    if has_zero {
        // Labels must not overlap that of zero.
        error_ticks.retain(|tick| errors.at(*tick) - zero > 30.0);
    }
    let bar_ticks = spaced(&bars.ticks(3.0), |tick| bars.at(tick), 48.0);
    html! {
        svg.plot.rows role="img" aria-label=(alt) viewBox=(format!("0 0 {width} {height}")) {
            text.head x=(zero - 6.0) y="12" { "error (RMSE)" }
            text.head x=(coordinate(first)) y="12" { "processor time" }
            @for tick in &error_ticks {
                line.grid x1=(coordinate(errors.at(*tick))) x2=(coordinate(errors.at(*tick))) y1=(TOP) y2=(whole) {}
                text.tick x=(coordinate(errors.at(*tick))) y=(whole + 16.0) text-anchor="middle" { (numbers::tick(*tick)) }
            }
            @if has_zero {
                line.grid.zero x1=(zero) x2=(zero) y1=(TOP) y2=(whole) {}
                text.tick x=(zero) y=(whole + 16.0) text-anchor="middle" { "0" }
            }
            @for tick in &bar_ticks {
                line.grid x1=(coordinate(bars.at(*tick))) x2=(coordinate(bars.at(*tick))) y1=(TOP) y2=(whole) {}
                text.tick x=(coordinate(bars.at(*tick))) y=(whole + 16.0) text-anchor="middle" { (trim_zeros(numbers::seconds(*tick))) }
            }
            @if order == RowOrder::Ascending { polyline.trend points=(line.join(" ")) {} }
            @for (place, row) in rows.iter().enumerate() {
                g data-cost=(row.cost) data-error=(row.error) {
                    title { (row.name) ": error " (numbers::error(row.error)) ", " (numbers::seconds(row.cost)) }
                    text.name x=(names) y=(coordinate(y(place) + 4.0)) text-anchor="end" { (truncated(&row.name, names)) }
                    g.dot.best.(row.family.class()) { (row.family.mark(at(row), y(place), 5.0)) }
                    rect.bar x=(coordinate(bars.at(0.0))) y=(coordinate(y(place) - 6.5)) height="13"
                        width=(coordinate((bars.at(row.cost) - bars.at(0.0)).max(1.0))) {}
                    line.spread x1=(coordinate(bars.at(row.spread[0]))) x2=(coordinate(bars.at(row.spread[1])))
                        y1=(coordinate(y(place))) y2=(coordinate(y(place))) {}
                    text.value x=(coordinate(bars.at(row.cost.max(row.spread[1])) + 6.0)) y=(coordinate(y(place) + 4.0)) { (numbers::seconds(row.cost)) }
                }
            }
        }
    }
}

/// A name, shortened to the available width.
fn truncated(name: &str, width: f64) -> String {
    let most = (width / LETTER) as usize;
    if name.chars().count() <= most {
        return name.into();
    }
    let start: String = name.chars().take(most.saturating_sub(1)).collect();
    format!("{start}…")
}
