//! Mappings of uniform sample points in the unit square to other distributions.
//!
//! They are continuous almost everywhere, so a well distributed set of points stays well distributed.

use super::{PI, Real, Vec3, cos, exp, ln, sin, sqrt, try_normalize, vec3};

/// Maps a uniform `u` in `[0, 1)` to the tent distribution with density `1 - |x|`, `x` in `[-1, 1)`.
pub fn sample_tent(u: Real) -> Real {
    if u < 0.5 { sqrt(2.0 * u) - 1.0 } else { 1.0 - sqrt(2.0 * (1.0 - u)) }
}

/// Maps a uniform point in the unit square to the two-dimensional standard normal distribution, truncated
/// to the disc of the given `radius`.
///
/// Source: Box and Muller, "A Note on the Generation of Random Normal Deviates", 1958. Difference: the
/// truncation.
pub fn sample_truncated_gaussian([u, v]: [Real; 2], radius: Real) -> [Real; 2] {
    let probability_inside = 1.0 - exp(-0.5 * radius * radius);
    let r = sqrt(-2.0 * ln(1.0 - u * probability_inside));
    let angle = 2.0 * PI * v;
    [r * cos(angle), r * sin(angle)]
}

/// Maps a uniform point in the unit square to a uniform point in the unit disc. Concentric squares become
/// concentric circles.
///
/// Source: Shirley and Chiu, "A Low Distortion Map Between Disk and Square", JGT 1997.
pub fn sample_disc_concentric([u, v]: [Real; 2]) -> [Real; 2] {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let (r, angle) =
        if x.abs() > y.abs() { (x, 0.25 * PI * (y / x)) } else { (y, 0.5 * PI - 0.25 * PI * (x / y)) };
    [r * cos(angle), r * sin(angle)]
}

/// Two unit vectors that are perpendicular to each other and to the unit vector `n`.
///
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017.
pub fn orthonormal_basis(n: Vec3) -> [Vec3; 2] {
    let sign = if n.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    [vec3(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), vec3(b, sign + n.y * n.y * a, -n.y)]
}

/// Maps a uniform point in the unit square to a microfacet normal of a rough surface that is visible from
/// `view_direction`, world space.
///
/// * `n`: unit normal of the surface.
/// * `view_direction`: unit vector away from the surface, on the side of `n`.
/// * `alpha`: roughness of the GGX distribution, the tangent of the typical slope of the microfacets.
///
/// Sources: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; Dupuy and
/// Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023.
pub fn sample_visible_normal(n: Vec3, view_direction: Vec3, alpha: Real, [u, v]: [Real; 2]) -> Vec3 {
    let [x_axis, y_axis] = orthonormal_basis(n);
    // Stretch the surface, so that its microfacet normals become uniform on the hemisphere.
    let cos_theta = view_direction.dot(n);
    let cos_theta = if cos_theta > 0.0 { cos_theta } else { 0.0 };
    let stretched = vec3(alpha * view_direction.dot(x_axis), alpha * view_direction.dot(y_axis), cos_theta);
    let view = try_normalize(stretched).unwrap_or(Vec3::Z);
    // Sample uniformly the spherical cap of directions that the hemisphere reflects into `view`.
    let z = (1.0 - v) * (1.0 + view.z) - view.z;
    let sin_theta = sqrt(if z * z < 1.0 { 1.0 - z * z } else { 0.0 });
    let angle = 2.0 * PI * u;
    let half_vector = vec3(sin_theta * cos(angle), sin_theta * sin(angle), z) + view;
    // Undo the stretching.
    let normal = x_axis * (alpha * half_vector.x) + y_axis * (alpha * half_vector.y) + n * half_vector.z;
    try_normalize(normal).unwrap_or(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Dimension, SobolSequence, length};

    fn points() -> impl Iterator<Item = [Real; 2]> {
        (0..4096).map(|index| SobolSequence::new(0, 0, index, 0).sample_2d(Dimension::LENS))
    }

    #[test]
    fn disc_samples_are_uniform() {
        assert_eq!(sample_disc_concentric([0.5, 0.5]), [0.0, 0.0]);
        let (mut inside, mut right, mut upper) = (0, 0, 0);
        for point in points() {
            let [x, y] = sample_disc_concentric(point);
            let r2 = x * x + y * y;
            assert!(r2 <= 1.0 + 1e-6);
            inside += i32::from(r2 < 0.3);
            right += i32::from(x > 0.5);
            upper += i32::from(y > 0.0);
        }
        // A chord at half the radius cuts off 1/3 - sqrt(3) / (4 pi) of the disc.
        for (count, fraction) in [(inside, 0.3), (right, 0.195_501), (upper, 0.5)] {
            assert!((count as Real / 4096.0 - fraction).abs() < 2e-3, "{count} {fraction}");
        }
    }

    #[test]
    fn the_basis_is_orthonormal() {
        for n in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::Z, vec3(0.6, 0.0, -0.8), vec3(0.48, 0.6, 0.64)] {
            let [a, b] = orthonormal_basis(n);
            for dot in [a.dot(b), a.dot(n), b.dot(n), a.dot(a) - 1.0, b.dot(b) - 1.0] {
                assert!(dot.abs() < 1e-6, "{n}");
            }
        }
    }

    #[test]
    fn visible_normals_follow_the_ggx_distribution_and_are_visible() {
        // Seen along the normal, the mean of the squared cosine for GGX with alpha = a is the integral over
        // t in 0..1 of (1 - t) / (1 + (a^2 - 1) t).
        for alpha in [0.1, 0.4, 1.0] {
            let (mut sum, mut expected) = (0.0, 0.0);
            for (point, index) in points().zip(0..) {
                let h = sample_visible_normal(Vec3::Y, Vec3::Y, alpha, point);
                assert!((length(h) - 1.0).abs() < 1e-5);
                sum += h.y * h.y;
                let t = (index as Real + 0.5) / 4096.0;
                expected += (1.0 - t) / (1.0 + (alpha * alpha - 1.0) * t);
            }
            assert!((sum - expected).abs() < 2e-3 * expected, "{alpha}: {sum} {expected}");
        }
        let view_direction = vec3(0.8, 0.6, 0.0);
        for point in points() {
            let h = sample_visible_normal(Vec3::Y, view_direction, 0.5, point);
            assert!(h.dot(view_direction) > -1e-5 && h.y > -1e-5, "{h}");
        }
    }
}
