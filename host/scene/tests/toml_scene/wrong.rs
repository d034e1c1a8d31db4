//! What is wrong with bad scenes, and where.

use crate::table::WRONG;
use crate::text::{ALL, faults, wrong};

#[test]
fn a_mistake_is_told_with_its_place_and_nothing_else_is() {
    for (text, line, underlined, says) in WRONG {
        let list = wrong(text);
        assert_eq!(list.len(), 1, "{text}\n{list:?}");
        let (found, column, marked, said) = &list[0];
        assert_eq!((found, marked.as_str()), (line, *underlined), "{text}\n{said}");
        let shown = text.lines().nth(line - 1).unwrap();
        let at = shown.chars().skip(column - 1).collect::<String>();
        assert!(at.starts_with(underlined.lines().next().unwrap()), "{text}\ncolumn {column}");
        assert!(said.contains(says), "`{says}` is not in `{said}`\n{text}");
        assert!(!said.replace('\n', " ").contains(|c: char| c.is_control()), "{said:?}");
    }
}

#[test]
fn a_mistake_is_in_the_same_line_with_any_line_ends() {
    for (text, line, ..) in WRONG {
        let text = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        let list = wrong(&text);
        assert_eq!((list.len(), list[0].0), (1, *line), "{text}\n{list:?}");
    }
}

#[test]
fn all_mistakes_of_a_file_are_told_at_once_in_their_order() {
    // All but those which take the whole file: what is no TOML, and what is only wrong once.
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
    let several = WRONG.iter().filter(|(text, ..)| !alone.iter().any(|word| text.contains(word)));
    let several: Vec<_> = several.filter(|(text, ..)| !text.starts_with('\u{200b}')).collect();
    assert!(several.len() > 50);
    for some in several.chunks(7) {
        let text: String = some.iter().map(|(text, ..)| *text).collect();
        let list = wrong(&text);
        let mut before = 0;
        // A table of which each file has many may be unknown once only.
        for ((part, line, underlined, says), (found, _, marked, said)) in some.iter().zip(&list) {
            assert_eq!((before + line, *underlined), (*found, marked.as_str()), "{text}");
            assert!(said.contains(says), "`{says}` is not in `{said}`\n{text}");
            before += part.lines().count();
        }
        assert_eq!(list.len(), some.len(), "{text}\n{list:?}");
    }
}

#[test]
fn several_mistakes_in_one_table_are_told_at_once() {
    let list = wrong(
        "[[sphere]]\nradius = -1\ncenter = [nan, 0, 'x']\nmaterial = \"gold\"\nname = 1\n\
         [camera]\nfrom = [1, 1, 1]\nat = [1, 1, 1]\nfoo = 1\n",
    );
    let places: Vec<_> = list.iter().map(|(line, _, marked, _)| (*line, marked.as_str())).collect();
    let expected =
        [(2, "-1"), (3, "nan"), (3, "'x'"), (4, "\"gold\""), (5, "name"), (8, "[1, 1, 1]"), (9, "foo")];
    assert_eq!(places, expected);
}

#[test]
fn a_name_is_known_wherever_and_however_wrong_its_material_is() {
    let list = wrong("[[plane]]\nmaterial = \"gold\"\n[[material]]\nmirror = 2\nname = \"gold\"\n");
    assert_eq!(list.len(), 1, "{list:?}");
    assert_eq!(list[0].2, "2");
}

#[test]
fn more_materials_than_numbers_are_told_once() {
    let one = "[[plane]]\nmaterial = {}\n";
    let list = wrong(&one.repeat((1 << 16) + 3));
    assert_eq!(list.len(), 1);
    assert!(list[0].3.contains("more than 65536 materials"), "{list:?}");
    assert_eq!(list[0].0, 2 * (1 << 16) + 2);
}

#[test]
fn every_value_in_place_of_every_other_is_right_or_wrong_there() {
    let values = ["nan", "-1", "1e30", "\"x\"", "true", "[]", "{}", "[[[]]]", "1979-05-27", "\"\"", "0"];
    let mut told = 0;
    for (number, line) in ALL.lines().enumerate() {
        let Some((key, _)) = line.split_once(" = ").filter(|_| !line.starts_with("background")) else {
            continue;
        };
        for value in values {
            let mut lines: Vec<String> = ALL.lines().map(String::from).collect();
            lines[number] = format!("{key} = {value}");
            let text = lines.join("\n");
            if let Err(strahl_scene::LoadError::Diagnostics(faults)) = crate::text::load(text.as_bytes()) {
                told += 1;
                // A name that is no longer there is missed where it is used.
                let is_there = |fault| faults.line_and_column(fault).0 == number + 1;
                let is_fine =
                    key == "name" || faults.list().iter().any(is_there) || value == "0" || value == "-1";
                assert!(is_fine, "line {}: {}\n{faults}", number + 1, lines[number]);
            }
        }
    }
    assert!(told > 500, "{told}");
}

#[test]
fn what_is_no_text_is_told_with_its_place() {
    let list = faults(b"[[sphere]]\nradius = 1\nname = \"\xff\xfe\"\n");
    assert_eq!(list.list().len(), 1);
    assert_eq!(list.line_and_column(&list.list()[0]), (3, 9));
    assert!(list.list()[0].message.contains("not UTF-8"));
}
