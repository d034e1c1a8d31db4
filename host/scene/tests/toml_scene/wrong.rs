//! Errors of invalid scenes.

use strahl_loader_tests::invalid_toml::INVALID;

use crate::text::{ALL, diagnostics, errors};

#[test]
fn an_error_is_reported_alone_with_its_location() {
    for (text, line, underlined, expected_text) in INVALID {
        let list = errors(text);
        assert_eq!(list.len(), 1, "{text}\n{list:?}");
        let (found, column, marked, message) = &list[0];
        assert_eq!((found, marked.as_str()), (line, *underlined), "{text}\n{message}");
        let shown = text.lines().nth(line - 1).unwrap();
        let at = shown.chars().skip(column - 1).collect::<String>();
        assert!(at.starts_with(underlined.lines().next().unwrap()), "{text}\ncolumn {column}");
        assert!(message.contains(expected_text), "`{expected_text}` is not in `{message}`\n{text}");
        assert!(!message.replace('\n', " ").contains(|c: char| c.is_control()), "{message:?}");
    }
}

#[test]
fn an_error_has_the_same_line_with_any_line_ends() {
    for (text, line, ..) in INVALID {
        let text = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        let list = errors(&text);
        assert_eq!((list.len(), list[0].0), (1, *line), "{text}\n{list:?}");
    }
}

#[test]
fn all_errors_of_a_file_are_reported_at_once_in_order() {
    // All except those that affect the whole file: syntax errors, and errors that can occur once.
    let alone = [
        "camera",
        "render",
        "background",
        "ambient_light",
        "x = ",
        "sphere = ",
        "[sphere]",
        "\"a\"",
        "\"gol",
    ];
    let several = INVALID.iter().filter(|(text, ..)| !alone.iter().any(|word| text.contains(word)));
    let several: Vec<_> = several.filter(|(text, ..)| !text.starts_with('\u{200b}')).collect();
    assert!(several.len() > 50);
    for some in several.chunks(7) {
        let text: String = some.iter().map(|(text, ..)| *text).collect();
        let list = errors(&text);
        let mut before = 0;
        // An unknown array of tables is one error.
        for ((part, line, underlined, expected_text), (found, _, marked, message)) in some.iter().zip(&list) {
            assert_eq!((before + line, *underlined), (*found, marked.as_str()), "{text}");
            assert!(message.contains(expected_text), "`{expected_text}` is not in `{message}`\n{text}");
            before += part.lines().count();
        }
        assert_eq!(list.len(), some.len(), "{text}\n{list:?}");
    }
}

#[test]
fn several_errors_in_one_table_are_reported_at_once() {
    let list = errors(
        "[[sphere]]\nradius = -1\ncenter = [nan, 0, 'x']\nmaterial = \"gold\"\nname = 1\n\
         [camera]\nfrom = [1, 1, 1]\nat = [1, 1, 1]\nfoo = 1\n",
    );
    let places: Vec<_> = list.iter().map(|(line, _, marked, _)| (*line, marked.as_str())).collect();
    let expected =
        [(2, "-1"), (3, "nan"), (3, "'x'"), (4, "\"gold\""), (5, "name"), (8, "[1, 1, 1]"), (9, "foo")];
    assert_eq!(places, expected);
}

#[test]
fn a_material_name_is_known_anywhere_even_if_the_material_has_errors() {
    let list = errors("[[plane]]\nmaterial = \"gold\"\n[[material]]\nmirror = 2\nname = \"gold\"\n");
    assert_eq!(list.len(), 1, "{list:?}");
    assert_eq!(list[0].2, "2");
}

#[test]
fn too_many_materials_are_reported_once() {
    let one = "[[plane]]\nmaterial = {}\n";
    let list = errors(&one.repeat((1 << 16) + 3));
    assert_eq!(list.len(), 1);
    assert!(list[0].3.contains("more than 65536 materials"), "{list:?}");
    assert_eq!(list[0].0, 2 * (1 << 16) + 2);
}

#[test]
fn every_value_replaced_by_any_other_is_valid_or_an_error_at_its_line() {
    let values = ["nan", "-1", "1e30", "\"x\"", "true", "[]", "{}", "[[[]]]", "1979-05-27", "\"\"", "0"];
    let mut rejected = 0;
    for (number, line) in ALL.lines().enumerate() {
        let Some((key, _)) = line.split_once(" = ").filter(|_| !line.starts_with("background")) else {
            continue;
        };
        for value in values {
            let mut lines: Vec<String> = ALL.lines().map(String::from).collect();
            lines[number] = format!("{key} = {value}");
            let text = lines.join("\n");
            if let Err(strahl_scene::LoadError::Diagnostics(diagnostics)) = crate::text::load(text.as_bytes())
            {
                rejected += 1;
                // A name that no longer exists is reported where it is used.
                let is_there = |fault| diagnostics.line_and_column(fault).0 == number + 1;
                let is_fine =
                    key == "name" || diagnostics.list().iter().any(is_there) || value == "0" || value == "-1";
                assert!(is_fine, "line {}: {}\n{diagnostics}", number + 1, lines[number]);
            }
        }
    }
    assert!(rejected > 500, "{rejected}");
}

#[test]
fn invalid_utf8_is_reported_with_its_location() {
    let list = diagnostics(b"[[sphere]]\nradius = 1\nname = \"\xff\xfe\"\n");
    assert_eq!(list.list().len(), 1);
    assert_eq!(list.line_and_column(&list.list()[0]), (3, 9));
    assert!(list.list()[0].message.contains("not UTF-8"));
}
