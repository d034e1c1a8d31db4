//! Points and directions in double precision.

/// Point or direction in double precision.
pub type DVec3 = strahl_core_double::Vec3;

/// A vector from its components.
pub fn dvec3(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The unit vector in the direction of `v`.
pub fn unit(v: DVec3) -> DVec3 {
    v / v.dot(v).sqrt()
}

/// Two unit vectors perpendicular to `n` and to each other, right-handed: `x` cross `y` has the direction of
/// `n`.
pub fn perpendicular_axes(n: DVec3) -> (DVec3, DVec3) {
    let n = unit(n);
    let other = if n.x.abs() < 0.5 { DVec3::X } else { DVec3::Y };
    let x = unit(other.cross(n));
    (x, n.cross(x))
}

/// Twice the vector area of a polygon: perpendicular to it if its vertices lie in a plane.
pub fn area(vertices: &[DVec3]) -> DVec3 {
    let next = vertices.iter().skip(1).chain(vertices.first());
    let start = vertices[0];
    vertices.iter().zip(next).map(|(a, b)| (*a - start).cross(*b - start)).sum()
}
