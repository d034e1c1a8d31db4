//! What is wrong in a text: all of it at once, each with its place, shown as a compiler would.
//!
//! The text is another's. What could steer a terminal is shown as a harmless character of the
//! same length, and a line that is longer than the screen is cut to the part in question.

use std::fmt;
use std::io::{self, IsTerminal};
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::amount::amount;
use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents,
    SourceCode, SourceSpan, SpanContents,
};

/// More than anybody reads.
const MOST_SHOWN: usize = 50;

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What.
    pub message: String,
    /// Where, in bytes of the text.
    pub span: Range<usize>,
    /// What to do about it.
    pub help: Option<String>,
    /// Another place that has to do with it, and how.
    pub also: Option<(Range<usize>, String)>,
}

impl Fault {
    /// Something wrong at a place.
    pub fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        Fault { message: message.into(), span, help: None, also: None }
    }

    /// The same with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same with another place.
    pub fn also(mut self, span: Range<usize>, what: impl Into<String>) -> Self {
        self.also = Some((span, what.into()));
        self
    }
}

/// Where the lines of a text begin.
#[derive(Clone, Debug)]
pub struct Lines(Vec<usize>);

impl Lines {
    /// Those of `text`.
    pub fn of(text: &str) -> Self {
        Lines(std::iter::once(0).chain(text.match_indices('\n').map(|(end, _)| end + 1)).collect())
    }

    /// The line of a place, counted from 0.
    fn index(&self, place: usize) -> usize {
        self.0.partition_point(|start| *start <= place).saturating_sub(1)
    }

    /// The line of a place, counted from 1.
    pub fn line(&self, place: usize) -> usize {
        self.index(place) + 1
    }
}

/// Everything that is wrong in a text.
#[derive(Clone, Debug)]
pub struct Faults {
    path: PathBuf,
    text: String,
    lines: Lines,
    /// The first of them.
    list: Vec<Fault>,
    /// How many there are.
    count: usize,
}

impl Faults {
    /// The faults of the text of a file, in the order of their places.
    pub fn new(path: &Path, text: &str, list: impl IntoIterator<Item = Fault>) -> Self {
        let text = harmless(text);
        let lines = Lines::of(&text);
        let mut list: Vec<Fault> = list.into_iter().collect();
        list.sort_by_key(|fault| fault.span.start);
        let count = list.len();
        list.truncate(MOST_SHOWN);
        let mut faults = Faults { path: path.to_owned(), text, lines, list, count };
        for fault in &mut faults.list {
            fault.span = visible(&faults.text, &fault.span);
            if let Some((span, _)) = &mut fault.also {
                *span = visible(&faults.text, span);
            }
        }
        faults
    }

    /// The same, where more have been found than were kept.
    pub fn counting(mut self, count: usize) -> Self {
        self.count = self.count.max(count);
        self
    }

    /// The first of them, as many as are shown.
    pub fn list(&self) -> &[Fault] {
        &self.list
    }

    /// The line and the column of a fault, counted from 1.
    pub fn place(&self, fault: &Fault) -> (usize, usize) {
        (self.lines.line(fault.span.start), self.column(fault.span.start) + 1)
    }

    /// The characters before a place in its line.
    fn column(&self, place: usize) -> usize {
        let start = self.lines.0[self.lines.index(place)];
        self.text[start..place].chars().filter(|c| *c != '\u{feff}').count()
    }

    /// The line at this index without its end.
    fn bounds(&self, index: usize) -> Range<usize> {
        let start = self.lines.0[index];
        let end = self.lines.0.get(index + 1).map_or(self.text.len(), |next| next - 1);
        start..start + self.text[start..end].trim_end_matches('\r').len()
    }

    /// All of them as they are shown on `screen`.
    pub fn show(&self, screen: Screen) -> String {
        let theme = match screen.drawing {
            Drawing::Plain => GraphicalTheme::none(),
            Drawing::PlainColors => GraphicalTheme::ascii(),
            Drawing::Lines => GraphicalTheme::unicode_nocolor(),
            Drawing::Colors => GraphicalTheme::unicode(),
        };
        let handler = GraphicalReportHandler::new_themed(theme)
            .with_width(screen.width.max(20))
            .with_context_lines(1)
            .with_links(false);
        let excerpt = Excerpt { of: self, name: self.path.display().to_string(), width: screen.width };
        let mut shown = String::new();
        for fault in &self.list {
            // A writer that is a string does not fail.
            let _ = handler.render_report(&mut shown, &Shown { fault, excerpt: &excerpt });
            shown.push('\n');
        }
        let many = amount(self.count, "error");
        let cut = if self.count > self.list.len() { ", of which the first are shown" } else { "" };
        shown + &format!("{}: {many}{cut}", excerpt.name)
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.show(Screen::PLAIN))
    }
}

/// What is drawn on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screen {
    /// Characters in a row.
    pub width: usize,
    /// What it can show.
    pub drawing: Drawing,
}

/// What a screen can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawing {
    /// ASCII.
    Plain,
    /// ASCII and colours.
    PlainColors,
    /// Lines, but no colours.
    Lines,
    /// Lines and colours.
    Colors,
}

impl Screen {
    /// A file or a pipe.
    pub const PLAIN: Screen = Screen { width: 80, drawing: Drawing::Plain };

