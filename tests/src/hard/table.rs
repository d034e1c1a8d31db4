//! `tests/HARD-CASES.md`: the hard cases as a table, from the figures of the tests.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::{Case, Tally};

/// Between these lines stands what is the same in every run; a test holds it against the file.
pub const BEGIN: &str = "<!-- the same in every run: from here -->";
/// See [`BEGIN`].
pub const END: &str = "<!-- to here -->";

/// Where the page and its picture lie.
pub fn page() -> (PathBuf, PathBuf) {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    (tests.join("HARD-CASES.md"), tests.join("hard-cases.png"))
}

/// An error in few characters.
fn error(x: f64) -> String {
    match x {
        _ if x.is_infinite() => "no unit normal".into(),
        0.0 => "0".into(),
        _ if x >= 1000.0 => format!("{x:.0e}"),
        _ => format!("{x:.2}"),
    }
}

/// The page as far as it is the same in every run.
pub fn head(outcomes: &[(Case, [Tally; 3])]) -> String {
    format!("{HEAD}\n{BEGIN}\n\n{}\n{END}\n\n", cases_as_text(outcomes))
}

const HEAD: &str = "# Hard cases

Rays that are known to go wrong in single precision, and what three ways make of them: the formula of the
textbooks in `f32`, the core in `f32`, and the core with `f64` inside, whose answers are rounded. All three
answer the same rays, and are held against an oracle that shares no code with them.

![Above the textbook's formula, below the core: a sphere 3000 radii away, a cone 1000 sizes away, a torus
40 sizes away, a needle, a box far from the origin](hard-cases.png)

*Above the textbook's formula, below the core, each with 112 x 112 rays: a sphere 3000 radii away, a cone 1000
sizes away, a torus 40 sizes away, a needle, a turned box 9500 from the origin. Red: a wrong answer. Blue: so
close to an outline or an edge that either answer is right.*

This page is written by

    cargo run --release -p strahl-tests --example hard_cases

and held against the tests' own figures by `cargo test -p strahl-tests --test hard_cases`.

- *Either way*: rays that pass a silhouette, an edge or a rim closer than 32 roundoffs of the largest difference
  that must be formed (the distance between eye and object and its size). Every other ray has one answer.
- *Faults*: hit for miss, miss for hit, a distance or a normal outside the bound, a normal that is not of
  length one, a NaN.
- *Error*: of the distance and of the normal, in units in the last place times the conditioning, which is that
  largest difference over the cosine between ray and normal, and the way. For meshes there is none: a fault is a
  ray that gets through. Of rays that leave a surface it is how far they start from it, in units in the last
  place of its coordinates and its size; a fault is a ray that meets the surface again, or starts farther away
  than the bound. For refraction the conditioning is that of the square root at the critical angle.
";

/// The table of all cases.
fn cases_as_text(outcomes: &[(Case, [Tally; 3])]) -> String {
    let mut text = String::new();
    let mut say = |line: std::fmt::Arguments| writeln!(text, "{line}").unwrap();
    say(format_args!(
        "| family | case | what goes wrong in a naive implementation | rays | either way | faults: textbook | ours, f32 | f64 inside | worst error: textbook | ours, f32 | f64 inside | bound |"
    ));
    say(format_args!("|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"));
    for (case, [textbook, single, double]) in outcomes {
        say(format_args!(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            case.family,
            case.name,
            case.naive,
            single.rays,
            single.unclear,
            textbook.faults,
            single.faults,
            double.faults,
            error(textbook.worst),
            error(single.worst),
            error(double.worst),
            if case.bound == 0.0 { "–".into() } else { format!("{}", case.bound) },
        ));
    }
    text
}
