//! Words from a file, quoted for a message.

/// The maximum number of characters shown.
const MAX_CHARACTERS: usize = 40;

/// The word in backquotes, truncated, with control characters escaped.
pub fn quoted(word: &str) -> String {
    let mut text = String::from("`");
    let mut length = 0;
    for c in word.chars() {
        let escaped = c.escape_debug();
        length += escaped.len();
        if length > MAX_CHARACTERS {
            text.push('…');
            break;
        }
        text.extend(escaped);
    }
    text.push('`');
    text
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn a_word_is_quoted_whole_or_truncated() {
        let word = |c: char, count: usize| c.to_string().repeat(count);
        assert_eq!(quoted(""), "``");
        assert_eq!(quoted("a\u{1b}[2J"), "`a\\u{1b}[2J`");
        assert_eq!(quoted(&word('x', 40)), format!("`{}`", word('x', 40)));
        assert_eq!(quoted(&word('é', 41)), format!("`{}…`", word('é', 40)));
        // An escaped character counts with the length of its escape.
        assert_eq!(quoted(&word('\u{1}', 9)), format!("`{}…`", "\\u{1}".repeat(8)));
    }
}
