//! A picture of hard cases: rays that fail in red, for the textbook's formula and for the core.

use super::case::{Solver, answers, held, judged, towards};
use crate::oracle::{Truth, meet};
use crate::thing::{Line, Thing};
use crate::vector::{Vector, upright, vector};

/// Pixels along each side of a panel.
const SIDE: usize = 112;

/// Between panels.
const GAP: usize = 4;

/// What a panel shows: a thing, where the eye is, how much of it is seen, and the case's bound.
struct Panel {
    thing: Thing,
    eye: Vector,
    reach: f64,
    bound: f64,
}

fn panels() -> [Panel; 5] {
    let far = |center: Vector, away: f64| held(center + vector(0.55, 0.35, 0.76) * away);
    let sphere = vector(0.3, -0.2, 0.5);
    let cone = vector(0.1, 0.4, -0.3);
    let torus = vector(-0.2, 0.1, 0.3);
    let needle = [vector(-1.0, -0.62, 0.37), vector(1.0, 0.71, -0.46), vector(0.11, 0.08, -0.045)].map(held);
    let placed = held(vector(5.3e3, -4.1e3, 6.7e3));
    [
        Panel {
            thing: Thing::Sphere { center: held(sphere), radius: 1.0 },
            eye: far(sphere, 3000.0),
            reach: 1.15,
            bound: 4.0,
        },
        Panel {
            thing: Thing::Cone {
                base: held(cone - vector(0.5, 0.8, -0.2)),
                base_radius: 0.6000000238418579,
                end: held(cone + vector(0.5, 0.8, -0.2)),
                end_radius: 0.25,
                capped: false,
            },
            eye: far(cone, 1000.0),
            reach: 1.3,
            bound: 8.0,
        },
        Panel {
            thing: Thing::Torus {
                center: held(torus),
                axis: held(vector(0.3, 0.9, 0.5)),
                major: 1.0,
                minor: 0.3125,
            },
            eye: far(torus, 40.0),
            reach: 1.4,
            bound: 8.0,
        },
        Panel {
            thing: Thing::Triangle { corners: needle },
            eye: far(Vector::ZERO, 1.5),
            reach: 1.0,
            bound: 4.0,
        },
        Panel {
            thing: Thing::OrientedCuboid {
                center: placed,
                half: vector(0.75, 0.5, 0.625),
                first: held(vector(0.8, 0.1, -0.6)),
                third: held(vector(0.3, 0.9, 0.5)),
            },
            eye: far(placed, 6.0),
            reach: 1.4,
            bound: 4.0,
        },
    ]
}

impl Panel {
    fn lines(&self) -> Vec<Line> {
        let center = self.thing.ball().0;
        let (x, y) = upright(self.eye - center);
        let place = |i: usize| ((i as f64 + 0.5) / SIDE as f64 * 2.0 - 1.0) * self.reach;
        let line = |row: usize, column: usize| towards(self.eye, center + x * place(column) - y * place(row));
        (0..SIDE)
            .flat_map(|row| (0..SIDE).map(move |column| (row, column)))
            .map(|(r, c)| line(r, c))
            .collect()
    }

    /// The colours of the rays: lit by the eye, red where the answer is wrong.
    fn colors(&self, lines: &[Line], truths: &[Truth], solver: Solver) -> Vec<[u8; 3]> {
        let answers = answers(solver, &self.thing, lines);
        let color = |((line, truth), answer)| {
            if judged(&self.thing, line, truth, answer, self.bound).is_err() {
                return [220, 30, 30];
            }
            match truth {
                Truth::Miss => [245, 245, 245],
                Truth::Unclear => [120, 140, 170],
                Truth::Hit(contact) => [(60.0 + 160.0 * contact.slope) as u8; 3],
            }
        };
        lines.iter().zip(truths).zip(answers).map(color).collect()
    }
}

/// The picture: its width, and its pixels row by row. Above the textbook's formula, below the core.
pub fn picture() -> (usize, Vec<[u8; 3]>) {
    let panels = panels();
    let width = panels.len() * (SIDE + GAP) + GAP;
    let height = 2 * (SIDE + GAP) + GAP;
    let mut pixels = vec![[255; 3]; width * height];
    for (column, panel) in panels.iter().enumerate() {
        let lines = panel.lines();
        let truths: Vec<Truth> = lines.iter().map(|line| meet(&panel.thing, line)).collect();
        for (row, solver) in [Solver::Textbook, Solver::Single].into_iter().enumerate() {
            let (left, top) = (GAP + column * (SIDE + GAP), GAP + row * (SIDE + GAP));
            for (i, color) in panel.colors(&lines, &truths, solver).into_iter().enumerate() {
                pixels[(top + i / SIDE) * width + left + i % SIDE] = color;
            }
        }
    }
    (width, pixels)
}
