//! Line wrapping at the width of the terminal.

use anstream::adapter::strip_str;

/// Columns of standard output; `usize::MAX` if it is not a terminal.
pub fn stdout_width() -> usize {
    terminal_size::terminal_size_of(std::io::stdout()).map_or(usize::MAX, |(width, _)| width.0.into())
}

/// Columns of standard error; `usize::MAX` if it is not a terminal.
pub fn stderr_width() -> usize {
    terminal_size::terminal_size_of(std::io::stderr()).map_or(usize::MAX, |(width, _)| width.0.into())
}

/// Breaks lines longer than `width` at spaces. Continuation lines are indented by `indent` characters. Styles have
/// no width.
pub fn wrapped(text: &str, width: usize, indent: usize) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let (mut left, mut margin) = (line, 0);
        while margin + visible(left) > width {
            let fits = |place: &usize| margin + visible(&left[..*place]) <= width;
            // No break between a label and its text.
            let is_text = |place: &usize| margin + visible(left[..*place].trim_end()) > indent;
            let spaces = left.match_indices(' ').map(|(place, _)| place).filter(is_text);
            let Some(place) = spaces.clone().take_while(fits).last().or(spaces.clone().next()) else { break };
            out.push_str(left[..place].trim_end());
            out.push('\n');
            out.extend(std::iter::repeat_n(' ', indent));
            (left, margin) = (left[place..].trim_start(), indent);
        }
        out.push_str(left);
        out.push('\n');
    }
    out
}

/// Number of visible characters.
fn visible(text: &str) -> usize {
    strip_str(text).map(|piece| piece.chars().count()).sum()
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn lines_break_at_spaces_and_go_on_below_their_text() {
        let text = "a.png  4 x 3\n  time      load 0.00 s, build 0.00 s, write 0.00 s\n";
        assert_eq!(wrapped(text, 80, 12), text);
        assert_eq!(
            wrapped(text, 30, 12),
            "a.png  4 x 3\n  time      load 0.00 s, build\n            0.00 s, write 0.00\n            s\n"
        );
    }

    #[test]
    fn text_without_a_space_is_not_broken_and_styles_have_no_width() {
        assert_eq!(wrapped("  label     averylongword\n", 14, 12), "  label     averylongword\n");
        let styled = "  \u{1b}[2mlabel     \u{1b}[0mone two";
        assert_eq!(wrapped(styled, 19, 12), format!("{styled}\n"));
        assert_eq!(wrapped(styled, 18, 12), "  \u{1b}[2mlabel     \u{1b}[0mone\n            two\n");
    }
}
