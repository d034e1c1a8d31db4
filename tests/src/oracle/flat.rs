//! Intersection of flat shapes on their plane, and their shading normals.

use super::answer::{OracleAnswer, OracleHit, band};
use super::measure::{angle, length, to_segment};
use strahl_test_scene::vector::{area, perpendicular_axes, unit};
use strahl_test_scene::{DVec3, TestRay, TestShape};

/// A point of the plane of a flat shape, and the plane's normal.
pub(super) fn plane_of(shape: &TestShape) -> (DVec3, DVec3) {
    match shape {
        TestShape::Plane { point, normal } => (*point, unit(*normal)),
        TestShape::Disc { center, normal, .. } => (*center, unit(*normal)),
        _ => {
            let vertices = vertices(shape);
            (vertices.iter().sum::<DVec3>() / vertices.len() as f64, unit(area(vertices)))
        }
    }
}

/// Vertices of a triangle or polygon; none for other shapes.
fn vertices(shape: &TestShape) -> &[DVec3] {
    match shape {
        TestShape::Triangle { vertices } | TestShape::SmoothTriangle { vertices, .. } => vertices,
        TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => vertices,
        _ => &[],
    }
}

/// Intersects a ray with a flat shape.
pub(super) fn intersect(shape: &TestShape, ray: &TestRay) -> OracleAnswer {
    let speed = length(ray.direction);
    let (origin, direction) = (ray.origin, ray.direction / speed);
    let (point, normal) = plane_of(shape);
    let (height, slope) = ((origin - point).dot(normal), normal.dot(direction));
    let band = band(shape, ray);
    if slope.abs() < 1e-6 || height.abs() <= band {
        return OracleAnswer::Unclear;
    }
    let distance = -height / slope;
    if distance < 0.0 {
        return OracleAnswer::Miss;
    }
    let point_on_plane = origin + direction * distance;
    let (is_inside, border) = match shape {
        TestShape::Plane { .. } => (true, f64::INFINITY),
        TestShape::Disc { center, radius, .. } => {
            let from_center = length(point_on_plane - *center);
            (from_center < *radius, (from_center - radius).abs())
        }
        _ => inside(vertices(shape), point_on_plane, normal),
    };
    let slope = slope.abs();
    if border <= band / slope {
        OracleAnswer::Unclear
    } else if is_inside {
        OracleAnswer::Hit(OracleHit {
            t: distance / speed,
            distance,
            point: point_on_plane,
            normal,
            slope,
            curvature: f64::INFINITY,
        })
    } else {
        OracleAnswer::Miss
    }
}

/// The edges: each vertex with the next.
fn edges(vertices: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
    vertices.iter().copied().zip(vertices.iter().copied().cycle().skip(1))
}

/// Whether a point of the plane is inside, by the winding number of the border, and its distance from the
/// border.
fn inside(vertices: &[DVec3], p: DVec3, normal: DVec3) -> (bool, f64) {
    let (x, y) = perpendicular_axes(normal);
    let flat = |vertex: DVec3| ((vertex - p).dot(x), (vertex - p).dot(y));
    let (mut turn, mut border) = (0.0_f64, f64::INFINITY);
    for (a, b) in edges(vertices) {
        let (a, b) = (flat(a), flat(b));
        turn += angle(a, b);
        border = border.min(to_segment((0.0, 0.0), a, b));
    }
    (turn.abs() > std::f64::consts::PI, border)
}

/// The shading normal of a smooth shape at a point of its plane, and the distance of the nearest vertex.
/// `None` for other shapes.
///
/// The weights of the vertex normals are barycentric coordinates for a triangle, and mean value coordinates
/// for a polygon.
///
/// Source: Floater, "Mean Value Coordinates", Computer Aided Geometric Design 20, 2003.
pub fn shading(shape: &TestShape, p: DVec3) -> Option<(DVec3, f64)> {
    let (vertices, normals) = match shape {
        TestShape::SmoothTriangle { vertices, normals } => (&vertices[..], &normals[..]),
        TestShape::SmoothPolygon { vertices, normals } => (&vertices[..], &normals[..]),
        _ => return None,
    };
    let (_, upward) = plane_of(shape);
    let nearest = vertices.iter().map(|vertex| length(*vertex - p)).fold(f64::INFINITY, f64::min);
    let weight = |i: usize| {
        let (before, here, after) = (
            vertices[(i + vertices.len() - 1) % vertices.len()],
            vertices[i],
            vertices[(i + 1) % vertices.len()],
        );
        if let TestShape::SmoothTriangle { .. } = shape {
            return (after - p).cross(before - p).dot(upward);
        }
        let (x, y) = perpendicular_axes(upward);
        let flat = |vertex: DVec3| ((vertex - p).dot(x), (vertex - p).dot(y));
        let half = |a: DVec3, b: DVec3| (0.5 * angle(flat(a), flat(b))).tan();
        (half(before, here) + half(here, after)) / length(here - p)
    };
    Some((unit(normals.iter().enumerate().map(|(i, normal)| unit(*normal) * weight(i)).sum()), nearest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use strahl_test_scene::dvec3;

    #[test]
    fn a_point_in_a_concave_corner_is_outside() {
        let vertices =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 1.0), (0.0, 3.0)].map(|(x, y)| dvec3(x, y, 0.0));
        assert_eq!(inside(&vertices, dvec3(2.0, 0.5, 0.0), DVec3::Z), (true, 0.5));
        assert!(!inside(&vertices, dvec3(2.0, 2.0, 0.0), DVec3::Z).0);
    }
}
