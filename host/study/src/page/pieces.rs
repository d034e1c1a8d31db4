//! Shared pieces of HTML.

use maud::{Markup, html};

use crate::record::StudyRun;

/// Command-line options; lines break only between options.
pub fn options(text: &str) -> Markup {
    let separate = if text.contains("--") { " --" } else { " " };
    html! {
        code {
            @for (place, word) in text.split(separate).enumerate() {
                @if place > 0 { " " }
                span { @if place > 0 && separate == " --" { "--" } (word) }
            }
        }
    }
}

/// The options of a run without dashes.
pub fn words(run: &StudyRun) -> String {
    run.setting.options.replace("--", "")
}

/// A table with a scroll bar on narrow screens.
pub fn scrollable(table: Markup) -> Markup {
    html! { div.scroll tabindex="0" { (table) } }
}
