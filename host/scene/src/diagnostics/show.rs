//! Display of diagnostics with source excerpts.

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
    /// All errors as text, for an output of this style, with their total at the end.
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
        for diagnostic in &self.list {
            // Writing to a string cannot fail.
            let _ = handler.render_report(&mut shown, &MietteDiagnostic { diagnostic, excerpt: &excerpt });
            shown.push('\n');
        }
        let many = quantity(self.total, "error");
        let first = format!(", the first {} shown", self.list.len());
        let clipped = if self.total > self.list.len() { first } else { String::new() };
        shown + &format!("{}: {many}{clipped}", excerpt.name)
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(TerminalStyle::PLAIN))
    }
}

/// The source text around an error; whole lines if they fit.
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
        let diagnostics = self.diagnostics;
        let (start, end) = (span.offset(), span.offset() + span.len());
        let (first, last) = (diagnostics.lines.index(start), diagnostics.lines.index(end));
        let whole = first.saturating_sub(before)..(last + after + 1).min(diagnostics.lines.0.len());
        // The line numbers and the frame take the rest of the width.
        let max_bytes = self.width.saturating_sub(12).max(20);
        let fits = whole.clone().all(|index| diagnostics.line_range(index).len() <= max_bytes);
        let piece = if before == 0 && after == 0 {
            start..end
        } else if fits {
            diagnostics.line_range(whole.start).start..diagnostics.line_range(whole.end - 1).end
        } else {
            clip(
                &diagnostics.text,
                diagnostics.line_range(first).start..diagnostics.line_range(last).end,
                start..end,
                max_bytes,
            )
        };
        let line = diagnostics.lines.index(piece.start);
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            &diagnostics.text.as_bytes()[piece.clone()],
            (piece.start, piece.len()).into(),
            line,
            diagnostics.column(piece.start),
            diagnostics.lines.index(piece.end) - line + 1,
        )))
    }
}

/// The part of the lines around a span that fits in `max_bytes` bytes; the span itself is never clipped.
fn clip(text: &str, lines: Range<usize>, span: Range<usize>, max_bytes: usize) -> Range<usize> {
    let spare = max_bytes.saturating_sub(span.len());
    let start = lines.start.max(span.start.saturating_sub(spare / 2));
    let end = lines.end.min(span.end.max(start + max_bytes));
    let start = (start..=span.start).find(|p| text.is_char_boundary(*p)).unwrap_or(span.start);
    let end = (span.end..=end).rev().find(|p| text.is_char_boundary(*p)).unwrap_or(span.end);
    start..end
}

/// Adapts a diagnostic to miette's trait.
struct MietteDiagnostic<'f> {
    diagnostic: &'f Diagnostic,
    excerpt: &'f SourceExcerpt<'f>,
}

impl fmt::Debug for MietteDiagnostic<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.diagnostic.fmt(f)
    }
}

impl fmt::Display for MietteDiagnostic<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.diagnostic.message)
    }
}

impl std::error::Error for MietteDiagnostic<'_> {}

impl miette::Diagnostic for MietteDiagnostic<'_> {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.diagnostic.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let main = LabeledSpan::new_primary_with_span(None, self.diagnostic.span.clone());
        let also = self.diagnostic.related.iter();
        let also = also.map(|(span, what)| LabeledSpan::new_with_span(Some(what.clone()), span.clone()));
        Some(Box::new(std::iter::once(main).chain(also)))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn shown(text: &str, diagnostic: Diagnostic, width: usize) -> String {
        Diagnostics::new(Path::new("a.toml"), text, [diagnostic])
            .render(TerminalStyle { width, features: TerminalFeatures::Ascii })
    }

    #[test]
    fn an_error_is_displayed_with_its_line_a_caret_and_advice() {
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
    fn every_position_in_any_text_has_a_line_and_a_caret() {
        for text in ["", "\n", "a", "é\r\n\r\n ü", "\u{feff}a = \u{1b}[2J\n\n", "x\n\n\n", "\t\u{202e}\n"] {
            for start in 0..=text.len() + 1 {
                for end in start..=text.len() + 1 {
                    let diagnostics =
                        Diagnostics::new(Path::new("a.toml"), text, [Diagnostic::new(start..end, "wrong")]);
                    let (line, column) = diagnostics.line_and_column(&diagnostics.list()[0]);
                    assert!(line <= text.lines().count().max(1) && column <= text.chars().count().max(1));
                    let shown = diagnostics.to_string();
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
    fn a_long_line_is_clipped_around_the_error() {
        let text = format!("a = [{}\"x\"{}]\n", "1.25, ".repeat(1000), ", 4.5".repeat(1000));
        let place = text.find('"').unwrap();
        for width in [40, 80, 200] {
            let shown = shown(&text, Diagnostic::new(place..place + 3, "no number"), width);
            assert!(shown.contains("\"x\"") && shown.contains("^^^"), "{shown}");
            assert!(shown.lines().all(|line| line.chars().count() <= width), "{width}\n{shown}");
        }
    }
}
