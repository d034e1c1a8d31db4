//! `tests/HARD-CASES.md`: the hard cases as a table, from the figures of the tests.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::remedies::{Remedy, Trial};
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

/// What is measured: for each row of a table, by its first words, what stands in its last columns.
#[derive(Default)]
pub struct Figures {
    columns: BTreeMap<String, String>,
}

impl Figures {
    /// Those that stand in the file.
    pub fn kept(text: &str) -> Figures {
        let mut columns = BTreeMap::new();
        for row in text.lines().filter(|line| line.starts_with("| ")) {
            let cells: Vec<&str> = row.trim_matches('|').split(" | ").map(str::trim).collect();
            match cells.len() {
                FAMILY => columns.insert(cells[0].into(), cells[1..].join(" | ")),
                REMEDY => columns.insert(cells[..2].join(" | "), cells[8..].join(" | ")),
                _ => None,
            };
        }
        Figures { columns }
    }

    /// Instructions and nanoseconds for each ray: of the textbook, of the core, with `f64` inside.
    pub fn family(&mut self, family: &str, counts: &[f64], times: &[f64]) {
        let columns = format!(
            "{:.0} | {:.0} | {:.0} | {:.2} | {:.0} | {:.0} | {:.0}",
            counts[0],
            counts[1],
            counts[2],
            counts[1] / counts[0],
            times[0],
            times[1],
            times[2],
        );
        self.columns.insert(family.into(), columns);
    }

    /// Instructions and nanoseconds for each ray: with the remedy and without it.
    pub fn remedy(&mut self, remedy: &Remedy, counts: &[f64], times: &[f64]) {
        let cost = (100.0 * (counts[0] / counts[1] - 1.0)).round();
        let cost = if cost == 0.0 { 0.0 } else { cost };
        let columns =
            format!("{:.0} | {:.0} | {cost:+} % | {:.1} | {:.1}", counts[0], counts[1], times[0], times[1],);
        self.columns.insert(format!("{} | {}", remedy.family, remedy.name), columns);
    }

    fn of(&self, row: &str, columns: usize) -> String {
        self.columns.get(row).cloned().unwrap_or_else(|| vec!["?"; columns].join(" | "))
    }
}

/// How many columns the tables of the costs have.
const FAMILY: usize = 8;
const REMEDY: usize = 13;

/// The whole page.
pub fn text(outcomes: &[(Case, [Tally; 3])], remedies: &[(&Remedy, &Trial)], figures: &Figures) -> String {
    let mut text = head(outcomes);
    text += COSTS;
    for (family, _) in super::cost::FAMILIES {
        writeln!(text, "| {family} | {} |", figures.of(family, FAMILY - 1)).unwrap();
    }
    text += REMEDIES;
    for (remedy, trial) in remedies {
        let row = format!("{} | {}", remedy.family, remedy.name);
        writeln!(text, "{} {} |", found(remedy, trial), figures.of(&row, REMEDY - 8)).unwrap();
    }
    text
}

/// The first columns of a remedy's row, which are the same in every run.
pub fn found(remedy: &Remedy, trial: &Trial) -> String {
    let Remedy { family, name, without, .. } = remedy;
    let [with, alone] = trial.faults;
    let [least, most] = trial.worst.map_or(["–".into(), "–".into()], |worst| worst.map(error));
    format!("| {family} | {name} | {without} | {} | {with} | {alone} | {least} | {most} |", trial.rays)
}

/// The page as far as it is the same in every run.
pub fn head(outcomes: &[(Case, [Tally; 3])]) -> String {
    format!("{HEAD}\n{BEGIN}\n\n{}\n{END}\n\n", cases_as_text(outcomes))
}

const COSTS: &str = "## What the remedies cost

Measured with `--measure`, where valgrind is at hand. Instructions are callgrind's on x86-64, on rays at things
of ordinary proportions from 2 to 20 sizes away, of which about half meet. Times are the least of many runs, and
only good for comparing them with each other.

First each shape as a whole, on ordinary rays:

| shape | instructions per ray: textbook | ours, f32 | f64 inside | ours / textbook | ns per ray: textbook | ours, f32 | f64 inside |
|---|--:|--:|--:|--:|--:|--:|--:|
";

const REMEDIES: &str = "
Then each remedy alone: the core's own test with the remedy, and the same test without it. Faults and times are
those of the family's hard rays, the same for both; instructions those of ordinary rays. Where neither faults nor
errors tell both apart, these rays do not need the remedy: the foot of the perpendicular does for spheres what
their roots were for, and turning points are refined for tubes still thinner than these.

| family | remedy | without it | hard rays | faults: with | without | worst error inside the bound: with | without | instructions per ray: with | without | cost | ns per hard ray: with | without |
|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
";

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
  largest difference over the cosine between ray and normal, and the way. Of rays that leave a surface it is how
  far they start from it, in units in the last place of its coordinates and its size; a fault is a ray that meets
  the surface again, or starts farther away than the bound. For refraction the conditioning is that of the square
  root at the critical angle.
- Where there is no error there is no bound either, and a fault is an answer of another kind: of meshes a ray that
  gets through; of the slab test a box that is missed although the exact ray, in whole numbers, meets it, or met
  although it lies beyond the band; of grid, octree and hierarchy an answer that is not the list's to the last bit;
  of the shadow terminator a point whose shading normal faces the light and that lies in the shadow of its own
  smooth mesh, or a point behind a plate that is lit; of other scales an answer that does not grow with the scene,
  bit for bit.
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
