//! Every public function of the core is called in the panic proof, or is for hosts only.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::workspace;

/// Public doors of the core that no firmware needs, so that nothing is proven of them.
const FOR_HOSTS_ONLY: [&str; 1] = ["pour"];

/// A room: its path below the folder of all of them, and its code without comments and tests.
struct Room {
    path: String,
    code: String,
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The rooms of the core.
fn rooms() -> Vec<Room> {
    let rooms = rooms_of("core/src");
    assert!(rooms.len() > 30, "only {} rooms found", rooms.len());
    rooms
}

/// The rooms below a folder of the workspace.
fn rooms_of(folder: &str) -> Vec<Room> {
    fn collect(folder: &Path, base: &Path, rooms: &mut Vec<Room>) {
        let mut paths: Vec<PathBuf> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        for path in paths {
            if path.is_dir() {
                collect(&path, base, rooms);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let name = path.strip_prefix(base).unwrap().to_str().unwrap().replace('\\', "/");
                rooms.push(Room { path: name, code: code(&read(&path)) });
            }
        }
    }
    let base = workspace().join(folder);
    let mut rooms = Vec::new();
    collect(&base, &base, &mut rooms);
    rooms
}

/// The lines that are code: no comments, no strings' content, and nothing that is marked
/// `#[cfg(test)]`. The test module of a room is its end.
fn code(text: &str) -> String {
    let mut lines = Vec::new();
    let mut marked = false;
    for line in text.lines() {
        let line = without_comment(line);
        let trimmed = line.trim();
        if marked && trimmed.starts_with("mod tests") {
            break;
        }
        if marked && !trimmed.starts_with("#[") && !trimmed.is_empty() {
            // An import or a small function: to its end.
            marked = !(trimmed.ends_with(';') || trimmed == "}");
            continue;
        }
        marked |= trimmed == "#[cfg(test)]";
        if !marked {
            lines.push(line);
        }
    }
    lines.join("\n")
}

/// A line without its comment and without what stands between quotes.
fn without_comment(line: &str) -> String {
    let mut code = String::new();
    let mut quoted = false;
    let mut before = ' ';
    for c in line.chars() {
        if c == '"' && before != '\\' && before != '\'' {
            quoted = !quoted;
        }
        if !quoted && c == '/' && before == '/' {
            code.pop();
            break;
        }
        if !quoted || c == '"' {
            code.push(c);
        }
        before = c;
    }
    code
}

/// The words of some code: names and numbers.
fn words(code: &str) -> Vec<&str> {
    code.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty()).collect()
}

/// What comes right after each place where `before` stands.
fn after<'c>(code: &'c str, before: &'c str) -> impl Iterator<Item = &'c str> {
    code.match_indices(before).map(move |(at, _)| &code[at + before.len()..])
}

#[test]
fn what_the_tests_take_for_code_is_code() {
    let text = "use a; // not b\n#[cfg(test)]\nuse c::{\n    d,\n};\nlet e = \"f // g\";\n/// h\n#[cfg(test)]\n#[inline]\nfn i() {\n    j();\n}\nk\n#[cfg(test)]\nmod tests {\n    l\n}\n";
    assert_eq!(words(&code(text)), ["use", "a", "let", "e", "k"]);
}

/// The functions that can be called from outside the core: their names, and where they are.
fn doors() -> BTreeMap<String, String> {
    let rooms = rooms();
    let map = &rooms.iter().find(|room| room.path == "lib.rs").unwrap().code;
    let exported: BTreeSet<&str> =
        after(map, "pub use ").flat_map(|exports| words(exports.split(';').next().unwrap())).collect();
    let mut doors = BTreeMap::new();
    for Room { path, code } in &rooms {
        // What the code at the left margin belongs to; a macro makes types that are exported.
        let mut owner_is_public = false;
        for line in code.lines() {
            let indented = line.starts_with(' ');
            let line = line.trim();
            if line.starts_with("impl") {
                // `impl<..> Type<..> {`, `impl<..> Trait for Type<..> {`: the last name before generics.
                let subject = line.rsplit(" for ").next().unwrap();
                let subject = if subject.starts_with("impl<") { after_generics(subject) } else { subject };
                let name = words(subject).into_iter().find(|word| *word != "impl");
                owner_is_public = subject.contains('$') || name.is_some_and(|name| exported.contains(name));
            } else if !indented && line.starts_with('}') {
                owner_is_public = false;
            }
            let Some(declared) =
                ["pub fn ", "pub const fn "].iter().find_map(|start| line.strip_prefix(start))
            else {
                continue;
            };
            let name = words(declared)[0];
            if owner_is_public || !indented && exported.contains(name) {
                doors.insert(name.to_owned(), path.clone());
            }
        }
    }
    doors
}

/// What follows `impl<..>`.
fn after_generics(line: &str) -> &str {
    let mut depth = 0;
    let end = line.find(|c| {
        depth += i32::from(c == '<') - i32::from(c == '>');
        c == '>' && depth == 0
    });
    end.map_or(line, |end| &line[end + 1..])
}

/// The names of what is called, which a function is not where it is declared.
fn calls(code: &str) -> BTreeSet<&str> {
    let called = |at: usize| {
        let mut before = code[..at].rsplit(|c: char| !c.is_alphanumeric() && c != '_');
        let name = before.next().filter(|name| !name.is_empty())?;
        (before.next() != Some("fn")).then_some(name)
    };
    ["(", "::<"].iter().flat_map(|call| code.match_indices(call)).filter_map(|(at, _)| called(at)).collect()
}

#[test]
fn what_is_called_is_found_and_what_is_only_declared_is_not() {
    let code = "fn a(b: &mut (C, D)) {\n    e((f::<8>(), g.h(3)));\n    I::j(&(k, l))\n}";
    assert_eq!(calls(code), BTreeSet::from(["e", "f", "h", "j"]));
}

#[test]
fn the_doors_of_the_core_are_found() {
    let doors = doors();
    // Free, of a type, constant, of a type with parameters, made by a macro.
    for known in
        ["render", "leave", "to_srgb8", "group_count", "with_boxes", "trace", "nearest", "with", "color"]
    {
        assert_eq!(doors.contains_key(known), known != "color", "{known}: {doors:?}");
    }
    assert!(!doors.contains_key("powf") && !doors.contains_key("product_error"), "{doors:?}");
}

#[test]
fn every_public_door_is_proven_free_of_panics_or_for_hosts_only() {
    let rooms: Vec<String> =
        rooms_of("tests/firmware/src/bin/proof").into_iter().map(|room| room.code).collect();
    let proof = rooms.join("\n");
    let calls = calls(&proof);
    let doors = doors();
    for (door, room) in &doors {
        let is_for_hosts = FOR_HOSTS_ONLY.contains(&door.as_str());
        let is_called = calls.contains(door.as_str());
        assert!(is_called || is_for_hosts, "{door} in {room} is not called in the proof");
        assert!(!(is_called && is_for_hosts), "{door} is called in the proof, and is not for hosts only");
    }
    for host in FOR_HOSTS_ONLY {
        assert!(doors.contains_key(host), "{host} is no door");
    }
    // Whoever called one of these would seem to call the door.
    for line in proof.lines() {
        let declared = ["fn ", "pub fn "].iter().find_map(|start| line.strip_prefix(start));
        let name = declared.map_or("", |declared| words(declared)[0]);
        assert!(!doors.contains_key(name), "{name} in the proof has the name of a door");
    }
}
