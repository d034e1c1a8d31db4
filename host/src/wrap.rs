//! Text that fits the screen.

use anstream::adapter::strip_str;

/// Characters in a row of the standard output; as many as one likes where it is no terminal.
pub fn width_of_stdout() -> usize {
    terminal_size::terminal_size_of(std::io::stdout()).map_or(usize::MAX, |(width, _)| width.0.into())
}

/// The same of the standard error.
pub fn width_of_stderr() -> usize {
    terminal_size::terminal_size_of(std::io::stderr()).map_or(usize::MAX, |(width, _)| width.0.into())
}

/// The text with no line longer than `width`, where there is a space to break it at. What is
/// broken off stands `indent` characters from the left. Styles take no room.
pub fn wrapped(text: &str, width: usize, indent: usize) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let (mut left, mut margin) = (line, 0);
        while margin + visible(left) > width {
            let fits = |place: &usize| margin + visible(&left[..*place]) <= width;
            // The label stays with what it is for.
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

/// The characters of a text that are seen.
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
    fn what_has_no_space_stays_whole_and_styles_take_no_room() {
        assert_eq!(wrapped("  label     averylongword\n", 14, 12), "  label     averylongword\n");
        let styled = "  \u{1b}[2mlabel     \u{1b}[0mone two";
        assert_eq!(wrapped(styled, 19, 12), format!("{styled}\n"));
        assert_eq!(wrapped(styled, 18, 12), "  \u{1b}[2mlabel     \u{1b}[0mone\n            two\n");
    }
}
