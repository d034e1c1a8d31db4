//! The memory for loading a scene in TOML is bounded by the file size, whether the file is valid or not.
//!
//! The allocator counts all allocations of the process, so the program has only one test.

use strahl_loader_tests::invalid_toml::INVALID;
use strahl_loader_tests::memory::{Bound, peak_memory};
use strahl_scene::load;

/// One more than a power of two: a table has just been doubled.
const MANY: usize = (1 << 14) + 1;

/// Long files that repeat one entity.
fn files() -> Vec<String> {
    let many = |begin: &str, again: &str, end: &str| format!("{begin}{}{end}", again.repeat(MANY));
    let numbered = |word: &dyn Fn(usize) -> String| (0..MANY).map(word).collect::<String>();
    vec![
        many("", "x", ""),
        many("", "\n", ""),
        many("", "[", ""),
        many("", "=\n", ""),
        many("", "\"", ""),
        many("", "[a]\n", ""),
        many("", "[[a]]\n", ""),
        many("", "a=1\n", ""),
        many("a=[", "[],", "]"),
        many("a=[", "{},", "]"),
        many("a=[", "0,", "]"),
        many("a=\"", "\\n", "\""),
        many("a", ".a", "=1"),
        many("", "[[plane]]\n", ""),
        many("", "[[sphere]]\n", ""),
        many("", "[[mesh]]\n", ""),
        many("", "[[material]]\n", ""),
        many("", "[[sphere]]\nradius=1\n", ""),
        many("", "[[sphere]]\nradius=1\nmaterial={}\n", ""),
        many("sphere=[", "{radius=1},", "]"),
        many("plane=[", "{},", "]"),
        many("plane=[", "{material={}},", "]"),
        many("plane=[", "{material={checker={}}},", "]"),
        many("plane=[", "{material=0},", "]"),
        many("sphere=[", "{radius=0},", "]"),
        many("sphere=[", "{a=0,b=0},", "]"),
        many("material=[", "{},", "]"),
        many("[[polygon]]\ncorners=[", "[0,0,0],", "]"),
        many("[[polygon]]\ncorners=[", "[0,0],", "]"),
        many(
            "[[triangle]]\ncorners=[[0,0,0],[1,0,0],[0,1,0]]\n",
            "[[triangle]]\ncorners=[[0,0,0],[1,0,0],[0,1,0]]\n",
            "",
        ),
        many("", "[[directional_light]]\ndirection=[1,1,1]\n", ""),
        many("directional_light=[", "{direction=[1,1,1]},", "]"),
        numbered(&|n| format!("k{n}=0\n")),
        numbered(&|n| format!("[k{n}]\n")),
        numbered(&|n| format!("[[material]]\nname='{n}'\n")),
        numbered(&|n| format!("[[plane]]\nmaterial='{n}'\n")),
        format!("material=[{}]", numbered(&|n| format!("{{name='{n}'}},"))),
        format!("plane=[{}]", numbered(&|n| format!("{{a{n}=0}},"))),
    ]
}

#[test]
fn loading_takes_at_most_a_small_multiple_of_the_file_size() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let wrong = INVALID.iter().map(|(text, ..)| (*text).to_owned());
    for text in wrong.chain(files()) {
        std::fs::write(&path, &text).unwrap();
        let (loaded, most) = peak_memory(|| load(&path));
        let start: String = text.chars().take(200).collect();
        let bound = Bound::TOML.of(text.len());
        assert!(
            most <= bound,
            "{most} bytes for a file of {} ({:?}), which begins with {start}",
            text.len(),
            loaded.is_ok()
        );
    }
}
