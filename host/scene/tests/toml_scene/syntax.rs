//! Texts that are no TOML.

use crate::text::wrong;

/// Line, what is underlined, and a part of what is said.
type Mistake = (usize, &'static str, &'static str);

const WRONG: &[(&str, &[Mistake])] = &[
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
    // Several, and what is wrong beside them.
    (
        "[[plane]]\nmaterial = gold\nnormal = [0, 0, 0]\n\n[[sphere]]\nradius = 1 2\n\n[[disc]]\nradius = -1\n",
        &[
            (2, "gold", "quoted"),
            (3, "[0, 0, 0]", "zero vector"),
            (6, "1 2", "quoted"),
            (9, "-1", "more than 0"),
        ],
    ),
    // A key that cannot be read is not missing, nor is a name.
    (
        "[[sphere]]\nradius =\n[[plane]]\nmaterial = \"a\"\n[[material]]\nname = a\n",
        &[(2, "=", "quoted"), (6, "a", "quoted")],
    ),
];

#[test]
fn what_the_parser_says_is_told_with_its_place() {
    for (text, mistakes) in WRONG {
        let list = wrong(text);
        let found: Vec<_> = list.iter().map(|(line, _, marked, _)| (*line, marked.as_str())).collect();
        let expected: Vec<_> = mistakes.iter().map(|(line, marked, _)| (*line, *marked)).collect();
        assert_eq!(found, expected, "{text}\n{list:?}");
        for ((.., says), (.., said)) in mistakes.iter().zip(&list) {
            assert!(said.contains(says), "`{says}` is not in `{said}`\n{text}");
        }
    }
}

#[test]
fn a_tower_of_brackets_is_refused_once() {
    for text in ["x = ".to_owned() + &"[".repeat(100_000), "x = ".to_owned() + &"{a=".repeat(100_000)] {
        assert_eq!(wrong(&text).len(), 1);
    }
}

#[test]
fn a_file_of_nothing_but_mistakes_is_answered_in_time() {
    // Each would take minutes if the work grew with the square of their number.
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
        assert!(!wrong(&one.repeat(100_000)).is_empty());
    }
    let corners = format!("[[polygon]]\ncorners = [{}]\n", "[nan, 0, 0],".repeat(100_000));
    assert_eq!(wrong(&corners).len(), 50);
}
