//! Diagnostics as a compiler would show them.

use std::fmt;
use std::ops::Range;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents, SourceCode,
    SourceSpan, SpanContents,
};

use super::diagnostic::Diagnostic;
use super::list::Diagnostics;
use super::screen::{TerminalFeatures, TerminalStyle};
use crate::quantity::quantity;

impl Diagnostics {
    /// All of them as they are shown on `screen`.
    pub fn render(&self, screen: TerminalStyle) -> String {
        let theme = match screen.features {
            TerminalFeatures::Ascii => GraphicalTheme::none(),
            TerminalFeatures::AsciiColor => GraphicalTheme::ascii(),
            TerminalFeatures::Unicode => GraphicalTheme::unicode_nocolor(),
            TerminalFeatures::UnicodeColor => GraphicalTheme::unicode(),
        };
        let handler = GraphicalReportHandler::new_themed(theme)
            .with_width(screen.width.max(20))
            .with_context_lines(1)
            .with_links(false);
        let excerpt =
            SourceExcerpt { diagnostics: self, name: self.path.display().to_string(), width: screen.width };
        let mut shown = String::new();
        for fault in &self.list {
            // A writer that is a string does not fail.
            let _ = handler.render_report(&mut shown, &MietteDiagnostic { fault, excerpt: &excerpt });
            shown.push('\n');
        }
        let many = quantity(self.total, "error");
        let cut = if self.total > self.list.len() { ", of which the first are shown" } else { "" };
        shown + &format!("{}: {many}{cut}", excerpt.name)
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(TerminalStyle::PLAIN))
    }
}

/// The text around a place, whole lines where they fit.
struct SourceExcerpt<'f> {
    diagnostics: &'f Diagnostics,
    name: String,
    width: usize,
}

impl SourceCode for SourceExcerpt<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let faults = self.diagnostics;
        let (start, end) = (span.offset(), span.offset() + span.len());
        let (first, last) = (faults.lines.index(start), faults.lines.index(end));
        let whole = first.saturating_sub(before)..(last + after + 1).min(faults.lines.0.len());
        // The numbers of lines and the frame stand beside the text.
        let room = self.width.saturating_sub(12).max(20);
        let fits = whole.clone().all(|index| faults.line_range(index).len() <= room);
        let piece = if before == 0 && after == 0 {
            start..end
        } else if fits {
            faults.line_range(whole.start).start..faults.line_range(whole.end - 1).end
        } else {
            clip(&faults.text, faults.line_range(first).start..faults.line_range(last).end, start..end, room)
        };
        let line = faults.lines.index(piece.start);
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            &faults.text.as_bytes()[piece.clone()],
            (piece.start, piece.len()).into(),
            line,
            faults.column(piece.start),
            faults.lines.index(piece.end) - line + 1,
        )))
    }
}

/// The part of the lines round a span that has room; the span itself is never cut.
fn clip(text: &str, lines: Range<usize>, span: Range<usize>, room: usize) -> Range<usize> {
    let spare = room.saturating_sub(span.len());
    let start = lines.start.max(span.start.saturating_sub(spare / 2));
    let end = lines.end.min(span.end.max(start + room));
    let start = (start..=span.start).find(|p| text.is_char_boundary(*p)).unwrap_or(span.start);
    let end = (span.end..=end).rev().find(|p| text.is_char_boundary(*p)).unwrap_or(span.end);
    start..end
}

/// A fault as miette wants it.
struct MietteDiagnostic<'f> {
    fault: &'f Diagnostic,
    excerpt: &'f SourceExcerpt<'f>,
}

impl fmt::Debug for MietteDiagnostic<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.fault.fmt(f)
    }
}

impl fmt::Display for MietteDiagnostic<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.fault.message)
    }
}

impl std::error::Error for MietteDiagnostic<'_> {}

impl miette::Diagnostic for MietteDiagnostic<'_> {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.fault.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let main = LabeledSpan::new_primary_with_span(None, self.fault.span.clone());
        let also = self.fault.related.iter();
        let also = also.map(|(span, what)| LabeledSpan::new_with_span(Some(what.clone()), span.clone()));
        Some(Box::new(std::iter::once(main).chain(also)))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn shown(text: &str, fault: Diagnostic, width: usize) -> String {
        Diagnostics::new(Path::new("a.toml"), text, [fault])
            .render(TerminalStyle { width, features: TerminalFeatures::Ascii })
    }

    #[test]
    fn a_fault_is_shown_with_its_line_a_caret_and_advice() {
        let text = "[[sphere]]\nradius = -1\ncenter = [0, 0, 0]\n";
        let shown = shown(text, Diagnostic::new(20..22, "too small").with_help("larger"), 80);
        assert_eq!(
            shown,
            "  x too small
   ,-[a.toml:2:10]
 1 | [[sphere]]
 2 | radius = -1
   :          ^^
 3 | center = [0, 0, 0]
   `----
  help: larger

a.toml: 1 error"
        );
    }

    #[test]
    fn every_place_in_any_text_has_a_line_and_a_caret() {
        for text in ["", "\n", "a", "é\r\n\r\n ü", "\u{feff}a = \u{1b}[2J\n\n", "x\n\n\n", "\t\u{202e}\n"] {
            for start in 0..=text.len() + 1 {
                for end in start..=text.len() + 1 {
                    let faults =
                        Diagnostics::new(Path::new("a.toml"), text, [Diagnostic::new(start..end, "wrong")]);
                    let (line, column) = faults.line_and_column(&faults.list()[0]);
                    assert!(line <= text.lines().count().max(1) && column <= text.chars().count().max(1));
                    let shown = faults.to_string();
                    assert!(shown.contains(&format!("a.toml:{line}:{column}")), "{start}..{end} {shown}");
                    assert!(!shown.contains(['\u{1b}', '\u{202e}', '\r']), "{shown:?}");
                    assert!(
                        shown.contains('^') || text.trim().is_empty(),
                        "{text:?} {start}..{end}\n{shown}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_long_line_is_cut_to_the_part_in_question() {
        let text = format!("a = [{}\"x\"{}]\n", "1.25, ".repeat(1000), ", 4.5".repeat(1000));
        let place = text.find('"').unwrap();
        for width in [40, 80, 200] {
            let shown = shown(&text, Diagnostic::new(place..place + 3, "no number"), width);
            assert!(shown.contains("\"x\"") && shown.contains("^^^"), "{shown}");
            assert!(shown.lines().all(|line| line.chars().count() <= width), "{width}\n{shown}");
        }
    }
}
