//! A picture of hard cases: wrong answers in red, for the textbook's formula and for the core.

use super::case::{Solver, answers, as_f32, judged, towards};
use crate::oracle::{OracleAnswer, intersect};
use strahl_test_scene::vector::perpendicular_axes;
use strahl_test_scene::{DVec3, TestRay, TestShape, dvec3};

/// Pixels along each side of a panel.
const SIDE: usize = 112;

/// Pixels between panels.
const GAP: usize = 4;

/// A panel: a shape, the viewpoint, the half extent of the view, and the error bound of the case.
struct HardCasePanel {
    shape: TestShape,
    viewpoint: DVec3,
    half_extent: f64,
    bound: f64,
}

fn panels() -> [HardCasePanel; 5] {
    let far = |center: DVec3, away: f64| as_f32(center + dvec3(0.55, 0.35, 0.76) * away);
    let sphere = dvec3(0.3, -0.2, 0.5);
    let cone = dvec3(0.1, 0.4, -0.3);
    let torus = dvec3(-0.2, 0.1, 0.3);
    let needle = [dvec3(-1.0, -0.62, 0.37), dvec3(1.0, 0.71, -0.46), dvec3(0.11, 0.08, -0.045)].map(as_f32);
    let distant = as_f32(dvec3(5.3e3, -4.1e3, 6.7e3));
    [
        HardCasePanel {
            shape: TestShape::Sphere { center: as_f32(sphere), radius: 1.0 },
            viewpoint: far(sphere, 3000.0),
            half_extent: 1.15,
            bound: 4.0,
        },
        HardCasePanel {
            shape: TestShape::Cone {
                base: as_f32(cone - dvec3(0.5, 0.8, -0.2)),
                base_radius: 0.6000000238418579,
                end: as_f32(cone + dvec3(0.5, 0.8, -0.2)),
                end_radius: 0.25,
                capped: false,
            },
            viewpoint: far(cone, 1000.0),
            half_extent: 1.3,
            bound: 8.0,
        },
        HardCasePanel {
            shape: TestShape::Torus {
                center: as_f32(torus),
                axis: as_f32(dvec3(0.3, 0.9, 0.5)),
                major: 1.0,
                minor: 0.3125,
            },
            viewpoint: far(torus, 40.0),
            half_extent: 1.4,
            bound: 8.0,
        },
        HardCasePanel {
            shape: TestShape::Triangle { vertices: needle },
            viewpoint: far(DVec3::ZERO, 1.5),
            half_extent: 1.0,
            bound: 4.0,
        },
        HardCasePanel {
            shape: TestShape::OrientedCuboid {
                center: distant,
                half: dvec3(0.75, 0.5, 0.625),
                first: as_f32(dvec3(0.8, 0.1, -0.6)),
                third: as_f32(dvec3(0.3, 0.9, 0.5)),
            },
            viewpoint: far(distant, 6.0),
            half_extent: 1.4,
            bound: 4.0,
        },
    ]
}

impl HardCasePanel {
    fn rays(&self) -> Vec<TestRay> {
        let center = self.shape.bounding_sphere().0;
        let (x, y) = perpendicular_axes(self.viewpoint - center);
        let coordinate = |i: usize| ((i as f64 + 0.5) / SIDE as f64 * 2.0 - 1.0) * self.half_extent;
        let ray = |row: usize, column: usize| {
            towards(self.viewpoint, center + x * coordinate(column) - y * coordinate(row))
        };
        (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (row, column))).map(|(r, c)| ray(r, c)).collect()
    }

    /// Colors of the rays: lit from the viewpoint, red if the answer is wrong.
    fn colors(&self, rays: &[TestRay], expected: &[OracleAnswer], solver: Solver) -> Vec<[u8; 3]> {
        let answers = answers(solver, &self.shape, rays);
        let color = |((ray, expected), answer)| {
            if judged(&self.shape, ray, expected, answer, self.bound).is_err() {
                return [220, 30, 30];
            }
            match expected {
                OracleAnswer::Miss => [245, 245, 245],
                OracleAnswer::Unclear => [120, 140, 170],
                OracleAnswer::Hit(contact) => [(60.0 + 160.0 * contact.slope) as u8; 3],
            }
        };
        rays.iter().zip(expected).zip(answers).map(color).collect()
    }
}

/// The picture: its width, and its pixels row by row. The top row of panels is the textbook's, the bottom row
/// the core's.
pub fn picture() -> (usize, Vec<[u8; 3]>) {
    let panels = panels();
    let width = panels.len() * (SIDE + GAP) + GAP;
    let height = 2 * (SIDE + GAP) + GAP;
    let mut pixels = vec![[255; 3]; width * height];
    for (column, panel) in panels.iter().enumerate() {
        let rays = panel.rays();
        let expected: Vec<OracleAnswer> = rays.iter().map(|ray| intersect(&panel.shape, ray)).collect();
        for (row, solver) in [Solver::Textbook, Solver::Single].into_iter().enumerate() {
            let (left, top) = (GAP + column * (SIDE + GAP), GAP + row * (SIDE + GAP));
            for (i, color) in panel.colors(&rays, &expected, solver).into_iter().enumerate() {
                pixels[(top + i / SIDE) * width + left + i % SIDE] = color;
            }
        }
    }
    (width, pixels)
}
