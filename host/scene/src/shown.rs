//! Words of another's file as they may stand in a message.

/// The most characters of a word that are shown.
const MOST: usize = 40;

/// The word in backquotes: short, and without characters that steer a terminal.
pub fn shown(word: &str) -> String {
    let mut shown = String::from("`");
    let mut length = 0;
    for c in word.chars() {
        let escaped = c.escape_debug();
        length += escaped.len();
        if length > MOST {
            shown.push('…');
            break;
        }
        shown.extend(escaped);
    }
    shown.push('`');
    shown
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn a_word_is_shown_whole_or_cut_before_it_is_long() {
        let word = |c: char, count: usize| c.to_string().repeat(count);
        assert_eq!(shown(""), "``");
        assert_eq!(shown("a\u{1b}[2J"), "`a\\u{1b}[2J`");
        assert_eq!(shown(&word('x', 40)), format!("`{}`", word('x', 40)));
        assert_eq!(shown(&word('é', 41)), format!("`{}…`", word('é', 40)));
        // A character that is shown as several counts as several.
        assert_eq!(shown(&word('\u{1}', 9)), format!("`{}…`", "\\u{1}".repeat(8)));
    }
}
