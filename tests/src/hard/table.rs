//! The report `tests/reports/hard-cases.md`: the hard cases as a table.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::case::{HardCase, HardCaseTally};

/// Paths of the report and of its picture.
pub fn report() -> (PathBuf, PathBuf) {
    let reports = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports");
    (reports.join("hard-cases.md"), reports.join("hard-cases.png"))
}

/// The whole report. Deterministic.
pub fn text(outcomes: &[(HardCase, [HardCaseTally; 3])]) -> String {
    format!("{HEAD}\n{}{REST}", figures(outcomes))
}

/// The part of the report that the cases determine.
pub fn figures(outcomes: &[(HardCase, [HardCaseTally; 3])]) -> String {
    format!("{}\n{}", sum(outcomes), table(outcomes))
}

/// The sums over all cases, as a sentence.
fn sum(outcomes: &[(HardCase, [HardCaseTally; 3])]) -> String {
    let of = |count: fn(&[HardCaseTally; 3]) -> usize| -> usize {
        outcomes.iter().map(|(_, tallies)| count(tallies)).sum()
    };
    let rays = of(|[_, single, _]| single.rays);
    let [textbook, single, double] =
        [of(|[x, _, _]| x.faults), of(|[_, x, _]| x.faults), of(|[_, _, x]| x.faults)];
    format!(
        "Faults in {rays} rays of {} cases: {textbook} by the textbook's formulas, {single} by the core, {double} by \
         the core with `f64` inside.\n",
        outcomes.len()
    )
}

fn table(outcomes: &[(HardCase, [HardCaseTally; 3])]) -> String {
    let mut text = String::new();
    let mut line = |line: std::fmt::Arguments| writeln!(text, "{line}").unwrap();
    line(format_args!(
        "| family | case | what goes wrong in a naive implementation | rays | either | faults: textbook | core, f32 | f64 inside | worst error: textbook | core, f32 | f64 inside | bound |"
    ));
    line(format_args!("|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"));
    for (case, [textbook, single, double]) in outcomes {
        line(format_args!(
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

/// An error with few characters.
fn error(x: f64) -> String {
    match x {
        _ if x.is_infinite() => "no unit normal".into(),
        0.0 => "0".into(),
        _ if x >= 1000.0 => format!("{x:.0e}"),
        _ => format!("{x:.2}"),
    }
}

const HEAD: &str = "# Hard numeric cases

Made by

    cargo run --release -p strahl-tests --example hard_cases

Rays that are known to go wrong in single precision, answered in three ways: by the formulas of the textbooks in
`f32`, by the core in `f32`, and by the core with `f64` inside, whose answers are rounded. All three
get the same rays and are compared with an oracle that shares no code with them.
`cargo test -p strahl-tests --test hard_cases` checks that the core makes no fault, and that the figures and the picture
here are those of the code.

![Top the textbook's formulas, bottom the core: a sphere 3000 radii away, a cone 1000 sizes away, a torus
40 sizes away, a needle, a box far from the origin](hard-cases.png)

*Top the textbook's formulas, bottom the core, each with 112 x 112 rays: a sphere 3000 radii away, a cone 1000
sizes away, a torus 40 sizes away, a needle triangle, an oriented box 9500 from the origin. Red: a wrong answer. Blue: so
close to a silhouette or an edge that either answer is right.*

- *Either*: rays closer to a silhouette or an edge than 32 roundoffs of the largest difference
  that must be formed (the distance between viewpoint and object and its size): either answer is right. Every other ray has
  one right answer.
- *Faults*: hit for miss, miss for hit, a distance or a normal outside the bound, a normal that is not of
  unit length, a NaN.
- *Error*: of the distance and of the normal, in units in the last place times the conditioning, which is that
  largest difference over the cosine between ray and normal, plus the distance. For rays that leave a surface (*leaving*)
  it is how far they start from it, in units in the last place of its coordinates and its size; a fault is a ray that
  hits the surface again, or starts farther away than the bound. For refraction the conditioning is that of the square
  root at the critical angle.
- Where there is no bound, a fault is an answer of another kind: for meshes a ray that
  gets through; for the slab test a box that is missed although the exact ray, in integers, hits it, or hit
  although it lies beyond the band; for grid, octree and BVH an answer that is not the list's to the last
  bit; for the shadow terminator a point whose shading normal faces the light and that lies in the shadow of its own
  smooth mesh, or a lit point behind a plate; for scale an answer that does not scale with the scene,
  bit for bit.

What each remedy costs is in [remedies.md](remedies.md).
";

const REST: &str = "
## What else holds

Each is tested by `cargo test -p strahl-tests --test` and the words in parentheses.

- *Meshes are watertight* (`hard_cases watertight`): of a million rays from inside, aimed at vertices and at points of
  edges of spheres, cubes, sheets and cones of slivers, near the origin and 2e5 from it, none gets through, with no
  accelerator; from outside, the number of crossings of a closed mesh is even. Of 10^8 rays none gets through either:

      cargo run --release -p strahl-tests --example hard_cases -- --watertight 100000000

- *Accelerators agree* (`hard_cases accelerators`): for every hard ray, grid, octree and BVH (with a
  stack, with a heap, and with a stack and a heap of capacity 0) find what the list finds, to the last bit.
- *Every pixel is finite* (`hard_cases pixels`): in random scenes 1e-6 to 1e6 in size, with materials, lights and
  cameras as extreme as the public API permits, with every sampler. A ray with NaN or infinity tests no bounds and no shape.
- *Scale* (`hard_cases scale`): times 2^k, k from -20 to 20, the picture is the same, bit for bit.
- *Mirrored scenes* (`hard_cases scale`) have the mirrored hits, bit for bit, except at the edges of polygons: an edge
  contains its lower end and not its upper one. With permuted axes, triangles and axis-aligned boxes are hit at
  the same distance, bit for bit. Elsewhere sums of three products are rounded in the order of the axes: both
  distances lie within 8 units in the last place times the conditioning of each other.
- *Points and normals* (`shapes`): for every kind of shape, the point found lies on it within the error bound that
  it comes with, the normal is of unit length within 1e-6 and points outward; a ray that leaves something convex or
  flat, 1e-4 to 1e4 in size and up to 1e4 sizes from the origin, does not hit it again.
- *Media* (`closed_form`): glass in water, bodies that overlap, an viewpoint inside glass; at the critical angle no light
  is lost.
- *Input* (`cargo test -p strahl`): objects without area or size, views that show nothing, NaN and infinities
  are errors with their position. Triangles without area in a mesh keep their number and are never hit; one warning
  counts them.
";
