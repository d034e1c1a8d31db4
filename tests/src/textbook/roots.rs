//! Roots of polynomials by formulas.

/// The roots of `a x^2 + b x + c` in ascending order, by the quadratic formula.
pub(super) fn quadratic(a: f32, b: f32, c: f32) -> Option<[f32; 2]> {
    let d = b * b - 4.0 * a * c;
    if d < 0.0 {
        return None;
    }
    let (x, y) = ((-b - d.sqrt()) / (2.0 * a), (-b + d.sqrt()) / (2.0 * a));
    Some(if x < y { [x, y] } else { [y, x] })
}

/// The real roots of `x^4 + a x^3 + b x^2 + c x + d`.
pub(super) fn quartic(a: f32, b: f32, c: f32, d: f32) -> Vec<f32> {
    // x = y - a/4: y^4 + p y^2 + q y + r.
    let s = a * a;
    let p = b - 0.375 * s;
    let q = 0.125 * s * a - 0.5 * a * b + c;
    let r = -3.0 / 256.0 * s * s + s * b / 16.0 - 0.25 * a * c + d;
    let z = resolvent(-0.5 * p, -r, 0.5 * r * p - 0.125 * q * q);
    let (u, v) = (z * z - r, 2.0 * z - p);
    if u < 0.0 || v < 0.0 {
        return Vec::new();
    }
    let (u, v) = (u.sqrt(), v.sqrt());
    let v = if q < 0.0 { -v } else { v };
    [quadratic(1.0, v, z - u), quadratic(1.0, -v, z + u)]
        .into_iter()
        .flatten()
        .flatten()
        .map(|y| y - 0.25 * a)
        .collect()
}

/// A real root of `x^3 + a x^2 + b x + c`.
fn resolvent(a: f32, b: f32, c: f32) -> f32 {
    let p = (b - a * a / 3.0) / 3.0;
    let q = 0.5 * (2.0 / 27.0 * a * a * a - a * b / 3.0 + c);
    let d = q * q + p * p * p;
    let y = if d < 0.0 {
        let angle = libm::acosf(-q / (-p * p * p).sqrt()) / 3.0;
        2.0 * (-p).sqrt() * libm::cosf(angle)
    } else {
        libm::cbrtf(d.sqrt() - q) - libm::cbrtf(d.sqrt() + q)
    };
    y - a / 3.0
}
