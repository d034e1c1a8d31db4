//! Intersection of a ray with a shape of any kind.

use super::answer::{OracleAnswer, OracleHit};
use super::{flat, march};
use strahl_test_scene::{TestRay, TestShape};

/// Intersects a ray with a shape.
pub fn intersect(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    // Around the origin, where `f64` is fine enough for small shapes. Differences of `f32` numbers are exact,
    // or nearly.
    let center = shape.bounding_sphere().0;
    let ray = TestRay { origin: ray.origin - center, ..*ray };
    match intersect_at_origin(&shape.mapped(|p| p - center, |d| d, 1.0), &ray) {
        OracleAnswer::Hit(contact) => {
            OracleAnswer::Hit(OracleHit { point: contact.point + center, ..contact })
        }
        other => other,
    }
}

fn intersect_at_origin(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    match shape {
        TestShape::Plane { .. }
        | TestShape::Disc { .. }
        | TestShape::Triangle { .. }
        | TestShape::SmoothTriangle { .. }
        | TestShape::Polygon { .. }
        | TestShape::SmoothPolygon { .. } => flat::intersect(shape, ray),
        _ => march::intersect(shape, ray),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use strahl_test_scene::{DVec3, dvec3};

    fn ray(origin: DVec3, direction: DVec3) -> TestRay {
        TestRay { origin, direction }
    }

    fn distance(shape: &TestShape, ray: &TestRay) -> Option<f64> {
        match intersect(shape, ray) {
            OracleAnswer::Hit(contact) => Some(contact.distance),
            OracleAnswer::Miss => None,
            OracleAnswer::Unclear => panic!("unclear"),
        }
    }

    #[test]
    fn the_oracle_agrees_with_results_known_on_paper() {
        let close = |got: Option<f64>, want: f64| (got.unwrap() - want).abs() <= 1e-12;
        let along_x = ray(dvec3(-5.0, 0.0, 0.0), dvec3(2.0, 0.0, 0.0));
        let ball = TestShape::Sphere { center: DVec3::ZERO, radius: 1.5 };
        assert!(close(distance(&ball, &along_x), 3.5));
        assert!(close(distance(&ball, &ray(dvec3(0.5, 0.0, 0.0), DVec3::X)), 1.0));
        let ring = TestShape::Torus { center: DVec3::ZERO, axis: DVec3::Z, major: 2.0, minor: 0.5 };
        assert!(close(distance(&ring, &along_x), 2.5));
        assert!(close(distance(&ring, &ray(dvec3(-1.0, 0.0, 0.0), DVec3::X)), 2.5));
        assert_eq!(distance(&ring, &ray(dvec3(0.0, 0.0, 3.0), -DVec3::Z)), None);
        let cone = |capped| TestShape::Cone {
            base: DVec3::ZERO,
            base_radius: 2.0,
            end: dvec3(0.0, 0.0, 2.0),
            end_radius: 0.0,
            capped,
        };
        let up = ray(dvec3(1.0, 0.0, -1.0), DVec3::Z);
        assert!(close(distance(&cone(true), &up), 1.0) && close(distance(&cone(false), &up), 2.0));
        let tilted = ray(dvec3(2.0, 1.5, 0.5), dvec3(-1.0, -1.0, 0.0));
        let cube = TestShape::Cuboid { min: dvec3(-1.0, 0.0, 0.0), max: DVec3::ONE };
        assert!(close(distance(&cube, &tilted), 2.0_f64.sqrt()));
    }
}
