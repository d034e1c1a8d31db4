//! Rays that are known to go wrong, held against the bounds: see `strahl_tests::hard`.

mod accelerators;
mod pixels;
mod scale;
mod watertight;

use std::sync::OnceLock;

use strahl_tests::hard::{HardCase, HardCaseTally, cases, panels, table};

/// Every case, what the solvers made of it, and the first things that went wrong.
struct Outcome {
    case: HardCase,
    tallies: [HardCaseTally; 3],
    wrong: Vec<String>,
}

/// Computed once for all tests.
fn outcomes() -> &'static [Outcome] {
    static OUTCOMES: OnceLock<Vec<Outcome>> = OnceLock::new();
    OUTCOMES.get_or_init(|| {
        let run = |case: HardCase| {
            let mut wrong = Vec::new();
            let tallies = case.run_with_faults(&mut |what| {
                if !what.starts_with("Textbook") && wrong.len() < 3 {
                    wrong.push(what);
                }
            });
            Outcome { case, tallies, wrong }
        };
        let all = cases();
        // Two halves of about the same work: every second case.
        std::thread::scope(|scope| {
            let half = |odd: usize| {
                let cases: Vec<HardCase> = all.iter().copied().skip(odd).step_by(2).collect();
                scope.spawn(move || cases.into_iter().map(run).collect::<Vec<_>>())
            };
            let (even, odd) = (half(0), half(1));
            let (mut even, mut odd) = (even.join().unwrap().into_iter(), odd.join().unwrap().into_iter());
            all.iter()
                .enumerate()
                .filter_map(|(i, _)| if i % 2 == 0 { even.next() } else { odd.next() })
                .collect()
        })
    })
}

/// Asserts of every case, and shows all that are wrong at once.
fn assert_all(is_right: impl Fn(&Outcome) -> bool) {
    let wrong: Vec<String> = outcomes()
        .iter()
        .filter(|outcome| !is_right(outcome))
        .map(|Outcome { case, tallies, wrong }| {
            format!("{}, {}: bound {}, {tallies:?}\n{}", case.family, case.name, case.bound, wrong.join("\n"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_hard_ray_is_answered_wrongly() {
    assert_all(|outcome| outcome.tallies[1].faults == 0);
}

#[test]
fn no_hard_ray_is_answered_wrongly_with_double_precision_inside() {
    assert_all(|outcome| outcome.tallies[2].faults == 0);
}

#[test]
fn no_error_is_outside_its_bound() {
    assert_all(|outcome| outcome.tallies[1..].iter().all(|tally| tally.worst <= outcome.case.bound));
}

#[test]
fn the_textbooks_formula_fails_where_a_remedy_is_needed() {
    assert_all(|outcome| !outcome.case.breaks || outcome.tallies[0].faults > 0);
}

#[test]
fn where_the_textbooks_formula_does_no_harm_the_case_says_so() {
    assert_all(|outcome| outcome.case.breaks || outcome.tallies[0].faults == 0);
}

#[test]
fn most_hard_rays_have_one_answer() {
    assert_all(|outcome| {
        let HardCaseTally { rays, unclear, .. } = outcome.tallies[1];
        rays >= 990 && unclear * 10 <= rays * 5
    });
}

#[test]
fn the_report_has_the_figures_and_the_picture_of_this_code() {
    let all: Vec<(HardCase, [HardCaseTally; 3])> =
        outcomes().iter().map(|outcome| (outcome.case, outcome.tallies)).collect();
    let (report, picture) = table::report();
    let again = "write it again: cargo run --release -p strahl-tests --example hard_cases";
    let text = std::fs::read_to_string(&report).unwrap();
    for line in table::figures(&all).lines() {
        assert!(text.contains(line), "{} does not have: {line}\n{again}", report.display());
    }
    let image = image::open(&picture).unwrap().into_rgb8();
    let (width, pixels) = panels::picture();
    assert_eq!(image.width() as usize, width, "{again}");
    let is_same = image.pixels().map(|pixel| pixel.0).eq(pixels);
    assert!(is_same, "{} is stale; {again}", picture.display());
}
