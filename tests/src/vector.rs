//! Points and directions in double precision.

/// A point or a direction in double precision.
pub type DVec3 = strahl_core_double::Vec3;

/// A vector from its components.
pub fn dvec3(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// A vector of length one.
pub(crate) fn unit(v: DVec3) -> DVec3 {
    v / v.dot(v).sqrt()
}

/// Two directions upright on `n` and on each other, right-handed: `x` cross `y` is along `n`.
pub(crate) fn perpendicular_axes(n: DVec3) -> (DVec3, DVec3) {
    let n = unit(n);
    let other = if n.x.abs() < 0.5 { DVec3::X } else { DVec3::Y };
    let x = unit(other.cross(n));
    (x, n.cross(x))
}

/// The sum of the areas that the corners span, as a vector upright on them.
pub(crate) fn area(corners: &[DVec3]) -> DVec3 {
    let round = corners.iter().skip(1).chain(corners.first());
    let start = corners[0];
    corners.iter().zip(round).map(|(a, b)| (*a - start).cross(*b - start)).sum()
}
