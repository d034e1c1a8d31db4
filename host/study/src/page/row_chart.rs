//! Rows: a name, an error as a dot on a logarithmic axis, a cost as a bar from zero.

use maud::{Markup, html};

use super::axis::{LinearAxis, LogAxis};
use super::family::{SettingFamily, round};
use super::numbers;
use super::scatter::{spaced, trim_zeros};

/// One row.
pub struct SweepRow {
    /// What it is called.
    pub name: String,
    /// Zero is drawn at the edge, apart from the axis.
    pub error: f64,
    /// Seconds.
    pub cost: f64,
    /// From where to where they were measured.
    pub spread: [f64; 2],
    /// What the dot looks like.
    pub family: SettingFamily,
}

/// Whether each row is finer than the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowOrder {
    Ascending,
    None,
}

/// In a size for screens, and in one for phones.
pub fn draw(rows: &[SweepRow], order: RowOrder, alt: &str) -> Markup {
    html! {
        div.wide { (sized(rows, order, alt, 560.0, 170.0, 84.0)) }
        div.narrow { (sized(rows, order, alt, 350.0, 112.0, 58.0)) }
    }
}

/// How high one row is.
const HEIGHT: f64 = 24.0;
/// How wide a letter of a name is.
const LETTER: f64 = 6.8;
/// The room above them.
const TOP: f64 = 24.0;
/// The room between errors and bars: for half a word of either axis.
const BETWEEN: f64 = 34.0;

fn sized(rows: &[SweepRow], order: RowOrder, alt: &str, width: f64, most: f64, values: f64) -> Markup {
    // As wide as the longest name, but no wider than there is room.
    let longest = rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0);
    let names = (LETTER * longest as f64 + 6.0).min(most);
    let whole = TOP + HEIGHT * rows.len() as f64;
    let height = whole + 40.0;
    // Names, the place of zero, errors, bars, the numbers of the bars.
    let zero = names + 14.0;
    let middle = zero + 16.0 + 0.44 * (width - zero - values);
    let first = middle + BETWEEN;
    let errors = LogAxis::of(rows.iter().map(|row| row.error), zero + 18.0, middle);
    let bars = LinearAxis::of(rows.iter().flat_map(|row| [row.cost, row.spread[1]]), first, width - values);
    let y = |place: usize| TOP + HEIGHT * (place as f64 + 0.5);
    let has_zero = rows.iter().any(|row| row.error <= 0.0);
    let at = |row: &SweepRow| if row.error > 0.0 { errors.at(row.error) } else { zero };
    let line: Vec<String> = rows
        .iter()
        .enumerate()
        .filter(|(_, row)| row.error > 0.0)
        .map(|(place, row)| format!("{},{}", round(at(row)), round(y(place))))
        .collect();
    let mut error_ticks = spaced(&errors.ticks(), |tick| errors.at(tick), 48.0);
    if rows.iter().all(|row| row.error <= 0.0) {
        // Of an axis with nothing on it there is nothing to read.
        error_ticks.clear();
    }
    if has_zero {
        // Its word needs room beside that of zero.
        error_ticks.retain(|tick| errors.at(*tick) - zero > 30.0);
    }
    let bar_ticks = spaced(&bars.ticks(3.0), |tick| bars.at(tick), 48.0);
    html! {
        svg.plot.rows role="img" aria-label=(alt) viewBox=(format!("0 0 {width} {height}")) {
            text.head x=(zero - 6.0) y="12" { "error (RMSE)" }
            text.head x=(round(first)) y="12" { "processor time" }
            @for tick in &error_ticks {
                line.grid x1=(round(errors.at(*tick))) x2=(round(errors.at(*tick))) y1=(TOP) y2=(whole) {}
                text.tick x=(round(errors.at(*tick))) y=(whole + 16.0) text-anchor="middle" { (numbers::tick(*tick)) }
            }
            @if has_zero {
                line.grid.zero x1=(zero) x2=(zero) y1=(TOP) y2=(whole) {}
                text.tick x=(zero) y=(whole + 16.0) text-anchor="middle" { "0" }
            }
            @for tick in &bar_ticks {
                line.grid x1=(round(bars.at(*tick))) x2=(round(bars.at(*tick))) y1=(TOP) y2=(whole) {}
                text.tick x=(round(bars.at(*tick))) y=(whole + 16.0) text-anchor="middle" { (trim_zeros(numbers::seconds(*tick))) }
            }
            @if order == RowOrder::Ascending { polyline.trend points=(line.join(" ")) {} }
            @for (place, row) in rows.iter().enumerate() {
                g data-cost=(row.cost) data-error=(row.error) {
                    title { (row.name) ": error " (numbers::error(row.error)) ", " (numbers::seconds(row.cost)) }
                    text.name x=(names) y=(round(y(place) + 4.0)) text-anchor="end" { (truncated(&row.name, names)) }
                    g.dot.best.(row.family.class()) { (row.family.mark(at(row), y(place), 5.0)) }
                    rect.bar x=(round(bars.at(0.0))) y=(round(y(place) - 6.5)) height="13"
                        width=(round((bars.at(row.cost) - bars.at(0.0)).max(1.0))) {}
                    line.spread x1=(round(bars.at(row.spread[0]))) x2=(round(bars.at(row.spread[1])))
                        y1=(round(y(place))) y2=(round(y(place))) {}
                    text.value x=(round(bars.at(row.cost.max(row.spread[1])) + 6.0)) y=(round(y(place) + 4.0)) { (numbers::seconds(row.cost)) }
                }
            }
        }
    }
}

/// As much of a name as has room.
fn truncated(name: &str, room: f64) -> String {
    let most = (room / LETTER) as usize;
    if name.chars().count() <= most {
        return name.into();
    }
    let kept: String = name.chars().take(most.saturating_sub(1)).collect();
    format!("{kept}…")
}
