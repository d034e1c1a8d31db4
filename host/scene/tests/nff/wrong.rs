//! Errors of invalid files.

use strahl_loader_tests::invalid_nff::{VIEW, invalid_files};

use crate::text::{ALL, loaded, refused};

#[test]
fn an_invalid_file_is_rejected_with_its_line_and_the_reason() {
    for (bytes, expected_line, expected) in invalid_files() {
        let (line, reason) = refused(&bytes);
        let text = String::from_utf8_lossy(&bytes);
        assert_eq!(line, expected_line, "{reason}\n{text}");
        assert!(reason.contains(expected), "`{expected}` is not in `{reason}`\n{text}");
        assert!(!reason.contains(|c: char| c.is_control()), "{reason:?}");
        assert!(reason.chars().count() < 200, "{reason}");
    }
}

#[test]
fn an_invalid_file_has_the_same_line_of_its_error_with_any_line_ends() {
    for (bytes, expected_line, _) in invalid_files() {
        let Ok(text) = String::from_utf8(bytes) else { continue };
        let (line, reason) = refused(text.replace('\n', "\r\n").as_bytes());
        assert_eq!(line, expected_line, "{reason}\n{text}");
    }
}

#[test]
fn a_file_that_ends_inside_an_entity_is_rejected_at_its_last_line() {
    let mut cuts = 0;
    for entity in [
        "b 1 1 1",
        "l 1 2 3 1 1 1",
        "f 1 1 1 1 0 0 0 0",
        "s 0 0 0 1",
        "c\n0 0 0 1\n0 0 1 1",
        "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0",
        "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1",
    ] {
        let whole = format!("{VIEW}f 1 0 0 1 0 0 0 0\n{entity}");
        loaded(&whole);
        for (end, _) in entity.match_indices([' ', '\n']) {
            if entity[..end] == *"l 1 2 3" {
                continue; // whole without a colour
            }
            let text = &whole[..whole.len() - entity.len() + end];
            let (line, reason) = refused(text.as_bytes());
            assert_eq!(line, text.lines().count(), "{reason}\n{text}");
            assert!(reason.starts_with("unexpected end of file; "), "{reason}\n{text}");
            let of = format!("(`{}` in line 3)", entity.split_whitespace().next().unwrap());
            assert!(reason.ends_with(&of), "{reason}\n{text}");
            cuts += 1;
        }
    }
    assert_eq!(cuts, 3 + 5 + 8 + 4 + 8 + 13 + 19);
}

#[test]
fn a_file_with_a_missing_number_is_rejected() {
    let mut left_out = 0;
    for (start, word) in words(ALL) {
        if word.parse::<f32>().is_err() {
            continue;
        }
        let text = format!("{}{}", &ALL[..start], &ALL[start + word.len()..]);
        let (line, reason) = refused(text.as_bytes());
        // The next entity may be some lines below, but not before the gap.
        let gap = ALL[..start].lines().count();
        assert!(line >= gap && line <= text.lines().count(), "{line}: {reason}\n{text}");
        left_out += 1;
    }
    assert!(left_out > 100, "{left_out}");
}

#[test]
fn a_word_instead_of_a_number_is_reported_with_its_line() {
    for (start, word) in words(ALL) {
        if word.parse::<f32>().is_err() {
            continue;
        }
        let line = ALL[..=start].lines().count();
        for bad in ["x", "NaN", "-inf", "1e999"] {
            let text = format!("{}{bad}{}", &ALL[..start], &ALL[start + word.len()..]);
            let (found, reason) = refused(text.as_bytes());
            // A light may end before its color; then the word is not an entity.
            assert_eq!(found, line, "{reason}\n{text}");
            assert!(reason.contains(&format!("`{bad}`")), "{reason}\n{text}");
        }
    }
}

/// The words outside comments, with their positions.
fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = text.split_inclusive('\n').map(move |line| line.split('#').next().unwrap_or_default());
    let words = lines.flat_map(str::split_whitespace);
    words.map(move |word| (word.as_ptr() as usize - text.as_ptr() as usize, word))
}
