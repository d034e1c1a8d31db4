//! Points and directions in double precision.

/// A point or a direction in double precision.
pub type Vector = strahl_core_double::Vec3;

/// A vector from its components.
pub fn vector(x: f64, y: f64, z: f64) -> Vector {
    Vector::new(x, y, z)
}

/// A vector of length one.
pub(crate) fn unit(v: Vector) -> Vector {
    v / v.dot(v).sqrt()
}

/// Two directions upright on `n` and on each other, right-handed: `x` cross `y` is along `n`.
pub(crate) fn upright(n: Vector) -> (Vector, Vector) {
    let n = unit(n);
    let other = if n.x.abs() < 0.5 { Vector::X } else { Vector::Y };
    let x = unit(other.cross(n));
    (x, n.cross(x))
}

/// The sum of the areas that the corners span, as a vector upright on them.
pub(crate) fn area(corners: &[Vector]) -> Vector {
    let round = corners.iter().skip(1).chain(corners.first());
    let start = corners[0];
    corners.iter().zip(round).map(|(a, b)| (*a - start).cross(*b - start)).sum()
}
