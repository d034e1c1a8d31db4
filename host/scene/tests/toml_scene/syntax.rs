//! TOML syntax errors.

use crate::text::errors;

/// Line, underlined text, and a part of the message.
type Mistake = (usize, &'static str, &'static str);

const INVALID: &[(&str, &[Mistake])] = &[
    ("[[sphere]\nradius = 1\n", &[(1, "]", "unclosed array table, expected `]`")]),
    ("[[sphere]]\nradius = \n", &[(2, " ", "string values must be quoted")]),
    ("[[sphere]]\nradius 1\n", &[(2, "1", "key with no value, expected `=`")]),
    ("[[plane]]\nmaterial = gold\n", &[(2, "gold", "write \"gold\"")]),
    ("[[plane]]\nmaterial = \"gold\n", &[(2, "d", "invalid basic string")]),
    ("[[plane]]\nnormal = [0 1 0]\n", &[(2, "0 1 0", "string values must be quoted")]),
    ("[[plane]]\nnormal = [0, 1, 0\n", &[(2, "0", "unclosed array")]),
    ("[[plane]]\nnormal = [0, 1, 0\n[[sphere]]\nradius = 1\n", &[(3, "[", "missing comma")]),
    ("[[sphere]]\nradius = 1\nradius = 2\n", &[(3, "radius", "duplicate key")]),
    ("[camera]\n[camera]\n", &[(2, "camera", "duplicate key")]),
    ("x = \u{1}\n", &[(1, "\u{1}", "")]),
    // Several syntax errors, and errors of values.
    (
        "[[plane]]\nmaterial = gold\nnormal = [0, 0, 0]\n\n[[sphere]]\nradius = 1 2\n\n[[disc]]\nradius = -1\n",
        &[
            (2, "gold", "quoted"),
            (3, "[0, 0, 0]", "zero vector"),
            (6, "1 2", "quoted"),
            (9, "-1", "more than 0"),
        ],
    ),
    // A key or name that cannot be parsed does not count as missing.
    (
        "[[sphere]]\nradius =\n[[plane]]\nmaterial = \"a\"\n[[material]]\nname = a\n",
        &[(2, "=", "quoted"), (6, "a", "quoted")],
    ),
];

#[test]
fn syntax_errors_are_reported_with_their_location() {
    for (text, mistakes) in INVALID {
        let list = errors(text);
        let found: Vec<_> = list.iter().map(|(line, _, marked, _)| (*line, marked.as_str())).collect();
        let expected: Vec<_> = mistakes.iter().map(|(line, marked, _)| (*line, *marked)).collect();
        assert_eq!(found, expected, "{text}\n{list:?}");
        for ((.., expected_text), (.., message)) in mistakes.iter().zip(&list) {
            assert!(message.contains(expected_text), "`{expected_text}` is not in `{message}`\n{text}");
        }
    }
}

#[test]
fn deeply_nested_brackets_are_one_error() {
    for text in ["x = ".to_owned() + &"[".repeat(100_000), "x = ".to_owned() + &"{a=".repeat(100_000)] {
        assert_eq!(errors(&text).len(), 1);
    }
}

#[test]
fn the_time_to_report_errors_is_linear_in_their_number() {
    // Each would take minutes if the time were quadratic in the number of errors.
    for one in [
        "[[plane]]\nmaterial = gold\n",
        "[[plane]]\nmaterial = \"gold\"\n",
        "[[material]]\nname = \"a\"\n",
        "[[x]]\n",
        "x = nan\n",
        "]",
        "[\n",
        "[[sphere]]\nradius = -1\nx = 1\n",
    ] {
        assert!(!errors(&one.repeat(100_000)).is_empty());
    }
    let corners = format!("[[polygon]]\ncorners = [{}]\n", "[nan, 0, 0],".repeat(100_000));
    assert_eq!(errors(&corners).len(), 50);
}
