//! Reflection, refraction and absorption.
//!
//! Directions are unit. `d` is the direction of a ray towards the surface, and `n` is the normal on the side
//! that the ray comes from, so `d · n < 0`. Total internal reflection is detected before a square root is
//! taken, so no NaN arises.

use crate::math::{Real, Rgb, Vec3, exp, max, sqrt};

/// Direction of specular reflection: `d` mirrored at the plane perpendicular to the unit vector `n`.
///
/// `d`: any length, toward the surface. The result has the same length and points away from the surface.
///
/// ```
/// use strahl_core::shade::reflect;
/// use strahl_core::{Vec3, vec3};
///
/// assert_eq!(reflect(vec3(0.6, -0.8, 0.0), Vec3::Y), vec3(0.6, 0.8, 0.0));
/// ```
pub fn reflect(d: Vec3, n: Vec3) -> Vec3 {
    d - n * (2.0 * d.dot(n))
}

/// Result of [`refract`]: the direction of the refracted ray, and the Fresnel reflectance of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction {
    /// Direction of the refracted ray, unit.
    pub direction: Vec3,
    /// Fresnel reflectance of a dielectric for unpolarized light, in `0..=1`.
    pub reflectance: Real,
}

/// Refraction by Snell's law; `None` in case of total internal reflection.
///
/// * `d`: unit vector, toward the surface.
/// * `n`: unit normal, on the side that the ray comes from.
/// * `ratio`: refractive index on the side that the ray comes from, divided by that on the far side. A
///   ratio of 1 returns `d` unchanged and a reflectance of 0.
///
/// ```
/// use strahl_core::Vec3;
/// use strahl_core::shade::refract;
///
/// // From air into glass, perpendicular to the surface.
/// let refraction = refract(-Vec3::Y, Vec3::Y, 1.0 / 1.5).unwrap();
/// assert_eq!(refraction.direction, -Vec3::Y);
/// assert!((refraction.reflectance - 0.04).abs() < 1e-6);
/// ```
pub fn refract(d: Vec3, n: Vec3, ratio: Real) -> Option<Refraction> {
    if ratio == 1.0 {
        return Some(Refraction { direction: d, reflectance: 0.0 });
    }
    let cos = max(-d.dot(n), 0.0);
    // Tangential component of the refracted direction. Its square is accurate even if `d` and `n` are not
    // exactly unit; `1 - cos^2` is not.
    let tangential = (d + n * cos) * ratio;
    // Square of the sine of the angle of refraction.
    let sin2 = tangential.dot(tangential);
    if !(sin2 < 1.0) {
        return None;
    }
    let cos_refracted = sqrt(1.0 - sin2);
    let direction = tangential - n * cos_refracted;
    let r_perpendicular = (ratio * cos - cos_refracted) / (ratio * cos + cos_refracted);
    let r_parallel = (cos - ratio * cos_refracted) / (cos + ratio * cos_refracted);
    Some(Refraction {
        direction,
        reflectance: 0.5 * (r_perpendicular * r_perpendicular + r_parallel * r_parallel),
    })
}

/// Transmittance of a homogeneous medium over a distance, per channel, in `0..=1` (Beer-Lambert law).
///
/// * `attenuation_length`: distance after which a fraction 1/e of the light is left, positive; infinite is
///   clear.
/// * `distance`: in the same unit, not negative.
pub fn transmittance(attenuation_length: Rgb, distance: Real) -> Rgb {
    attenuation_length.map(|length| if length < Real::INFINITY { exp(-(distance / length)) } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{PI, cos, length, sin, vec3};

    /// A downward direction at an angle of incidence to the surface normal +y.
    fn incident(angle: Real) -> Vec3 {
        vec3(sin(angle), -cos(angle), 0.0)
    }

    #[test]
    fn the_angle_of_reflection_is_the_angle_of_incidence() {
        assert!(length(reflect(incident(0.3), Vec3::Y) - vec3(sin(0.3), cos(0.3), 0.0)) < 1e-6);
    }

    #[test]
    fn snells_law_holds_for_entering_and_leaving_rays() {
        for angle in [0.0, 0.1, 0.6, 1.2, 1.5] {
            for ratio in [1.0 / 1.5, 1.5, 1.0 / 2.4] {
                let Some(out) = refract(incident(angle), Vec3::Y, ratio) else {
                    assert!(sin(angle) * ratio >= 1.0);
                    continue;
                };
                assert!((out.direction.x - ratio * sin(angle)).abs() < 1e-6);
                assert!((length(out.direction) - 1.0).abs() < 1e-6 && out.direction.y < 0.0);
            }
        }
    }

    #[test]
    fn fresnel_reflectance_has_its_known_values() {
        // Normal incidence: ((n - 1) / (n + 1))^2, from either side. Brewster's angle: 0 for parallel
        // polarization, ((n^2 - 1) / (n^2 + 1))^2 for perpendicular polarization.
        let reflectance = |angle, ratio| refract(incident(angle), Vec3::Y, ratio).unwrap().reflectance;
        assert!((reflectance(0.0, 1.0 / 1.5) - 0.04).abs() < 1e-6);
        assert!((reflectance(0.0, 1.5) - 0.04).abs() < 1e-6);
        let brewster = crate::math::acos(1.0 / sqrt(1.0 + 1.5 * 1.5)); // tan = 1.5
        let r: Real = (1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0);
        assert!((reflectance(brewster, 1.0 / 1.5) - 0.5 * r * r).abs() < 1e-6);
        // Grazing incidence: 1.
        assert!(reflectance(PI / 2.0 - 1e-4, 1.0 / 1.5) > 0.999);
    }

    #[test]
    fn beyond_the_critical_angle_there_is_total_internal_reflection() {
        let critical = PI / 2.0 - crate::math::acos(1.0 / 1.5);
        assert!(refract(incident(critical - 1e-3), Vec3::Y, 1.5).is_some());
        assert!(refract(incident(critical + 1e-3), Vec3::Y, 1.5).is_none());
    }

    #[test]
    fn one_over_e_is_left_after_one_attenuation_length() {
        let left = transmittance(Rgb::new(2.0, Real::INFINITY, 1e-30), 2.0);
        assert!((left.r - 0.367_879_44).abs() < 1e-6);
        assert_eq!((left.g, left.b), (1.0, 0.0));
    }
}