    /// The standard error. Its terminal's colours are used unless `NO_COLOR` or a dumb terminal
    /// forbid it.
    pub fn of_stderr() -> Self {
        if !io::stderr().is_terminal() {
            return Screen::PLAIN;
        }
        let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
        let has_colors = !is_set("NO_COLOR") && std::env::var("TERM").as_deref() != Ok("dumb");
        let drawing = match (speaks_unicode(), has_colors) {
            (false, false) => Drawing::Plain,
            (false, true) => Drawing::PlainColors,
            (true, false) => Drawing::Lines,
            (true, true) => Drawing::Colors,
        };
        let width = terminal_size::terminal_size_of(io::stderr()).map_or(80, |(width, _)| width.0.into());
        Screen { width, drawing }
    }
}

/// Whether the locale, as far as one is told, has more than ASCII.
fn speaks_unicode() -> bool {
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].iter().find_map(|name| {
        let value = std::env::var(name).unwrap_or_default();
        (!value.is_empty()).then_some(value.to_ascii_uppercase())
    });
    match locale {
        Some(locale) => locale.contains("UTF-8") || locale.contains("UTF8"),
        None => cfg!(windows),
    }
}

/// The text with nothing in it that steers a terminal; every place in it stays where it is.
fn harmless(text: &str) -> String {
    let mut harmless = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let turns = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}');
        let ends = matches!(c, '\n' | '\t') || c == '\r' && rest.peek() == Some(&'\n');
        harmless.push(match c.len_utf8() {
            1 if c.is_control() && !ends => '?',
            2 if c.is_control() => '·',
            3 if turns => '\u{fffd}',
            _ => c,
        });
    }
    harmless
}

/// The part of a span in its first line, and at least one character.
fn visible(text: &str, span: &Range<usize>) -> Range<usize> {
    let boundary = |place: usize| (0..=place.min(text.len())).rev().find(|p| text.is_char_boundary(*p));
    let mut start = boundary(span.start).unwrap_or(0);
    // Nothing can be shown at the end of a line, or in the empty lines at the end of a file.
    if text[start..].trim_start().is_empty() {
        start = text.trim_end().len();
    }
    if text[start..].is_empty() || text[start..].starts_with(['\r', '\n']) {
        let before = text[..start].chars().next_back().filter(|c| *c != '\n');
        start -= before.map_or(0, char::len_utf8);
    }
    let line = text[start..].lines().next().unwrap_or_default();
    let first = line.chars().next().map_or(0, char::len_utf8);
    let end = boundary(span.end).unwrap_or(0).min(start + line.len());
    start..if end > start { end } else { start + first }
}

/// The text around a place, whole lines where they fit.
struct Excerpt<'f> {
    of: &'f Faults,
    name: String,
    width: usize,
}

impl SourceCode for Excerpt<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let faults = self.of;
        let (start, end) = (span.offset(), span.offset() + span.len());
        let (first, last) = (faults.lines.index(start), faults.lines.index(end));
        let whole = first.saturating_sub(before)..(last + after + 1).min(faults.lines.0.len());
        // The numbers of lines and the frame stand beside the text.
        let room = self.width.saturating_sub(12).max(20);
        let fits = whole.clone().all(|index| faults.bounds(index).len() <= room);
        let piece = if before == 0 && after == 0 {
            start..end
        } else if fits {
            faults.bounds(whole.start).start..faults.bounds(whole.end - 1).end
        } else {
            cut(&faults.text, faults.bounds(first).start..faults.bounds(last).end, start..end, room)
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
fn cut(text: &str, lines: Range<usize>, span: Range<usize>, room: usize) -> Range<usize> {
    let spare = room.saturating_sub(span.len());
    let start = lines.start.max(span.start.saturating_sub(spare / 2));
    let end = lines.end.min(span.end.max(start + room));
    let start = (start..=span.start).find(|p| text.is_char_boundary(*p)).unwrap_or(span.start);
    let end = (span.end..=end).rev().find(|p| text.is_char_boundary(*p)).unwrap_or(span.end);
    start..end
}

/// A fault as miette wants it.
struct Shown<'f> {
    fault: &'f Fault,
    excerpt: &'f Excerpt<'f>,
}

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.fault.fmt(f)
    }
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.fault.message)
    }
}

impl std::error::Error for Shown<'_> {}

impl Diagnostic for Shown<'_> {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.fault.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let main = LabeledSpan::new_primary_with_span(None, self.fault.span.clone());
        let also = self.fault.also.iter();
        let also = also.map(|(span, what)| LabeledSpan::new_with_span(Some(what.clone()), span.clone()));
        Some(Box::new(std::iter::once(main).chain(also)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, fault: Fault, width: usize) -> String {
        Faults::new(Path::new("a.toml"), text, [fault]).show(Screen { width, drawing: Drawing::Plain })
    }

    #[test]
    fn a_fault_is_shown_with_its_line_a_caret_and_advice() {
        let text = "[[sphere]]\nradius = -1\ncenter = [0, 0, 0]\n";
        let shown = shown(text, Fault::new(20..22, "too small").help("larger"), 80);
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
                    let faults = Faults::new(Path::new("a.toml"), text, [Fault::new(start..end, "wrong")]);
                    let (line, column) = faults.place(&faults.list()[0]);
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
            let shown = shown(&text, Fault::new(place..place + 3, "no number"), width);
            assert!(shown.contains("\"x\"") && shown.contains("^^^"), "{shown}");
            assert!(shown.lines().all(|line| line.chars().count() <= width), "{width}\n{shown}");
        }
    }
}
