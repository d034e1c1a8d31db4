//! The house rules that no compiler checks: floors go one way, in the core and in the host, the core
//! stands alone, and every public door is proven free of panics.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms of the core, from the ground up. Those in one line stand on one floor and know
/// nothing of each other.
const FLOORS: [&[&str]; 9] = [
    &["math", "set"],
    &["geometry"],
    &["tally"],
    &["accel"],
    &["scene"],
    &["shade"],
    &["trace"],
    &["image"],
    &["render"],
];

/// The most lines of a room, without its tests.
const MOST_LINES: usize = 350;

/// Rooms that may be longer, and why.
const LONG: [(&str, &str); 0] = [];

/// Public doors of the core that no firmware needs, so that nothing is proven of them.
const FOR_HOSTS_ONLY: [&str; 1] = ["pour"];

/// A room: its path below the folder of all of them, and its code without comments and tests.
struct Room {
    path: String,
    code: String,
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
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

#[test]
fn a_room_uses_only_what_lies_below_it() {
    let floor = |room: &str| FLOORS.iter().position(|floor| floor.contains(&room));
    let mut uses = 0;
    for Room { path, code } in rooms() {
        let name = path.split(['/', '.']).next().unwrap();
        if name == "lib" {
            continue; // the map names all of them
        }
        let own = floor(name).unwrap_or_else(|| panic!("{path} stands on no floor"));
        for path_after in after(&code, "crate::") {
            let used = words(path_after)[0];
            let below = floor(used).unwrap_or_else(|| panic!("{path} uses crate::{used}, which is no room"));
            assert!(below < own || used == name, "{path} uses crate::{used}, which does not lie below it");
            uses += 1;
        }
        // As many steps up as there are names in the path of the module lead to the root.
        let depth = path.split('/').count() - usize::from(path.ends_with("mod.rs"));
        assert!(!code.contains(&"super::".repeat(depth)), "{path} goes round the floors by super");
    }
    assert!(uses > 50, "only {uses} uses found");
}

/// The rooms at the root that some code of `path` names.
fn named_at_the_root<'c>(path: &str, code: &'c str) -> BTreeSet<&'c str> {
    // As many steps up as there are names in the path of the module lead to the root.
    let depth = path.split('/').count() - usize::from(path.ends_with("mod.rs"));
    let up = "super::".repeat(depth);
    let roots = ["crate::", &up].map(|root| code.match_indices(root).map(|(at, _)| &code[at + root.len()..]));
    let mut named = BTreeSet::new();
    for path in roots.into_iter().flatten() {
        match path.strip_prefix('{') {
            None => named.extend(words(path).first()),
            Some(group) => {
                let mut inner = 0;
                let end = group.find(|c| {
                    inner += i32::from(c == '{') - i32::from(c == '}');
                    inner < 0
                });
                // Of each path in the group the first name.
                let group = &group[..end.unwrap_or(group.len())];
                let mut inner = 0;
                let starts = group.split(|c| {
                    inner += i32::from(c == '{') - i32::from(c == '}');
                    c == ',' && inner == 0
                });
                named.extend(starts.filter_map(|path| words(path).first().copied()));
            }
        }
    }
    named
}

#[test]
fn the_rooms_that_code_names_are_found() {
    let code = "use crate::a::b;\nuse crate::{c, d::{e, f}, g};\nfn h() { super::i::j() }";
    let found = |path| named_at_the_root(path, code).into_iter().collect::<Vec<_>>();
    assert_eq!(found("k.rs"), ["a", "c", "d", "g", "i"]);
    assert_eq!(found("k/l.rs"), ["a", "c", "d", "g"], "one step up is a room's own");
}

#[test]
fn no_rooms_of_the_host_go_round_in_a_circle() {
    let own = |path: &str| path.split(['/', '.']).next().unwrap().to_owned();
    let rooms = rooms_of("host/src");
    let names: BTreeSet<String> = rooms.iter().map(|room| own(&room.path)).collect();
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    // The map and the program name all of them.
    for Room { path, code } in rooms.iter().filter(|room| !["lib.rs", "main.rs"].contains(&&*room.path)) {
        let used = named_at_the_root(path, code).into_iter().filter(|room| names.contains(*room));
        let used = used.filter(|room| *room != own(path)).map(str::to_owned);
        uses.entry(own(path)).or_default().extend(used);
    }
    assert!(uses.values().map(BTreeSet::len).sum::<usize>() > 150, "too few uses were found: {uses:?}");
    // Who uses none of those that are left, or is used by none, stands in no circle.
    loop {
        let used: BTreeSet<String> = uses.values().flatten().cloned().collect();
        let before = uses.len();
        uses.retain(|room, used_by_it| !used_by_it.is_empty() && used.contains(room));
        if uses.len() == before {
            break;
        }
        let left: BTreeSet<String> = uses.keys().cloned().collect();
        uses.values_mut().for_each(|used| used.retain(|room| left.contains(room)));
    }
    assert!(uses.is_empty(), "in a circle: {uses:#?}");
}

