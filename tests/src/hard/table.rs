//! `tests/HARD-CASES.md`: the hard cases as a table, from the figures of the tests.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::remedies::{Remedy, Tried};
use super::{Case, Tally};

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
        self.columns.insert(name(remedy), columns);
    }

    /// How many instructions more a remedy takes than what is done without it, in percent.
    pub fn cost(&self, remedy: &Remedy) -> Option<f64> {
        let columns = self.columns.get(&name(remedy))?;
        columns.split(" | ").nth(2)?.trim_end_matches(" %").parse().ok()
    }

    fn of(&self, row: &str, columns: usize) -> String {
        self.columns.get(row).cloned().unwrap_or_else(|| vec!["?"; columns].join(" | "))
    }
}

/// How many columns the tables of the costs have.
const FAMILY: usize = 8;
const REMEDY: usize = 13;

/// The whole page. But for what was measured it is the same in every run.
pub fn text(outcomes: &[(Case, [Tally; 3])], remedies: &[(Remedy, Tried)], figures: &Figures) -> String {
    let mut text = format!("{HEAD}\n{}\n{}\n{COSTS}", sum(outcomes), cases_as_text(outcomes));
    for (family, _) in super::cost::FAMILIES {
        writeln!(text, "| {family} | {} |", figures.of(family, FAMILY - 1)).unwrap();
    }
    text += REMEDIES;
    for (remedy, tried) in remedies {
        let [with, alone] = tried.faults;
        let [least, most] = tried.worst.map_or(["–".into(), "–".into()], |worst| worst.map(error));
        let found = format!("{} | {} | {with} | {alone} | {least} | {most}", remedy.without, tried.rays);
        let name = name(remedy);
        writeln!(text, "| {name} | {found} | {} |", figures.of(&name, REMEDY - 8)).unwrap();
    }
    text + REST
}

/// The first words of a remedy's row: its family, which leads to its room, and what it does.
fn name(Remedy { family, name, room, .. }: &Remedy) -> String {
    format!("[{family}](../{room}) | {name}")
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
Then each remedy alone: the core's own method with the remedy, and the same method without it, both written again
among the tests; what the core does besides to be quick is left out. Faults and times are those of the family's hard
rays, the same for both; instructions those of ordinary rays. Where neither faults nor
errors tell both apart, these rays do not need the remedy: the foot of the perpendicular does for spheres what
their roots were for, and turning points are refined for tubes still thinner than these.

Of grid, octree and hierarchy whole walks are counted, from the box round all to the nearest of 400 small boxes, and
of the shadow terminator whole rays to a light through a hierarchy of 1,280 smooth triangles: what is paid for is
not the step alone but also where it leads. Walks are code of many branches, which a compiler lays out differently
from one form to the next: a few percent mean nothing there. Where a remedy costs more than 5 % its room says so; the family's name
leads there.

| family | remedy | without it | hard rays | faults: with | without | worst error inside the bound: with | without | instructions per ray: with | without | cost | ns per hard ray: with | without |
|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
";

const REST: &str = "
The speeds in [accelerators.md](accelerators.md) and, beside other crates, in [bench/README.md](bench/README.md)
were measured with all of these remedies in: the core cannot be built without them.

## What else holds

Where it is tested: each by `cargo test -p strahl-tests --test` and the words in brackets.

- *Meshes are tight* (`hard_cases watertight`): of a million rays from inside, aimed at corners and at points of
  edges of spheres, cubes, sheets and cones of slivers, near the origin and 2e5 from it, none gets through, with no
  accelerator; from outside a closed mesh is crossed an even number of times. Of 10^8 rays none gets through either:

      cargo run --release -p strahl-tests --example hard_cases -- --watertight 100000000

- *Accelerators agree* (`hard_cases accelerators`): for every hard ray at a thing grid, octree and hierarchy (by a
  stack, by a heap, and with no memory at all) find what the list finds, to the last bit.
- *Every pixel is a number* (`hard_cases pixels`): of random scenes 1e-6 to 1e6 in size, with materials, lights and
  cameras as extreme as the doors let in, by every sampler. A ray that is none asks for no box and no shape.
- *Scenes of any size* (`hard_cases scale`): times 2^k, k from -20 to 20, the picture is the same, bit for bit.
- *Mirrored scenes* (`hard_cases scale`) have the mirrored hits, bit for bit, but for the edges of polygons: an edge
  holds its lower end and not its upper one. With the axes in another order triangles and upright boxes are met at
  the same distance, bit for bit. Elsewhere sums of three products are rounded in the order of the axes: both
  distances lie within 8 units in the last place times the conditioning of each other.
- *Points and normals* (`shapes`): of every kind of shape, the point that is found lies on it within the error that
  it comes with, the normal is of length one within 1e-6 and faces outward; a ray that leaves something convex or
  flat, 1e-4 to 1e4 in size and up to 1e4 sizes from the origin, does not meet it again.
- *Bodies* (`closed_form`): glass in water, bodies that overlap, an eye inside glass; at the critical angle no light
  is lost.
- *Doors* (`cargo test -p strahl`): what has no area or no size, views that show nothing and numbers that are none
  are errors with their place. Triangles without area in a mesh keep their number and are met by no ray; one warning
  counts them.
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

and what costs are measured by

    cargo run --release -p strahl-tests --example hard_cases -- --measure

`cargo test -p strahl-tests --test hard_cases` holds every word and every figure of it but the measured ones against
what it finds itself, and that none of the measured ones is missing.

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

/// All cases in a sentence.
fn sum(outcomes: &[(Case, [Tally; 3])]) -> String {
    let of = |count: fn(&[Tally; 3]) -> usize| -> usize {
        outcomes.iter().map(|(_, tallies)| count(tallies)).sum()
    };
    let rays = of(|[_, single, _]| single.rays);
    let [textbook, single, double] =
        [of(|[x, _, _]| x.faults), of(|[_, x, _]| x.faults), of(|[_, _, x]| x.faults)];
    format!(
        "Of {rays} rays of {} kinds the textbook's formulas answer {textbook} wrongly, the core {single}, and with \
         `f64` inside {double}.\n",
        outcomes.len()
    )
}

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
