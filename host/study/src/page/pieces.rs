//! Pieces of HTML that several parts of the page use.

use maud::{Markup, html};

use crate::record::StudyRun;

/// Options of the command line, which are broken between two of them only.
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

/// What a run is, in the words of the command line without the dashes.
pub fn words(run: &StudyRun) -> String {
    run.setting.options.replace("--", "")
}

/// A table that may be wider than a phone.
pub fn wide(table: Markup) -> Markup {
    html! { div.scroll tabindex="0" { (table) } }
}