#[test]
fn the_core_needs_no_operating_system_and_no_heap() {
    for Room { path, code } in rooms() {
        for library in ["std", "alloc"] {
            assert!(!words(&code).contains(&library), "{path} names {library}");
        }
    }
}

#[test]
fn the_core_has_no_way_to_panic_on_purpose_and_nothing_unsafe() {
    // `debug_assert!` is there for our own promises, `assert!` for constants.
    let forbidden = [
        ".unwrap()",
        ".expect(",
        "panic!(",
        "unreachable!(",
        "todo!(",
        "unimplemented!(",
        "mul_add(",
        "dbg!(",
    ];
    for Room { path, code } in rooms() {
        for word in forbidden {
            assert!(!code.contains(word), "{path} has {word}");
        }
        let unsafe_blocks = words(&code).iter().filter(|word| **word == "unsafe").count();
        let allowed = usize::from(path == "math/float.rs"); // one instruction: the square root
        assert_eq!(unsafe_blocks, allowed, "{path} has unsafe code");
        for line in code.lines().filter(|line| words(line).contains(&"assert")) {
            assert!(line.contains("const "), "{path} asserts at run time: {line}");
        }
    }
}

#[test]
fn only_one_room_names_libm() {
    for Room { path, code } in rooms() {
        assert_eq!(words(&code).contains(&"libm"), path == "math/float.rs", "{path}");
    }
}

#[test]
fn no_room_is_too_long() {
    for Room { path, .. } in rooms() {
        let text = read(&workspace().join("core/src").join(&path));
        let lines = text.lines().take_while(|line| line.trim() != "mod tests {").count();
        match LONG.iter().find(|(long, _)| *long == path) {
            None => assert!(lines <= MOST_LINES, "{path} has {lines} lines"),
            Some((_, reason)) => assert!(lines > MOST_LINES, "{path} is no longer long: {reason}"),
        }
    }
}

/// What a document names: paths from the workspace's root into the folders of scenes and tests, and what
/// its links lead to.
fn named_in(document: &str, text: &str) -> BTreeSet<PathBuf> {
    let is_of_a_path = |c: char| c.is_ascii_alphanumeric() || "._/-".contains(c);
    let paths = text.split(|c| !is_of_a_path(c)).map(|word| word.trim_end_matches('.'));
    let paths = paths.filter(|word| word.starts_with("scenes/") || word.starts_with("tests/"));
    let links = after(text, "](").filter_map(|link| link.split([')', '#']).next());
    let links = links.filter(|link| !link.is_empty() && !link.contains("://"));
    let folder = Path::new(document).parent().unwrap();
    paths.map(PathBuf::from).chain(links.map(|link| folder.join(link))).collect()
}

#[test]
fn every_path_that_a_document_names_is_there() {
    let mut documents = vec!["README.md".to_owned(), "CHANGELOG.md".to_owned()];
    for folder in ["scenes", "tests", "tests/bench", "tests/fuzz", "tests/reports"] {
        let files = fs::read_dir(workspace().join(folder)).unwrap();
        let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
        documents.extend(names.filter(|name| name.ends_with(".md")).map(|name| format!("{folder}/{name}")));
    }
    let mut count = 0;
    for document in documents {
        for path in named_in(&document, &read(&workspace().join(&document))) {
            assert!(workspace().join(&path).exists(), "{document} names {}", path.display());
            count += 1;
        }
    }
    assert!(count > 50, "only {count} paths found");
}

#[test]
fn the_paths_that_a_document_names_are_found() {
    let text = "`strahl a scenes/b.toml`, host/tests/c; tests/d/e.rs. [f](g.md#h) [i](https://j/k) [l](#m)\n";
    let found: Vec<PathBuf> = named_in("tests/n.md", text).into_iter().collect();
    assert_eq!(found, ["scenes/b.toml", "tests/d/e.rs", "tests/g.md"].map(PathBuf::from));
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
    for known in ["render", "leave", "to_srgb8", "groups_of", "boxed", "look", "nearest", "with", "color"] {
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
