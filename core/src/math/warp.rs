//! From the unit square to where samples are wanted: without holes, without heaps, neighbours
//! staying neighbours.

use super::{PI, Real, Vec3, cos, exp, ln, sin, sqrt, unit, vec3};

/// A number evenly in `[0, 1)` to one in `(-1, 1)`, the more often the nearer to zero: the
/// height of a tent.
pub fn tent(u: Real) -> Real {
    if u < 0.5 { sqrt(2.0 * u) - 1.0 } else { 1.0 - sqrt(2.0 * (1.0 - u)) }
}

/// A point evenly in the unit square to one by a round normal distribution of deviation one,
/// cut off at `radius` (Box, Muller 1958).
pub fn normal([u, v]: [Real; 2], radius: Real) -> [Real; 2] {
    // What the distribution has inside the radius.
    let inside = 1.0 - exp(-0.5 * radius * radius);
    let r = sqrt(-2.0 * ln(1.0 - u * inside));
    let angle = 2.0 * PI * v;
    [r * cos(angle), r * sin(angle)]
}

/// A point evenly in the unit square to one evenly in the disc of radius one; the middle stays
/// the middle ("A Low Distortion Map Between Disk and Square", Shirley, Chiu, JGT 1997).
pub fn disc([u, v]: [Real; 2]) -> [Real; 2] {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let (r, angle) =
        if x.abs() > y.abs() { (x, 0.25 * PI * (y / x)) } else { (y, 0.5 * PI - 0.25 * PI * (x / y)) };
    [r * cos(angle), r * sin(angle)]
}

/// Two directions of length one that are upright on `n`, which has length one, and on each
/// other ("Building an Orthonormal Basis, Revisited", Duff et al., JCGT 2017).
pub fn across(n: Vec3) -> [Vec3; 2] {
    let sign = if n.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    [vec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), vec3(b, sign + n.y * n.y * a, -n.y)]
}

/// The normal of one of the facets that make up a rough surface: of those that are seen from
/// the direction `eye`, by a point evenly in the unit square. Roughness is the tangent of the
/// facets' typical slope; the surface, whose normal is `n`, has facets as the GGX distribution
/// has them ("Microfacet Models for Refraction", Walter et al., EGSR 2007; "Sampling Visible GGX
/// Normals with Spherical Caps", Dupuy, Benyoub, HPG 2023).
pub fn facet(n: Vec3, eye: Vec3, slope: Real, [u, v]: [Real; 2]) -> Vec3 {
    let [first, second] = across(n);
    // As if the surface were stretched until its facets are those of a sphere.
    let up = eye.dot(n);
    let up = if up > 0.0 { up } else { 0.0 };
    let stretched = vec3(slope * eye.dot(first), slope * eye.dot(second), up);
    let eye = unit(stretched).unwrap_or(Vec3::Z);
    // Evenly in the cap of directions that the sphere mirrors to the eye.
    let z = (1.0 - v) * (1.0 + eye.z) - eye.z;
    let across = sqrt(if z * z < 1.0 { 1.0 - z * z } else { 0.0 });
    let angle = 2.0 * PI * u;
    let half = vec3(across * cos(angle), across * sin(angle), z) + eye;
    let facet = first * (slope * half.x) + second * (slope * half.y) + n * half.z;
    unit(facet).unwrap_or(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Dimension, Stream, length};

    fn points() -> impl Iterator<Item = [Real; 2]> {
        (0..4096).map(|index| Stream::new(0, 0, index, 0).pair(Dimension::LENS))
    }

    #[test]
    fn a_disc_is_filled_evenly_from_its_middle_to_its_rim() {
        assert_eq!(disc([0.5, 0.5]), [0.0, 0.0]);
        let (mut inside, mut right, mut upper) = (0, 0, 0);
        for point in points() {
            let [x, y] = disc(point);
            let r2 = x * x + y * y;
            assert!(r2 <= 1.0 + 1e-6);
            inside += i32::from(r2 < 0.3);
            right += i32::from(x > 0.5);
            upper += i32::from(y > 0.0);
        }
        // Beyond a chord at half the radius lies 1/3 - sqrt(3) / (4 pi) of the disc.
        for (count, share) in [(inside, 0.3), (right, 0.195_501), (upper, 0.5)] {
            assert!((count as Real / 4096.0 - share).abs() < 2e-3, "{count} {share}");
        }
    }

    #[test]
    fn directions_across_are_upright_on_the_normal_and_on_each_other() {
        for n in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::Z, vec3(0.6, 0.0, -0.8), vec3(0.48, 0.6, 0.64)] {
            let [a, b] = across(n);
            for dot in [a.dot(b), a.dot(n), b.dot(n), a.dot(a) - 1.0, b.dot(b) - 1.0] {
                assert!(dot.abs() < 1e-6, "{n}");
            }
        }
    }

    #[test]
    fn facets_have_the_mean_slope_of_their_distribution_and_are_seen() {
        // Looked at from above: the mean square of the cosine, which for GGX of slope s is
        // the integral over t in 0..1 of (1 - t) / (1 + (s^2 - 1) t).
        for slope in [0.1, 0.4, 1.0] {
            let (mut sum, mut want) = (0.0, 0.0);
            for (point, number) in points().zip(0..) {
                let h = facet(Vec3::Y, Vec3::Y, slope, point);
                assert!((length(h) - 1.0).abs() < 1e-5);
                sum += h.y * h.y;
                let t = (number as Real + 0.5) / 4096.0;
                want += (1.0 - t) / (1.0 + (slope * slope - 1.0) * t);
            }
            assert!((sum - want).abs() < 2e-3 * want, "{slope}: {sum} {want}");
        }
        let eye = vec3(0.8, 0.6, 0.0);
        for point in points() {
            let h = facet(Vec3::Y, eye, 0.5, point);
            assert!(h.dot(eye) > -1e-5 && h.y > -1e-5, "{h}");
        }
    }
}
