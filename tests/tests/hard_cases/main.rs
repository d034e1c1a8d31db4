//! Rays that are known to go wrong in single precision: see `strahl_tests::hard`.

mod accelerators;
mod pixels;
mod scale;
mod watertight;

use std::sync::OnceLock;

use strahl_tests::hard::{HardCase, HardCaseTally, cases, panels, table};

/// A case, its evaluation, and the first faults.
struct CaseOutcome {
    case: HardCase,
    tallies: [HardCaseTally; 3],
    faults: Vec<String>,
}

/// Computed once for all tests.
fn outcomes() -> &'static [CaseOutcome] {
    static OUTCOMES: OnceLock<Vec<CaseOutcome>> = OnceLock::new();
    OUTCOMES.get_or_init(|| {
        let run = |case: HardCase| {
            let mut faults = Vec::new();
            let tallies = case.run_with_faults(&mut |fault| {
                if !fault.starts_with("Textbook") && faults.len() < 3 {
                    faults.push(fault);
                }
            });
            CaseOutcome { case, tallies, faults }
        };
        let all = cases();
        // Two threads with about the same work: every second case each.
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

/// Asserts a property of every case, and reports all that violate it.
fn assert_all(is_right: impl Fn(&CaseOutcome) -> bool) {
    let wrong: Vec<String> = outcomes()
        .iter()
        .filter(|outcome| !is_right(outcome))
        .map(|CaseOutcome { case, tallies, faults }| {
            format!(
                "{}, {}: bound {}, {tallies:?}\n{}",
                case.family,
                case.name,
                case.bound,
                faults.join("\n")
            )
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
fn the_textbook_formula_fails_in_every_case_that_says_so() {
    assert_all(|outcome| !outcome.case.breaks || outcome.tallies[0].faults > 0);
}

#[test]
fn the_textbook_formula_is_correct_in_the_other_cases() {
    assert_all(|outcome| outcome.case.breaks || outcome.tallies[0].faults == 0);
}

#[test]
fn at_most_half_of_the_hard_rays_are_unclear() {
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
    let remedy = "write it again: cargo run --release -p strahl-tests --example hard_cases";
    let text = std::fs::read_to_string(&report).unwrap();
    for line in table::figures(&all).lines() {
        assert!(text.contains(line), "{} does not have: {line}\n{remedy}", report.display());
    }
    let image = image::open(&picture).unwrap().into_rgb8();
    let (width, pixels) = panels::picture();
    assert_eq!(image.width() as usize, width, "{remedy}");
    let is_same = image.pixels().map(|pixel| pixel.0).eq(pixels);
    assert!(is_same, "{} is stale; {remedy}", picture.display());
}
